"""The virtual rig: records to try things on."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from . import _native
from ._work import watched
from .campaign import Campaign, Path, Progress


def measure_virtual(
    folder: Path,
    *,
    amplitudes_m: Sequence[float] | None = None,
    peak_velocities_m_s: Sequence[float] | None = None,
    seed: int = 0,
    noise_percent: float = 1.0,
    hide: Mapping[str, float] | None = None,
    progress: Progress | None = None,
) -> Campaign:
    """Measures a campaign on the virtual rig, writes its records into a folder, and reads them; as ``dashpot rig``.

    The damper is a physical one that shares nothing with the model. With ``hide``, a neutral damper of the model's own topology
    instead, in which effects are hidden: names with strengths, 1 being a typical strong case; an empty mapping hides nothing.

    :param amplitudes_m: amplitudes of the tests, m; the thesis's if not given.
    :param peak_velocities_m_s: peak velocities of the tests, m/s; the thesis's if not given.
    :param seed: which damper, and which noise; 0 is the default damper.
    :param noise_percent: noise of the force, percent of each test's root-mean-square force.
    :raises RigError: where a test or an effect cannot be.
    """
    with watched(progress) as told:
        _native.measure(
            os.fspath(folder),
            None if amplitudes_m is None else list(amplitudes_m),
            None if peak_velocities_m_s is None else list(peak_velocities_m_s),
            seed,
            noise_percent,
            None if hide is None else list(hide.items()),
            told,
        )
    return Campaign.read(folder)
