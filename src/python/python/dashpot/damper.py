"""Simulation of one damper, or of many dampers together, in a loop with a fixed step."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Union, overload

import numpy as np

from . import _native
from ._numbers import HIGHEST_SPEED_M_S, LARGEST_AMPLITUDE_M, column, real, warn_of_units
from .model import Model

if TYPE_CHECKING:
    import numpy.typing as npt

    Forces = npt.NDArray[np.float64]


#: Length of a damper's state, and the index of its number that identifies the model's elements.
_NUMBERS, _LAYOUT = 14, 12
_COMPLEX = frozenset((np.complex64, np.complex128, np.clongdouble))


class Damper:
    """One damper, or many dampers, with their states, for a loop with a fixed step.

    >>> damper = Damper(model, initial_position_m=-0.02)          # doctest: +SKIP
    >>> force = damper.step(velocity, dt_s)                       # one damper: numbers  # doctest: +SKIP
    >>> corners = Damper([front, front, rear, rear], np.zeros(4)) # four: arrays  # doctest: +SKIP
    >>> corners.step(velocities, dt_s, out=forces)                 # no allocation  # doctest: +SKIP
    >>> moving = Damper(model, x, initial_velocity_m_s=v)         # steady motion  # doctest: +SKIP

    A single initial position makes a single damper, whose steps accept and return numbers. A list or an array makes one damper for each
    position. Their steps accept numbers or arrays, and return arrays. SI units; extension (rebound) velocity and tension force are positive.
    A rejected step raises :class:`dashpot.StepError` and leaves all states unchanged.

    By default a damper starts at rest and in equilibrium, so that a step without motion gives the static force. With ``initial_velocity_m_s``,
    it starts in steady motion at this velocity, with ``side_force_n`` and ``temperature_c``. Use this if the simulation starts in motion.
    Otherwise the first step would contain a jump of the velocity. The C interface has ``dashpot_state_init_motion`` for the same start.

    :param initial_position_m: initial displacement, m, extension positive; one number, or one for each damper.
    :param initial_velocity_m_s: initial velocity, m/s, extension positive; one number for all dampers, or one for each.
    :param side_force_n: side force at the start, N; one number for all dampers, or one for each.
    :param temperature_c: damper temperature at the start, °C; one number for all dampers, or one for each.
    :raises StepError: if a damper cannot start with these values.
    """

    def __init__(
        self,
        model: Union[Model, Sequence[Model]],
        initial_position_m: npt.ArrayLike = 0.0,
        *,
        initial_velocity_m_s: npt.ArrayLike = 0.0,
        side_force_n: npt.ArrayLike = 0.0,
        temperature_c: npt.ArrayLike = 20.0,
    ) -> None:
        models = [model] if isinstance(model, Model) else list(model)
        for given in models:
            if not isinstance(given, Model):
                raise TypeError(f"a damper is made of a dashpot.Model, not of a {type(given).__name__}; dashpot.Model.read(path) reads one")
        given_positions = np.asarray(initial_position_m)
        real("initial_position_m", given_positions)
        positions = given_positions.astype(float)
        self._single = positions.ndim == 0 and isinstance(model, Model)
        if positions.ndim == 0:
            positions = np.full(len(models), float(positions))
        if positions.ndim != 1:
            raise ValueError(f"initial_position_m is one number, or one for each damper, not an array of {positions.ndim} dimensions")
        self._models, self._count = tuple(models), len(positions)
        channels = {"initial_velocity_m_s": initial_velocity_m_s, "side_force_n": side_force_n, "temperature_c": temperature_c}
        start = [_of_each(name, given, len(positions)) for name, given in channels.items()]
        self._warned = False
        warn_of_units(velocity_m_s=np.asarray(start[0]))
        if len(positions) and float(np.abs(positions).max()) > LARGEST_AMPLITUDE_M:
            self._warn()
        self._native = _native.Dampers([m._native for m in models], positions.tolist(), *start)
        self._forces: Forces = np.zeros(len(positions))
        self._layouts = self._native.state[:, _LAYOUT].copy()

    def __len__(self) -> int:
        return self._count

    def __repr__(self) -> str:
        return f"<dashpot.Damper, {'one damper' if self._single else f'{len(self)} dampers'}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (self._models, self._single, self.state))

    @overload
    def step(
        self,
        velocity_m_s: npt.ArrayLike,
        dt_s: float,
        displacement_m: npt.ArrayLike | None = None,
        *,
        side_force_n: npt.ArrayLike = 0.0,
        temperature_c: npt.ArrayLike = 20.0,
        out: Forces,
    ) -> Forces: ...
    @overload
    def step(  # pyright: ignore[reportOverlappingOverload]
        self,
        velocity_m_s: float,
        dt_s: float,
        displacement_m: float | None = None,
        *,
        side_force_n: float = 0.0,
        temperature_c: float = 20.0,
        out: None = None,
    ) -> float: ...
    @overload
    def step(
        self,
        velocity_m_s: npt.ArrayLike,
        dt_s: float,
        displacement_m: npt.ArrayLike | None = None,
        *,
        side_force_n: npt.ArrayLike = 0.0,
        temperature_c: npt.ArrayLike = 20.0,
        out: None = None,
    ) -> Forces: ...
    def step(
        self,
        velocity_m_s: npt.ArrayLike,
        dt_s: float,
        displacement_m: npt.ArrayLike | None = None,
        *,
        side_force_n: npt.ArrayLike = 0.0,
        temperature_c: npt.ArrayLike = 20.0,
        out: Forces | None = None,
    ) -> Union[float, Forces]:
        """Advances the dampers by ``dt_s`` (s) to the velocity (m/s) at the end of the step. Returns the force (N) at that time.

        A single damper returns a number, and many dampers return an array, regardless of the types of the arguments. Type checkers do not
        know the number of dampers. They assume that numbers give a number, and arrays give an array.

        :param displacement_m: displacement at the end of the step, m. By default it is integrated from the initial position. A host that
            knows the displacement should pass it, because the integral drifts.
        :param side_force_n: side force, N.
        :param temperature_c: damper temperature, °C.
        :param out: array for the forces, one float64 for each damper; a new array if not given.
        :raises StepError: if an input is implausible. All states stay unchanged.
        """
        # A complex number of numpy would lose its imaginary part. Set lookups are fast enough for a step of about one microsecond.
        if (
            velocity_m_s.__class__ in _COMPLEX or displacement_m.__class__ in _COMPLEX or dt_s.__class__ in _COMPLEX
            or side_force_n.__class__ in _COMPLEX or temperature_c.__class__ in _COMPLEX
        ):  # fmt: skip
            raise TypeError("velocity_m_s, dt_s, displacement_m, side_force_n and temperature_c are real numbers; one of them is complex")
        if out is not None:
            if self._native.step(velocity_m_s, dt_s, displacement_m, side_force_n, temperature_c, out):
                self._warn()
            return out
        forces = self._forces if self._single else np.empty(self._count)
        if self._native.step(velocity_m_s, dt_s, displacement_m, side_force_n, temperature_c, forces):
            self._warn()
        return float(forces[0]) if self._single else forces

    def _warn(self) -> None:
        """Warns once of a motion that is too large for a damper."""
        if not self._warned:
            self._warned = True
            warnings.warn(
                f"a displacement beyond {LARGEST_AMPLITUDE_M} m or a velocity beyond {HIGHEST_SPEED_M_S:g} m/s is none of a damper; displacements are in "
                "meters and velocities in m/s: divide millimeters by 1000",
                stacklevel=3,
            )

    @property
    def state(self) -> npt.NDArray[np.float64]:
        """Copy of all states, with a row of fourteen numbers for each damper. Assigning such an array restores the states."""
        return self._native.state

    @state.setter
    def state(self, rows: npt.NDArray[np.float64]) -> None:
        given = np.asarray(rows)
        real("the state", given)
        if given.shape == (self._count, _NUMBERS):
            # The number is 0 in a state of zeros, which every model accepts.
            other = np.flatnonzero((given[:, _LAYOUT] != self._layouts) & (given[:, _LAYOUT] != 0))
            if len(other):
                raise ValueError(f"the state of damper {other[0]} is of a model with other elements; start a damper of that model instead")
        self._native.state = given


def _of_each(name: str, given: npt.ArrayLike, count: int) -> list[float]:
    """Converts one number for all dampers, or a column with one number for each, to a list of ``count`` numbers."""
    values = np.asarray(given)
    real(name, values)
    if values.ndim == 0:
        return [float(values)] * count
    return list(column(name, given).tolist())


def _again(models: tuple[Model, ...], single: bool, state: Forces) -> Damper:
    """Rebuilds dampers for pickle."""
    damper = Damper(models[0], 0.0) if single else Damper(models[0] if len(models) == 1 else models, np.zeros(len(state)))
    damper.state = state
    return damper
