//! Where each entry of the stiffness matrix stands: node ordering, sparsity, scatter map; made once per mesh.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;
use nalgebra::{Matrix3, Matrix6};
use sprs::{CsMat, TriMat};

/// Lower triangle of the stiffness matrix of a model: freedoms are ordered node by node, six each.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// Place of each node in the order of elimination.
    pub position: Vec<usize>,
    /// Node at each place.
    pub node_at: Vec<usize>,
    /// Start of each column's entries.
    column_start: Vec<usize>,
    /// Row of each entry.
    row: Vec<usize>,
    /// Rank of the off-diagonal block of each pair of nodes of the shells (01, 02, 12) and of the beams.
    shell_block: Vec<[u32; 3]>,
    beam_block: Vec<u32>,
}

impl Pattern {
    /// Of so many nodes, and of the elements between them.
    pub fn new(count: usize, shells: &[[usize; 3]], beams: &[[usize; 2]]) -> Self {
        let shell_pairs =
            |nodes: [usize; 3]| [[nodes[0], nodes[1]], [nodes[0], nodes[2]], [nodes[1], nodes[2]]];
        let pairs: Vec<[usize; 2]> = (shells.iter().flat_map(|&nodes| shell_pairs(nodes)))
            .chain(beams.iter().copied())
            .collect();
        let position = order(count, &pairs);
        let mut node_at = vec![0; count];
        for (node, &place) in position.iter().enumerate() {
            node_at[place] = node;
        }
        let graph = graph(count, pairs.iter().map(|pair| pair.map(|node| position[node])));
        let blocks = |column: usize| {
            graph
                .outer_view(column)
                .map_or(Vec::new(), |view| view.indices().to_vec())
        };
        let mut column_start = vec![0];
        let mut row = Vec::new();
        for column in 0..count {
            let blocks = blocks(column);
            for j in 0..6 {
                row.extend((j..6).map(|i| 6 * column + i));
                row.extend(
                    blocks
                        .iter()
                        .skip(1)
                        .flat_map(|&block| (0..6).map(move |i| 6 * block + i)),
                );
                column_start.push(row.len());
            }
        }
        let rank = |[a, b]: [usize; 2]| {
            let (a, b) = (position[a], position[b]);
            let column = graph.outer_view(a.min(b));
            let found = column.and_then(|view| view.indices().binary_search(&a.max(b)).ok());
            found.unwrap_or(0) as u32
        };
        let shell_block = shells.iter().map(|&nodes| shell_pairs(nodes).map(rank)).collect();
        let beam_block = beams.iter().copied().map(rank).collect();
        Pattern {
            position,
            node_at,
            column_start,
            row,
            shell_block,
            beam_block,
        }
    }

    /// Number of freedoms.
    pub fn len(&self) -> usize {
        6 * self.position.len()
    }

    /// Whether there are no freedoms.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        self.row.len()
    }

    /// A matrix of zeros with this pattern (lower triangle, by columns).
    pub fn zeros(&self) -> CsMat<f64> {
        let size = self.len();
        CsMat::new_csc(
            (size, size),
            self.column_start.clone(),
            self.row.clone(),
            vec![0.0; self.entries()],
        )
    }

    /// The same as faer sees it.
    pub fn symbolic(&self) -> SymbolicSparseColMatRef<'_, usize> {
        SymbolicSparseColMatRef::new_checked(self.len(), self.len(), &self.column_start, None, &self.row)
    }

    /// Index of the diagonal entry of freedom `component` of `node`.
    pub fn diagonal(&self, node: usize, component: usize) -> usize {
        self.column_start[6 * self.position[node] + component]
    }

    /// Freedom of `component` of `node`.
    pub fn freedom(&self, node: usize, component: usize) -> usize {
        6 * self.position[node] + component
    }

    /// Adds the 6×6 diagonal block of a node, given by `entry(row, column)` for row ≥ column.
    pub fn add_node(&self, values: &mut [f64], node: usize, entry: impl Fn(usize, usize) -> f64) {
        for j in 0..6 {
            let start = self.diagonal(node, j);
            for i in j..6 {
                values[start + i - j] += entry(i, j);
            }
        }
    }

    /// Adds a shell's matrix, given by `entry(row, column)` of its 18 freedoms.
    pub fn add_shell(
        &self,
        values: &mut [f64],
        index: usize,
        nodes: [usize; 3],
        entry: impl Fn(usize, usize) -> f64,
    ) {
        for (a, &node) in nodes.iter().enumerate() {
            self.add_node(values, node, |i, j| entry(6 * a + i, 6 * a + j));
        }
        for (pair, [a, b]) in [[0, 1], [0, 2], [1, 2]].into_iter().enumerate() {
            let rank = self.shell_block[index][pair] as usize;
            self.add_block(values, [nodes[a], nodes[b]], rank, |i, j| {
                entry(6 * a + i, 6 * b + j)
            });
        }
    }

    /// Adds a beam's matrix, given by `entry(row, column)` of its 12 freedoms.
    pub fn add_beam(
        &self,
        values: &mut [f64],
        index: usize,
        nodes: [usize; 2],
        entry: impl Fn(usize, usize) -> f64,
    ) {
        for (a, &node) in nodes.iter().enumerate() {
            self.add_node(values, node, |i, j| entry(6 * a + i, 6 * a + j));
        }
        self.add_block(values, nodes, self.beam_block[index] as usize, |i, j| {
            entry(i, 6 + j)
        });
    }

    fn add_block(
        &self,
        values: &mut [f64],
        [a, b]: [usize; 2],
        rank: usize,
        entry: impl Fn(usize, usize) -> f64,
    ) {
        let (pa, pb) = (self.position[a], self.position[b]);
        for j in 0..6 {
            // the column belongs to the node eliminated first
            let start = self.column_start[6 * pa.min(pb) + j] + 6 - j + 6 * (rank - 1);
            for (i, value) in values[start..start + 6].iter_mut().enumerate() {
                *value += if pa > pb { entry(i, j) } else { entry(j, i) };
            }
        }
    }

    /// y = K x with the symmetric matrix whose lower triangle is `values`.
    pub fn multiply(&self, values: &[f64], x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for column in 0..x.len() {
            let range = self.column_start[column]..self.column_start[column + 1];
            let mut sum = 0.0;
            for (&row, &value) in self.row[range.clone()].iter().zip(&values[range]) {
                y[row] += value * x[column];
                if row != column {
                    sum += value * x[row];
                }
            }
            y[column] += sum;
        }
        y
    }

    /// Tᵀ K T with the symmetric matrix whose lower triangle is `values`; T turns the rotations of each node by `turn(node)`.
    pub fn congruent(&self, values: &[f64], turn: impl Fn(usize) -> Matrix3<f64>) -> Vec<f64> {
        let spread = |&node: &usize| {
            let mut t = Matrix6::<f64>::identity();
            t.fixed_view_mut::<3, 3>(3, 3).copy_from(&turn(node));
            t
        };
        let t: Vec<Matrix6<f64>> = self.node_at.iter().map(spread).collect();
        let mut turned = vec![0.0; values.len()];
        for (place, right) in t.iter().enumerate() {
            let start: [usize; 6] = std::array::from_fn(|j| self.column_start[6 * place + j]);
            let rows = &self.row[start[0]..start[1]];
            for (block, row) in rows.iter().step_by(6).enumerate() {
                let left = t[row / 6].transpose();
                if block == 0 {
                    let at = |i: usize, j: usize| start[i.min(j)] + i.max(j) - i.min(j);
                    let k = left * Matrix6::from_fn(|i, j| values[at(i, j)]) * right;
                    (0..6).for_each(|j| (j..6).for_each(|i| turned[at(i, j)] = k[(i, j)]));
                } else {
                    let at = |i: usize, j: usize| start[j] + 6 * block - j + i;
                    let k = left * Matrix6::from_fn(|i, j| values[at(i, j)]) * right;
                    (0..6).for_each(|j| (0..6).for_each(|i| turned[at(i, j)] = k[(i, j)]));
                }
            }
        }
        turned
    }

    /// Takes the held freedoms out of a matrix: their rows and columns become those of the unit matrix.
    pub fn hold(&self, values: &mut [f64], held: &[bool]) {
        for column in 0..self.len() {
            let range = self.column_start[column]..self.column_start[column + 1];
            for (&row, value) in self.row[range.clone()].iter().zip(&mut values[range]) {
                if held[row] || held[column] {
                    *value = if row == column { 1.0 } else { 0.0 };
                }
            }
        }
    }

    /// Raises the diagonal by a share of itself.
    pub fn raise_diagonal(&self, values: &mut [f64], share: f64) {
        for column in 0..self.len() {
            let at = self.column_start[column];
            values[at] += share * values[at].abs();
        }
    }
}

/// Lower triangle of the graph of nodes, with the diagonal.
fn graph(count: usize, pairs: impl Iterator<Item = [usize; 2]>) -> CsMat<u8> {
    let mut triplets = TriMat::new((count, count));
    for node in 0..count {
        triplets.add_triplet(node, node, 1_u8);
    }
    let mut seen: Vec<[usize; 2]> = pairs.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    seen.sort_unstable();
    seen.dedup();
    for [a, b] in seen {
        triplets.add_triplet(b, a, 1);
    }
    triplets.to_csc()
}

/// Order of elimination of the nodes: approximate minimum degree on their graph.
fn order(count: usize, pairs: &[[usize; 2]]) -> Vec<usize> {
    let graph = graph(count, pairs.iter().copied());
    let starts = graph.indptr().into_raw_storage().to_vec();
    let pattern = SymbolicSparseColMatRef::new_checked(count, count, &starts, None, graph.indices());
    let mut buffer = MemBuffer::new(amd::order_maybe_unsorted_scratch::<usize>(count, graph.nnz()));
    let (mut forward, mut inverse) = (vec![0; count], vec![0; count]);
    let stack = MemStack::new(&mut buffer);
    match amd::order_maybe_unsorted(
        &mut forward,
        &mut inverse,
        pattern,
        amd::Control::default(),
        stack,
    ) {
        Ok(_) => inverse,
        // only if memory indices overflow: any order will do
        Err(_) => (0..count).collect(),
    }
}
