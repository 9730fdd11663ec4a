"""Dampers that depend on a setting: the current of a semi-active valve, the click of an adjuster."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from . import _native
from ._numbers import column, real
from .model import Model, Response


class Family:
    """A damper over a setting, from a model file that names its grid (``setting = [...]``).

    >>> family = dashpot.Family.read("semi_active.toml")              # doctest: +SKIP
    >>> family.at(0.8).steady_force([0.1, 0.5])                       # doctest: +SKIP
    >>> family.simulate(t, displacement=x, setting=current).force     # doctest: +SKIP
    """

    def __init__(self, text: str, name: Path | str = "model.toml") -> None:
        self._name = Path(name)
        self._native = _native.Family.parse(text, self._name)
        grid, self.start, self.name, self.unit = self._native.setting()
        #: The settings of the file, increasing.
        self.grid = np.array(grid)

    @staticmethod
    def read(path: Path | str) -> Family:
        """Reads a model file.

        :raises ModelError: where the file is no damper, or one that depends on no setting.
        """
        return Family(Path(path).read_text(encoding="utf-8"), path)

    def __getstate__(self) -> tuple[str, Path]:
        return self._native.text, self._name

    def __setstate__(self, state: tuple[str, Path]) -> None:
        self.__init__(*state)  # type: ignore[misc]

    def at(self, setting: float) -> Model:
        """The ordinary damper at a setting, clamped to the grid; the actuator is no part of it."""
        real("setting", setting)
        return Model(self._native.at(setting, self._name).text, self._name)

    def simulate(
        self,
        time: npt.ArrayLike,
        displacement: npt.ArrayLike | None = None,
        velocity: npt.ArrayLike | None = None,
        *,
        setting: npt.ArrayLike | None = None,
        initial_position: float | None = None,
    ) -> Response:
        """The force for a motion, as :meth:`Model.simulate`, actuator included.

        :param setting: commanded setting, one number or one for every time: that of the step that ends there. The start setting if not given.
        :raises MotionError: where a number overflows.
        :raises ValueError, TypeError: where a channel is no column of finite real numbers, one for every time.
        """
        times = column("time", time)
        given = np.asarray(self.start if setting is None else setting, dtype=float)
        settings = np.full(len(times), float(given)) if given.ndim == 0 else column("setting", setting)
        channels = (
            None if displacement is None else column("displacement", displacement),
            None if velocity is None else column("velocity", velocity),
        )
        real("initial_position", initial_position)
        return Response(*self._native.simulate(times, *channels, settings, initial_position))
