"""Results of the fit of a damper that depends on a setting. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result, Row, folded, held, table
from .fitted import Estimate, InventoryItem, Measured
from .reading import SignFinding, Unusable


@dataclass(frozen=True, repr=False)
class SettingAxis(Result):
    """Name and unit of the setting, and its values in the records."""

    name: str
    unit: str
    grid: tuple[float, ...]


@dataclass(frozen=True, repr=False)
class ForceAtSetting(Result):
    """Rms force of an effect at one setting, N, and its ratio to the rms measured force."""

    setting: float
    force_n_rms: float
    share: float


@dataclass(frozen=True, repr=False)
class FamilyItem(InventoryItem):
    """One effect of a damper that depends on a setting, with its force over all settings and at each setting."""

    settings: tuple[ForceAtSetting, ...] = ()


@dataclass(frozen=True, repr=False)
class FamilyEstimate(Estimate):
    """Estimate of one parameter, with its 95 % interval."""

    setting: float | None = field(default=None, metadata={"omitted": True})
    """Setting of the estimate; None if all settings share the parameter."""


@dataclass(frozen=True, repr=False)
class SettingDependence(Result):
    """Decision whether a parameter depends on the setting; ``fv_force`` is the FV curve."""

    name: str
    varies: bool
    probability: float
    """Probability that the parameter depends on the setting."""


@dataclass(frozen=True, repr=False)
class SettingError(Result):
    """Mean error over the tests of a setting, evaluated on the mean cycle of each test."""

    mean_error_n: float
    error_percent: float


@dataclass(frozen=True, repr=False)
class SettingReport(Result):
    """The errors at one setting."""

    setting: float
    tests: int
    own_fit: SettingError
    """Error of an ordinary damper that was fitted to this setting alone."""
    family: SettingError
    left_out: SettingError | None = field(default=None, metadata={"omitted": True})
    """Error of a family that was fitted to all other settings; None at the ends of the grid, and if that fit fails."""
    left_out_ratio: float | None = field(default=None, metadata={"omitted": True})
    """Ratio of the error ``left_out`` to the error ``own_fit``."""


@dataclass(frozen=True, repr=False)
class ActuatorDecision(Result):
    """Decision whether the actuator has a part: ``lag``, ``lag_each_way``, ``dead_time``, ``rate_limit`` or ``hysteresis``."""

    name: str
    is_present: bool
    probability: float
    """Probability that the actuator has the part."""


@dataclass(frozen=True, repr=False)
class ActuatorFit(Result):
    """The actuator, identified from tests whose setting changes."""

    estimates: tuple[Estimate, ...]
    """Parameters of the actuator. A parameter that both directions share is listed once for each direction."""
    parts: tuple[ActuatorDecision, ...]
    tests: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class FamilyFitResult(Result):
    """Result of the fit of a damper that depends on a setting; the JSON of ``dashpot fit --setting`` without the file name."""

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
    """The actuator; None if no test has a changing setting."""

    def _rows(self) -> list[Row]:
        return [held(of)[0] for of in self.settings]

    def _repr_html_(self) -> str:
        said = [*self.notes, *(u.why for u in self.unusable)]
        shown = table(f"Fit over {self.setting.name} to {len(self.tests)} tests", self._rows(), said)
        return shown + folded({name or "figures": rows for name, rows in self._tables().items() if name != "settings"})
