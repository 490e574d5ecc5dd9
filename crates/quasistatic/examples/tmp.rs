//! tmp
use tribodyn_bearing::Bearing;
use tribodyn_bearing::case::{Case, set_value};
use tribodyn_quasistatic::{Model, OperatingPoint, RingFreedom, solve, solve_from};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let n: usize = a[2].parse().unwrap();
    let mut text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    if let Some(v) = a.get(3) { text = set_value(&text, "traction.patch", v).unwrap(); }
    let case = Case::from_ron(&text).unwrap();
    let bearing = Bearing::new(&case).unwrap();
    let point = OperatingPoint::new(&case);
    let d = match a[1].as_str() { "nearer" => 0.1, _ => 1.0 };
    let mut other = point.clone();
    if let RingFreedom::Loaded(load) = &mut other.ring[0] { *load *= 1.0 + 0.02 * d; }
    other.inner_speed *= 1.0 + 0.01 * d;
    let here = solve(&bearing, &point, Model::Traction).unwrap();
    let there = solve(&bearing, &other, Model::Traction).unwrap();
    eprintln!("rule {:?} cold {:?} {:?}", here.warm_start.as_ref().unwrap().rule(), here.statistics, there.statistics);
    let (h, t) = (here.warm_start.unwrap(), there.warm_start.unwrap());
    eprintln!("warm {:?} {:?}", solve_from(&bearing, &other, &h).unwrap().statistics, solve_from(&bearing, &point, &t).unwrap().statistics);
    let clock = std::time::Instant::now();
    for i in 0..n {
        match a[1].as_str() {
            "cold" => { std::hint::black_box(solve(&bearing, &point, Model::Traction).unwrap()); }
            _ if i % 2 == 0 => { std::hint::black_box(solve_from(&bearing, &other, &h).unwrap()); }
            _ => { std::hint::black_box(solve_from(&bearing, &point, &t).unwrap()); }
        }
    }
    eprintln!("{} ms each", clock.elapsed().as_secs_f64() * 1e3 / n.max(1) as f64);
}
