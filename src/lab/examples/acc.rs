use dashpot_core::*; use dashpot_core::step::*; use dashpot_lab::accuracy::*;
fn main(){
 let mut tests=vec![]; for a in [50.,40.,30.,25.,15.,5.,2.,1.] { for v in [52.36,130.9,261.8,392.7,523.6,1047.2,1570.8] { let f=v/(std::f64::consts::TAU*a); if f<=25.03 {tests.push(Sine{amplitude:a*1e-3,frequency:f});}}}
 tests.push(Sine{amplitude:0.001,frequency:25.0}); tests.push(Sine{amplitude:0.01,frequency:25.0});
 tests.push(Sine{amplitude:0.01,frequency:0.041});
 for (ks,cs,m,kp) in [(3e6,200.,0.5,1e4),(1e7,200.,0.1,1e4),(1e6,0.,1.0,5e4),(3e5,500.,2.0,1e4),(2e7,1000.,0.05,1e5),(2e7,200.,0.05,1e5),(1e7,200.,0.1,1e5),(1e7,5000.,0.1,1e5)] {
 let mut p=Params::new(); p.set("series_stiffness",ks).unwrap();p.set("series_damping",cs).unwrap();p.set("internal_mass",m).unwrap();p.set("spring_quadratic",kp).unwrap();
 let model=Model::new(&p).unwrap();
 let t=std::time::Instant::now();
 let r=References::solve(&model,&tests,0.00025); println!("ks {ks} cs {cs} m {m}: ref {:?}",t.elapsed());
 for (name,method) in [("fourth",Method::Fourth),("third",Method::Third)] { for n in [1,2,3,4] {
  let mm=model.with_integration(Integration{method,substeps:n});
  let a=r.compare(&mm,1e-3,Given::Motion); let b=worst(&r.compare(&mm,2.5e-4,Given::Motion)); let c=worst(&r.compare(&mm,1e-3,Given::Velocity)); let w=worst(&a);
  println!("{name} {n}: 1ms rms {:.4}% max {:.3}% | .25ms rms {:.5}% max {:.4}% | vel rms {:.3}% max {:.3}%",w.rms*100.,w.largest*100.,b.rms*100.,b.largest*100.,c.rms*100.,c.largest*100.);
 }}}
}
