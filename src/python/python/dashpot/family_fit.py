"""What the fit of a damper over a setting found. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result, Row, folded, held, table
from .fitted import Estimate, InventoryItem, Measured
from .reading import SignFinding, Unusable


@dataclass(frozen=True, repr=False)
class SettingAxis(Result):
    """The setting: its name, its unit and the values that the records have."""

    name: str
    unit: str
    grid: tuple[float, ...]


@dataclass(frozen=True, repr=False)
class ForceAtSetting(Result):
    """Force that an effect carries at one setting, N rms, and its share of the measured force."""

    setting: float
    force_n_rms: float
    share: float


@dataclass(frozen=True, repr=False)
class FamilyItem(InventoryItem):
    """One effect of a family, with the force it carries over all settings and at each."""

    settings: tuple[ForceAtSetting, ...] = ()


@dataclass(frozen=True, repr=False)
class FamilyEstimate(Estimate):
    """What a fit says of one number, with its 95 % interval."""

    setting: float | None = field(default=None, metadata={"omitted": True})
    """The setting that it holds at; none where all settings share the number."""


@dataclass(frozen=True, repr=False)
class SettingDependence(Result):
    """Whether a number depends on the setting; ``fv_force`` is the FV curve."""

    name: str
    varies: bool
    probability: float
    """Probability that it does."""


@dataclass(frozen=True, repr=False)
class SettingError(Result):
    """Mean error over the tests of a setting, on the mean cycle of each."""

    mean_error_n: float
    error_percent: float


@dataclass(frozen=True, repr=False)
class SettingReport(Result):
    """The errors at one setting."""

    setting: float
    tests: int
    own_fit: SettingError
    """Of an ordinary damper that was fitted to this setting alone."""
    family: SettingError
    left_out: SettingError | None = field(default=None, metadata={"omitted": True})
    """Of the family that was fitted to all other settings; none at the ends of the grid."""
    left_out_ratio: float | None = field(default=None, metadata={"omitted": True})
    """That error over the one of the fit to this setting alone."""


@dataclass(frozen=True, repr=False)
class ActuatorDecision(Result):
    """Whether the valve has a part: ``lag``, ``lag_each_way``, ``dead_time``, ``rate_limit`` or ``hysteresis``."""

    name: str
    is_present: bool
    probability: float
    """Probability that it does."""


@dataclass(frozen=True, repr=False)
class ActuatorFit(Result):
    """The actuator, from tests whose setting changes."""

    estimates: tuple[Estimate, ...]
    """Its numbers; one that both ways share stands once for each."""
    parts: tuple[ActuatorDecision, ...]
    tests: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class FamilyFitResult(Result):
    """What the fit found; the JSON of ``dashpot fit --setting`` without the file name."""

    setting: SettingAxis
    tests: tuple[str, ...]
    parameters: tuple[FamilyEstimate, ...]
    depends_on_setting: tuple[SettingDependence, ...]
    inventory: tuple[FamilyItem, ...]
    measured: tuple[Measured, ...]
    settings: tuple[SettingReport, ...]
    notes: tuple[str, ...]
    misfit: float
    sign: SignFinding
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    actuator: ActuatorFit | None = field(default=None, metadata={"omitted": True})
    """The actuator; none where no test has a setting that changes."""

    def _rows(self) -> list[Row]:
        return [held(of)[0] for of in self.settings]

    def _repr_html_(self) -> str:
        said = [*self.notes, *(u.why for u in self.unusable)]
        shown = table(f"Fit over {self.setting.name} to {len(self.tests)} tests", self._rows(), said)
        return shown + folded({name or "figures": rows for name, rows in self._tables().items() if name != "settings"})
