//! What the effects of a diagnosis are: in words, and as a small picture of what each changes on the wing and what that makes.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use crate::coupling::Difference;
use crate::export::added::what;
use crate::mesh::{BeamPart, Mesh};
use crate::page::text::significant;
use crate::plot::pen::escaped;

use super::still::outline;
use super::table::paragraph;

/// An effect at work on a wing.
#[derive(Debug, Clone, PartialEq)]
pub struct EffectAtWork {
    /// Its name.
    pub effect: String,
    /// The case whose wing it is.
    pub case: String,
    /// The mesh of that wing.
    pub mesh: Mesh,
    /// Where the wing with it differs from the wing without.
    pub difference: Difference,
    /// Twist along the span without it and with it: places (m), twist (deg).
    pub twist_deg: [Vec<[f64; 2]>; 2],
}

/// The effects that are shown, and what is not, each with its reason.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EffectsAtWork {
    /// Those shown.
    pub shown: Vec<EffectAtWork>,
    /// What is not shown, and why.
    pub notes: Vec<String>,
}

/// The sheet, px.
const WIDTH: f64 = 320.0;
const MARGIN: f64 = 10.0;
/// The highest that a wing is drawn.
const WING: f64 = 110.0;
const CHART: f64 = 62.0;
/// Line of words above a chart.
const WORDS: f64 = 22.0;
/// So many nodes are marked one by one; of more only words tell.
const MARKED: usize = 40;

/// The effects side by side; nothing if there are none.
pub fn effects(at_work: &EffectsAtWork) -> String {
    let notes: String = at_work.notes.iter().map(|words| paragraph(words)).collect();
    if at_work.shown.is_empty() {
        return notes;
    }
    let figures: String = at_work.shown.iter().map(figure).collect();
    let key = "Orange: what the effect changes, and the wing with it. Grey: the wing without it. Everything else uncalibrated.";
    format!("<p class=\"quiet\">{key}</p>\n<div class=\"effects\">\n{figures}</div>\n{notes}")
}

fn figure(shown: &EffectAtWork) -> String {
    let words = what(&shown.effect).map_or(String::new(), |[what, _]| escaped(&what));
    format!(
        "<figure>{}<figcaption><strong>{}</strong> {words} <span class=\"quiet\">{} (Drawn: {}.)</span></figcaption></figure>\n",
        picture(shown),
        escaped(&shown.effect),
        escaped(&changed(shown)),
        escaped(&shown.case)
    )
}

/// What it changes, in words.
fn changed(shown: &EffectAtWork) -> String {
    let (mesh, difference) = (&shown.mesh, &shown.difference);
    let mut changed = beams(mesh, &difference.beams);
    match (difference.triangles.len(), mesh.triangles.len()) {
        (0, _) => {}
        (some, all) if some == all => changed.push("all of the film".to_string()),
        _ => changed.push("part of the film".to_string()),
    }
    match difference.nodes.as_slice() {
        [] => {}
        nodes if nodes.iter().all(|node| mesh.root.contains(node)) => {
            changed.push("how the root is held".to_string());
        }
        nodes if nodes.len() <= MARKED => changed.push("loads or masses where dots are".to_string()),
        _ => changed.push("loads all over the wing".to_string()),
    }
    if !difference.air_n_per_m.is_empty() {
        changed.push("the force of the air".to_string());
    }
    if difference.has_other_kinematics {
        changed.push("whether rotations are taken as large".to_string());
    }
    match changed.as_slice() {
        [] => "The wing stays as it is; what is read from it changes.".to_string(),
        changed => format!("It changes {}.", changed.join(", ")),
    }
}

/// Stretches of the rod, spars and ribs.
fn beams(mesh: &Mesh, changed: &[usize]) -> Vec<String> {
    let mut rod = Vec::new();
    let mut others: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for &beam in changed {
        match mesh.beams[beam].part {
            BeamPart::Rod(_) => rod.push(beam),
            BeamPart::Spar(index) => drop(others.entry("spar").or_default().insert(index)),
            BeamPart::Rib(index) => drop(others.entry("rib").or_default().insert(index)),
        }
    }
    let numbered = |(part, indices): (&str, BTreeSet<usize>)| {
        let plural = if indices.len() == 1 { "" } else { "s" };
        let numbers: Vec<String> = indices.iter().map(|index| (index + 1).to_string()).collect();
        format!("{part}{plural} {}", numbers.join(", "))
    };
    let stretch = stretch(mesh, &rod).into_iter();
    stretch.chain(others.into_iter().map(numbered)).collect()
}

/// Where the changed elements of the rod lie; none if there are none.
fn stretch(mesh: &Mesh, changed: &[usize]) -> Option<String> {
    let nodes = changed.iter().flat_map(|&beam| mesh.beams[beam].nodes);
    let [from_m, to_m] = ends(nodes.map(|node| mesh.nodes[node][0]));
    let is_at_root = changed
        .iter()
        .any(|&beam| mesh.root.contains(&mesh.beams[beam].nodes[0]));
    match changed {
        [] => None,
        [_] if is_at_root => Some("the root end of the rod".to_string()),
        _ => Some(format!(
            "the elements of the rod from {} to {} mm",
            significant(1e3 * from_m, 3),
            significant(1e3 * to_m, 3)
        )),
    }
}

/// The lowest and the highest.
fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// The wing from above with what changes, the air if that changes, the twist.
fn picture(shown: &EffectAtWork) -> String {
    let (mesh, difference) = (&shown.mesh, &shown.difference);
    let plan = Plan::of(mesh);
    let mut svg = String::new();
    // Writing to a String cannot fail.
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        let is_changed = difference.triangles.binary_search(&index).is_ok();
        let class = if is_changed { "film changed" } else { "film" };
        let _ = write!(svg, "<path class=\"{class}\" d=\"{}z\"/>", plan.path(triangle));
    }
    for edge in outline(&mesh.triangles) {
        let _ = write!(svg, "<path class=\"line\" d=\"{}\"/>", plan.path(&edge));
    }
    for (index, beam) in mesh.beams.iter().enumerate() {
        let is_rod = matches!(beam.part, BeamPart::Rod(_));
        let is_changed = difference.beams.binary_search(&index).is_ok();
        let class = match (is_rod, is_changed) {
            (_, true) => "line changed",
            (true, false) => "line rod",
            (false, false) => "line spar",
        };
        let _ = write!(svg, "<path class=\"{class}\" d=\"{}\"/>", plan.path(&beam.nodes));
    }
    if difference.nodes.len() <= MARKED {
        for &node in &difference.nodes {
            let [x, y] = plan.place(node);
            let _ = write!(
                svg,
                "<circle class=\"changed\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>"
            );
        }
    }
    let mut top = plan.bottom;
    let air = &difference.air_n_per_m;
    if !air.is_empty() {
        let curves = [1, 2].map(|k| air.iter().map(|row| [row[0], row[k]]).collect::<Vec<_>>());
        svg.push_str(&chart("air across the chord, N/m", &curves, &plan, top));
        top += WORDS + CHART;
    }
    svg.push_str(&chart("twist, deg", &shown.twist_deg, &plan, top));
    top += WORDS + CHART;
    format!(
        "<svg role=\"img\" viewBox=\"0 0 {WIDTH} {top:.0}\"><title>{} on {}</title>{svg}</svg>",
        escaped(&shown.effect),
        escaped(&shown.case)
    )
}

/// Two curves over the span of the wing above: without and with; their largest values stand in the words.
fn chart(name: &str, curves: &[Vec<[f64; 2]>; 2], plan: &Plan, top: f64) -> String {
    let values = curves.iter().flatten().map(|spot| spot[1]);
    let [low, high] = ends(values.chain([0.0]));
    let size = (high - low).max(f64::MIN_POSITIVE);
    let y = |value: f64| top + WORDS + (CHART - 8.0) * (high - value) / size;
    let zero = y(0.0);
    let mut svg = format!(
        "<path class=\"line\" d=\"M{:.1} {zero:.1}H{:.1}\"/>",
        plan.x(plan.from_m),
        plan.x(plan.to_m)
    );
    for (class, curve) in ["line rod", "line changed"].into_iter().zip(curves) {
        let spots = curve.iter().map(|[r_m, value]| [plan.x(*r_m), y(*value)]);
        let _ = write!(svg, "<path class=\"{class}\" d=\"{}\"/>", path(spots));
    }
    let most = |curve: &Vec<[f64; 2]>| {
        let largest = curve
            .iter()
            .map(|spot| spot[1])
            .max_by(|a, b| a.abs().total_cmp(&b.abs()));
        significant(largest.unwrap_or(0.0), 3)
    };
    let [without, with] = [0, 1].map(|k| most(&curves[k]));
    let _ = write!(
        svg,
        "<text x=\"{MARGIN}\" y=\"{:.1}\">{name}: up to {without}, with it {with}</text>",
        top + WORDS - 9.0
    );
    svg
}

/// Where the wing lies on the sheet, seen from above, the leading edge on top.
struct Plan<'a> {
    mesh: &'a Mesh,
    from_m: f64,
    to_m: f64,
    front_m: f64,
    scale: f64,
    bottom: f64,
}

impl<'a> Plan<'a> {
    fn of(mesh: &'a Mesh) -> Plan<'a> {
        let [[from_m, to_m], [front_m, back_m]] = [0, 1].map(|k| ends(mesh.nodes.iter().map(|node| node[k])));
        let scale = ((WIDTH - 2.0 * MARGIN) / (to_m - from_m)).min(WING / (back_m - front_m));
        Plan {
            mesh,
            from_m,
            to_m,
            front_m,
            scale,
            bottom: MARGIN + scale * (back_m - front_m) + 8.0,
        }
    }

    fn x(&self, r_m: f64) -> f64 {
        MARGIN + self.scale * (r_m - self.from_m)
    }

    fn place(&self, node: usize) -> [f64; 2] {
        let [x, y, _] = self.mesh.nodes[node];
        [self.x(x), MARGIN + self.scale * (y - self.front_m)]
    }

    fn path(&self, nodes: &[usize]) -> String {
        path(nodes.iter().map(|&node| self.place(node)))
    }
}

fn path(spots: impl Iterator<Item = [f64; 2]>) -> String {
    let mut text = String::new();
    for (index, [x, y]) in spots.enumerate() {
        // Writing to a String cannot fail.
        let _ = write!(text, "{}{x:.1} {y:.1}", if index == 0 { "M" } else { "L" });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::BeamElement;

    /// Two triangles, a rod of two pieces and a spar at the tip.
    fn at_work(difference: Difference) -> EffectAtWork {
        let beam = |nodes, part| BeamElement { nodes, part };
        EffectAtWork {
            effect: "rod-torsion-loss".to_string(),
            case: "22<hz".to_string(),
            mesh: Mesh {
                nodes: vec![
                    [0.0; 3],
                    [0.025, 0.0, 0.0],
                    [0.05, 0.0, 0.0],
                    [0.0, 0.02, 0.0],
                    [0.05, 0.02, 0.0],
                ],
                triangles: vec![[0, 1, 3], [1, 2, 4], [1, 4, 3]],
                beams: vec![
                    beam([0, 1], BeamPart::Rod(0)),
                    beam([1, 2], BeamPart::Rod(0)),
                    beam([2, 4], BeamPart::Spar(0)),
                ],
                root: vec![0, 3],
                leading_edge: vec![0, 1, 2],
                trailing_edge: vec![3, 4],
            },
            difference,
            twist_deg: [vec![[0.0, 0.0], [0.05, 10.0]], vec![[0.0, 0.0], [0.05, 12.5]]],
        }
    }

    fn shown(difference: Difference) -> String {
        let shown = vec![at_work(difference)];
        effects(&EffectsAtWork {
            shown,
            notes: Vec::new(),
        })
    }

    #[test]
    fn what_an_effect_changes_is_marked_and_named() {
        let html = shown(Difference {
            beams: vec![1, 2],
            air_n_per_m: vec![[0.0, 1.0, 1.0], [0.05, 1.0, 0.5]],
            ..Difference::default()
        });
        assert_eq!(
            html.matches("class=\"line changed\"").count(),
            4,
            "two beams, two curves: {html}"
        );
        assert_eq!(html.matches("class=\"film\"").count(), 3);
        for words in [
            "It changes the elements of the rod from 25.0 to 50.0 mm, spar 1, the force of the air.",
            "twist, deg: up to 10.0, with it 12.5",
            "lost torsional stiffness",
            "22&lt;hz",
        ] {
            assert!(html.contains(words), "{words}: {html}");
        }
    }

    #[test]
    fn an_effect_of_the_reading_leaves_the_wing_as_it_is() {
        let html = shown(Difference::default());
        assert!(
            html.contains("The wing stays as it is") && !html.contains("film changed"),
            "{html}"
        );
        assert_eq!(effects(&EffectsAtWork::default()), "");
        let notes = vec!["Not drawn: x<y.".to_string()];
        let undrawn = EffectsAtWork {
            shown: Vec::new(),
            notes,
        };
        assert_eq!(effects(&undrawn), "<p>Not drawn: x&lt;y.</p>\n");
    }

    #[test]
    fn the_root_is_told_from_loads_elsewhere() {
        let words = |nodes| {
            changed(&at_work(Difference {
                nodes,
                ..Difference::default()
            }))
        };
        assert_eq!(words(vec![0, 3]), "It changes how the root is held.");
        assert_eq!(words(vec![4]), "It changes loads or masses where dots are.");
    }
}
