"""What a fit found. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result, Row, folded, table
from .reading import SignFinding, Unusable
from .validation import Deviation


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

    def _rows(self) -> list[Row]:
        return [p.to_dict() for p in self.parameters]

    def _repr_html_(self) -> str:
        said = [f"{c.of}: {c.chosen} — {c.why}" for c in self.choices]
        said += [f"{m.name} of the measurement: {m.value:.4g} {m.unit} ({m.low:.4g} to {m.high:.4g})" for m in self.measured]
        said += [*self.notes, *(u.why for u in self.unusable)]
        shown = table(f"Fit to {len(self.tests)} tests", self._rows(), said)
        return shown + folded({name or "figures": rows for name, rows in self._tables().items() if name != "parameters"})
