"""The quarter cars of skyhook.c in Python, which prints the same lines.

    python skyhook.py target/release/libdashpot.so examples/semi_active.toml 1        quarter car
    python skyhook.py target/release/libdashpot.so examples/semi_active.toml 4        four corners
"""
import cmath
import ctypes as c
import math
import sys

from dashpot_damper import Damper

BODY, WHEEL, SPRING, TIRE = 400.0, 45.0, 22e3, 210e3  # kg, N/m
STEP, SKY, STEPS = 1e-3, 2200.0, 20000  # s, N s/m
EDGES = (0.5, 3.0, 8.0, 25.0)  # Hz
LENGTH = 16384  # samples of the spectrum, a power of two


def command(damper: Damper, motion: tuple[float, float], body_rate: float, setting: float, force: float,
            low: float, high: float) -> float:
    """Returns the setting at which the damper gives the skyhook force, or the lowest setting if it cannot."""
    gain, wanted = c.c_double(), SKY * body_rate
    at = damper.motion(*motion, setting)
    damper.check(damper.library.dashpot_d_force_d_setting(
        c.byref(damper.model), c.byref(damper.state), c.byref(at), c.c_double(STEP), c.byref(gain)))
    chosen = low
    if wanted * motion[1] > 0.0:
        chosen = setting + (wanted - force) / gain.value if abs(gain.value) > 1.0 else high
    return min(max(chosen, low), high)


def fourier(values: list[complex]) -> list[complex]:
    """Returns the discrete Fourier transform of a list whose length is a power of two."""
    half = len(values) // 2
    if half == 0:
        return values
    even, odd = fourier(values[::2]), fourier(values[1::2])
    turned = [cmath.exp(-1j * math.pi * k / half) * odd[k] for k in range(half)]
    return [a + b for a, b in zip(even, turned)] + [a - b for a, b in zip(even, turned)]


def bands(acceleration: list[float]) -> list[float]:
    """Returns the rms of the acceleration, m/s^2, in each frequency band over the last 16.384 s."""
    lines = fourier([complex(a) for a in acceleration[-LENGTH:]])

    def rms(low: float, high: float) -> float:
        own = range(math.ceil(low * LENGTH * STEP), math.ceil(high * LENGTH * STEP))
        return math.sqrt(sum(2.0 * abs(lines[k]) ** 2 for k in own)) / LENGTH

    return [rms(low, high) for low, high in zip(EDGES, EDGES[1:])]


def drive(damper: Damper, seed: int, controlled: bool, setting: float, low: float, high: float) -> tuple[list[float], float]:
    """Drives one corner. Returns the accelerations of the body, m/s^2, and the rms of the tire's deflection, m."""
    start = damper.motion(0.0, 0.0, setting)
    damper.check(damper.library.dashpot_state_init_motion(c.byref(damper.model), c.byref(start), c.byref(damper.state)))
    force = rest = damper.try_step(0.0, 0.0, 0.0, setting)[0]
    body = body_rate = wheel = wheel_rate = road = tires = 0.0
    accelerations = []
    for _ in range(STEPS):
        spring, damping, tire = -SPRING * (body - wheel), force - rest, -TIRE * (wheel - road)
        acceleration = (spring - damping) / BODY
        accelerations.append(acceleration)
        tires += (tire / TIRE) * (tire / TIRE) / STEPS
        body_rate += STEP * acceleration
        wheel_rate += STEP * (tire - spring + damping) / WHEEL
        body += STEP * body_rate
        wheel += STEP * wheel_rate
        seed = (seed * 1664525 + 1013904223) % 2**32
        road += STEP * (((seed >> 8) / 8388608.0 - 1.0) * 1.1 - 0.8 * road)
        motion = (body - wheel, body_rate - wheel_rate)
        if controlled:
            setting = command(damper, motion, body_rate, setting, damping, low, high)
        force = damper.step(*motion, STEP, setting)
    return accelerations, math.sqrt(tires)


def main() -> None:
    if len(sys.argv) < 3 or sys.argv[3:] not in ([], ["1"], ["4"]):
        raise SystemExit("usage: python skyhook.py LIBRARY MODEL.toml [1 or 4 corners]")
    corners = int(sys.argv[3]) if sys.argv[3:] else 1
    damper = Damper(sys.argv[1], sys.argv[2])
    for name, controlled, setting in (("soft", False, 0.0), ("start", False, 0.6), ("skyhook", True, 0.6)):
        for corner in range(1, corners + 1):
            accelerations, tire = drive(damper, corner, controlled, setting, 0.0, 1.6)
            whole = math.sqrt(sum(a * a for a in accelerations) / STEPS)
            one, two, three = bands(accelerations)
            print(f"{name:8} corner {corner}  acceleration {whole:.4f} m/s^2 ({one:.4f}, {two:.4f}, {three:.4f} in 0.5-3, 3-8, 8-25 Hz)"
                  f"  tire {1e3 * tire:.4f} mm")


if __name__ == "__main__":
    main()
