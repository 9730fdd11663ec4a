"""Findings of reading records. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result


@dataclass(frozen=True, repr=False)
class Note(Result):
    """Note on an action or an observation of reading."""

    kind: str
    text: str


@dataclass(frozen=True, repr=False)
class SignFinding(Result):
    """Positive direction in the files, its confidence and the reasons."""

    positive: str
    is_stated: bool
    confidence: float
    reasons: tuple[str, ...]
    standstill_force: float
    asymmetry: float | None


@dataclass(frozen=True, repr=False)
class Delay(Result):
    """Delay of the force channel relative to the motion, s. The records are not shifted by it."""

    seconds: float
    unexplained_as_recorded: float
    unexplained: float


@dataclass(frozen=True, repr=False)
class Noise(Result):
    """Noise of the force channel: root mean square of one sample, N, and correlation of adjacent samples."""

    force_rms: float
    lag1: float
    source: str = field(metadata={"key": "from"})


@dataclass(frozen=True, repr=False)
class Setting(Result):
    """Setting of an adjustable damper: the current of its valve, or the clicks of its adjuster."""

    name: str
    unit: str
    value: float


@dataclass(frozen=True, repr=False)
class Unusable(Result):
    """A file or test that was left out."""

    why: str
    """Reason, as a sentence that names the file and the test."""
    is_test: bool
    """Whether it is a test with a fault of its own. Otherwise the file is no record."""
