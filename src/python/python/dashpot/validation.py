"""Results of the comparison of a model with records. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _native
from ._papers import NamedModel, Origin, Papers, figures_alone, page
from ._result import Result, Row, by_test, folded, held, table
from ._work import watched
from .certificate import Certificate
from .reading import Unusable

if TYPE_CHECKING:
    import datetime
    import pathlib

    import numpy as np
    import numpy.typing as npt
    import pandas

    from .campaign import Campaign, Path
    from .limits import Row as Window


@dataclass(frozen=True, repr=False)
class Deviation(Result):
    """Errors of a simulated force, compared with the measured force."""

    mean_error_n: float
    error_percent: float
    region1_n: float
    region2_n: float
    rmse_n: float


@dataclass(frozen=True, repr=False)
class Errors(Deviation):
    """Errors of the model, and of the FV curve alone for comparison."""

    fv_only: Deviation


@dataclass(frozen=True, repr=False)
class Summary(Errors):
    """Mean errors over a set of tests."""

    tests: int


@dataclass(frozen=True, repr=False)
class SettingSummary(Summary):
    """Mean errors over the tests at one setting, for a damper that depends on a setting."""

    setting: float
    is_of_grid: bool
    """Whether the model file contains parameters at this setting. Otherwise the parameters are interpolated."""


@dataclass(frozen=True, repr=False)
class ResponseTimes(Result):
    """Times of the response to a step of the setting, from the instant of the step."""

    t10_s: float
    """Time until the force has completed 10 % of its change."""
    t63_s: float
    t90_s: float
    overshoot: float
    """Overshoot beyond the final force, as a fraction of the change."""


@dataclass(frozen=True, repr=False)
class TimeUncertainty(Result):
    """Uncertainties of measured response times: half the width of their 95 % intervals."""

    t63_s: float
    t90_s: float
    rise_s: float
    """Uncertainty of the time from 10 to 90 % of the change. The instant of the command does not affect it."""


@dataclass(frozen=True, repr=False)
class StepGroup(Result):
    """Response to the steps of one test in one stroke direction: rebound or compression."""

    test: str
    is_rebound: bool
    steps: int
    measured: ResponseTimes | None = field(default=None, metadata={"omitted": True})
    uncertainty: TimeUncertainty | None = field(default=None, metadata={"omitted": True})
    model: ResponseTimes | None = field(default=None, metadata={"omitted": True})


@dataclass(frozen=True, repr=False)
class StepResponse(Result):
    """Response to the steps from one setting to another."""

    steps: int
    tests: tuple[str, ...]
    before: float = field(metadata={"key": "from"})
    """Setting before the step."""
    after: float = field(metadata={"key": "to"})
    sample_s: float
    """Sampling interval, s. The instant of a step is known to half of it."""
    end_fraction: float
    """Completed fraction of the change of the model's force when the setting changes again. It is below 1 if the force lags too much."""
    groups: tuple[StepGroup, ...]
    """Response times of each test and stroke direction with at least three steps. A limit applies to the slowest of all groups and steps."""
    measured: ResponseTimes | None = field(default=None, metadata={"omitted": True})
    """Times of the measured force; None if the records do not show them."""
    uncertainty: TimeUncertainty | None = field(default=None, metadata={"omitted": True})
    """Half the width of the 95 % intervals of the measured times."""
    model: ResponseTimes | None = field(default=None, metadata={"omitted": True})


@dataclass(frozen=True, repr=False)
class OfEach(Result):
    """A quantity of the measured force, of the model, and of the FV curve alone."""

    measured: float
    model: float
    fv_only: float


@dataclass(frozen=True, repr=False)
class GapBin(Result):
    """Force at rising velocity minus force at falling velocity, N, in one velocity bin."""

    velocity_m_s: float
    gap_n: OfEach


@dataclass(frozen=True, repr=False)
class Hysteresis(Result):
    """Hysteresis of one test, averaged over its whole cycles."""

    cycles: int
    gap: tuple[GapBin, ...]
    mean_gap_n: OfEach
    max_gap_n: OfEach
    gap_error_n: float
    gap_error_fv_only_n: float
    area_n_m_s: OfEach
    energy_j: OfEach


@dataclass(frozen=True, repr=False)
class PeakForce(Result):
    """Force at the peak velocity of one stroke of a test."""

    velocity_m_s: float
    force_n: OfEach


@dataclass(frozen=True, repr=False)
class TestValidation(Errors):
    """All results of one test."""

    __test__ = False  # pytest must not collect this class as a test case.

    name: str
    amplitude_m: float
    frequency_hz: float
    peak_velocity_m_s: float
    max_force_n: float
    used_in_fit: bool
    samples: int
    cycles: int
    noise_rms_n: float
    hysteresis: Hysteresis | None
    peaks: tuple[PeakForce, ...]


@dataclass(frozen=True, repr=False)
class MatrixRow(Errors):
    """Errors of the tests of one amplitude or one peak velocity."""

    label: str
    value: float
    tests: int
    test_names: tuple[str, ...]
    max_force_n: float


@dataclass(frozen=True, repr=False)
class MatrixCell(Errors):
    """Errors of the tests of one amplitude and one peak velocity."""

    amplitude_row: int
    peak_velocity_row: int
    tests: int


@dataclass(frozen=True, repr=False)
class ErrorMatrix(Result):
    """Errors of a campaign by groups of tests, which follow the test schedule."""

    by_amplitude: tuple[MatrixRow, ...]
    by_peak_velocity: tuple[MatrixRow, ...]
    cells: tuple[MatrixCell, ...]
    slow: MatrixRow | None
    not_periodic: MatrixRow | None

    def _rows(self) -> list[Row]:
        return _in_groups(self)


@dataclass(frozen=True, repr=False)
class AgainstTest(Deviation):
    """Errors of a model of the literature on one test."""

    name: str
    used_in_fit: bool
    """Whether the fit of the validated model used this test."""


@dataclass(frozen=True, repr=False)
class AgainstSummary(Deviation):
    """Mean errors of a model of the literature over a set of tests."""

    tests: int


@dataclass(frozen=True, repr=False)
class Against(Result):
    """Errors of a model of the literature on the tests of the validation. The first entry of a validation is the validated model itself."""

    model: str
    meaning: str
    tests: tuple[AgainstTest, ...]
    used_in_fit: AgainstSummary | None
    left_out: AgainstSummary | None
    numbers: dict[str, Any] | None = field(default=None, metadata={"omitted": True})
    """The model with its parameters; None for the validated model."""

    def _short(self) -> Row:
        row: Row = {"model": self.model, "meaning": self.meaning}
        for name, summary in (("fitted", self.used_in_fit), ("left out", self.left_out)):
            if summary is not None:
                row |= {f"{name} tests": summary.tests, f"{name} mean error N": summary.mean_error_n, f"{name} error %": summary.error_percent}
        return row


def _in_groups(matrix: ErrorMatrix) -> list[Row]:
    """Returns the rows and cells of an error matrix. The column ``by`` names the quantity by which the tests are grouped."""
    rows = [("amplitude", row) for row in matrix.by_amplitude] + [("peak velocity", row) for row in matrix.by_peak_velocity]
    rows += [(name, row) for name, row in (("slow", matrix.slow), ("not periodic", matrix.not_periodic)) if row is not None]
    cells: list[Row] = []
    for cell in matrix.cells:
        label = f"{matrix.by_amplitude[cell.amplitude_row].label}, {matrix.by_peak_velocity[cell.peak_velocity_row].label}"
        cells.append({"by": "both", "label": label, **held(cell)[0]})
    return [{"by": by, **held(row)[0]} for by, row in rows] + cells


@dataclass(frozen=True)
class Compared:
    """Data of a validation, in addition to records and forces, from which reports and certificates are written."""

    model: NamedModel
    windows: list[Window] | None
    #: Names of models of the literature with their forces on every test.
    rivals: tuple[tuple[str, list[npt.NDArray[np.float64]]], ...]
    origin: Origin


@dataclass(frozen=True, repr=False)
class SettingDoubt(Result):
    """A test whose forces match another setting better than its stated setting."""

    test: str
    stated: float
    fitting: float
    """Setting at which the model matches the forces best."""
    stated_error_n: float
    fitting_error_n: float


@dataclass(frozen=True, repr=False)
class Validation(Papers, Result):
    """Result of the comparison of a model with a campaign; the JSON of ``dashpot validate``."""

    tests: tuple[TestValidation, ...]
    overall: Summary
    used_in_fit: Summary | None
    left_out: Summary | None
    matrix: ErrorMatrix
    region_boundary_m_s: float
    limits: Certificate | None = field(default=None, metadata={"omitted": True})
    """Verdicts on the limits; None without limits."""
    settings: tuple[SettingSummary, ...] = field(default=(), metadata={"omitted": True})
    """Errors at each setting of a damper that depends on one."""
    changing: Summary | None = field(default=None, metadata={"omitted": True})
    """Errors over the tests whose setting changes."""
    step_responses: tuple[StepResponse, ...] = field(default=(), metadata={"omitted": True})
    """Responses to steps of the setting."""
    setting_doubts: tuple[SettingDoubt, ...] = field(default=(), metadata={"omitted": True})
    """Tests whose forces match another setting; :meth:`Family.validate` warns of them."""
    against: tuple[Against, ...] = field(default=(), metadata={"omitted": True})
    """Errors of the validated model and of the models of the literature; empty without such models."""
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """Note on the measurement errors that the model's fit found in its own records, and on whether the records of this result were corrected."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    campaign: Campaign | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)
    """The compared records, with corrections; None in a result made from a dictionary."""
    _forces: tuple[tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]], ...] | None = field(
        default=None, metadata={"hidden": True}, compare=False, repr=False
    )

    _compared: Compared | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    def forces(self, test: str) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Returns the forces (N) of the model and of the FV curve alone at the samples of one test of :attr:`campaign`."""
        names = [t.name for t in self.tests]
        if test not in names:
            raise KeyError(f"there is no test {test!r}; the first is called {names[0]!r}")
        if self._forces is None:
            raise ValueError("the forces are kept by Model.validate alone, not by a result made from a dictionary")
        model, fv_only = self._forces[names.index(test)]
        return model.copy(), fv_only.copy()

    def write_report(
        self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, full: bool = False, force: bool = False
    ) -> None:
        """Writes the report with tables and plots as one HTML file without external resources. Its bytes are those of ``dashpot validate --report``.

        Nothing is fitted or simulated again, because the result contains the forces. The records are read once more, because the report lists the
        files with their hashes. Files that no longer exist are omitted. The report names the command that makes the same report if there is one.
        That requires all records of a campaign, a model that was read from a file or written, and limits from a table.

        :param language: language of the report: ``"en"``, ``"de"``, ``"fr"`` or ``"zh"``.
        :param date: date in the report. By default it is the date of ``SOURCE_DATE_EPOCH``, or none, so that equal input gives an equal report.
        :param full: prints the whole report. By default, only its first two pages are printed.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: if the language is unknown, or if this result was made from a dictionary.
        """
        self._write("report", path, language, date, force, full)

    def _write(
        self, what: str, path: Path, language: str, date: str | datetime.date | None, force: bool, full: bool = False
    ) -> list[pathlib.Path]:
        made_from = self._compared
        if self.settings and made_from is None:
            raise ValueError("papers of a damper over a setting are written by the command: dashpot validate family.toml DATA --report report.html")
        if made_from is None or self._forces is None or self.campaign is None:
            raise figures_alone("Model.validate", "was made from a dictionary")
        how = page("validate", made_from.origin, made_from.model, language=language, date=date, force=force, full=full)
        with watched():
            return _native.write_validation(
                what, os.fspath(path), how, made_from.model._native, self.campaign._native, self._forces, made_from.windows, made_from.rivals
            )

    def _rows(self) -> list[Row]:
        return [held(t)[0] for t in self.tests]

    def to_pandas(self) -> pandas.DataFrame:
        """Returns one row for each test, with the test's name as index."""
        return by_test(self._rows())

    def _repr_html_(self) -> str:
        row = {
            "tests": self.overall.tests,
            "mean error N": self.overall.mean_error_n,
            "error %": self.overall.error_percent,
            "rms N": self.overall.rmse_n,
            "FV curve %": self.overall.fv_only.error_percent,
        }
        short = [
            {
                "test": t.name,
                "used in the fit": t.used_in_fit,
                "mean error N": t.mean_error_n,
                "error %": t.error_percent,
                "FV curve %": t.fv_only.error_percent,
                "noise N": t.noise_rms_n,
            }
            for t in self.tests
        ]
        said = [self.as_the_fit_saw] if self.as_the_fit_saw else []
        shown = table("Validation", [row], [*said, *(u.why for u in self.unusable)])
        if self.settings:
            shown += table("Settings", [held(of)[0] for of in self.settings])
        shown += table("Tests", short)
        if self.limits is not None:
            shown += self.limits._repr_html_()
        if self.against:
            shown += table("Beside models of the literature", [one._short() for one in self.against])
        return shown + folded({name or "figures": rows for name, rows in self._tables().items() if not name.startswith("limits")})


@dataclass(frozen=True, repr=False)
class JudgedValidation(Validation):
    """A validation with limits, and the verdicts on them."""

    limits: Certificate
    """Verdicts on the damper and on the model for every limit."""

    def write_certificate(self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, force: bool = False) -> None:
        """Writes the verdicts on the limits as a separate page, with every limit and a diagram, like ``dashpot validate --certificate``.

        Parameters and errors are those of :meth:`write_report`. A certificate names the table of limits that :func:`dashpot.read_limits` read.
        For limits without a table, it names none.
        """
        self._write("certificate", path, language, date, force)
