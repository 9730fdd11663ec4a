"""Small campaigns of many dampers, simulated by the kernel with noise on the force."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

import dashpot

#: Amplitude, m, and peak velocity, m/s, of the tests. Without the slow test, no fit can distinguish friction from the FV curve.
TESTS = ((0.025, 0.003), (0.025, 0.05), (0.025, 0.26), (0.025, 0.52), (0.005, 0.13))
#: Number of samples in a cycle, and number of cycles in a test.
SAMPLES, CYCLES = 100, 3


def damper(scale: float = 1.0, friction: float = 30.0, gas: float = 140.0) -> dashpot.Model:
    """Makes a digressive damper with friction, N, and gas force, N. ``scale`` is a factor of its FV curve."""
    velocity = [-1.0, -0.5, -0.25, -0.1, 0.0, 0.1, 0.25, 0.5, 1.0]
    force = [scale * f for f in (-1100, -800, -560, -330, 0, 600, 1150, 1500, 2000)]
    return dashpot.Model(
        'format = 1\nelements = ["fv_curve", "series_compliance", "coulomb_friction", "gas_preload"]\n'
        f"fv_velocity = {velocity}\nfv_force = {force}\ncoulomb_force = {friction!r}\ngas_force = {gas!r}\n"
    )


def measure(model: dashpot.Model, folder: Path, seed: int, tests: Sequence[tuple[float, float]] = TESTS) -> None:
    """Simulates a campaign of the damper, adds 2 N rms of noise, and writes its records into a folder."""
    folder.mkdir(parents=True)
    noise = np.random.default_rng(seed)
    for amplitude, peak in tests:
        rate = peak / amplitude
        t = np.arange(SAMPLES * CYCLES + 1) * (2 * np.pi / rate / SAMPLES)
        x, v = amplitude * np.sin(rate * t), peak * np.cos(rate * t)
        force = model.simulate(t, x, v).force + noise.normal(0, 2, len(t))
        table = np.column_stack([t, x, v, force])
        name = folder / f"a{1000 * amplitude:g}_v{1000 * peak:g}.csv"
        np.savetxt(name, table, fmt="%.9g", delimiter=",", header="time_s,displacement_m,velocity_m_s,force_N", comments="")


def turn(folder: Path) -> None:
    """Reverses the signs of displacement, velocity and force in every test of a campaign."""
    for file in folder.iterdir():
        table = np.loadtxt(file, delimiter=",", skiprows=1)
        head = file.read_text().splitlines()[0]
        np.savetxt(file, table * [1, -1, -1, -1], fmt="%.9g", delimiter=",", header=head, comments="")


def fleet(folder: Path, count: int) -> Path:
    """Writes campaigns of ``count`` dampers whose FV curves scatter by 3 % and whose friction scatters by 5 %. Returns the path of their list."""
    scatter = np.random.default_rng(7)
    lines = ["campaign,serial,batch,date"]
    for k in range(count):
        scale = 1 + 0.03 * scatter.normal()
        measure(damper(scale, 30 * (1 + 0.05 * scatter.normal())), folder / f"d{k:05d}", seed=k)
        lines.append(f"d{k:05d},SN{k:05d},B{k // 20:03d},2026-{1 + k // 25 % 12:02d}-{1 + k % 25:02d}")
    path = folder / "fleet.csv"
    path.write_text("\n".join(lines) + "\n")
    return path
