//! Scratch.
use std::ops::ControlFlow;
use tribodyn_bearing::case::{Case, set_value};
use tribodyn_dynamics::*;
struct O { last: Option<Sample>, x: Vec<f64>, n: usize, impacts: usize, maxf: f64, orb: Vec<f64>, acc: Vec<f64> }
impl Observer for O {
    type Error = std::convert::Infallible;
    fn sample(&mut self, s: &Sample, _: bool) -> Result<ControlFlow<()>, Self::Error> {
        self.x.push(s.cage.speed_rad_s);
        self.acc.push(s.outer.acceleration_m_s2[0]);
        self.orb.push(s.balls[0].orbital_speed_rad_s * 30.0 / 3.14159265358979);
        self.maxf = s.balls.iter().fold(self.maxf, |m, b| m.max(b.pocket_force_n.abs()));
        self.n += 1;
        if self.n % 512 == 0 { let (mn,mx)=self.orb[self.n-512..].iter().fold((1e9f64,0f64),|a,&b|(a.0.min(b),a.1.max(b)));
            let a=&self.acc[self.n-512..]; let m=a.iter().sum::<f64>()/512.0; let pk=a.iter().fold(0f64,|p,v|p.max((v-m).abs()));
            let mean=self.x[self.n-512..].iter().sum::<f64>()/512.0*9.549296585;
            println!("t {:.3} cage {:.3} mean {:.3} orb {:.1}..{:.1} acc pk {:.3} pocket max {:.1} imb {:.2e} impacts {} x_i {:.3e} x_o {:.3e}", s.time_s, s.cage.speed_rad_s*9.549296585, mean, mn, mx, pk, self.maxf, s.power.imbalance_j/s.power.throughput_j.max(1e-9), self.impacts, s.inner.displacement_m[0], s.outer.displacement_m[0]); self.maxf=0.0; }
        self.last = Some(s.clone());
        Ok(ControlFlow::Continue(()))
    }
    fn event(&mut self, e: &Event) -> Result<(), Self::Error> { match &e.kind { EventKind::Impact{..} => self.impacts += 1, k => println!("{:.6} {:?}", e.time_s, k) } Ok(()) }
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let mut text = std::fs::read_to_string(&a[1]).unwrap();
    for c in &a[2..] { let (p, v) = c.split_once('=').unwrap(); text = set_value(&text, p, v).unwrap(); }
    let case = Case::from_ron(&text).unwrap();
    let t0 = std::time::Instant::now();
    let mut run = Run::new(&case).unwrap();
    println!("start {:?} rule {:?} qs {:.3} {:?}", t0.elapsed(), run.patch_rule(), run.solution().cage_speed_rpm, run.stiffness());
    let t0 = std::time::Instant::now();
    let mut o = O { last: None, x: vec![], n: 0, impacts: 0, maxf: 0.0, orb: vec![], acc: vec![] };
    let e = run.advance(f64::INFINITY, &mut o);
    println!("{e:?} {:?} for {} s: {:?}", t0.elapsed(), run.time(), run.statistics());
    if let Some(s) = o.last { println!("{:?}", s.power); }
}
