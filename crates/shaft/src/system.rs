//! A shaft in its bearings and their housings.

use crate::element::FREEDOMS;
use crate::error::ShaftError;
use crate::ring::{Held, RingForce, Vector};
use crate::rotor::Shaft;
use faer::Mat;
use tribodyn_quasistatic::StiffnessMatrix;

/// A bearing on the shaft.
pub struct Support<'a> {
    /// Node at the bearing's middle.
    pub node: usize,
    /// True if the bearing carries a shaft pushed along +z; else it is the mirror image and carries one pushed along
    /// −z.
    pub carries_plus_z: bool,
    /// How far its inner ring is pushed into the load side when the shaft has not moved, m: preload, or below 0 play.
    pub offset: f64,
    /// The bearing.
    pub ring: Box<dyn RingForce + 'a>,
    /// Where its outer ring sits.
    pub seat: Seat,
}

/// The seat of an outer ring.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Seat {
    /// Stiffness of the housing; absent for a rigid one, or where the housing of the system has a matrix.
    pub stiffness: Option<StiffnessMatrix>,
    /// Displacement without load, by heat or misalignment: m and rad.
    pub displaced: Vector,
    /// Force along z (N) of a spring on an outer ring that slides in its seat; absent where the seat holds it.
    pub slides: Option<f64>,
    /// Mass of the housing about the seat, kg; absent for one that follows at once.
    pub mass: Option<f64>,
}

/// A shaft, what it runs in, and what loads it.
pub struct System<'a> {
    /// The shaft.
    pub shaft: Shaft,
    /// Its bearings.
    pub supports: Vec<Support<'a>>,
    /// Rows of the stiffness over the freedoms of all seats, in their order, of a housing that couples them.
    pub housing: Option<Vec<Vec<f64>>>,
    /// Forces (N) and moments (N m) on each node.
    pub loads: Vec<Vector>,
}

/// All bearings and the shaft at a displacement.
pub(crate) struct Evaluated {
    pub held: Vec<Held>,
    /// Residual of the equilibrium: N and N m, or m and rad where a seat is held.
    pub lacking: Mat<f64>,
    /// Largest force and moment on any freedom, to judge what is lacking.
    pub size: [f64; 2],
}

impl System<'_> {
    /// Checks nodes and sizes.
    pub(crate) fn check(&self) -> Result<(), ShaftError> {
        let nodes = self.shaft.nodes();
        if let Some(support) = self.supports.iter().find(|support| support.node >= nodes) {
            return Err(ShaftError::Node { node: support.node, nodes });
        }
        let size = |found: usize, expected: usize| match found == expected {
            true => Ok(()),
            false => Err(ShaftError::Size { found, expected }),
        };
        size(FREEDOMS * self.loads.len(), FREEDOMS * nodes)?;
        self.housing.as_ref().map_or(Ok(()), |rows| {
            let expected = FREEDOMS * self.supports.len();
            rows.iter().try_for_each(|row| size(row.len(), expected)).and_then(|()| size(rows.len(), expected))
        })
    }

    /// Unknowns: five of each node, then five of each seat.
    pub(crate) fn unknowns(&self) -> usize {
        FREEDOMS * (self.shaft.nodes() + self.supports.len())
    }

    pub(crate) fn seat(&self, index: usize) -> usize {
        FREEDOMS * (self.shaft.nodes() + index)
    }

    /// True if a freedom of a seat does not give way.
    pub(crate) fn is_held(&self, index: usize, freedom: usize) -> bool {
        let seat = &self.supports[index].seat;
        let slides = freedom == 2 && seat.slides.is_some();
        !slides && seat.stiffness.is_none() && self.housing.is_none()
    }

    /// Stiffness of all housings over the freedoms of the seats; a ring that slides has none along z.
    pub(crate) fn housings(&self) -> Mat<f64> {
        let n = FREEDOMS * self.supports.len();
        let mut matrix = Mat::from_fn(n, n, |i, j| self.housing.as_ref().map_or(0.0, |rows| rows[i][j]));
        for (index, support) in self.supports.iter().enumerate() {
            let at = FREEDOMS * index;
            if let Some(stiffness) = support.seat.stiffness {
                for i in 0..FREEDOMS {
                    (0..FREEDOMS).for_each(|j| matrix[(at + i, at + j)] += stiffness[i][j]);
                }
            }
            if support.seat.slides.is_some() {
                for k in 0..n {
                    matrix[(at + 2, k)] = 0.0;
                    matrix[(k, at + 2)] = 0.0;
                }
            }
        }
        matrix
    }

    /// Signs of a bearing's freedoms seen from the shaft: a mirror image has its z and its tilts the other way.
    fn signs(&self, index: usize) -> Vector {
        let s = if self.supports[index].carries_plus_z { 1.0 } else { -1.0 };
        [1.0, 1.0, s, s, s]
    }

    /// Displacement of a bearing's inner ring against its outer one, in the bearing's own axes.
    pub(crate) fn ring_displacement(&self, index: usize, u: &Mat<f64>) -> Vector {
        let (node, seat) = (FREEDOMS * self.supports[index].node, self.seat(index));
        let signs = self.signs(index);
        let mut moved: Vector = std::array::from_fn(|k| signs[k] * (u[(node + k, 0)] - u[(seat + k, 0)]));
        moved[2] += self.supports[index].offset;
        moved
    }

    /// Force that holds the inner ring of a bearing, and its stiffness, in the shaft's axes.
    fn held(&mut self, index: usize, u: &Mat<f64>) -> Result<Held, ShaftError> {
        let (moved, signs) = (self.ring_displacement(index, u), self.signs(index));
        let found = self.supports[index].ring.at(&moved);
        let held = found.map_err(|source| ShaftError::Bearing { bearing: index, source })?;
        Ok(Held {
            force: std::array::from_fn(|k| signs[k] * held.force[k]),
            stiffness: std::array::from_fn(|i| std::array::from_fn(|j| signs[i] * signs[j] * held.stiffness[i][j])),
        })
    }

    /// Forces at a displacement under a share of the loads, with springs that centre the shaft.
    pub(crate) fn evaluate(
        &mut self,
        linear: &Mat<f64>,
        u: &Mat<f64>,
        share: f64,
        centring: &Vector,
    ) -> Result<Evaluated, ShaftError> {
        // Housings are at rest where they stand without load.
        let internal = linear * (u - self.start());
        let mut lacking = Mat::zeros(self.unknowns(), 1);
        let mut size = [0.0f64; 2];
        let mut take = |k: usize, value: f64| size[usize::from(k > 2)] = size[usize::from(k > 2)].max(value.abs());
        for node in 0..self.shaft.nodes() {
            for k in 0..FREEDOMS {
                let row = FREEDOMS * node + k;
                lacking[(row, 0)] = share * self.loads[node][k] - internal[(row, 0)];
                take(k, share * self.loads[node][k]);
            }
        }
        let mut all = Vec::with_capacity(self.supports.len());
        for index in 0..self.supports.len() {
            let held = self.held(index, u)?;
            let (node, seat) = (FREEDOMS * self.supports[index].node, self.seat(index));
            let Seat { displaced, slides, .. } = self.supports[index].seat;
            for k in 0..FREEDOMS {
                lacking[(node + k, 0)] -= held.force[k] + centring[k] * u[(node + k, 0)];
                take(k, held.force[k]);
                lacking[(seat + k, 0)] = if self.is_held(index, k) {
                    displaced[k] - u[(seat + k, 0)]
                } else {
                    let spring = if k == 2 { slides.unwrap_or(0.0) } else { 0.0 };
                    let centred = if k == 2 && slides.is_some() { centring[k] * u[(seat + k, 0)] } else { 0.0 };
                    spring - internal[(seat + k, 0)] + held.force[k] - centred
                };
            }
            all.push(held);
        }
        Ok(Evaluated { held: all, lacking, size })
    }

    /// Stiffness of shaft and housings over all unknowns.
    pub(crate) fn linear(&self) -> Mat<f64> {
        let n = self.unknowns();
        let (shaft, housings) = (self.shaft.stiffness(), self.housings());
        let edge = shaft.nrows();
        Mat::from_fn(n, n, |i, j| match (i < edge, j < edge) {
            (true, true) => shaft[(i, j)],
            (false, false) => housings[(i - edge, j - edge)],
            _ => 0.0,
        })
    }

    /// The whole tangent: shaft, housings and bearings; rows of held freedoms are those of the unit matrix.
    pub(crate) fn tangent(&self, linear: &Mat<f64>, held: &[Held], centring: &Vector) -> Mat<f64> {
        let mut matrix = linear.clone();
        for (index, held) in held.iter().enumerate() {
            let (node, seat) = (FREEDOMS * self.supports[index].node, self.seat(index));
            for i in 0..FREEDOMS {
                for j in 0..FREEDOMS {
                    let k = held.stiffness[i][j];
                    matrix[(node + i, node + j)] += k;
                    matrix[(node + i, seat + j)] -= k;
                    matrix[(seat + i, node + j)] -= k;
                    matrix[(seat + i, seat + j)] += k;
                }
                matrix[(node + i, node + i)] += centring[i];
            }
            if self.supports[index].seat.slides.is_some() {
                matrix[(seat + 2, seat + 2)] += centring[2];
            }
        }
        for index in 0..self.supports.len() {
            for k in (0..FREEDOMS).filter(|&k| self.is_held(index, k)) {
                let row = self.seat(index) + k;
                (0..matrix.ncols()).for_each(|j| matrix[(row, j)] = 0.0);
                matrix[(row, row)] = 1.0;
            }
        }
        matrix
    }

    /// Where the seats stand without load.
    pub(crate) fn start(&self) -> Mat<f64> {
        let mut u = Mat::zeros(self.unknowns(), 1);
        for (index, support) in self.supports.iter().enumerate() {
            (0..FREEDOMS).for_each(|k| u[(self.seat(index) + k, 0)] = support.seat.displaced[k]);
        }
        u
    }
}

/// Sum of the forces on all nodes and of their moments about the first one.
pub fn resultant(positions: &[f64], loads: &[Vector]) -> Vector {
    let mut sum = [0.0; FREEDOMS];
    for (z, [x, y, along, mx, my]) in positions.iter().zip(loads) {
        sum = [sum[0] + x, sum[1] + y, sum[2] + along, sum[3] + mx - z * y, sum[4] + my + z * x];
    }
    sum
}
