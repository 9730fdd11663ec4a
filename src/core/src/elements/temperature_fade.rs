//! Temperature fade: warm oil damps less.

use crate::dual::Real;
use crate::element::Prepare;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Temperature fade of the laminar part of the FV force F_d, by the factor exp(−α (T − T_0)/(1 + κ (T − T_0))).
///
/// The factor is the viscosity of the oil at the temperature T relative to that at T_0, the temperature of the FV
/// curve. α is the relative fall per kelvin at T_0, 1/K, and κ, 1/K, lowers it at higher temperatures. The laminar part
/// is 1/(1 + |F_d|/F_l) of F_d, half of it at the force F_l; orifices and blow-off valves do not depend on the
/// viscosity. κ = 0 gives an exponential, κ = 1/(T_0 + C) Vogel's law (Phys. Z. 22, 1921), with C about 95 °C for
/// damper oils. T is the temperature from the host, or the ambient temperature plus the rise ϑ by self-heating. The
/// rise satisfies C_h dϑ/dt = F_h (w + b) − h ϑ, with the heat capacity C_h, J/K, and the heat transfer h, W/K. F_h is
/// the hydraulic force, w the oil velocity at the valves, and b the flow parallel to the valves, as a piston velocity.
#[derive(Clone, Copy, Debug)]
pub struct TemperatureFade {
    coefficient: f64,
    /// Parameter κ, 1/K, which reduces the fall per kelvin at higher temperatures.
    slackening: f64,
    reference: f64,
    /// One over the force F_l at which half of the force is laminar, 1/N; 0 if all of it is.
    per_laminar: f64,
    /// One over the heat capacity, 1/C_h, K/J.
    pub(crate) per_capacity: f64,
    /// Cooling rate: heat transfer over heat capacity, h/C_h, 1/s.
    pub(crate) cooling: f64,
    pub(crate) heats_itself: bool,
}

/// Value of `fade_laminar_force`, N, from which on the whole FV force fades.
const ALL: f64 = 1e9;
/// Largest magnitude of the exponent of the fade factor, which is clamped: e³ is a factor of twenty, more than any
/// damper shows.
const LARGEST: f64 = 3.0;
/// Smallest value of the denominator 1 + κ (T − T_0), which is clamped. The law has a pole far below the reference
/// temperature T_0, where the oil becomes a wax.
const STIFFEST: f64 = 0.05;

impl Describe for TemperatureFade {
    const MEANING: &'static str =
        "temperature fade: damping that decreases with the oil temperature, measured or from self-heating";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice(
            "fade_source",
            &["measured", "self_heating"],
            "oil temperature: measured, or ambient temperature plus computed self-heating",
        ),
        Parameter::scalar(
            "fade_coefficient",
            "1/K",
            &[0.003],
            (-0.02, 0.2),
            "relative decrease of the damping per kelvin, alpha",
        ),
        Parameter::scalar(
            "fade_reference",
            "degC",
            &[20.0],
            (-60.0, 200.0),
            "reference temperature of the FV curve, T_0",
        ),
        Parameter::scalar(
            "heat_capacity",
            "J/K",
            &[1500.0],
            (50.0, 1e5),
            "heat capacity of the oil and the damper body, C_h",
        )
        .in_form("fade_source", &["self_heating"]),
        Parameter::scalar(
            "heat_transfer",
            "W/K",
            &[6.0],
            (0.0, 1e3),
            "heat flow to the surroundings per kelvin of temperature difference, h",
        )
        .in_form("fade_source", &["self_heating"]),
        Parameter::scalar(
            "fade_laminar_force",
            "N",
            &[ALL],
            (10.0, ALL),
            "FV force of which half is laminar and fades, F_l; large: all of it fades",
        )
        .none_at_most(),
        Parameter::scalar(
            "fade_slackening",
            "1/K",
            &[0.0],
            (0.0, 0.03),
            "temperature dependence of the decrease, kappa; 0: exponential law, 1/(T_0 + 95 degC): Vogel's law",
        ),
    ];
}

impl Prepare for TemperatureFade {
    const OFF: Self = TemperatureFade {
        coefficient: 0.0,
        slackening: 0.0,
        reference: 0.0,
        per_laminar: 0.0,
        per_capacity: 0.0,
        cooling: 0.0,
        heats_itself: false,
    };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let per_capacity = 1.0 / p.number(own!("heat_capacity"));
        Ok(TemperatureFade {
            coefficient: p.number(own!("fade_coefficient")),
            slackening: p.number(own!("fade_slackening")),
            reference: p.number(own!("fade_reference")),
            per_laminar: if p.number(own!("fade_laminar_force")) < ALL {
                1.0 / p.number(own!("fade_laminar_force"))
            } else {
                0.0
            },
            per_capacity,
            cooling: p.number(own!("heat_transfer")) * per_capacity,
            heats_itself: p.number(own!("fade_source")) == 1.0,
        })
    }
}

impl TemperatureFade {
    /// Returns whether the whole FV force fades, whatever its size.
    #[inline(always)]
    pub(crate) fn is_of_all(&self) -> bool {
        self.per_laminar == 0.0
    }

    /// Computes the faded FV force, N, from the FV force `force`; `factor` is the factor on its laminar part.
    #[inline(always)]
    pub(crate) fn force<R: Real>(&self, force: R, factor: R) -> R {
        force * (factor.plus(-1.0) * self.laminar(force)).plus(1.0)
    }

    /// Computes the laminar fraction of a force F, 1/(1 + |F|/F_l): half at the force F_l.
    #[inline(always)]
    pub(crate) fn laminar<R: Real>(&self, force: R) -> R {
        (force.abs() * self.per_laminar).plus(1.0).inverse()
    }

    /// Computes the factor of the laminar part at the temperature `given`, °C, plus the self-heating `rise`, K.
    #[inline(always)]
    pub(crate) fn factor<R: Real>(&self, given: f64, rise: R) -> R {
        let above = rise.plus(given - self.reference);
        let mut exponent = -(above * self.coefficient);
        if self.slackening > 0.0 {
            let slack = (above * self.slackening).plus(1.0);
            let slack = if slack.value() > STIFFEST { slack } else { R::constant(STIFFEST) };
            exponent = exponent * slack.inverse();
        }
        let at = exponent.value();
        if at > LARGEST {
            R::constant(LARGEST).exp()
        } else if at < -LARGEST {
            R::constant(-LARGEST).exp()
        } else {
            exponent.exp()
        }
    }
}
