//! Claims of the dynamic model: listed, not decided.

use super::row::{Evidence, Row, Stated, Verdict};

/// Every claim of the paper's transient sections, in its order.
const CLAIMS: [(&str, &str); 25] = [
    ("F13.1", "outer-race passing frequency in the outer-ring acceleration 1260 Hz (test 1254 Hz, 0.48 %)"),
    ("F13.2", "settles within about 0.1 s from the quasi-static start; acceleration amplitude about 5 m/s²"),
    ("F13.3", "orbital speed of a ball between 5810 and 5844 r/min over an orbit"),
    ("F19.1", "peak outer-ring acceleration 8.41 m/s² (Ag), 22.65 m/s² (PTFE)"),
    ("F19.2", "orbital speed repeats every 0.0103 s"),
    ("F19.3", "impacts between 245° and 330°, on the way from light to heavy zone"),
    ("F19.4", "acceleration spectrum: cage frequency and its harmonics only"),
    ("F20.1", "loads and angles do not depend on the coating"),
    ("F20.2", "|ξ| larger with PTFE than with Ag; |ξ_o| well above |ξ_i|; outer spin ratio below inner"),
    ("F21.1", "ball–race wear with PTFE well above Ag"),
    ("F21.2", "ball–race wear higher in the heavy zone although |ξ| is lower there"),
    ("F22.1.text", "ring acceleration rises with axial load (section 5.2.2)"),
    ("F22.1.conclusion", "ring vibration falls with axial load (conclusion 3)"),
    ("F22.2", "orbital speed falls as axial load falls"),
    ("F22.3", "first impact at about 310°, 290°, 260°, 240° at 25, 50, 75, 100 % of the axial load"),
    ("F22.4", "x direction most sensitive to axial load"),
    ("F23.1.load", "angles and loads rise with axial load"),
    ("F23.1.slip", "|ξ| falls as axial load rises"),
    ("F23.2.text", "peak ball–cage force grows with axial load (text on Fig. 23d)"),
    ("F23.2.fig24", "peak ball–cage force falls with axial load (text on Fig. 24)"),
    ("F24.1.race", "ball–race wear rises with axial load"),
    ("F24.1.cage", "ball–cage wear falls as axial load rises"),
    ("F13.3/T4.dyn", "range 5810–5844 r/min against a mean of 5799 r/min: they exclude each other"),
    ("F13.1/T4.dyn", "1260 Hz is 5815 r/min over 13 balls, against 5799 r/min"),
    ("F19.4/F13.2", "cage frequency only, against a single line at 13 times the cage frequency"),
];

pub fn not_yet() -> Vec<Row> {
    let row = |&(id, text): &(&str, &'static str)| Row {
        id: id.to_owned(),
        evidence: Evidence::Validation,
        quantity: "dynamic model".to_owned(),
        published: Stated::Text(text),
        computed: None,
        unit: "",
        deviation: None,
        tolerance: None,
        verdict: Verdict::NotYet,
        note: String::new(),
        decimals: 3,
    };
    CLAIMS.iter().map(row).collect()
}
