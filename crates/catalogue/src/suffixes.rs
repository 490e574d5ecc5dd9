//! Prefixes and suffixes of a designation, before and after its basic number.
//!
//! Sources: DIN 623-1 (seals, snap rings, cages, tolerance and clearance classes); the designation systems in the
//! catalogues of SKF, Schaeffler (FAG), NSK, NTN and Koyo.

use crate::ClearanceGroup;

/// A part of a designation, as it was understood.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// As it stands in the designation, in capitals.
    pub text: String,
    /// Its meaning, with what the case makes of it.
    pub meaning: &'static str,
}

impl Part {
    /// True for seals and shields.
    pub(crate) fn closes(&self) -> bool {
        [SHIELD, LOW_SEAL, SEAL].contains(&self.meaning)
    }
}

/// The effect of a suffix on a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Effect {
    /// None: the models have no part for it.
    None,
    /// Radial internal clearance.
    Clearance(ClearanceGroup),
    /// Nominal contact angle, degrees.
    Angle(f64),
    /// Balls of silicon nitride.
    Ceramic,
    /// More than one bearing.
    Several,
}

/// The bearings that a suffix belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    /// All.
    Any,
    /// Deep-groove bearings.
    DeepGroove,
    /// Angular-contact bearings.
    Angular,
}

/// A suffix with its meaning.
pub(crate) struct Suffix {
    pub text: &'static str,
    pub of: Of,
    pub effect: Effect,
    pub meaning: &'static str,
}

const fn any(text: &'static str, meaning: &'static str) -> Suffix {
    Suffix { text, of: Of::Any, effect: Effect::None, meaning }
}

const fn deep(text: &'static str, meaning: &'static str) -> Suffix {
    Suffix { text, of: Of::DeepGroove, effect: Effect::None, meaning }
}

const fn angular(text: &'static str, meaning: &'static str) -> Suffix {
    Suffix { text, of: Of::Angular, effect: Effect::None, meaning }
}

const fn clearance(text: &'static str, group: ClearanceGroup, meaning: &'static str) -> Suffix {
    Suffix { text, of: Of::DeepGroove, effect: Effect::Clearance(group), meaning }
}

const fn angle(text: &'static str, degrees: f64, meaning: &'static str) -> Suffix {
    Suffix { text, of: Of::Angular, effect: Effect::Angle(degrees), meaning }
}

const fn several(text: &'static str) -> Suffix {
    let meaning = "a set of bearings: give one of them to `tribodyn set`, or its case to `tribodyn pair`";
    Suffix { text, of: Of::Angular, effect: Effect::Several, meaning }
}

const fn ceramic(text: &'static str) -> Suffix {
    Suffix { text, of: Of::Any, effect: Effect::Ceramic, meaning: "balls of silicon nitride" }
}

const SHIELD: &str = "metal shield, without effect in the models";
const LOW_SEAL: &str = "low-friction seal; its friction is not in the models";
const SEAL: &str = "contact seal; its friction is not in the models";
const RING: &str = "snap ring or its groove in the outer ring, without effect in the models";
const BRASS: &str = "machined brass cage: put its mass and clearances into the section cage";
const POLYAMIDE: &str = "moulded polyamide cage, as the section cage assumes";
const PHENOLIC: &str = "machined cage of laminated phenolic resin: put its mass and clearances into the section cage";
const STEEL_CAGE: &str = "pressed steel cage: put its mass and clearances into the section cage";
const PEEK: &str = "moulded PEEK cage: put its mass and clearances into the section cage";
const CLASS: &str = "tolerance class, without effect in the models";
const HEAT: &str = "rings stabilised for higher temperature, without effect in the models";
const GREASE: &str = "grease fill: put its oil into the case";
const UNIVERSAL: &str = "ground for mounting in any arrangement, without effect on a single bearing";
const PRELOAD: &str = "preload class of a set, without effect on a single bearing";
const DESIGN: &str = "internal design of the maker; its balls may differ from those of the list";
const NOISE: &str = "vibration class, without effect in the models";

/// The longest that fits is taken.
#[rustfmt::skip]
pub(crate) const SUFFIXES: &[Suffix] = &[
    deep("2ZR", SHIELD), deep("ZZ1", SHIELD), any("ZZ", SHIELD), any("2Z", SHIELD), deep("ZNR", RING), deep("ZN", RING), deep("ZR", SHIELD), deep("Z", SHIELD),
    any("2RS1", SEAL), deep("2RSH2", SEAL), deep("2RSH", SEAL), deep("2RSL", LOW_SEAL), deep("2RSR", SEAL), deep("2RST", SEAL), any("2RZ", LOW_SEAL), deep("2RU", LOW_SEAL), deep("2RD", LOW_SEAL), any("2RS", SEAL),
    deep("2HRS", SEAL), deep("HRS", SEAL), deep("RS1", SEAL), deep("RSH", SEAL), deep("RSL", LOW_SEAL), deep("RSR", SEAL), deep("RZ", LOW_SEAL), deep("RS", SEAL),
    deep("LLU", SEAL), deep("LLB", LOW_SEAL), deep("LLH", LOW_SEAL), deep("LLF", LOW_SEAL), deep("LU", SEAL), deep("LB", LOW_SEAL),
    deep("DDU", SEAL), deep("DDW", SEAL), deep("DD", SEAL), deep("DU", SEAL), deep("VV", LOW_SEAL), deep("V", LOW_SEAL),
    deep("NR", RING), deep("N", RING),
    clearance("C2", ClearanceGroup::C2, "radial internal clearance smaller than normal (ISO 5753-1)"),
    clearance("CN", ClearanceGroup::Normal, "normal radial internal clearance (ISO 5753-1)"),
    clearance("C0", ClearanceGroup::Normal, "normal radial internal clearance (ISO 5753-1)"),
    clearance("C3", ClearanceGroup::C3, "radial internal clearance larger than normal (ISO 5753-1)"),
    clearance("C4", ClearanceGroup::C4, "radial internal clearance larger than C3 (ISO 5753-1)"),
    clearance("C5", ClearanceGroup::C5, "radial internal clearance larger than C4 (ISO 5753-1)"),
    clearance("P63", ClearanceGroup::C3, "tolerance class P6 with clearance group C3"),
    clearance("P62", ClearanceGroup::C2, "tolerance class P6 with clearance group C2"),
    clearance("P53", ClearanceGroup::C3, "tolerance class P5 with clearance group C3"),
    clearance("P52", ClearanceGroup::C2, "tolerance class P5 with clearance group C2"),
    angle("ACE", 25.0, "contact angle 25°, high-speed design of the maker: its balls may be smaller than those of the list"),
    angle("ACD", 25.0, "contact angle 25°"), angle("ACB", 25.0, "contact angle 25°, high-speed design of the maker: its balls may be smaller than those of the list"),
    angle("AC", 25.0, "contact angle 25°"), angle("A5", 25.0, "contact angle 25°"),
    angle("CE", 15.0, "contact angle 15°, high-speed design of the maker: its balls may be smaller than those of the list"),
    angle("CD", 15.0, "contact angle 15°"), angle("CB", 15.0, "contact angle 15°, high-speed design of the maker: its balls may be smaller than those of the list"),
    angle("BECB", 40.0, "contact angle 40°, reinforced, ground for mounting in any arrangement"),
    angle("BEGA", 40.0, "contact angle 40°, reinforced, ground for sets with light preload"), angle("BEGB", 40.0, "contact angle 40°, reinforced, ground for sets with moderate preload"),
    angle("BECA", 40.0, "contact angle 40°, reinforced, ground for mounting in any arrangement"),
    angle("BE", 40.0, "contact angle 40°, reinforced"),
    angle("C", 15.0, "contact angle 15°"), angle("B", 40.0, "contact angle 40°"), angle("A", 30.0, "contact angle 30°"),
    several("QBC"), several("QBT"), several("QFC"), several("TBT"), several("TFT"), several("DBD"), several("DFD"), several("DBT"), several("DFT"), several("DTD"), several("DB"), several("DF"), several("DT"),
    angular("DUL", UNIVERSAL), angular("DU", UNIVERSAL), angular("SUL", UNIVERSAL), angular("SU", UNIVERSAL), angular("UL", PRELOAD), angular("UM", PRELOAD), angular("UH", PRELOAD), angular("UA", UNIVERSAL), angular("UO", UNIVERSAL), angular("U", UNIVERSAL),
    angular("GA", PRELOAD), angular("GB", PRELOAD), angular("GC", PRELOAD), angular("DGA", PRELOAD), angular("DGB", PRELOAD), angular("DGC", PRELOAD), angular("DG", UNIVERSAL), angular("G", UNIVERSAL),
    angular("EL", PRELOAD), angular("PH", PEEK),
    any("TYN", POLYAMIDE), any("TVP2", POLYAMIDE), any("TVP", POLYAMIDE), any("TVH", POLYAMIDE), any("TNHA", PEEK), any("TNH", PEEK), any("TN9", POLYAMIDE), any("TN", POLYAMIDE), any("T1X", POLYAMIDE), any("T2X", POLYAMIDE), any("TPA", PHENOLIC), any("TR", PHENOLIC), any("ETN9", POLYAMIDE), any("T", PHENOLIC),
    any("MPA", BRASS), any("MP", BRASS), any("MA", BRASS), any("MB", BRASS), any("MS", BRASS), any("M", BRASS), any("JP", STEEL_CAGE), any("J", STEEL_CAGE), any("Y", "pressed brass cage: put its mass and clearances into the section cage"), any("W", STEEL_CAGE),
    any("P4A", CLASS), any("P4S", CLASS), any("PA9A", CLASS), any("PA9", CLASS), any("P7", CLASS), any("P6X", CLASS), any("P6", CLASS), any("P5", CLASS), any("P4", CLASS), any("P3", CLASS), any("P2", CLASS), any("P0", CLASS), any("PN", CLASS), any("ABEC1", CLASS), any("ABEC3", CLASS), any("ABEC5", CLASS), any("ABEC7", CLASS), any("ABEC9", CLASS),
    angular("P", POLYAMIDE), angular("L", PRELOAD),
    any("S0", HEAT), any("S1", HEAT), any("S2", HEAT), any("S3", HEAT), any("S4", HEAT),
    any("LHT23", GREASE), any("MT33", GREASE), any("MT47", GREASE), any("GJN", GREASE), any("WT", GREASE), any("HT", GREASE), any("2AS", GREASE), any("NS7S", GREASE), any("NS7", GREASE), any("AS2S", GREASE), any("5K", GREASE),
    ceramic("HC5"), ceramic("HC"), ceramic("HN"),
    deep("E", DESIGN), deep("R", DESIGN), deep("A", DESIGN), deep("C", DESIGN),
    any("XL", "current design of the maker"), any("V1", NOISE), any("V2", NOISE), any("V3", NOISE), any("Q6", NOISE), any("Q66", NOISE),
];

/// Words in front of a basic number: what they stand for, and whether the balls are ceramic.
#[rustfmt::skip]
pub(crate) const PREFIXES: &[(&str, Effect, &str)] = &[
    ("HCB", Effect::Ceramic, "spindle bearing with balls of silicon nitride"),
    ("HCS", Effect::Ceramic, "spindle bearing with balls of silicon nitride, sealed"),
    ("HC", Effect::Ceramic, "balls of silicon nitride"),
    ("BSS", Effect::None, "spindle bearing, sealed"),
    ("SS", Effect::None, "rings and balls of stainless steel: their modulus and density are those of 100Cr6 within 3 %"),
    ("S", Effect::None, "sealed, or of stainless steel, by maker"),
    ("W", Effect::None, "rings and balls of stainless steel: their modulus and density are those of 100Cr6 within 3 %"),
    ("B", Effect::None, "spindle bearing"),
    ("SKF", Effect::None, "the maker"), ("FAG", Effect::None, "the maker"), ("NSK", Effect::None, "the maker"), ("NTN", Effect::None, "the maker"),
    ("KOYO", Effect::None, "the maker"), ("SNR", Effect::None, "the maker"), ("NKE", Effect::None, "the maker"), ("NACHI", Effect::None, "the maker"), ("ORS", Effect::None, "the maker"), ("FBJ", Effect::None, "the maker"),
];

/// Allowed suffixes of deep-groove bearings, as messages list them.
pub(crate) const DEEP_GROOVE_ALLOWED: &str = "seals and shields (Z, ZZ, 2Z, RS, 2RS, 2RS1, 2RSH, 2RSR, 2RZ, 2HRS, LLU, LLB, DD, DDU, VV), a snap ring (N, NR, ZNR), clearance (C2, CN, C3, C4, C5), cages (M, MA, MB, TN9, TVH, TVP, T, J, Y), tolerance classes (P6, P5, P4, P2, P63), ceramic balls (HC5), heat stabilisation (S0 to S4), grease (MT33, MT47, GJN, WT, 2AS, 5K)";
/// Allowed suffixes of angular-contact bearings, as messages list them.
pub(crate) const ANGULAR_ALLOWED: &str = "the contact angle (C and CD 15°, AC, ACD and A5 25°, A 30°, B, BE and BECB 40°), universal or preloaded grinding (U, UL, UM, UA, DU, DUL, SU, G, GA, GB, GC), cages (M, MA, MP, TVP, TYN, TR, T, P, J, JP, Y, W), tolerance classes (P6 to P2, P4A, P4S, PA9A), seals (2RS, 2RZ), ceramic balls (HC)";
