"""Results of a diagnosis: effects that a model lacks, or changes against a reference damper.

SI units; extension (rebound) velocity and tension force are positive.
"""

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
    """Improvement by a refit with an effect, and the resulting odds of the effect."""

    fraction: float
    mean_square_before: float
    mean_square_after: float
    log_odds: float
    numbers: float
    negative_log_prior: float
    tests_better: float


@dataclass(frozen=True, repr=False)
class Value(Result):
    """A value with its 95 % interval. ``plausible`` states whether the value occurs in real dampers (or rigs)."""

    value: float
    low: float
    high: float
    unit: str
    plausible: bool


@dataclass(frozen=True, repr=False)
class Rival(Result):
    """Another effect that explains the same residual."""

    effect: str
    confidence: float
    fraction: float
    why: str


@dataclass(frozen=True, repr=False)
class Finding(Result):
    """An identified effect that the model lacks."""

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
    """Errors of a model, and the noise of the records."""

    rmse_n: float
    error_percent: float
    left_out_rmse_n: float | None
    noise_n: float
    left_out_noise_n: float | None


@dataclass(frozen=True, repr=False)
class Branch(Result):
    """Node of the tree of probabilities. Its levels are path, family, effect and form."""

    name: str
    level: str
    probability: float
    branches: tuple[Branch, ...]


@dataclass(frozen=True, repr=False)
class NextTest(Result):
    """A proposed rig test that distinguishes between remaining explanations."""

    text: str
    amplitude_m: float | None
    frequency_hz: float | None
    mean_displacement_m: float | None
    """Mean displacement, m, with the zero and the positive direction of the files."""
    side_force_n: float | None
    difference_n: float | None
    separates: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class CouldNotTest(Result):
    """An effect that the records cannot show, with the reason."""

    effect: str
    why: str


@dataclass(frozen=True, repr=False)
class Shift(Result):
    """A parameter of the model whose value changed when effects were added."""

    parameter: str
    before: float
    after: float
    unit: str


@dataclass(frozen=True, repr=False)
class Change(Result):
    """A parameter of the model, or a part of its FV curve, that differs from the reference damper."""

    #: Name of a parameter or of a part of the curve: ``rebound_curve``, ``compression_curve``, ``rebound_low_speed`` and so on.
    name: str
    reference: float
    value: float
    #: Lower end of the value's 95 % interval if ``reference`` is exact. Minus ``reference``, it is the end of the change's interval.
    low: float
    high: float
    unit: str
    probability: float
    #: Rms force of the change, N.
    force_n_rms: float
    #: Velocity, m/s, rebound positive, at which ``reference`` and ``value`` are forces of the FV curve; None for a parameter.
    velocity_m_s: float | None = field(default=None, metadata={"omitted": True})

    @property
    def label(self) -> str:
        """The name; for a part of the FV curve followed by its velocity."""
        return self.name if self.velocity_m_s is None else f"{self.name}, {self.velocity_m_s:.3f} m/s"


@dataclass(frozen=True, repr=False)
class TestOutcome(Result):
    """Errors of one test before and after the improvement of the model."""

    __test__ = False  # pytest must not collect this class as a test case.

    test: str
    left_out: bool
    before_rmse_n: float
    after_rmse_n: float
    noise_n: float
    allowed_n: float


@dataclass(frozen=True, repr=False)
class Tried(Result):
    """An effect that was tested by a refit of the model with this effect."""

    effect: str
    form: str
    confidence: float
    evidence: Evidence


@dataclass(frozen=True, repr=False)
class OverWholeRecords(Result):
    """Errors of the given, the refitted and the improved model over all samples of all records. A validation reports the same errors."""

    as_it_came: Deviation
    refitted: Deviation
    improved: Deviation


@dataclass(frozen=True, repr=False)
class Findings(Result):
    """Findings of a diagnosis: effects that a model lacks, or changes against a reference."""

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
        """Returns the mean cycle of one test: displacement, velocity, measured force, and the model's force before and after improvement."""
        names = [t.test for t in self.tests]
        if test not in names:
            raise KeyError(f"there is no test {test!r}; the first is called {names[0]!r}")
        if self._curves is None:
            raise ValueError("the curves are kept by diagnose() and diagnose_groups() alone, not by a result made from a dictionary")
        return {name: values.copy() for name, values in self._curves[names.index(test)].items()}

    def _rows(self) -> list[Row]:
        """Returns a row for each parameter of an effect, suspect and change. The first column states the kind of the row."""
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
        """Returns notes on the diagnosed records."""
        return []

    def _repr_html_(self) -> str:
        suspects = [f"Suspect, {s.effect}: {s.why}" for s in self.suspects]
        said = table(self.summary, self._rows(), [*suspects, *self._of_the_records(), *self.notes, *(t.text for t in self.next_tests)])
        return said + folded({name or "figures": rows for name, rows in self._tables().items()})


@dataclass(frozen=True, repr=False)
class Diagnosis(Papers, Findings):
    """Result of a diagnosis: effects that a model lacks, or changes against a reference; the JSON of ``dashpot diagnose``."""

    over_whole_records: OverWholeRecords = field(kw_only=True)
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """Note on the measurement errors that the model's fit found in its own records, and on whether the records of this result were corrected."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    _improved: Model | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)
    _made_from: tuple[_native.Diagnosed, Model, Origin] | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    @property
    def improved(self) -> Model:
        """The model with the identified effects of the damper. Measurement errors of the rig are not added to the model.

        :raises ValueError: if this result was made from a dictionary, which contains no model.
        """
        if self._improved is None:
            raise ValueError("the improved model is kept by diagnose() alone, not by a result made from a dictionary")
        return self._improved

    def write_report(
        self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, full: bool = False, force: bool = False
    ) -> None:
        """Writes the report as one HTML file without external resources. Its bytes are those of ``dashpot diagnose --report``.

        Nothing is fitted again. The records are read once more, because the report contains their hashes. The report names the command that
        makes the same report if there is one. That requires all records of a campaign, and a model that was read from a file or written.

        :param language: language of the report: ``"en"``, ``"de"``, ``"fr"`` or ``"zh"``.
        :param date: date in the report. By default it is the date of ``SOURCE_DATE_EPOCH``, or none, so that equal input gives an equal report.
        :param full: prints the whole report. By default, only its first two pages are printed.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: if the language is unknown, or if this result was pickled or made from a dictionary. In the latter case, diagnose again.
        """
        self._write("report", path, language, date, force, full)

    def write_next_tests(self, path: Path, *, force: bool = False) -> int:
        """Writes the proposed tests as a test matrix for the rig (CSV), like ``dashpot diagnose --next-tests``.

        Tests that are no sine have no row. They are only in :attr:`next_tests`.

        :returns: number of rows. If it is 0, no proposed test is a sine, and no file is written.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: if this result was pickled or made from a dictionary. In this case, diagnose again.
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
        # The extension module's data of the diagnosis cannot be pickled.
        return {**self.__dict__, "_made_from": None}

    def _of_the_records(self) -> list[str]:
        return [*([self.as_the_fit_saw] if self.as_the_fit_saw else []), *(u.why for u in self.unusable)]
