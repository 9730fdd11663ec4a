"""Dampers that depend on a setting, such as the current of a semi-active valve or the click of an adjuster."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._arguments import as_arguments, loads
from ._files import needs, write_new
from ._numbers import column, real
from ._result import Row, frame, table
from ._work import watched
from .campaign import Campaign, Path, Progress, Record, native_of
from .family_fit import FamilyFitResult
from .limits import Limit, rows
from .model import Model, Response, _named_after
from .validation import JudgedValidation, Validation

if TYPE_CHECKING:
    import pandas


class Family:
    """A damper that depends on a setting. Its model file contains a grid of settings (``setting = [...]``).

    :func:`dashpot.fit` with ``setting`` makes a family, and :meth:`read` reads one.

    >>> family = dashpot.fit(campaign, setting="current")             # doctest: +SKIP
    >>> family.at(0.8).steady_force([0.1, 0.5])                       # doctest: +SKIP
    >>> family.steady_force(0.5, setting=[0.0, 0.8, 1.6])             # doctest: +SKIP
    >>> family.simulate(t, displacement_m=x, setting=current).force     # doctest: +SKIP
    >>> family.validate(campaign).settings                            # doctest: +SKIP
    """

    def __init__(self, text: str, name: Path = "model.toml") -> None:
        self._name = os.fspath(name)
        self._native = _native.Family.parse(text, self._name)
        grid, self.start, self.name, self.unit = self._native.setting()
        #: Settings of the model file, increasing.
        self.grid = np.array(grid)

    @staticmethod
    def read(path: Path) -> Family:
        """Reads a model file.

        :raises ModelError: if the file is no model file, or its damper depends on no setting.
        :raises FileNotFoundError: if the file does not exist.
        """
        with needs(path), open(path, encoding="utf-8") as file:
            return Family(file.read(), path)

    @staticmethod
    def from_peaks(
        path: Path,
        *,
        positive: str | None = None,
        units: Mapping[str, str] | None = None,
        columns: Mapping[str, str | int] | None = None,
        gas_force_n: float = 0.0,
        friction_n: float = 0.0,
    ) -> Family:
        """Makes a damper that depends on clicks from a table of peak forces with a curve for each click.

        The command is ``dashpot import peaks --clicks family``. The arguments are those of :meth:`Model.from_peaks`. Warnings report speeds
        that were left out or interpolated, and clicks that seem to be interchanged.

        :raises ModelError: if the table is unreadable or has no clicks, or if its forces give no valid model. The message names the line.
        """
        for name, value in (("gas_force_n", gas_force_n), ("friction_n", friction_n)):
            real(name, value)
        with needs(path):
            text, direction, is_doubtful, notes = _native.import_peaks(
                os.fspath(path), positive, dict(units or {}), {k: str(v) for k, v in (columns or {}).items()}, None, gas_force_n, friction_n, True
            )
        for note in [*([direction] if is_doubtful else []), *notes]:
            warnings.warn(as_arguments(note), stacklevel=2)
        return Family(text, _named_after(path))

    def __reduce__(self) -> tuple[Any, ...]:
        return (Family, (self.text, self._name))

    def __repr__(self) -> str:
        settings = ", ".join(f"{value:g}" for value in self.grid)
        return f"<dashpot.Family over {self.name or 'a setting'}: {settings} {self.unit}".rstrip() + ">"

    @property
    def text(self) -> str:
        """Text of the model file."""
        return self._native.text

    def write(self, path: Path, *, force: bool = False) -> None:
        """Writes the model file atomically.

        :param force: replaces an existing file, even one of another kind or a write-protected file.
        :raises OutputError: if the file cannot be written.
        """
        write_new(path, self.text, force)
        self._name = os.fspath(path)

    def at(self, setting: float) -> Model:
        """Returns the ordinary damper at a setting, which is clamped to the range of the grid. It does not contain the actuator."""
        real("setting", setting)
        return Model(self._native.at(setting, self._name).text, self._name)

    def _rows(self) -> list[Row]:
        def row(setting: float) -> Row:
            numbers = {p.name: p.value for p in self.at(setting).parameters.values() if isinstance(p.value, float)}
            return {self.name or "setting": setting, **numbers}

        return [row(float(setting)) for setting in self.grid]

    def to_pandas(self) -> pandas.DataFrame:
        """Returns one row for each setting of the grid, with the parameters in use at that setting. Requires pandas."""
        return frame(self._rows())

    def _repr_html_(self) -> str:
        return table(f"Damper over {self.name or 'a setting'} {self.unit}".rstrip(), self._rows())

    def steady_force(self, velocity_m_s: npt.ArrayLike, *, setting: npt.ArrayLike | None = None) -> npt.NDArray[np.float64]:
        """Returns the force (N) in steady motion at each velocity (m/s) through displacement 0: the FV curve with friction and gas force.

        :param setting: one setting or several. Velocities and settings are broadcast by the rules of numpy. Default: start setting.
        :raises ValueError: if shapes do not match or a number is not finite.
        """
        given = np.asarray(self.start if setting is None else setting, dtype=float)
        velocities, settings = np.broadcast_arrays(np.asarray(velocity_m_s, dtype=float), given)
        return self._native.steady_force(velocities.ravel(), settings.ravel()).reshape(velocities.shape)

    @overload
    def validate(
        self, campaign: Sequence[Record], *, setting: float | None = None, limits: None = None, progress: Progress | None = None
    ) -> Validation: ...
    @overload
    def validate(
        self, campaign: Sequence[Record], *, setting: float | None = None, limits: Sequence[Limit], progress: Progress | None = None
    ) -> JudgedValidation: ...
    def validate(
        self,
        campaign: Sequence[Record],
        *,
        setting: float | None = None,
        limits: Sequence[Limit] | None = None,
        progress: Progress | None = None,
    ) -> Validation:
        """Compares the damper with records, each test at its own setting, like ``dashpot validate``.

        :attr:`Validation.settings` contains the errors at each setting. Warnings report tests whose forces match another setting.

        :param setting: setting of tests without a setting of their own.
        :param limits: limits that the damper must keep, each at its :attr:`Limit.setting`.
        :raises ValidationError: if a test or a limit has no setting.
        """
        real("setting", setting)
        windows = None if limits is None else rows(limits)
        with watched(progress) as told:
            said, forces, as_compared, doubts = self._native.validate(native_of(campaign, "campaign"), setting, told, windows)
        compared = Campaign(as_compared, campaign.paths if isinstance(campaign, Campaign) else ())
        kind = Validation if limits is None else JudgedValidation
        for doubt in doubts:
            warnings.warn(doubt, stacklevel=2)
        return replace(kind.from_dict(loads(said)), _forces=tuple(forces), campaign=compared)

    def simulate(
        self,
        time_s: npt.ArrayLike,
        displacement_m: npt.ArrayLike | None = None,
        velocity_m_s: npt.ArrayLike | None = None,
        *,
        setting: npt.ArrayLike | None = None,
        initial_position_m: float | None = None,
    ) -> Response:
        """Simulates the force for a motion, like :meth:`Model.simulate`, but including the actuator.

        :param setting: commanded setting, one number or one for every time. A setting applies to the step that ends at its time, and is
            clamped to the range of the grid. Default: start setting. For a sampled channel, ``dashpot simulate`` uses the mean of the
            settings at both ends of the step instead.
        :raises MotionError: if a number overflows.
        :raises ValueError, TypeError: if a channel is not one-dimensional or does not contain one finite real number for every time.
        """
        times = column("time_s", time_s)
        given = np.asarray(self.start if setting is None else setting, dtype=float)
        settings = np.full(len(times), float(given)) if given.ndim == 0 else column("setting", given)
        channels = (
            None if displacement_m is None else column("displacement_m", displacement_m),
            None if velocity_m_s is None else column("velocity_m_s", velocity_m_s),
        )
        real("initial_position_m", initial_position_m)
        return Response(*self._native.simulate(times, *channels, settings, initial_position_m))


class FittedFamily(Family):
    """A damper that depends on a setting and was made by :func:`dashpot.fit`, with the results of the fit."""

    def __init__(self, text: str, name: Path, fit: FamilyFitResult) -> None:
        super().__init__(text, name)
        #: Results of the fit: parameters with intervals, dependence on the setting, and errors at each setting.
        self.fit = fit

    def __reduce__(self) -> tuple[Any, ...]:
        return (FittedFamily, (self.text, self._name, self.fit))
