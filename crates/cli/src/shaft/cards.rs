//! Files for other programs: tables, coefficients for rotor programs, springs for finite elements.

use crate::failure::Failure;
use std::fmt::Write;
use std::path::Path;
use tribodyn_study::shaft::{BearingAnswer, LifeAnswer, Running, ShaftAnswer, ShaftFile};

/// Kinds of spring cards.
#[derive(Clone, Copy, PartialEq)]
pub enum Format {
    CalculiX,
    Nastran,
}

impl Format {
    /// By the ending of a name.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("inp") => Ok(Self::CalculiX),
            Some("bdf" | "nas" | "dat") => Ok(Self::Nastran),
            _ => Err(Failure::Option {
                option: "springs",
                value: path.display().to_string(),
                message: "allowed is a name that ends in .inp (CalculiX), .bdf, .nas or .dat (Nastran)".to_owned(),
            }),
        }
    }
}

/// Nodes of all load cases, SI.
pub fn stations(life: &LifeAnswer) -> String {
    let mut text = "load_case,position_m,displacement_x_m,displacement_y_m,displacement_z_m,tilt_x_rad,tilt_y_rad,\
        shear_force_x_n,shear_force_y_n,axial_force_n,bending_moment_x_nm,bending_moment_y_nm,torque_nm,\
        bending_stress_pa,equivalent_stress_pa\n"
        .to_owned();
    for (index, duty) in life.duties.iter().enumerate() {
        for s in &duty.shaft.stations {
            let _ = write!(text, "{},{}", index + 1, s.position_m);
            let numbers = s.displacement_m.iter().chain(&s.tilt_rad).chain(&s.shear_force_n);
            let numbers = numbers.chain([&s.axial_force_n]).chain(&s.bending_moment_nm).chain([
                &s.torque_nm,
                &s.bending_stress_pa,
                &s.equivalent_stress_pa,
            ]);
            numbers.for_each(|v| _ = write!(text, ",{v}"));
            text.push('\n');
        }
    }
    text
}

/// Tangent coefficients of each bearing about its equilibrium at each speed, rad/s, under the names of the
/// `BearingElement` of ROSS 3.
pub fn ross(file: &ShaftFile, life: &LifeAnswer, speeds_rpm: &[f64]) -> Result<String, Failure> {
    let mut text = "bearing,node,speed,kxx,kxy,kyx,kyy,kzz,cxx,cyy\n".to_owned();
    let solved: Vec<ShaftAnswer>;
    let answers = if speeds_rpm.is_empty() {
        vec![&life.duties[0].shaft]
    } else {
        let at = |rpm: &f64| ShaftAnswer::at(file, rpm * std::f64::consts::PI / 30.0, 1.0);
        solved = speeds_rpm.iter().map(at).collect::<Result<_, _>>()?;
        solved.iter().collect()
    };
    let running = Running::new(file, file.system.speed, 1.0)?;
    for (index, spec) in file.system.bearings.iter().enumerate() {
        for answer in &answers {
            let (k, c) = (&answer.bearings[index].stiffness, spec.damping.unwrap_or(0.0));
            let (node, speed) = (running.node(spec.at), answer.speed_rpm * std::f64::consts::PI / 30.0);
            let _ = writeln!(
                text,
                "{index},{node},{speed},{},{},{},{},{},{c},{c}",
                k[0][0], k[0][1], k[1][0], k[1][1], k[2][2]
            );
        }
    }
    Ok(text)
}

/// Springs between shaft and seat, at one place on the shaft's axis: the diagonal of each bearing's stiffness, SI. Both
/// programs' linear springs couple no freedoms: what the diagonal leaves out stands in comments.
///
/// A node of CalculiX has no rotations. Each side of a bearing has a node that moves and one whose x and y are the
/// tilts: REF NODE and ROT NODE of a `*RIGID BODY` that holds the nodes of the user's seat.
pub fn springs(file: &ShaftFile, life: &LifeAnswer, format: Format) -> String {
    let comment = match format {
        Format::CalculiX => "**",
        Format::Nastran => "$",
    };
    let mut text = format!(
        "{comment} bearings of {}, tangent stiffness at {} r/min, N/m and N m/rad\n",
        file.system.name.replace('\n', " "),
        life.duties[0].shaft.speed_rpm
    );
    if format == Format::CalculiX {
        text += "** tie a seat to its nodes: *RIGID BODY, NSET=<its nodes>, REF NODE=<moves>, ROT NODE=<tilts>\n";
    }
    for (index, bearing) in life.duties[0].shaft.bearings.iter().enumerate() {
        let _ = writeln!(text, "{comment} {}, stiffness by rows, as x y z and tilts about x y:", bearing.name);
        for row in &bearing.stiffness {
            let numbers = row.iter().map(|k| format!("{k:.6e}")).collect::<Vec<_>>().join(", ");
            let _ = writeln!(text, "{comment} {numbers}");
        }
        text += &match format {
            Format::CalculiX => calculix(index, bearing),
            Format::Nastran => nastran(index, bearing),
        };
    }
    text
}

fn calculix(index: usize, bearing: &BearingAnswer) -> String {
    let [shaft, seat, shaft_tilt, seat_tilt] = [1, 2, 3, 4].map(|node| 4 * index + node);
    let mut text = format!(
        "** the shaft moves with node {shaft} and tilts with {shaft_tilt}, the seat with {seat} and {seat_tilt}\n*NODE\n"
    );
    for node in [shaft, seat, shaft_tilt, seat_tilt] {
        let _ = writeln!(text, "{node}, 0., 0., {:.9e}", bearing.position_m);
    }
    for (k, row) in bearing.stiffness.iter().enumerate() {
        // Tilts about x and y are x and y of the nodes that tilt.
        let (one, other, freedom) = if k < 3 { (shaft, seat, k + 1) } else { (shaft_tilt, seat_tilt, k - 2) };
        let (element, set) = (5 * index + k + 1, format!("BEARING{}_{}", index + 1, k + 1));
        let _ = writeln!(
            text,
            "*ELEMENT, TYPE=SPRING2, ELSET={set}\n{element}, {one}, {other}\n*SPRING, ELSET={set}\n{freedom}, \
             {freedom}\n{:.9e}",
            row[k]
        );
    }
    text
}

/// Cards of the large format, whose fields are 16 characters wide.
fn nastran(index: usize, bearing: &BearingAnswer) -> String {
    let [shaft, seat] = [2 * index + 1, 2 * index + 2];
    let mut text = format!("$ node {shaft} on the shaft, node {seat} in the housing\n");
    let fields = |name: &str, values: [String; 4], rest: [String; 2]| {
        let [a, b, c, d] = values;
        let [e, f] = rest;
        let first = format!("{name:<8}{a:>16}{b:>16}{c:>16}{d:>16}*");
        format!("{first}\n*       {}\n", format!("{e:>16}{f:>16}").trim_end())
    };
    for node in [shaft, seat] {
        let origin = || "0.".to_owned();
        let values = [node.to_string(), String::new(), origin(), origin()];
        text += &fields("GRID*", values, [format!("{:.9E}", bearing.position_m), String::new()]);
    }
    for (k, row) in bearing.stiffness.iter().enumerate() {
        let (element, freedom) = (5 * index + k + 1, k + 1);
        let values = [element.to_string(), format!("{:.8E}", row[k]), shaft.to_string(), freedom.to_string()];
        text += &fields("CELAS2*", values, [seat.to_string(), freedom.to_string()]);
    }
    text
}
