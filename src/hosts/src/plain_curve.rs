//! FV curve for hosts that use only a curve, such as readers of a property file, and CarMaker in its computation of equilibrium.
//!
//! The model's own curve represents only the valves, because friction is a separate element. Without friction, this curve lacks most of the
//! force at low velocity. So a host that uses only a curve gets the plain FV curve that the fit stored in the model file. Among all curves
//! with its velocities, the plain curve has the smallest weighted error on the tests of the fit.

use crate::adams::akima::{self, Difference};
use crate::adams::property::Curve;
use anyhow::Context as _;
use dashpot_core::elements::fv_curve::fv_interpolation;
use dashpot_core::parameter::Element;
use dashpot_core::{Params, element};
use dashpot_identification::model_file::{FvOnly, ModelFile, prepared};

/// Origin of the curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The plain FV curve, fitted to the same tests as the model.
    Fitted,
    /// The model's own curve, because the caller requested it.
    Asked,
    /// The model's own curve, because the file has no other curve.
    Only,
    /// The model's own curve. The file was changed after its fit, so the plain curve represents the damper before the change.
    Changed,
}

/// An FV curve, and the gas force if the model has one.
pub struct PlainCurve {
    /// Damper with `fv_curve` and, if present, `gas_preload`.
    pub params: Params,
    /// Origin of the curve.
    pub source: Source,
    /// Elements of the model that the curve does not contain.
    pub omitted_elements: Vec<&'static str>,
}

impl PlainCurve {
    /// Returns the plain FV curve of a model file. With `own`, or without such a curve, returns the model's own curve. Returns `None` if
    /// there is neither.
    ///
    /// # Errors
    /// The table of the plain FV curve in the file is invalid.
    pub fn from_model_file(file: &ModelFile, own: bool) -> anyhow::Result<Option<PlainCurve>> {
        let on = Element::all().filter(|element| file.params.is_on(*element) && *element != element!("fv_curve"));
        let omitted_elements = on.map(Element::name).collect();
        let source = match &file.identification.fv_only {
            _ if own => Source::Asked,
            None => Source::Only,
            Some(_) if file.was_changed() => Source::Changed,
            Some(fitted) => {
                let params = FvOnly::params(fitted).map_err(anyhow::Error::msg);
                let params = params.context("the table [identification.fv_only] of the model file")?;
                return Ok(Some(PlainCurve { params, source: Source::Fitted, omitted_elements }));
            }
        };
        if !file.params.is_on(element!("fv_curve")) {
            return Ok(None);
        }
        let mut params = file.params;
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.enable(element!("gas_preload"), file.params.is_on(element!("gas_preload")));
        Ok(Some(PlainCurve { params, source, omitted_elements }))
    }

    /// Returns the points of the curve.
    ///
    /// # Errors
    /// The points do not form a valid model.
    pub fn curve(&self) -> anyhow::Result<Curve> {
        Ok(Curve::from_model(&self.params, &prepared(&self.params)?))
    }

    /// Returns points whose Akima curve follows this curve, because Adams interpolates a property file by Akima's method. Also returns the
    /// number of points of this curve, and the remaining difference between the two curves.
    ///
    /// # Errors
    /// The errors of [`PlainCurve::curve`].
    pub fn for_akima(&self) -> anyhow::Result<(Curve, usize, Difference)> {
        let model = prepared(&self.params)?;
        let own = Curve::from_model(&self.params, &model);
        let reading = fv_interpolation(&self.params);
        let count = own.velocities.len();
        let (curve, left) = akima::written(own, reading, &|v| model.elements().paths.fv_curve.evaluate(v).value);
        Ok((curve, count, left))
    }

    /// Returns the origin of the curve as a sentence.
    pub fn note(&self) -> &'static str {
        match self.source {
            Source::Fitted => {
                "The curve is the plain FV curve fitted to the same tests as the model (fv_only in the model file): friction and whatever \
                 else acts by velocity is in it as far as a curve can hold it."
            }
            Source::Asked => {
                "The curve is the model's own fv_curve, as asked for: friction and what else the model has beside it is not in it."
            }
            Source::Only => {
                "The curve is the model's own fv_curve, for the model file has no plain FV curve of a fit (fv_only): friction and what else the \
                 model has beside it is not in it."
            }
            Source::Changed => {
                "The curve is the model's own fv_curve: the numbers of the model file were changed after its fit, so the plain FV curve that the \
                 fit left (fv_only) is not that of this damper. Friction and what else the model has beside it is not in it."
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::list;
    use dashpot_core::number;
    use dashpot_identification::model_file::of_text;
    use std::path::Path;

    const DAMPER: &str = "format = 1\nelements = [\"fv_curve\", \"stribeck_friction\"]\nfv_velocity = [-1.0, 0.0, 1.0]\n\
                          fv_force = [-600.0, 0.0, 1300.0]\n";
    const FIT: &str = "[identification.intervals]\nfv_force = [[-610.0, -590.0], [0.0, 0.0], [1290.0, 1310.0]]\n\
                       [identification.fv_only]\nvelocity = [-1.0, -0.01, 0.0, 0.01, 1.0]\nforce = [-640.0, -40.0, 0.0, 40.0, 1340.0]\n\
                       gas_force = 150.0\n";

    fn of(text: &str, own: bool) -> PlainCurve {
        PlainCurve::from_model_file(&of_text(text, Path::new("m.toml")).unwrap(), own).unwrap().expect("a curve")
    }

    #[test]
    fn a_host_with_nothing_but_a_curve_gets_the_fitted_one() {
        let plain = of(&format!("{DAMPER}{FIT}"), false);
        assert_eq!(plain.source, Source::Fitted);
        assert_eq!(plain.curve().unwrap().forces, [-640.0, -40.0, 0.0, 40.0, 1340.0]);
        assert_eq!(plain.params.number(number!("gas_force")), 150.0);
        for (text, own, source) in [
            (format!("{DAMPER}{FIT}"), true, Source::Asked),
            (DAMPER.to_owned(), false, Source::Only),
            // In these two files, a point of the curve or an element was changed by hand after the fit. The file still contains the tables
            // of the fit.
            (format!("{DAMPER}{FIT}").replace("1300.0]", "1500.0]"), false, Source::Changed),
            (
                format!("{DAMPER}{FIT}").replace("\"stribeck_friction\"", "\"gas_preload\"").replace(
                    "[identification.intervals]\n",
                    "[identification.intervals]\nstribeck_coulomb_force = [20.0, 30.0]\n",
                ),
                false,
                Source::Changed,
            ),
        ] {
            let plain = of(&text, own);
            assert_eq!(plain.source, source, "{text}");
            assert_eq!(plain.curve().unwrap().velocities, plain.params.list(list!("fv_velocity")));
            assert!(plain.curve().unwrap().forces.len() == 3 && plain.note().contains("own fv_curve"));
        }
        // After a change of a parameter within its uncertainty interval, the plain FV curve of the fit is still used.
        assert_eq!(of(&format!("{DAMPER}{FIT}").replace("1300.0]", "1305.0]"), false).source, Source::Fitted);
    }

    #[test]
    fn what_is_no_curve_is_refused_with_the_table() {
        let falls = format!("{DAMPER}{FIT}").replace("40.0, 1340.0", "40.0, 13.0");
        let file = of_text(&falls, Path::new("m.toml")).unwrap();
        let refusal =
            PlainCurve::from_model_file(&file, false).and_then(|plain| plain.expect("a curve").curve()).map(|_| ());
        assert!(format!("{:#}", refusal.unwrap_err()).contains("fv_force falls"));
        let bare = of_text("format = 1\nelements = [\"gas_preload\"]\n", Path::new("m.toml")).unwrap();
        assert!(PlainCurve::from_model_file(&bare, false).unwrap().is_none());
    }
}
