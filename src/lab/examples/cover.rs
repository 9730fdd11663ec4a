use dashpot_core::*; use dashpot_lab::accuracy::Sine; use dashpot_lab::records::*; use dashpot_lab::identification::*; use dashpot_lab::identification::{segment::segments, first_guess, sensitivity};
use std::collections::BTreeMap;
fn records(p:&Params, seed:u64, noise:f64)->Vec<Record>{
  let model=Model::new(p).unwrap(); let mut out=vec![]; let mut s=seed.wrapping_mul(0x9E3779B97F4A7C15)|1;
  let mut uni=||{ s^=s<<13; s^=s>>7; s^=s<<17; (s>>11) as f64/(1u64<<53) as f64};
  let mut tests=vec![]; for a in [50.,25.,15.,5.,2.,1.] { for v in [52.36,130.9,261.8,523.6,1047.2,1570.8] { let f=v/(std::f64::consts::TAU*a); if f<=25.03 {tests.push((a*1e-3,f));}}}
  for f in [0.041,0.02,0.01] {tests.push((0.01,f));}
  for (a,f) in tests { let rate=(400.*f).clamp(20.,1000.); let dt=1./rate; let per=(rate/f).round() as usize; let n=3*per+1;
    let sine=Sine{amplitude:a,frequency:f}; let m=sine.motion(); let ph=0.25/f; let mut st; let sub=4;
    let (x0,v0)=m(ph); st=model.settled(&Input::motion(x0,v0)); let mut t=vec![];let mut x=vec![];let mut v=vec![];let mut F=vec![];
    for i in 0..n { let tt=ph+i as f64*dt; if i>0 { for k in 1..=sub { let q=ph+(i as f64-1.+k as f64/sub as f64)*dt; let (xx,vv)=m(q); let (s2,o)=step(&model,&st,&Input::motion(xx,vv),dt/sub as f64); st=s2; if k==sub {F.push(o.force);} } } else {F.push(evaluate(&model,&st,&Input::motion(x0,v0)).0.force);} let (xx,vv)=m(tt); t.push(tt);x.push(xx);v.push(vv);}
    let rms=(F.iter().map(|f|f*f).sum::<f64>()/n as f64).sqrt(); let sd=noise*rms;
    for f in F.iter_mut(){ let g=(-2.*(uni()+1e-300).ln()).sqrt()*(std::f64::consts::TAU*uni()).cos(); *f+=sd*g; }
    out.push(Record{name:format!("{a}_{f:.3}"),time:t,displacement:x,velocity:v,force:F,amplitude:a,frequency:f,peak_velocity:a*f*std::f64::consts::TAU,cycles:(0..3).map(|c|c*per..(c+1)*per).collect(),noise:Noise{force_rms:sd,..Noise::default()},..Record::default()});
  } out }
fn main(){
  let mut p=Params::new(); p.set("viscous_coefficient",0.).unwrap(); p.enable("viscous_friction",false).unwrap();
  if std::env::args().nth(1).as_deref()==Some("own") {
   let r=records(&p,1,0.0); let v=first_guess::velocities(&segments(&r.iter().collect::<Vec<_>>()));
   let m=Model::new(&p).unwrap(); let f:Vec<f64>=v.iter().map(|v|m.elements().fv_curve.at(*v).value).collect(); p.set_list("fv_velocity",&v).unwrap(); p.set_list("fv_force",&f).unwrap(); }
  if std::env::args().nth(3).as_deref()==Some("0") { look(&p); return; }
  let mut hit:BTreeMap<String,(u32,u32,f64,f64)>=BTreeMap::new(); let t0=std::time::Instant::now(); let n=std::env::args().nth(3).map_or(20,|a|a.parse().unwrap());
  for seed in 1..=n { let r=records(&p,seed,std::env::args().nth(2).map_or(0.01,|a|a.parse().unwrap())); let f=fit(&r.iter().collect::<Vec<_>>(),&FitOptions::default(),|_|()).unwrap();
    if seed<3 {println!("{:?} {:?} misfit {}",f.choices.iter().map(|c|c.chosen).collect::<Vec<_>>(), f.notes, f.misfit);}
    let truth=Model::new(&p).unwrap();
    for e in &f.estimates { let (Some(lo),Some(hi))=(e.low,e.high) else {*hit.entry(format!("{} NOT",e.name)).or_default()=(0,0,0.,0.);continue}; let tv=match e.index {None=>p.scalar(e.name), Some(k)=> if e.name=="fv_force" {truth.elements().fv_curve.at(f.params.list("fv_velocity")[k]).value} else {f64::NAN}};
      let h=hit.entry(format!("{}{}",e.name,e.index.map_or(String::new(),|i|format!("[{i:02}]")))).or_default(); h.1+=1; if lo<=tv&&tv<=hi {h.0+=1;} h.2+=(e.value-tv)/n as f64; h.3+=(hi-lo)/2./n as f64; }
  }
  for (k,v) in hit {println!("{k:34} {}/{} bias {:.4} half {:.4}",v.0,v.1,v.2,v.3);}
  println!("{:?}",t0.elapsed());
}
#[allow(dead_code)] pub fn look(p:&Params){ let r=records(p,1,0.0); let m=Model::new(p).unwrap(); for s in segments(&r.iter().collect::<Vec<_>>()) { let f=sensitivity::forces(&m,&s); let n=s.force.len(); let e:Vec<f64>=(s.from..n).map(|i|f[i]-s.force[i]).collect(); let x:Vec<f64>=(s.from..n).map(|i|s.input[i].displacement.unwrap()).collect(); let v:Vec<f64>=(s.from..n).map(|i|s.input[i].velocity).collect(); let rms=(e.iter().map(|e|e*e).sum::<f64>()/e.len() as f64).sqrt(); let cx=e.iter().zip(&x).map(|(a,b)|a*b).sum::<f64>()/x.iter().map(|a|a*a).sum::<f64>()*s.amplitude; let cv=e.iter().zip(&v).map(|(a,b)|a*b).sum::<f64>()/v.iter().map(|a|a*a).sum::<f64>()*s.peak_velocity; println!("{} dt {:.4} rms {:.4} in x {:.4} in v {:.4} scale {:.2}",s.name,s.dt[1],rms,cx,cv,s.scale);} }
