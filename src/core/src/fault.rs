//! Errors in a parameter set: the parameter at fault and the reason.

/// Value of [`Fault::parameter`] if no single parameter is at fault.
pub const NO_PARAMETER: u16 = u16::MAX;

/// An error in a parameter set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Index of the parameter at fault in the parameter table, or [`NO_PARAMETER`].
    pub parameter: u16,
    /// Reason of the error.
    pub reason: Reason,
}

/// Kind of error in a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// No parameter or element has the name.
    UnknownName,
    /// The number is NaN or infinite.
    NotFinite,
    /// The number is outside the bounds of the parameter table, or of an entry of the setting.
    OutOfBounds,
    /// The number is not one of the choices.
    NotAChoice,
    /// The value is a list instead of one number, or one number instead of a list.
    WrongShape,
    /// The list has too few or too many points, or the name or unit of a setting is too long.
    PointCount,
    /// The lists of a curve's abscissae and ordinates have different lengths.
    CurveLengths,
    /// The abscissae (velocities or displacements) of a curve do not increase.
    NotIncreasing,
    /// The ordinates (forces) of a curve decrease somewhere, so the damper would drive a motion that it should resist.
    ForceDecreases,
    /// Two points of a curve are closer to each other than 1e-6 m/s or m.
    TooClose,
    /// A curve rises by more than 1e8 N s/m or N/m between two points.
    TooSteep,
    /// The number is far too large or too small in proportion to the other numbers of the damper.
    OutOfProportion,
    /// A limit must exceed another limit, but does not: the second knee of the FV curve, or the upper speed of a lag.
    Order,
    /// The springs on the internal mass are stiffer than the series spring that drives the mass.
    SofterThanInner,
    /// The elements that are on have more internal states than a [`crate::State`] can store.
    TooManyStates,
    /// An element that modifies the series compliance is on, but the series compliance is off.
    NeedsSeries,
    /// The grid of a setting is invalid.
    SettingGrid,
    /// The number of values given over a setting differs from the number of grid values.
    SettingCount,
    /// The parameter cannot depend on the setting.
    SettingFixed,
    /// Too many parameters depend on the setting.
    SettingTooMany,
    /// The damper has different internal states at two settings.
    SettingStates,
}

impl Reason {
    /// Returns the message for the user, without the parameter's name.
    pub const fn text(self) -> &'static str {
        match self {
            Reason::UnknownName => "no parameter or element has this name",
            Reason::NotFinite => "is not a finite number",
            Reason::OutOfBounds => "is outside the bounds of the parameter table",
            Reason::NotAChoice => "is none of the choices of the parameter table",
            Reason::WrongShape => "is a list where one number belongs, or one number where a list belongs",
            Reason::PointCount => "has too few or too many points (a curve needs 2 to 63)",
            Reason::CurveLengths => "has another number of points than the list it belongs to",
            Reason::NotIncreasing => "does not increase from point to point",
            Reason::ForceDecreases => "falls from one point to the next; make the force non-decreasing",
            Reason::TooClose => "has two points nearer than 1e-6 (m/s or m); leave one of them out",
            Reason::TooSteep => {
                "rises from one point to the next by more than 1e8 N s/m (or N/m); draw the jump over a longer part"
            }
            Reason::OutOfProportion => {
                "is far larger or smaller than goes with the others: no damper has numbers of such different sizes"
            }
            Reason::Order => "must be larger than the limit below it",
            Reason::SofterThanInner => {
                "is softer than the parallel spring somewhere within 100 mm; the model is made for stiff series springs"
            }
            Reason::NeedsSeries => "belongs to an element that needs series_compliance, which is off",
            Reason::TooManyStates => {
                "the elements that are on have more than 8 private states; switch some of them off"
            }
            Reason::SettingGrid => "must be 2 to 8 increasing numbers, in a line setting = [...] of the model file",
            Reason::SettingCount => "needs one value for each value of the setting",
            Reason::SettingFixed => {
                "cannot depend on the setting; single numbers of elements and the list fv_force can"
            }
            Reason::SettingTooMany => "is one number too many that depends on the setting; at most 32 can",
            Reason::SettingStates => {
                "is 0 at one setting and not at another, which adds a state; make it small there and not 0"
            }
        }
    }
}
