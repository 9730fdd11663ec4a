"""A damper in a host that holds its force over a step. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, TypeVar

from ._result import Result, table

_Model = TypeVar("_Model")


@dataclass(frozen=True, repr=False)
class HostCheck(Result, Generic[_Model]):
    """Whether a damper chatters in a host; the JSON of ``dashpot check``."""

    host_step_s: float
    wheel_mass_kg: float
    gain: float
    """c·h/m at most: from 1 on the velocity changes sign at every step, beyond 2 that grows."""
    chatters: bool
    """Whether the gain is 1 or more, or the force turns at every step in a loop like the host's."""
    swings: bool
    velocity_m_s: float
    """Velocity at which the gain is largest, and the slopes of the force there."""
    damping_n_s_m: float
    stiffness_n_m: float
    place_m: float
    side_force_n: float
    temperature_c: float
    quiet_step_s: float | None
    """The longest step without chatter; none where none was found."""
    element: str | None
    """The element that makes most of it."""
    turning_force_n: float | None
    turning_steps: int | None
    grows: bool
    calming_series_damping_n_s_m: float | None
    gain_without_it: float | None
    softened: tuple[str, ...]
    """Elements that were replaced or made less steep for ``for_step_s``."""
    rms_error_n: float | None
    """By how much the force of the damper that was made ready differs, over the motions looked at."""
    fastest_rate_1_s: float
    """How fast the states move by themselves, for a host that integrates them itself."""
    explicit_step_s: float
    followed_step_s: float | None
    """The longest step whose substeps follow a mass that rings on its spring; none where nothing rings."""
    largest_error_n: float | None
    told: tuple[str, ...] = field(default=(), metadata={"hidden": True}, compare=False)
    """What the command says of it, in sentences."""
    _ready: _Model | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    @property
    def ready(self) -> _Model:
        """The damper as the host gets it: with ``for_step_s`` without the friction that would chatter, else as it was.

        :raises ValueError: if this result was made from a dictionary, which contains no model.
        """
        if self._ready is None:
            raise ValueError("the damper is kept by Model.check alone, not by a result made from a dictionary")
        return self._ready

    def _repr_html_(self) -> str:
        return table("Chatters in this host" if self.chatters else "Does not chatter in this host", self._rows(), self.told)
