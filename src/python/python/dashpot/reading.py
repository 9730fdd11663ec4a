"""What reading records found and noticed. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field

from ._result import Result


@dataclass(frozen=True, repr=False)
class Note(Result):
    """One thing that reading did or noticed."""

    kind: str
    text: str


@dataclass(frozen=True, repr=False)
class SignFinding(Result):
    """Which direction the files count positive, and how sure that is."""

    positive: str
    is_stated: bool
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
class Setting(Result):
    """What an adjustable damper was set to: the current of its valve, or the clicks of its adjuster."""

    name: str
    unit: str
    value: float


@dataclass(frozen=True, repr=False)
class Unusable(Result):
    """A file or test that was left out."""

    why: str
    """Why, in a sentence that names the file, and the test within it."""
    is_test: bool
    """Whether it is a test, with a fault of its own; else the file is no record at all."""
