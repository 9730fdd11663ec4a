"""Which physical effect a model lacks, or what changed. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _native
from ._papers import Origin, Papers, figures_alone, page
from ._result import Result, Row, folded, table
from ._work import watched
from .fitted import InventoryItem
from .reading import Unusable
from .validation import Deviation

if TYPE_CHECKING:
    import datetime
    import pathlib

    import numpy as np
    import numpy.typing as npt

    from .campaign import Path
    from .model import Model


@dataclass(frozen=True, repr=False)
class Evidence(Result):
    """What a refit with an effect brought."""

    fraction: float
    mean_square_before: float
    mean_square_after: float
    log_odds: float
    numbers: float
    negative_log_prior: float
    tests_better: float


@dataclass(frozen=True, repr=False)
class Value(Result):
    """A number with its 95 % interval; ``plausible`` says whether dampers (or rigs) show such values."""

    value: float
    low: float
    high: float
    unit: str
    plausible: bool


@dataclass(frozen=True, repr=False)
class Rival(Result):
    """Another name for the same disagreement."""

    effect: str
    confidence: float
    fraction: float
    why: str


@dataclass(frozen=True, repr=False)
class Finding(Result):
    """A named effect."""

    effect: str
    form: str
    meaning: str
    path: str
    family: str
    confidence: float
    family_confidence: float
    fraction: float
    force_n_rms: float
    of_the_rig: bool
    parameters: dict[str, Value]
    gap_closed: float | None
    evidence: Evidence
    rivals: tuple[Rival, ...]


@dataclass(frozen=True, repr=False)
class Region(Result):
    """A region where model and records disagree."""

    test: str
    velocity_m_s: tuple[float, float]
    displacement_m: tuple[float, float]
    direction: str
    acceleration: str
    rmse_n: float
    mean_n: float
    noise_n: float
    text: str


@dataclass(frozen=True, repr=False)
class Figures(Result):
    """How far a model is off."""

    rmse_n: float
    error_percent: float
    left_out_rmse_n: float | None
    noise_n: float
    left_out_noise_n: float | None


@dataclass(frozen=True, repr=False)
class Branch(Result):
    """A branch of the tree of probabilities: path, family, effect, form."""

    name: str
    level: str
    probability: float
    branches: tuple[Branch, ...]


@dataclass(frozen=True, repr=False)
class NextTest(Result):
    """A rig test worth running."""

    text: str
    amplitude_m: float | None
    frequency_hz: float | None
    mean_displacement_m: float | None
    """In the direction and from the zero that the files count."""
    side_force_n: float | None
    difference_n: float | None
    separates: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class CouldNotTest(Result):
    """An effect that these records cannot show."""

    effect: str
    why: str


@dataclass(frozen=True, repr=False)
class Shift(Result):
    """A number of the model that moved when effects were added."""

    parameter: str
    before: float
    after: float
    unit: str


@dataclass(frozen=True, repr=False)
class Change(Result):
    """A number of the model, or a part of its FV curve, that differs from the reference damper."""

    #: A parameter, or ``rebound_curve``, ``compression_curve``, ``rebound_low_speed`` and so on.
    name: str
    reference: float
    value: float
    #: 95 % interval of the value where ``reference`` is exact: less ``reference``, that of the change.
    low: float
    high: float
    unit: str
    probability: float
    #: Force that the change makes, N rms.
    force_n_rms: float
    #: Of a part of the FV curve: velocity at which ``reference`` and ``value`` are its forces, rebound positive.
    velocity_m_s: float | None = field(default=None, metadata={"omitted": True})

    @property
    def label(self) -> str:
        """The name, with the velocity of a part of the FV curve."""
        return self.name if self.velocity_m_s is None else f"{self.name}, {self.velocity_m_s:.3f} m/s"


@dataclass(frozen=True, repr=False)
class TestOutcome(Result):
    """One test before and after."""

    __test__ = False  # no test case of pytest's

    test: str
    left_out: bool
    before_rmse_n: float
    after_rmse_n: float
    noise_n: float
    allowed_n: float


@dataclass(frozen=True, repr=False)
class Tried(Result):
    """An effect that was tried by refitting everything with it."""

    effect: str
    form: str
    confidence: float
    evidence: Evidence


@dataclass(frozen=True, repr=False)
class OverWholeRecords(Result):
    """Errors of the models in a diagnosis over every sample of every record, as a validation measures."""

    as_it_came: Deviation
    refitted: Deviation
    improved: Deviation


@dataclass(frozen=True, repr=False)
class Findings(Result):
    """What a model lacks, or what changed against a reference."""

    verdict: str
    summary: str
    findings: tuple[Finding, ...]
    inventory: tuple[InventoryItem, ...]
    changes: tuple[Change, ...]
    suspects: tuple[Rival, ...]
    regions: tuple[Region, ...] = field(metadata={"key": "where"})
    before: Figures
    after: Figures
    gap_closed: float | None
    unexplained_fraction: float
    tree: tuple[Branch, ...]
    next_tests: tuple[NextTest, ...]
    could_not_test: tuple[CouldNotTest, ...]
    shifts: tuple[Shift, ...]
    notes: tuple[str, ...]
    tests: tuple[TestOutcome, ...]
    iterations: tuple[tuple[Tried, ...], ...]
    corrections: dict[str, float]
    _curves: tuple[dict[str, npt.NDArray[np.float64]], ...] | None = field(
        default=None, metadata={"hidden": True}, compare=False, repr=False
    )

    def curves(self, test: str) -> dict[str, npt.NDArray[np.float64]]:
        """Mean cycle of one test: displacement, velocity, measured force, force before and after."""
        names = [t.test for t in self.tests]
        if test not in names:
            raise KeyError(f"there is no test {test!r}; the first is called {names[0]!r}")
        if self._curves is None:
            raise ValueError("the curves are kept by diagnose() and diagnose_groups() alone, not by a result made from a dictionary")
        return {name: values.copy() for name, values in self._curves[names.index(test)].items()}

    def _rows(self) -> list[Row]:
        """Effects with their numbers, suspects, and changes against the reference; the first column says which of these a row is."""
        rows: list[Row] = []
        for found in self.findings:
            of_it: Row = {"what": "effect", "effect": found.effect, "form": found.form, "confidence": found.confidence, "fraction": found.fraction}
            of_it["of the rig"] = found.of_the_rig
            numbers = [{"parameter": name, **number.to_dict()} for name, number in found.parameters.items()]
            rows += [{**of_it, **number} for number in numbers or [{}]]
        for suspect in self.suspects:
            rows.append({"what": "suspect", **suspect.to_dict()})
        for change in self.changes:
            numbers_of_it = change.to_dict()
            rows.append({"what": "changed", "parameter": numbers_of_it.pop("name"), **numbers_of_it})
        return rows

    def _of_the_records(self) -> list[str]:
        """What is to be said of the records that were looked at."""
        return []

    def _repr_html_(self) -> str:
        suspects = [f"Suspect, {s.effect}: {s.why}" for s in self.suspects]
        said = table(self.summary, self._rows(), [*suspects, *self._of_the_records(), *self.notes, *(t.text for t in self.next_tests)])
        return said + folded({name or "figures": rows for name, rows in self._tables().items()})


@dataclass(frozen=True, repr=False)
class Diagnosis(Papers, Findings):
    """What a model lacks, or what changed against a reference; the JSON of ``dashpot diagnose``."""

    over_whole_records: OverWholeRecords = field(kw_only=True)
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """What the model's own fit found its records to be off by, and whether it was taken out of these."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    _improved: Model | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)
    _made_from: tuple[_native.Diagnosed, Model, Origin] | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    @property
    def improved(self) -> Model:
        """The model with the named effects added; what is of the rig is not put into it.

        :raises ValueError: of a result that was made from a dictionary, which holds no model.
        """
        if self._improved is None:
            raise ValueError("the improved model is kept by diagnose() alone, not by a result made from a dictionary")
        return self._improved

    def write_report(
        self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, full: bool = False, force: bool = False
    ) -> None:
        """Writes the report for people, one HTML file that opens without a network; as ``dashpot diagnose --report``, byte by byte.

        Nothing is fitted again; the records are read once more for the hashes that the report says of them. It names the command that makes the
        same, where there is one: of all records of a campaign, and a model that was read from a file or written.

        :param language: of the report: ``"en"``, ``"de"``, ``"fr"`` or ``"zh"``.
        :param date: date to write into it; without it that of ``SOURCE_DATE_EPOCH``, or none, so that the same input gives the same report.
        :param full: print all of the report, not its first two pages alone.
        :param force: also over a file of another kind, or a write-protected one; the command's ``--force``.
        :raises OutputError: where it cannot be written, or would take another file's place.
        :raises ValueError: of a language that there is not, and of a result that was pickled or made from a dictionary: diagnose again.
        """
        self._write("report", path, language, date, force, full)

    def write_next_tests(self, path: Path, *, force: bool = False) -> int:
        """Writes the tests that would tell more as a test matrix for the rig (CSV); as ``dashpot diagnose --next-tests``.

        Those that are no sine have no row and stand in :attr:`next_tests` alone.

        :returns: the rows written. Where it is 0, there is none that a rig could be driven by, and no file.
        :raises OutputError: where it cannot be written, or would take another file's place.
        :raises ValueError: of a result that was pickled or made from a dictionary: diagnose again.
        """
        return _native.write_next_tests(os.fspath(path), self._held()[0], bool(force))

    def _held(self) -> tuple[_native.Diagnosed, Model, Origin]:
        if self._made_from is None:
            raise figures_alone("dashpot.diagnose", "was pickled or made from a dictionary; diagnose again")
        return self._made_from

    def _write(
        self, what: str, path: Path, language: str, date: str | datetime.date | None, force: bool, full: bool = False
    ) -> list[pathlib.Path]:
        found, model, origin = self._held()
        how = page("diagnose", origin, model, language=language, date=date, force=force, full=full)
        with watched():
            return _native.write_diagnosis(what, os.fspath(path), how, found)

    def __getstate__(self) -> dict[str, Any]:
        # What the compiled part holds of a diagnosis stays in its process.
        return {**self.__dict__, "_made_from": None}

    def _of_the_records(self) -> list[str]:
        return [*([self.as_the_fit_saw] if self.as_the_fit_saw else []), *(u.why for u in self.unusable)]
