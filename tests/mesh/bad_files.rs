//! Broken mesh files: each is refused, with file, line and cure.

use washout::mesh::gmsh::read;

/// Two bays, three spanwise places, one spar; tags with gaps.
const GOOD: &str = r#"$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
6
1 1 "rod-0"
1 2 "spar-0"
1 3 "root"
1 4 "leading-edge"
1 5 "trailing-edge"
2 6 "membrane"
$EndPhysicalNames
$Entities
0 4 1 0
1 0 0 0 0.02 0 0 2 1 4 0
2 0.01 0 0 0.01 0.01 0 1 2 0
3 0 0 0 0 0.01 0 1 3 0
4 0 0.01 0 0.02 0.01 0 1 5 0
1 0 0 0 0.02 0.01 0 1 6 0
$EndEntities
$Nodes
1 6 11 22
2 1 0 6
11
12
13
20
21
22
0 0 0
0.01 0 0
0.02 0 0
0 0.01 0
0.01 0.01 0
0.02 0.01 0
$EndNodes
$Elements
5 10 1 10
1 1 1 2
1 12 11
2 12 13
1 2 1 1
3 21 12
1 3 1 1
4 20 11
1 4 1 2
5 22 21
6 20 21
2 1 2 4
7 11 12 21
8 11 21 20
9 12 13 22
10 12 22 21
$EndElements
"#;

/// What the reader says to the good file after one change.
fn message(from: &str, to: &str) -> String {
    assert_eq!(GOOD.matches(from).count(), 1, "`{from}` must stand once");
    error_of(GOOD.replace(from, to).as_bytes())
}

fn error_of(bytes: &[u8]) -> String {
    read(bytes, "wing.msh").unwrap_err().to_string()
}

#[test]
fn the_good_file_is_good() {
    let mesh = read(GOOD.as_bytes(), "wing.msh").unwrap();
    assert_eq!(
        (mesh.nodes.len(), mesh.triangles.len(), mesh.beams.len()),
        (6, 4, 3)
    );
    assert_eq!(
        (mesh.rod_nodes(), mesh.spar_nodes(0)),
        (vec![0, 1, 2], vec![1, 4])
    );
    assert_eq!(
        (&mesh.root[..], &mesh.trailing_edge[..]),
        (&[0, 3][..], &[3, 4, 5][..])
    );
}

#[test]
fn files_that_are_no_mesh() {
    assert_eq!(
        error_of(b" \n \n"),
        "wing.msh: the file is empty; write a mesh with `washout mesh`, or save one with Gmsh as MSH 4.1 text"
    );
    assert_eq!(
        error_of(b"$MeshFormat\n4.1 1 8\n\x01\x00\x00\x00\n$EndMeshFormat\n"),
        "wing.msh: the file is binary; save it as text (gmsh: -bin off, or Mesh.Binary = 0)"
    );
    assert_eq!(
        error_of(b"\xff\xfe$MeshFormat"),
        "wing.msh: the file is binary; save it as text (gmsh: -bin off, or Mesh.Binary = 0)"
    );
    assert_eq!(
        message("4.1 0 8", "4.1 1 8"),
        "wing.msh:2: the file is binary; save it as text (gmsh: -bin off, or Mesh.Binary = 0)"
    );
    assert_eq!(
        error_of(b"solid wing\nfacet normal 0 0 1\n"),
        "wing.msh:1: not a Gmsh file: it starts with `solid wing` instead of $MeshFormat"
    );
    assert_eq!(
        message("4.1 0 8", "4.0 0 8"),
        "wing.msh:2: MSH version `4.0`; this reads 4.1 and 2.2: save it again (gmsh: -format msh41)"
    );
    assert_eq!(
        error_of(&vec![b'1'; (512 << 20) + 1]),
        "wing.msh: the file has 512 MB; a mesh may have 512 MB: mesh it coarser"
    );
}

#[test]
fn files_that_were_cut_short_or_miscounted() {
    let cut = |at: &str| error_of(&GOOD.as_bytes()[..GOOD.find(at).unwrap()]);
    assert_eq!(
        cut("0.01 0.01 0\n0.02"),
        "wing.msh: the file ends inside $Nodes, which must close with $EndNodes; it was cut short: save it again"
    );
    assert_eq!(
        cut("$EndElements"),
        "wing.msh: the file ends inside $Elements, which must close with $EndElements; \
         it was cut short: save it again"
    );
    assert_eq!(
        cut("$Elements"),
        "wing.msh: the section $Elements is missing; save the mesh with its physical groups as MSH 4.1"
    );
    assert_eq!(
        message("$EndNodes\n", "$EndNodes\n$Nodes\n0 0 0 0\n$EndNodes\n"),
        "wing.msh:37: the section $Nodes stands twice; keep one"
    );
    assert_eq!(
        message("2 1 0 6\n", "2 1 0 7\n"),
        "wing.msh:30: expected a node tag, found `0 0 0`"
    );
    assert_eq!(
        message("2 1 2 4\n", "2 1 2 3\n"),
        "wing.msh:53: $Elements should close here with $EndElements, found `10 12 22 21`: the counts above it are wrong"
    );
    assert_eq!(
        message("2 1 2 4\n", "2 1 2 18446744073709551615\n"),
        "wing.msh:49: expected dimension, entity, element type and number of elements of a block, \
         found `2 1 2 18446744073709551615`"
    );
}

#[test]
fn nodes_that_are_wrong() {
    assert_eq!(
        message("\n0.02 0 0\n", "\n0.02 NaN 0\n"),
        "wing.msh:32: the coordinate `NaN` is not a finite number"
    );
    assert_eq!(
        message("\n0.02 0 0\n", "\n0.02 0,1 0\n"),
        "wing.msh:32: expected the coordinates x y z of a node, found `0.02 0,1 0`"
    );
    assert_eq!(
        message("13\n20\n", "13\n12\n"),
        "wing.msh:33: node 12 stands twice; node tags must differ (gmsh: Mesh.RenumberNodes)"
    );
    assert_eq!(
        message("\n0.02 0 0\n", "\n0.02 0 0.001\n"),
        "wing.msh:32: node at (20.0000, 0.0000) mm lies 1.000000 mm off the plane z = 0; \
         the wing at rest is flat: project it"
    );
    assert_eq!(
        message("\n0.02 0 0\n", "\n0.02 0.001 0\n"),
        "wing.msh:32: node at (20.0000, 1.0000) mm belongs to the leading edge, which must lie on y = 0; \
         shift or turn the mesh"
    );
    let loose = GOOD
        .replace("1 6 11 22\n2 1 0 6\n", "1 7 11 23\n2 1 0 7\n")
        .replace("22\n0 0 0\n", "22\n23\n0 0 0\n")
        .replace("0.02 0.01 0\n$EndNodes", "0.02 0.01 0\n0.005 0.005 0\n$EndNodes");
    assert_eq!(
        error_of(loose.as_bytes()),
        "wing.msh:37: node at (5.0000, 5.0000) mm belongs to no element; remove it"
    );
}

#[test]
fn elements_that_are_wrong() {
    assert_eq!(
        message("7 11 12 21", "7 11 12 99"),
        "wing.msh:50: element 7 names node 99, which does not exist"
    );
    assert_eq!(
        message("7 11 12 21", "7 11 12"),
        "wing.msh:50: expected tag and nodes of an element, found `7 11 12`"
    );
    assert_eq!(
        message("2 1 2 4", "2 1 3 4"),
        "wing.msh:49: element type 3 (4-node quadrangle); a wing has points (15), 2-node lines (1) and \
         3-node triangles (2): mesh with first-order triangles, without recombination"
    );
    assert_eq!(
        message("7 11 12 21", "7 11 12 13"),
        "wing.msh:50: triangle at (10.0000, 0.0000) mm has no area; remove it or move its nodes apart"
    );
    // Clockwise is turned, but a triangle that lies over its neighbour is refused.
    assert!(read(GOOD.replace("7 11 12 21", "7 21 12 11").as_bytes(), "wing.msh").is_ok());
    assert_eq!(
        message("8 11 21 20", "8 11 21 13"),
        "wing.msh:51: triangle at (10.0000, 3.3333) mm is inverted: it lies over its neighbour, or stands there \
         twice; move its nodes back, or remove it"
    );
    // The outer bay with nodes of its own along the spar: it touches the inner one, but is not joined to it.
    let torn = GOOD
        .replace("1 6 11 22\n2 1 0 6\n", "1 8 11 24\n2 1 0 8\n")
        .replace("22\n0 0 0\n", "22\n23\n24\n0 0 0\n")
        .replace(
            "0.02 0.01 0\n$EndNodes",
            "0.02 0.01 0\n0.01 0 0\n0.01 0.01 0\n$EndNodes",
        )
        .replace("9 12 13 22\n10 12 22 21", "9 23 13 22\n10 23 22 24");
    assert_eq!(
        error_of(torn.as_bytes()),
        "wing.msh:38: two nodes stand at (10.0000, 0.0000) mm, so the parts there are not joined; \
         merge them (gmsh: Coherence Mesh)"
    );
    let apart = torn.replace("0.01 0 0\n0.01 0.01 0\n$End", "0.012 0.001 0\n0.012 0.01 0\n$End");
    let apart = apart
        .replace("2 12 13\n", "2 12 11\n")
        .replace("1 1 1 2\n1 12 11\n2 12 11\n", "1 1 1 1\n1 12 11\n");
    assert_eq!(
        error_of(apart.as_bytes()),
        "wing.msh:34: the elements at (20.0000, 0.0000) mm are not connected with the rod; join them or remove them"
    );
}

#[test]
fn sets_that_are_wrong_or_missing() {
    assert_eq!(
        message("\"spar-0\"", "\"spar_0\""),
        "wing.msh:7: the set `spar_0` is unknown; use rod-N, spar-N (N from 0), membrane, root, leading-edge, \
         trailing-edge"
    );
    assert_eq!(
        message("\"spar-0\"", "\"spar-1\""),
        "wing.msh: the set `spar-0` is missing or empty; give its elements a physical group of that name"
    );
    assert_eq!(
        message("0.01 0 1 3 0\n", "0.01 0 0 0\n"),
        "wing.msh: the set `root` is missing or empty; give its lines that physical name"
    );
    assert_eq!(
        message("0.02 0 0 2 1 4 0", "0.02 0 0 1 4 0"),
        "wing.msh:6: the set `rod-0` is missing or empty; give its elements a physical group of that name"
    );
    assert_eq!(
        message("0.02 0.01 0 1 6 0", "0.02 0.01 0 0 0"),
        "wing.msh:50: the triangles of surface 1 belong to no set; add the surface to the physical group `membrane`"
    );
    assert_eq!(
        message("2 6 \"membrane\"", "1 6 \"membrane\""),
        "wing.msh:11: the set `membrane` has dimension 1; it must hold surfaces (2)"
    );
    assert_eq!(
        message("0.01 0 1 2 0\n", "0.01 0 1 9 0\n"),
        "wing.msh:16: physical group 9 (dimension 1) has no name; name it in $PhysicalNames"
    );
    assert_eq!(
        message("1 4 1 2\n5 22 21\n6 20 21\n", "1 4 1 1\n5 22 21\n"),
        "wing.msh:33: the root ends at (0.0000, 10.0000) mm, which is not the first node of the trailing edge; \
         it must run from the one to the other"
    );
    assert_eq!(
        message("1 4 1 2\n5 22 21\n6 20 21\n", "1 4 1 1\n5 22 20\n"),
        "wing.msh:35: the set `trailing-edge` is interrupted at (20.0000, 10.0000) mm; its lines must follow the \
         film's edge without a gap, and not go round a corner (the tip belongs to no set)"
    );
}

#[test]
fn rods_and_spars_that_do_not_run() {
    assert_eq!(
        message("1 1 1 2\n1 12 11\n2 12 13\n", "1 1 1 1\n1 13 11\n"),
        "wing.msh:40: rod-0 element at (10.0000, 0.0000) mm does not follow an edge of the film's triangles; \
         embed the line in the surface before meshing (gmsh: Curve{…} In Surface{…})"
    );
    assert_eq!(
        message("2 12 13\n", "2 12 11\n"),
        "wing.msh:40: `rod-0` is not one line from end to end: it is closed"
    );
    assert_eq!(
        message("3 21 12\n", "3 21 13\n"),
        "wing.msh:43: spar-0 element at (15.0000, 5.0000) mm does not follow an edge of the film's triangles; \
         embed the line in the surface before meshing (gmsh: Curve{…} In Surface{…})"
    );
    // The leading edge as a curve of its own, and a rod on its outer half only.
    let late = GOOD
        .replace("0 4 1 0\n", "0 5 1 0\n")
        .replace("2 1 4 0\n", "1 1 0\n")
        .replace(
            "0.02 0.01 0 1 5 0\n",
            "0.02 0.01 0 1 5 0\n5 0 0 0 0.02 0 0 1 4 0\n",
        )
        .replace(
            "5 10 1 10\n1 1 1 2\n1 12 11\n2 12 13\n",
            "6 11 1 11\n1 1 1 1\n2 12 13\n1 5 1 2\n1 12 11\n11 12 13\n",
        );
    assert_eq!(
        error_of(late.as_bytes()),
        "wing.msh:41: rod element at x = 10.0000 mm does not continue the rod: its pieces must join from the \
         root outward, along the leading edge"
    );
}
