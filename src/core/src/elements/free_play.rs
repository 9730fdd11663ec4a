//! Free play (backlash) in an eye or mount, in line with the series spring.

use crate::element::Prepare;
use crate::elements::soft_gap::SoftGap;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// d(F) = F/k_s + g F/(|F| + F_0): between its contacts the eye moves freely by 2 g. The series damping acts in
/// proportion to the stiffness there is, so it vanishes in the gap.
#[derive(Clone, Copy, Debug)]
pub struct FreePlay(pub(crate) SoftGap);

impl Describe for FreePlay {
    const MEANING: &'static str = "free play in an eye or mount; needs series_compliance";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("free_play_gap", "m", &[2e-4], (0.0, 5e-3), "free travel from contact to contact, 2 g"),
        Parameter::scalar(
            "free_play_force",
            "N",
            &[20.0],
            (0.1, 1e4),
            "force at which the gap is half closed, F_0: softness of the contact",
        ),
    ];
}

impl Prepare for FreePlay {
    const OFF: Self = FreePlay(SoftGap::CLOSED);

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(FreePlay(SoftGap {
            gap: 0.5 * p.number(own!("free_play_gap")),
            softness: p.number(own!("free_play_force")),
        }))
    }
}
