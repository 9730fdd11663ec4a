"""What a damper over a setting lacks, at each setting. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result, Row, folded, held, table
from .diagnosis import Change, Diagnosis
from .family_fit import SettingAxis
from .reading import Unusable


@dataclass(frozen=True, repr=False)
class EffectAtSetting(Result):
    """An effect at one setting."""

    setting: float
    probability: float
    """Probability that the damper has it there."""
    force_n_rms: float
    """Force that it carries there."""
    status: str


@dataclass(frozen=True, repr=False)
class EffectOverSettings(Result):
    """An effect over all settings."""

    effect: str
    at_all_settings: bool
    """Whether the damper shows it at every setting that was diagnosed."""
    is_found: bool
    """Whether it was missing in the model at any of them."""
    settings: tuple[EffectAtSetting, ...]


@dataclass(frozen=True, repr=False)
class ChangeAtSetting(Change):
    """A change against the reference at one setting."""

    setting: float = field(kw_only=True)


@dataclass(frozen=True, repr=False)
class ChangeOverSettings(Result):
    """A change against the reference over all settings."""

    name: str
    at_all_settings: bool
    """Whether it changed at every setting that was diagnosed."""
    settings: tuple[ChangeAtSetting, ...]


@dataclass(frozen=True, repr=False)
class SettingDiagnosis(Diagnosis):
    """What the damper lacks at one setting."""

    setting: float = field(kw_only=True)


@dataclass(frozen=True, repr=False)
class FamilyDiagnosis(Result):
    """What a damper over a setting lacks; the JSON of ``dashpot diagnose`` of one. ``found[1.6]`` is what was found at that setting."""

    setting: SettingAxis
    summary: tuple[str, ...]
    """What was found; an effect or a change of all settings is named once."""
    effects: tuple[EffectOverSettings, ...]
    changes: tuple[ChangeOverSettings, ...]
    """Against a reference: what changed."""
    settings: tuple[SettingDiagnosis, ...]
    """What was found at each setting of the records, lowest first."""
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """What the model's own fit found its records to be off by, and whether it was taken out of these."""
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
