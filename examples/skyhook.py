"""The quarter car of skyhook.c, in Python: the same loop with the same numbers.

    python skyhook.py target/release/libdashpot.so examples/semi_active.toml
"""
import ctypes as c
import math
import sys

from dashpot_damper import Damper

BODY, WHEEL, SPRING, TIRE = 400.0, 45.0, 22e3, 210e3  # kg, N/m
STEP, SKY, STEPS = 1e-3, 2200.0, 20000  # s, N s/m


def command(damper: Damper, motion: tuple[float, float], body_rate: float, setting: float, force: float,
            low: float, high: float) -> float:
    """The setting at which the damper gives the force that the sky would, where it can."""
    gain, wanted = c.c_double(), SKY * body_rate
    at = damper.motion(*motion, setting)
    damper.check(damper.library.dashpot_d_force_d_setting(
        c.byref(damper.model), c.byref(damper.state), c.byref(at), c.c_double(STEP), c.byref(gain)))
    chosen = low
    if wanted * motion[1] > 0.0:
        chosen = setting + (wanted - force) / gain.value if abs(gain.value) > 1.0 else high
    return min(max(chosen, low), high)


def drive(damper: Damper, controlled: bool, setting: float, low: float, high: float) -> tuple[float, float]:
    """Rms of the body's acceleration (m/s^2) and of the tire's deflection (m)."""
    start = damper.motion(0.0, 0.0, setting)
    damper.check(damper.library.dashpot_state_init_motion(c.byref(damper.model), c.byref(start), c.byref(damper.state)))
    force = rest = damper.try_step(0.0, 0.0, 0.0, setting)[0]
    body = body_rate = wheel = wheel_rate = road = squares = tires = 0.0
    seed = 1
    for _ in range(STEPS):
        spring, damping, tire = -SPRING * (body - wheel), force - rest, -TIRE * (wheel - road)
        acceleration = (spring - damping) / BODY
        squares += acceleration * acceleration / STEPS
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
    return math.sqrt(squares), math.sqrt(tires)


def main() -> None:
    damper = Damper(sys.argv[1], sys.argv[2])
    for name, controlled, setting in (("soft", False, 0.0), ("start", False, 0.6), ("skyhook", True, 0.6)):
        acceleration, tire = drive(damper, controlled, setting, 0.0, 1.6)
        print(f"{name:8} acceleration {acceleration:.4f} m/s^2  tire {1e3 * tire:.4f} mm")


if __name__ == "__main__":
    main()
