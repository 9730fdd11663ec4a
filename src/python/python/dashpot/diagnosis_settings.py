"""Results of the diagnosis of a damper that depends on a setting.

SI units; extension (rebound) velocity and tension force are positive.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result, Row, folded, held, table
from .diagnosis import Change, Diagnosis
from .family_fit import SettingAxis
from .reading import Unusable


@dataclass(frozen=True, repr=False)
class EffectAtSetting(Result):
    """Probability and force of an effect at one setting."""

    setting: float
    probability: float
    """Probability that the damper has the effect at this setting."""
    force_n_rms: float
    """Rms force of the effect at this setting, N."""
    status: str
    """Whether the most probable model has the effect: kept, added, removed or replaced."""
    is_named: bool
    """Whether the diagnosis of this setting names the effect. Only a named effect is a finding."""


@dataclass(frozen=True, repr=False)
class EffectOverSettings(Result):
    """An effect at all settings."""

    effect: str
    at_all_settings: bool
    """Whether the damper has the effect at every diagnosed setting."""
    is_found: bool
    """Whether the diagnosis names the effect at any setting, because the model lacks it there."""
    settings: tuple[EffectAtSetting, ...]


@dataclass(frozen=True, repr=False)
class ChangeAtSetting(Change):
    """A change against the reference at one setting."""

    setting: float = field(kw_only=True)


@dataclass(frozen=True, repr=False)
class ChangeOverSettings(Result):
    """A change against the reference at all settings."""

    name: str
    at_all_settings: bool
    """Whether the change occurred at every diagnosed setting."""
    settings: tuple[ChangeAtSetting, ...]


@dataclass(frozen=True, repr=False)
class SettingDiagnosis(Diagnosis):
    """Result of the diagnosis at one setting."""

    setting: float = field(kw_only=True)
    interpolated: bool = field(kw_only=True)
    """Whether the model was not measured at this setting. In this case, the diagnosis does not test the interpolation. A validation tests it."""


@dataclass(frozen=True, repr=False)
class FamilyDiagnosis(Result):
    """Result of the diagnosis of a damper that depends on a setting; the JSON of ``dashpot diagnose`` for such a damper.

    ``found[1.6]`` is the result at the setting 1.6.
    """

    setting: SettingAxis
    summary: tuple[str, ...]
    """Sentences on the findings. An effect or a change at all settings is named once."""
    effects: tuple[EffectOverSettings, ...]
    changes: tuple[ChangeOverSettings, ...]
    """Changes against the reference; empty without a reference."""
    settings: tuple[SettingDiagnosis, ...]
    """Results at each setting of the records, in increasing order of the setting."""
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """Note on the measurement errors that the model's fit found in its own records, and on whether the records of this result were corrected."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""

    def __getitem__(self, setting: float) -> SettingDiagnosis:
        for one in self.settings:
            if one.setting == setting:
                return one
        raise KeyError(f"no test is at {setting:g}; there are {', '.join(f'{one.setting:g}' for one in self.settings)}")

    def _rows(self) -> list[Row]:
        def row(of: EffectOverSettings) -> Row:
            own: Row = {"effect": of.effect, "at all settings": of.at_all_settings, "found": of.is_found}
            return own | {f"probability at {at.setting:g}": at.probability for at in of.settings}

        def changed(of: ChangeOverSettings) -> Row:
            own: Row = {"change": of.name, "at all settings": of.at_all_settings}
            return own | {f"probability at {at.setting:g}": at.probability for at in of.settings}

        return [changed(of) for of in self.changes] + [row(of) for of in self.effects]

    def _repr_html_(self) -> str:
        said = table(f"Diagnosis over {self.setting.name}", self._rows(), list(self.summary))
        return said + folded({f"{one.setting:g}": [held(one)[0]] for one in self.settings})
