//! From a case to an operating point and to the inputs of a run.

use crate::{
    BallSpallSpec, CageChurningSpec, CageLandSpec, CageSpec, Case, CoatingSpec, FreeCageSpec, Lacking, PocketFilmSpec,
    Purpose, RecordingSpec, RingSpec, SpallSpec, SupportSpec, TiltSpec,
};
use tribodyn_bearing::{
    BallSpall, BearingError, Cage, CageForm, CageLand, CoatingState, FreeCage, GuidingLand, LandFilm, MovingCage,
    OperatingPoint, PocketFilm, Races, RingLoads, RunInputs, RunOptions, SearchWatch, Side, SolverSettings, Support,
    Supports, TiltingRing,
};
use tribodyn_wear::{BallWaves, Defect, Spall};

/// Rates where a case has no recording section: the rig's acquisition and a fifth of it.
const RATES: RecordingSpec = RecordingSpec { state_rate: 25_600.0, ball_rate: 5_120.0 };

/// Why a case gives no inputs for a model.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InputError {
    /// Parts that the case does not have.
    #[error(transparent)]
    Lacking(#[from] Lacking),
    /// Data that do not make a bearing.
    #[error(transparent)]
    Bearing(#[from] BearingError),
}

impl Case {
    /// The case's operating point; where loads or speeds are tables in time, their last row, the steady state.
    pub fn operating_point(&self) -> OperatingPoint {
        self.operating_point_at(f64::INFINITY)
    }

    /// The case's operating point with the loads and speeds of a time in s.
    pub fn operating_point_at(&self, time: f64) -> OperatingPoint {
        OperatingPoint {
            ring: self.ring.loads().at(time),
            inner_speed: self.speed.inner.at(time),
            outer_speed: self.speed.outer.at(time),
            patch: self.patch(),
            cage: self.cage.as_ref().map(CageSpec::pockets),
            numerics: self.solver_settings(),
            watch: SearchWatch::default(),
        }
    }

    /// The cage in steady motion, where the case has one; without a moment of inertia it has none.
    pub fn moving_cage(&self) -> Option<MovingCage> {
        let cage = self.cage.as_ref()?;
        let still = MovingCage {
            pockets: cage.pockets(),
            pocket_friction: cage.pocket_friction,
            pocket_damping: cage.pocket_damping,
            pocket_film: cage.pocket_film.map(PocketFilmSpec::film),
            inertia: 0.0,
            guidance: cage.land(),
        };
        Some(cage.moving().unwrap_or(still))
    }

    /// Inputs of a transient run.
    ///
    /// # Errors
    /// [`InputError::Lacking`] where the case lacks what a run needs, [`InputError::Bearing`] where its data make no
    /// bearing.
    pub fn run_inputs(&self) -> Result<RunInputs, InputError> {
        self.require(Purpose::Transient)?;
        let (Some(patch), Some(cage), Some(supports), Some(transient)) =
            (self.patch(), &self.cage, &self.supports, &self.transient)
        else {
            return Err(self.lacking(Purpose::Transient).into());
        };
        let RecordingSpec { state_rate, ball_rate } = self.rates();
        let coating = |spec: &CoatingSpec| CoatingState { thickness: spec.thickness, worn: spec.worn };
        // In oil there is no coating that could wear through.
        let none = CoatingState { thickness: 0.0, worn: 0.0 };
        let coatings = match &self.coatings {
            Some(coatings) => Races { inner: coating(&coatings.inner), outer: coating(&coatings.outer) },
            None => Races { inner: none, outer: none },
        };
        Ok(RunInputs {
            bearing: self.bearing()?,
            ring: self.ring.loads(),
            speeds: Races { inner: self.speed.inner.clone(), outer: self.speed.outer.clone() },
            free_cage: cage.free.as_ref().map(FreeCageSpec::cage),
            cage: cage.moving().ok_or_else(|| self.lacking(Purpose::Transient))?,
            supports: Supports { inner: supports.inner.support(), outer: supports.outer.support() },
            tilting: Races {
                inner: supports.tilt.map(|tilt| tilt.ring(supports.inner.mass)),
                outer: supports.outer_tilt.map(|tilt| tilt.ring(supports.outer.mass)),
            },
            coatings,
            defects: Races::from_fn(|side| self.defects_of(side)),
            spalls: Races::from_fn(|side| self.spalls_of(side)),
            ball_spalls: self.ball_spalls.iter().map(BallSpallSpec::spall).collect(),
            ball_waves: self.deviations.as_ref().map_or_else(BallWaves::default, |d| d.ball_waves.waves()),
            patch,
            numerics: self.solver_settings(),
            options: RunOptions {
                duration: transient.duration,
                start: transient.start,
                scheme: transient.scheme,
                contact_damping: transient.contact_damping,
                wear_acceleration: transient.wear_acceleration,
                state_rate,
                ball_rate,
            },
        })
    }

    /// Rates of a run's samples, also where the case has no recording section.
    pub fn rates(&self) -> RecordingSpec {
        self.recording.unwrap_or(RATES)
    }

    fn defects_of(&self, side: Side) -> Vec<Defect> {
        let of_side = self.defects.iter().filter(|d| d.race == side);
        of_side.map(|d| Defect { azimuth: d.azimuth, width: d.width, depth: d.depth, bare: d.bare }).collect()
    }

    fn spalls_of(&self, side: Side) -> Vec<Spall> {
        let spall = |s: &SpallSpec| Spall {
            azimuth: s.azimuth,
            length: s.length,
            width: s.width,
            depth: s.depth,
            edge_radius: s.edge_radius,
            across: s.across,
        };
        self.spalls.iter().filter(|s| s.race == side).map(spall).collect()
    }

    fn solver_settings(&self) -> SolverSettings {
        SolverSettings { tolerance: self.numerics.tolerance, max_iterations: self.numerics.max_iterations }
    }
}

impl RingSpec {
    /// Loads over time.
    fn loads(&self) -> RingLoads {
        let Self { x, y, z, tilt_x, tilt_y } = self.clone();
        RingLoads { x, y, z, tilt_x, tilt_y }
    }
}

impl CageSpec {
    fn pockets(&self) -> Cage {
        let Self { pocket_gap, pocket_stiffness, drag_torque, .. } = *self;
        let form = |spec: CageChurningSpec| CageForm { bore: spec.bore, outside: spec.outside, width: spec.width };
        Cage { pocket_gap, pocket_stiffness, drag_torque, form: self.churning.map(form) }
    }

    /// The cage in motion; none without a moment of inertia.
    fn moving(&self) -> Option<MovingCage> {
        Some(MovingCage {
            pockets: self.pockets(),
            pocket_friction: self.pocket_friction,
            pocket_damping: self.pocket_damping,
            pocket_film: self.pocket_film.map(PocketFilmSpec::film),
            inertia: self.inertia?,
            guidance: self.land(),
        })
    }

    /// The land that guides it.
    fn land(&self) -> Option<GuidingLand> {
        self.guidance.map(|l| GuidingLand { side: l.land, radius: l.radius, width: l.width, gap: l.gap })
    }
}

impl PocketFilmSpec {
    fn film(self) -> PocketFilm {
        PocketFilm { fill: self.fill, roughness: self.roughness }
    }
}

impl FreeCageSpec {
    fn cage(&self) -> FreeCage {
        FreeCage {
            mass: self.mass,
            transverse_inertia: self.transverse_inertia,
            unbalance: self.unbalance,
            gravity: self.gravity,
            displacement: self.displacement,
            pockets: self.pockets,
            lands: self.lands.iter().map(CageLandSpec::land).collect(),
        }
    }
}

impl CageLandSpec {
    fn land(&self) -> CageLand {
        let film = self.film.map(|film| LandFilm {
            viscosity: film.viscosity,
            density: film.density,
            fill: film.fill,
            extent: film.extent,
            roughness: film.roughness,
        });
        let Self { land: side, axial, radius, width, gap, stiffness, damping, friction, .. } = *self;
        CageLand { side, axial, radius, width, gap, stiffness, damping, friction, film }
    }
}

impl BallSpallSpec {
    fn spall(&self) -> BallSpall {
        let Self { ball, angle, latitude, length, width, depth, edge_radius } = *self;
        let spall = Spall { azimuth: 0.0, length, width, depth, edge_radius, across: 0.0 };
        BallSpall { ball, angle, latitude, spall }
    }
}

impl TiltSpec {
    fn ring(self, mass: f64) -> TiltingRing {
        let [polar_inertia, transverse_inertia] = self.inertia.of(mass);
        let Self { stiffness, damping, askew, .. } = self;
        TiltingRing { polar_inertia, transverse_inertia, stiffness, damping, askew }
    }
}

impl<const N: usize> SupportSpec<N> {
    fn support(&self) -> Support<N> {
        let Self { mass, stiffness, damping } = *self;
        Support { mass, stiffness, damping }
    }
}
