"""What fit, validate and diagnose say, as dataclasses with the keys of the command's JSON.

SI units; extension (rebound) velocity and tension force are positive everywhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from ._result import Result, flat, table

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from .campaign import Campaign
    from .model import Model

__all__ = [
    "Branch", "Certificate", "Change", "Checked", "Choice", "CouldNotTest", "Delay", "Deviation", "Diagnosis", "ErrorMatrix", "Errors", "Estimate",
    "Evidence", "Figures", "Finding", "FitResult", "GapBin", "Hysteresis", "LimitValue", "MatrixCell", "MatrixRow", "Measured", "NextTest",
    "Noise", "Note", "OfEach", "OverWholeRecords", "PeakForce", "PeakPoint", "Region", "Result", "Rival", "Score", "Shift", "SignFinding", "Summary", "TestOutcome", "Unusable",
    "TestValidation", "Tried", "Validation", "Value",
]


@dataclass(frozen=True, repr=False)
class Note(Result):
    """One thing that reading did or noticed."""

    kind: str
    text: str


@dataclass(frozen=True, repr=False)
class SignFinding(Result):
    """Which direction the files count positive, and how sure that is."""

    positive: str
    given: bool
    confidence: float
    reasons: tuple[str, ...]
    standstill_force: float
    asymmetry: float | None


@dataclass(frozen=True, repr=False)
class Delay(Result):
    """How late the force comes, s; nothing was moved for it."""

    seconds: float
    unexplained_as_recorded: float
    unexplained: float


@dataclass(frozen=True, repr=False)
class Noise(Result):
    """Noise of the force channel: root mean square of one sample, N, and its correlation from one to the next."""

    force_rms: float
    lag1: float
    source: str = field(metadata={"key": "from"})


@dataclass(frozen=True, repr=False)
class Estimate(Result):
    """What a fit says of one number of the model, with its 95 % interval."""

    name: str
    index: int | None
    value: float
    low: float | None
    high: float | None
    unit: str
    source: str = field(metadata={"key": "from"})
    standing: str = "identified"


@dataclass(frozen=True, repr=False)
class Score(Result):
    """Error of one variant on left-out tests, in units of what noise and floor allow."""

    name: str
    held_out: float
    tie_within: float


@dataclass(frozen=True, repr=False)
class Choice(Result):
    """Which variant of friction, spring or FV points was kept, and why."""

    of: str
    chosen: str
    scores: tuple[Score, ...]
    why: str


@dataclass(frozen=True, repr=False)
class Measured(Result):
    """What the records are off by; taken out of the comparison and not part of the model."""

    name: str
    value: float
    low: float
    high: float
    unit: str
    option: str | None = None


@dataclass(frozen=True, repr=False)
class Unusable(Result):
    """A file or test that was left out."""

    why: str
    """Why, in a sentence that names the file, and the test within it."""
    is_test: bool
    """Whether it is a test, with a fault of its own; else the file is no record at all."""


@dataclass(frozen=True, repr=False)
class FitResult(Result):
    """What a fit found; the JSON of ``dashpot fit`` without the file name."""

    tests: tuple[str, ...]
    parameters: tuple[Estimate, ...]
    choices: tuple[Choice, ...]
    measured: tuple[Measured, ...]
    notes: tuple[str, ...]
    misfit: float
    over_whole_records: Deviation
    """Over every sample of the fitted tests, as a validation measures, after what is ``measured`` was taken out of them."""
    sign: SignFinding
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""

    def _rows(self) -> list[dict[str, Any]]:
        return [p.to_dict() for p in self.parameters]

    def _repr_html_(self) -> str:
        said = [f"{c.of}: {c.chosen} — {c.why}" for c in self.choices] + list(self.notes)
        return table(f"Fit to {len(self.tests)} tests", self._rows(), said)


@dataclass(frozen=True, repr=False)
class Deviation(Result):
    """How far a simulated force is from the measured one."""

    mean_error_n: float
    error_percent: float
    region1_n: float
    region2_n: float
    rmse_n: float


@dataclass(frozen=True, repr=False)
class Errors(Deviation):
    """Errors of the model, and beside them those of the FV curve alone."""

    fv_only: Deviation


@dataclass(frozen=True, repr=False)
class Summary(Errors):
    """Mean figures over a set of tests."""

    tests: int


@dataclass(frozen=True, repr=False)
class OfEach(Result):
    """One figure of the measured force, of the model, and of the FV curve alone."""

    measured: float
    model: float
    fv_only: float


@dataclass(frozen=True, repr=False)
class GapBin(Result):
    """Gap between rising and falling velocity at one velocity."""

    velocity_m_s: float
    gap_n: OfEach


@dataclass(frozen=True, repr=False)
class Hysteresis(Result):
    """Hysteresis of one test over its whole cycles."""

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
    """Every figure of one test."""

    __test__ = False  # no test case of pytest's

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
    """Errors grouped as the test schedule is."""

    by_amplitude: tuple[MatrixRow, ...]
    by_peak_velocity: tuple[MatrixRow, ...]
    cells: tuple[MatrixCell, ...]
    slow: MatrixRow | None
    not_periodic: MatrixRow | None


@dataclass(frozen=True, repr=False)
class LimitValue(Result):
    """A figure that a limit speaks of, N, and the test or tests that it comes from."""

    value_n: float
    tests: tuple[str, ...]


def missed(said: Mapping[str, Any]) -> str | None:
    """A sentence where a limit is missed, or was not tested, which is no pass; from the dictionary of a :class:`Checked`."""
    if said["verdict"] == "pass":
        return None
    name, quantity, velocity = said["name"], said["quantity"], said["velocity_m_s"]
    words = quantity if velocity is None else f"{quantity} at {velocity:g} m/s"
    # A limit without a name is called by its quantity, as the file writes it.
    if name.lower().replace(" ", "_").replace("-", "_") != quantity:
        words = f"{name}, {words}"
    if said["measured"] is None:
        slow = quantity in ("gas_force", "friction")
        return f"{words}: not tested, there is no {'slow test (below 6 mm/s)' if slow else 'test at this speed'}"
    value, low = said["measured"]["value_n"], said["low_n"]
    if low is not None and value < low:
        return f"{words}: {value:.4g} N is below {low:g} N"
    return f"{words}: {value:.4g} N is above {said['high_n']:g} N"


@dataclass(frozen=True, repr=False)
class Checked(Result):
    """One limit, with what the rig measured and what the model gives on the same tests."""

    name: str
    """Name in the table; the quantity where it has none."""
    quantity: str
    velocity_m_s: float | None
    amplitude_m: float | None
    low_n: float | None
    high_n: float | None
    line: int
    """Line of the table, or place among those given."""
    measured: LimitValue | None
    """None where the records cannot tell."""
    model: LimitValue | None
    verdict: str
    """Of the damper: ``pass``, ``fail`` or ``not_tested``, which is no pass."""
    model_verdict: str | None

    @property
    def missed(self) -> str | None:
        """A sentence where the damper misses the limit, or it was not tested."""
        return missed(self.to_dict())


@dataclass(frozen=True, repr=False)
class PeakPoint(Result):
    """Force at peak velocity of one stroke of a test, of rig and model."""

    test: str
    amplitude_m: float
    velocity_m_s: float
    force_n: float
    model_n: float | None


@dataclass(frozen=True, repr=False)
class Certificate(Result):
    """Which limits a damper keeps; the ``limits`` of ``dashpot validate --limits --json``."""

    passed: bool
    """Whether the damper keeps every limit. One that could not be tested is not kept."""
    model_passed: bool | None
    """The same for the model."""
    limits: tuple[Checked, ...]
    peaks: tuple[PeakPoint, ...]
    """The points that the forces were read from."""

    @property
    def missed(self) -> tuple[str, ...]:
        """A sentence for every limit that the damper misses or that was not tested."""
        return tuple(told for limit in self.limits if (told := limit.missed))

    def _rows(self) -> list[dict[str, Any]]:
        return [
            {
                "limit": c.name,
                "quantity": c.quantity,
                "velocity_m_s": c.velocity_m_s,
                "low_n": c.low_n,
                "high_n": c.high_n,
                "measured_n": c.measured.value_n if c.measured else None,
                "model_n": c.model.value_n if c.model else None,
                "verdict": c.verdict,
                "model_verdict": c.model_verdict,
            }
            for c in self.limits
        ]

    def _title(self) -> str:
        return "Limits: kept" if self.passed else "Limits: not kept"


@dataclass(frozen=True, repr=False)
class Validation(Result):
    """How close a model comes to a campaign; the JSON of ``dashpot validate``."""

    tests: tuple[TestValidation, ...]
    overall: Summary
    used_in_fit: Summary | None
    left_out: Summary | None
    matrix: ErrorMatrix
    region_boundary_m_s: float
    limits: Certificate | None = field(default=None, metadata={"omitted": True})
    """Which limits the damper keeps, where some were given."""
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """What the model's own fit found its records to be off by, and whether it was taken out of these."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    campaign: Campaign | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)
    """The records as they were compared; none in a result made from a dictionary."""
    _forces: tuple[tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]], ...] | None = field(
        default=None, metadata={"hidden": True}, compare=False, repr=False
    )

    def forces(self, test: str) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Forces (N) of the model and of the FV curve alone at the samples of one test of :attr:`campaign`."""
        names = [t.name for t in self.tests]
        if test not in names:
            raise KeyError(f"there is no test {test!r}; the first is called {names[0]!r}")
        if self._forces is None:
            raise ValueError("the forces are kept by Model.validate alone, not by a result made from a dictionary")
        model, fv_only = self._forces[names.index(test)]
        return model.copy(), fv_only.copy()

    def _rows(self) -> list[dict[str, Any]]:
        return [flat({k: v for k, v in t.to_dict().items() if k != "hysteresis"}) for t in self.tests]

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
        return table("Validation", [row]) + table("Tests", short)


@dataclass(frozen=True, repr=False)
class Evidence(Result):
    """What a refit with an effect brought."""

    share: float
    mean_square_before: float
    mean_square_after: float
    log_odds: float
    numbers: float
    implausibility: float
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
    share: float
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
    share: float
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
    held_out_rmse_n: float | None
    noise_n: float
    held_out_noise_n: float | None


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
    """A number of the model that is another on this damper than on the reference."""

    parameter: str
    reference: float
    value: float
    low: float
    high: float
    unit: str
    force_share: float
    #: Of a point of the FV curve (``fv_force``) its velocity, rebound positive.
    velocity_m_s: float | None = None

    @property
    def name(self) -> str:
        """The parameter, with the velocity of a point of the FV curve."""
        return self.parameter if self.velocity_m_s is None else f"{self.parameter}, {self.velocity_m_s:.3f} m/s"


@dataclass(frozen=True, repr=False)
class CurveMoved(Result):
    """How all points of the FV curve moved that the tests reach, where they moved alike."""

    #: ``dry_force`` (N against the motion) or ``share`` (of the force on the reference damper).
    by: str
    #: ``rebound``, ``compression`` or ``both``.
    side: str
    #: Mean over the points; ``low`` and ``high`` are the least and the most of them.
    value: float
    low: float
    high: float
    speed_m_s: tuple[float, float]


@dataclass(frozen=True, repr=False)
class TestOutcome(Result):
    """One test before and after."""

    __test__ = False  # no test case of pytest's

    test: str
    held_out: bool
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
class Diagnosis(Result):
    """What a model lacks, or what changed against a reference; the JSON of ``dashpot diagnose``."""

    verdict: str
    summary: str
    findings: tuple[Finding, ...]
    suspects: tuple[Rival, ...]
    regions: tuple[Region, ...] = field(metadata={"key": "where"})
    before: Figures
    after: Figures
    gap_closed: float | None
    unexplained_share: float
    tree: tuple[Branch, ...]
    next_tests: tuple[NextTest, ...]
    could_not_test: tuple[CouldNotTest, ...]
    shifts: tuple[Shift, ...]
    changed: tuple[Change, ...]
    curve_moved: tuple[CurveMoved, ...]
    notes: tuple[str, ...]
    tests: tuple[TestOutcome, ...]
    rounds: tuple[tuple[Tried, ...], ...]
    corrections: dict[str, float]
    over_whole_records: OverWholeRecords
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """What the model's own fit found its records to be off by, and whether it was taken out of these."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    improved: Model | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)
    """The model with the named effects added; what is of the rig is not put into it."""
    _curves: tuple[dict[str, npt.NDArray[np.float64]], ...] | None = field(
        default=None, metadata={"hidden": True}, compare=False, repr=False
    )

    def curves(self, test: str) -> dict[str, npt.NDArray[np.float64]]:
        """Mean cycle of one test: displacement, velocity, measured force, force before and after."""
        names = [t.test for t in self.tests]
        if test not in names:
            raise KeyError(f"there is no test {test!r}; the first is called {names[0]!r}")
        if self._curves is None:
            raise ValueError("the curves are kept by diagnose() alone, not by a result made from a dictionary")
        return {name: values.copy() for name, values in self._curves[names.index(test)].items()}

    def _rows(self) -> list[dict[str, Any]]:
        return [
            {
                "effect": f.effect,
                "form": f.form,
                "confidence": f.confidence,
                "share": f.share,
                "of the rig": f.of_the_rig,
                "parameter": name,
                "value": v.value,
                "low": v.low,
                "high": v.high,
                "unit": v.unit,
            }
            for f in self.findings
            for name, v in f.parameters.items()
        ]

    def _repr_html_(self) -> str:
        suspects = [f"Suspect, {s.effect}: {s.why}" for s in self.suspects]
        tests = [t.text for t in self.next_tests]
        changed = table("Numbers that are others than on the reference", [c.to_dict() for c in self.changed])
        said = table(self.summary, self._rows(), [*suspects, *self.notes, *tests])
        return said + (changed if self.changed else "")
