use dashpot_core::*; use dashpot_core::step::*;
fn main(){ let n:usize=std::env::args().nth(1).unwrap().parse().unwrap(); let m=std::env::args().nth(2).unwrap(); let k:u32=std::env::args().nth(3).unwrap().parse().unwrap();
 let model=Model::new(&Params::new()).unwrap().with_integration(Integration::fixed(match m.as_str(){"e"=>Method::Euler,"s"=>Method::Second,_=>Method::Fourth},k));
 let xs:Vec<(f64,f64)>=(0..4096).map(|i|{let t=i as f64*1e-3;let w=9.42; (0.03*(w*t).sin()+0.004*(81.7*t+1.).sin(),0.03*w*(w*t).cos()+0.004*81.7*(81.7*t+1.).cos())}).collect();
 let mut s=model.settled(&Input::motion(xs[0].0,xs[0].1)); let mut acc=0.; let mut o=Output::ZERO;
 let t=std::time::Instant::now();
 for i in 0..n { let (x,v)=xs[i&4095]; let f=s; step_into(&model,&f,&Input::motion(x,v),1e-3,&mut s,&mut o); acc+=o.force+o.force_by_displacement+o.force_by_velocity; }
 println!("{acc} {:.1} ns",t.elapsed().as_nanos() as f64/n as f64);
}
