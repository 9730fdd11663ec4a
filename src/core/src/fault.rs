//! Why a parameter set is refused: which parameter, and what is wrong with it.

/// Index that stands for "no single parameter".
pub const NO_PARAMETER: u16 = u16::MAX;

/// A refused parameter set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Index into the parameter table, or [`NO_PARAMETER`].
    pub parameter: u16,
    /// What is wrong.
    pub reason: Reason,
}

/// What can be wrong with a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// No parameter or element has that name.
    UnknownName,
    /// NaN or infinite.
    NotFinite,
    /// Outside the bounds of the table.
    OutOfBounds,
    /// A number that is none of the choices.
    NotAChoice,
    /// A list where one number belongs, or the reverse.
    WrongShape,
    /// Too few or too many points.
    PointCount,
    /// The two lists of a curve have different lengths.
    CurveLengths,
    /// Abscissae of a curve do not increase.
    NotIncreasing,
    /// Ordinates of a curve fall somewhere: the damper would push where it should resist.
    ForceDecreases,
    /// Two points of a curve are nearer than 1e-6.
    TooClose,
    /// A curve rises by more than 1e8 from point to point.
    TooSteep,
    /// Far larger or smaller than goes with the other numbers.
    OutOfProportion,
    /// A limit that must lie above another does not.
    Order,
    /// The springs on the internal mass are stiffer than the series spring that drives it.
    SofterThanInner,
    /// The elements that are on have more private states than a state has room for.
    TooManyStates,
    /// An element that bends the series compliance, without it.
    NeedsSeries,
    /// The grid of a setting is none.
    SettingGrid,
    /// Values over a setting, of which there are not as many as the grid has.
    SettingCount,
    /// Something that cannot depend on the setting.
    SettingFixed,
    /// More numbers depend on the setting than there is room for.
    SettingTooMany,
    /// The damper has other private states at one setting than at another.
    SettingStates,
}

impl Reason {
    /// The sentence that a person reads, without the parameter's name.
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
