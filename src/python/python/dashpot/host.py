"""Check of a damper in a host with a zero-order hold of its force. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Generic, TypeVar

from ._result import Result, table

_Model = TypeVar("_Model")


@dataclass(frozen=True, repr=False)
class HostCheck(Result, Generic[_Model]):
    """Result of the check for chatter of a damper in a host; the JSON of ``dashpot check``."""

    host_step_s: float
    wheel_mass_kg: float
    gain: float
    """Largest value of c·h/m, with damping c, host step h and mass m. From 1 on, the velocity changes sign at every step. Above 2, it grows."""
    chatters: bool
    """Whether the gain is 1 or more, or the force changes its direction at every step of a simulated host loop."""
    swings: bool
    velocity_m_s: float
    """Velocity at the largest gain. The two fields after it are the derivatives of the force at this velocity."""
    damping_n_s_m: float
    stiffness_n_m: float
    place_m: float
    side_force_n: float
    temperature_c: float
    quiet_step_s: float | None
    """Longest host step without chatter, s; None if none was found."""
    element: str | None
    """Element that causes the chatter; None if no single element is the cause."""
    turning_force_n: float | None
    turning_steps: int | None
    grows: bool
    calming_series_damping_n_s_m: float | None
    gain_without_it: float | None
    softened: tuple[str, ...]
    """Elements that were replaced or made less steep for ``for_step_s``."""
    rms_error_n: float | None
    """Rms difference between the forces of the given damper and of :attr:`ready` over the evaluated motions, N; None without a replacement."""
    fastest_rate_1_s: float
    """Fastest rate of the internal states, 1/s, for a host that integrates them itself."""
    explicit_step_s: float
    followed_step_s: float | None
    """Longest step, s, whose substeps resolve the oscillation of a mass on its spring; None if no mass oscillates."""
    largest_error_n: float | None
    told: tuple[str, ...] = field(default=(), metadata={"hidden": True}, compare=False)
    """Messages of the command."""
    _ready: _Model | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    @property
    def ready(self) -> _Model:
        """The damper for the host. With ``for_step_s``, friction that would chatter is replaced; otherwise the damper is unchanged.

        :raises ValueError: if this result was made from a dictionary, which contains no model.
        """
        if self._ready is None:
            raise ValueError("the damper is kept by Model.check alone, not by a result made from a dictionary")
        return self._ready

    def _repr_html_(self) -> str:
        return table("Chatters in this host" if self.chatters else "Does not chatter in this host", self._rows(), self.told)
