"""Dampers of a fleet that depend on a setting: fit over the setting, values at each setting, and the settings of a whole fleet."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from .. import _native
from .._native import DashpotError, FitError
from ..campaign import Campaign, Record
from ..diagnosis import Diagnosis
from ..diagnosis_settings import FamilyDiagnosis, SettingDiagnosis
from ..family import Family
from ..identification import NO_SETTING
from ..model import Model
from ..validation import Validation


def settings_in(records: Iterable[Record], name: str | None = None) -> list[float]:
    """Returns the constant settings of records, increasing and without duplicates; only those called ``name`` if it is given."""
    found: list[float] = []
    for record in records:
        own = record.setting
        if own is not None and name in (None, own.name) and not has(found, own.value):
            found.append(own.value)
    return sorted(found)


def has(settings: Iterable[float], value: float) -> bool:
    """Returns whether ``value`` is the same setting as one of ``settings``, apart from scatter."""
    return any(_native.is_same_setting(one, value) for one in settings)


def label(value: float, unit: str, name: str = "") -> str:
    """Formats a setting with its unit, or with its name if it has no unit: ``0.8 A``, ``3 clicks``."""
    return f"{value:g} {unit or name}".rstrip()


def named_option(campaign: Campaign, error: FitError) -> DashpotError:
    """Returns the error of a fit. If the cause is tests at several settings, the message names the option of a fleet instead of the command's."""
    names = sorted({r.setting.name for r in campaign if r.setting is not None})
    for name in names:
        unit = next(r.setting.unit for r in campaign if r.setting is not None and r.setting.name == name)
        settings = settings_in(campaign, name)
        if len(settings) > 1:
            listed = ", ".join(label(value, unit) for value in settings)
            return FitError(
                f"the tests have several settings of {name} ({listed}): give --setting {name}, in Python Plan(setting={name!r}), "
                f"for one damper over {name}; --setting {NO_SETTING} fits them as one damper without a setting"
            )
    return error


def at_each_setting(model: Model | Family, campaign: Campaign, validation: Validation, velocities: Sequence[float], margin: float) -> list[dict[str, Any]]:
    """Returns the entries of a row for each measured setting: errors, and forces at ``velocities``, m/s.

    :param margin: largest ratio of a velocity to the end of the FV curve at which an entry contains the force.
    """

    def entry(setting: float, damper: Model, tests: int, error: Any) -> dict[str, Any]:
        low, high = damper.velocity_range
        forces = damper.steady_force(np.array(velocities))
        # Outside the velocities of the campaign, the curve is extrapolated and therefore omitted.
        shown = [float(f) if low <= v / margin <= high else None for v, f in zip(velocities, forces, strict=True)]
        return {
            "setting": setting, "tests": tests, "error_percent": error.error_percent, "rmse_n": error.rmse_n,
            "fv_error_percent": error.fv_only.error_percent, "forces": shown,
        }  # fmt: skip

    if isinstance(model, Family):
        return [entry(one.setting, model.at(one.setting), one.tests, one) for one in validation.settings]
    (setting,) = settings_in(campaign)
    return [entry(setting, model, len(campaign), validation.overall)]


#: Verdicts of a diagnosis at one setting from the weakest to the strongest. The strongest one of all settings is the verdict of the row.
_VERDICTS = ("nothing_missing", "cannot_tell", "unknown_effect", "changed")


def diagnosed(found: FamilyDiagnosis) -> tuple[dict[str, Any], dict[float, dict[str, Any]]]:
    """Returns the entries of a diagnosis over the setting, for the whole damper and for each setting."""
    each = {one.setting: verdict_of(one) for one in found.settings}
    strength = {verdict: k for k, verdict in enumerate(_VERDICTS)}
    verdicts = [one["verdict"] for one in each.values()]
    said: dict[str, Any] = {
        "verdict": max(verdicts, key=lambda verdict: strength.get(verdict, len(strength))),
        "summary": "; ".join(found.summary),
        "changes": [asdict(change) for over in found.changes for change in over.settings],
    }
    kinds: dict[str, tuple[str, ...]] = {"effect": ("effect", "effect_form", "effect_confidence")}
    if not found.changes:
        # A suspect at one setting is omitted if parameters changed, because the changes at other settings are the result.
        kinds["suspect"] = ("suspect", "suspect_confidence")
    for kind, keys in kinds.items():
        named = [one for one in each.values() if one.get(kind)]
        if named:
            surest = max(named, key=lambda one: float(one[f"{kind}_confidence"]))
            said.update({key: surest[key] for key in keys})
            break
    return said, each


def verdict_of(one: Diagnosis | SettingDiagnosis) -> dict[str, Any]:
    """Returns the verdict of a diagnosis, of all tests or of those at one setting, with its effect or suspect."""
    said: dict[str, Any] = {"verdict": one.verdict}
    if one.findings:
        first = one.findings[0]
        said.update(effect=first.effect, effect_form=first.form, effect_confidence=first.confidence)
    elif one.suspects:
        said.update(suspect=one.suspects[0].effect, suspect_confidence=one.suspects[0].confidence)
    return said


#: Parameters of the actuator in the unit of the setting, and in this unit per second. All others have units of their own.
_IN_UNIT_OF_SETTING = {"setting_hysteresis": "", "setting_rate_up": "/s", "setting_rate_down": "/s"}


@dataclass
class FleetSettings:
    """Settings at which the dampers of a fleet were measured, and the parameters that depend on the setting in any damper.

    A parameter may be common to all settings in one damper and depend on the setting in another. It then has a value at each setting in
    both dampers.
    """

    name: str = ""
    unit: str = ""
    varying: set[str] = field(default_factory=set)
    _counts: Counter[float] = field(default_factory=Counter)

    def take(self, row: Mapping[str, Any]) -> None:
        """Adds the settings and parameters of a row. The first damper with settings determines name and unit of the fleet's setting."""
        settings = row["settings"] or ()
        if settings and not self.name:
            self.name, self.unit = row["setting"], row["setting_unit"] or ""
        self._counts.update(value for one in settings if (value := self.own(row, one["setting"])) is not None)
        for number in row["parameters"] or ():
            if number["index"] is None and number["setting"] is not None:
                self.varying.add(number["name"])

    def own(self, row: Mapping[str, Any], setting: float) -> float | None:
        """Returns a setting of a row in the unit of the fleet, or None if its unit belongs to another quantity."""
        return _native.restate_setting(setting, row["setting_unit"] or "", self.unit)

    def number_unit(self, name: str, unit: str) -> str:
        """Returns the unit of a parameter in the table. Some parameters of the actuator have that of the fleet's setting."""
        return f"{self.unit}{_IN_UNIT_OF_SETTING[name]}" if name in _IN_UNIT_OF_SETTING and self.unit else unit

    def own_number(self, row: Mapping[str, Any], name: str, value: float | None) -> float | None:
        """Returns a value of a parameter in the unit of the table."""
        return self.own(row, value) if value is not None and name in _IN_UNIT_OF_SETTING else value

    def values(self) -> list[float]:
        """Returns the settings of the fleet, increasing. Values that differ only by scatter count as one setting, with the most frequent value."""
        out: list[float] = []
        for value, _ in sorted(self._counts.items(), key=lambda pair: (-pair[1], pair[0])):
            if not has(out, value):
                out.append(value)
        return sorted(out)

    def label(self, value: float) -> str:
        """Formats a setting of the fleet with its unit."""
        return label(value, self.unit, self.name)


def place_of(settings: Sequence[float], value: float) -> float | None:
    """Returns the setting of the fleet that is nearest to ``value`` and equal apart from scatter, or None without such a setting."""
    near = [one for one in settings if _native.is_same_setting(one, value)]
    return min(near, key=lambda one: abs(one - value)) if near else None


def column(name: str, shown: str) -> str:
    """Returns the name of the column of a quantity at a setting: ``coulomb_force_at_0.8_A``."""
    return f"{name}_at_{shown.replace(' ', '_')}"
