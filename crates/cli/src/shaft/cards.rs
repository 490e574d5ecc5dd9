//! What other programs read: tables, coefficients for rotor programs, springs for finite elements.

use crate::failure::Failure;
use std::fmt::Write;
use std::path::Path;
use tribodyn_study::shaft::{LifeAnswer, Running, ShaftAnswer, ShaftFile};

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

/// Tangent coefficients of each bearing about its equilibrium at each speed, under the names of ROSS's
/// `BearingElement`: frequency is the speed in rad/s.
pub fn ross(file: &ShaftFile, life: &LifeAnswer, speeds_rpm: &[f64]) -> Result<String, Failure> {
    let mut text = "bearing,node,frequency,kxx,kxy,kyx,kyy,kzz,cxx,cyy\n".to_owned();
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

/// Springs between pairs of nodes, shaft and seat, at one place on the shaft's axis: the diagonal of each bearing's
/// stiffness, SI. Both programs' linear springs couple no freedoms: what the diagonal leaves out stands in comments.
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
    for (index, bearing) in life.duties[0].shaft.bearings.iter().enumerate() {
        let (shaft, seat) = (2 * index + 1, 2 * index + 2);
        let _ = writeln!(text, "{comment} {}: node {shaft} on the shaft, node {seat} in the housing", bearing.name);
        for row in &bearing.stiffness {
            let numbers = row.iter().map(|k| format!("{k:.6e}")).collect::<Vec<_>>().join(", ");
            let _ = writeln!(text, "{comment} {numbers}");
        }
        match format {
            Format::CalculiX => {
                let z = bearing.position_m;
                let _ = writeln!(text, "*NODE\n{shaft}, 0., 0., {z}\n{seat}, 0., 0., {z}");
            }
            Format::Nastran => {
                for node in [shaft, seat] {
                    let z = format!("{:.4}", bearing.position_m);
                    let _ = writeln!(text, "GRID,{node},,0.,0.,{z}");
                }
            }
        }
        for (k, row) in bearing.stiffness.iter().enumerate() {
            let (element, freedom, value) = (5 * index + k + 1, k + 1, row[k]);
            let _ = match format {
                Format::CalculiX => writeln!(
                    text,
                    "*ELEMENT, TYPE=SPRING2, ELSET=BEARING{index}_{freedom}\n{element}, {shaft}, {seat}\n\
                     *SPRING, ELSET=BEARING{index}_{freedom}\n{freedom}, {freedom}\n{value:.9e}"
                ),
                Format::Nastran => {
                    writeln!(text, "CELAS2,{element},{:.3E},{shaft},{freedom},{seat},{freedom}", value)
                }
            };
        }
    }
    text
}
