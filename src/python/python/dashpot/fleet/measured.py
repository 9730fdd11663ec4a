"""What the limits of a damper speak of, measured on its records as ``dashpot validate --limits`` measures it.

Forces at peak velocity and hysteresis are figures of a validation. Friction and gas force come from the mean cycle of the slow tests,
which the compiled part does not give away; it is made here as ``src/estimation/src/samples/cycle.rs`` makes it, so that both say the same
newtons.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ..campaign import Campaign, Record
from ..results import Validation

Numbers = npt.NDArray[np.float64]

#: Peak velocity, m/s, up to which a test shows friction and gas force alone.
SLOW = 0.006
#: How near a test's peak velocity lies to the speed asked for without anything to interpolate with.
NEAR = 0.05
#: Largest ratio of two peak velocities between which a force is interpolated.
BETWEEN = 2.0
#: Amplitudes that count as one stroke.
SAME_STROKE = 0.1


@dataclass(frozen=True)
class Point:
    """Force at the peak velocity of one stroke of a test."""

    amplitude_m: float
    velocity_m_s: float
    force_n: float


@dataclass(frozen=True)
class Gap:
    """Hysteresis of a test: mean gap between rising and falling velocity."""

    amplitude_m: float
    peak_velocity_m_s: float
    mean_gap_n: float


@dataclass(frozen=True)
class Measured:
    """Everything that a limit may ask of a campaign."""

    points: tuple[Point, ...]
    gaps: tuple[Gap, ...]
    friction_n: float | None
    """Half the difference between the strokes of the slow tests; none without a slow test."""
    gas_force_n: float | None
    """What pushes the rod out in the slow tests; none without a slow test."""

    @classmethod
    def of(cls, validation: Validation, records: Campaign) -> Measured:
        """Measures the records, which are those that the validation compared."""
        points: list[Point] = []
        gaps: list[Gap] = []
        slow: list[Record] = []
        for test, record in zip(validation.tests, validation.campaign or records, strict=True):
            # Without whole cycles there is no peak velocity, and nothing that a limit could speak of.
            if not test.peaks:
                continue
            points.extend(Point(test.amplitude_m, p.velocity_m_s, p.force_n.measured) for p in test.peaks)
            if test.hysteresis is not None:
                gaps.append(Gap(test.amplitude_m, test.peak_velocity_m_s, test.hysteresis.mean_gap_n.measured))
            if record.peak_velocity <= SLOW:
                slow.append(record)
        dry = _sliding(slow)
        return cls(tuple(points), tuple(gaps), *(dry or (None, None)))

    def text(self) -> str:
        """As text that :meth:`read` takes."""
        return json.dumps(asdict(self))

    @classmethod
    def read(cls, text: str) -> Measured:
        """From what :meth:`text` gave."""
        said: dict[str, Any] = json.loads(text)
        points = tuple(Point(**p) for p in said["points"])
        return cls(points, tuple(Gap(**g) for g in said["gaps"]), said["friction_n"], said["gas_force_n"])

    def force(self, velocity: float, amplitude: float | None) -> float | None:
        """Force at a speed, from the longest stroke that reaches it."""
        side = [p for p in self.points if p.velocity_m_s * velocity > 0 and _is_stroke(p.amplitude_m, amplitude)]
        side.sort(key=lambda p: -p.amplitude_m)
        stroke: list[Point] = []
        for k, point in enumerate(side):
            stroke.append(point)
            if k + 1 == len(side) or not point.amplitude_m - side[k + 1].amplitude_m <= SAME_STROKE * point.amplitude_m:
                found = _at_speed(stroke, abs(velocity))
                if found is not None:
                    return found
                stroke = []
        return None

    def hysteresis(self, velocity: float | None, amplitude: float | None) -> float | None:
        """Mean gap of the test at a speed, the longest stroke first; the largest of all tests where no speed is given."""
        shown = [g for g in self.gaps if _is_stroke(g.amplitude_m, amplitude)]
        if velocity is None:
            return max((g.mean_gap_n for g in shown), default=None)
        speed = abs(velocity)
        at = [g for g in reversed(shown) if abs(g.peak_velocity_m_s - speed) <= NEAR * speed]
        return max(at, key=lambda g: g.amplitude_m).mean_gap_n if at else None


def _is_stroke(amplitude: float, wanted: float | None) -> bool:
    return wanted is None or abs(amplitude - wanted) <= SAME_STROKE * wanted


def _at_speed(stroke: Sequence[Point], wanted: float) -> float | None:
    """Force at a speed from the peaks of one stroke: between its neighbours, or from the one that is near."""

    def speed(point: Point) -> float:
        return abs(point.velocity_m_s)

    below = max((p for p in reversed(stroke) if speed(p) <= wanted), key=speed, default=None)
    above = min((p for p in stroke if speed(p) > wanted), key=speed, default=None)
    if below is not None and above is not None and speed(above) <= BETWEEN * speed(below):
        share = (wanted - speed(below)) / (speed(above) - speed(below))
        return below.force_n + share * (above.force_n - below.force_n)
    near = [p for p in (below, above) if p is not None and abs(speed(p) - wanted) <= NEAR * wanted]
    return min(near, key=lambda p: abs(speed(p) - wanted)).force_n if near else None


def _sliding(slow: Sequence[Record]) -> tuple[float, float] | None:
    """Friction and gas force of slow tests: the medians of both strokes above half the peak velocity."""
    up: list[float] = []
    down: list[float] = []
    for record in slow:
        velocity, force = mean_cycle(record)
        part = velocity / record.peak_velocity
        up.extend(force[part > 0.5].tolist())
        down.extend(force[part < -0.5].tolist())
    if not up or not down:
        return None
    high, low = (sorted(side)[(len(side) - 1) // 2] for side in (up, down))
    return 0.5 * (high - low), -0.5 * (high + low)


# What follows is the mean cycle of src/estimation/src/samples, with its numbers.

#: Most samples of a mean cycle.
_PER_CYCLE = 120
#: Share of a cycle over which the force is averaged at most.
_WINDOW = 1.0 / 400.0
#: Share of a sample within which a time counts as that of the sample, and how many times steeper than beside it a jump is.
_AT_SAMPLE, _STEEPER = 0.02, 3.0


def mean_cycle(record: Record) -> tuple[Numbers, Numbers]:
    """Velocity and force of the mean of a test's cycles, with the motion that runs ahead of it."""
    time, force = record.time, record.force
    displacement, velocity = smoothed(record)
    cycles = [(c["start"], c["end"]) for c in record.cycles]
    last = len(time) - 1
    middle = len(cycles) // 2
    length = cycles[middle][1] - cycles[middle][0]
    in_cycle = max(1, length)
    averaged = int(in_cycle * _WINDOW) // 2 * 2 + 1

    def crossing(index: int) -> float:
        index = min(index, last)
        step = time[index] - time[index - 1] if index > 0 else time[1] - time[0]
        v = velocity[index]
        ahead = (record.mean_displacement - displacement[index]) / v if v != 0 else math.inf
        return float(time[index] + ahead if abs(ahead) <= 2 * step else time[index])

    bounds = np.array([(crossing(a), crossing(b)) for a, b in cycles])
    starts, spans = bounds[:, 0], bounds[:, 1] - bounds[:, 0]
    period = float(spans.mean())

    def mean(values: Numbers, phase: float) -> float:
        at = starts + phase * spans
        inside = at[(at >= time[0]) & (at <= time[last])]
        return float(_at(time, values, inside if len(inside) else at[:1]).mean())

    # Where the mean is taken: at the samples of the middle cycle, as far as so many of them.
    count = min(in_cycle, _PER_CYCLE)
    first, span = starts[middle], spans[middle]
    sampled = np.minimum(cycles[middle][0] + np.arange(count) * length // count, last)
    shares = (time[sampled] - first) / span
    end = shares[0] + 1.0 - 0.5 / length
    phases: list[float] = []
    before = -math.inf
    for share in shares.tolist():
        if share < end:
            if share > before:
                phases.append(share % 1.0)
            before = share
    half = averaged // 2
    beside = [k / in_cycle for k in range(-half, half + 1)]
    of_cycle = np.empty((len(phases), 2))
    for k, phase in enumerate(phases):
        alone = any(_across_a_jump(record, time, force, at) for at in (starts + phase * spans).tolist())
        own = (
            float(_at(time, force, np.array([first + phase * span]))[0])
            if alone
            else sum(mean(force, phase + b) for b in beside) / averaged
        )
        of_cycle[k] = mean(velocity, phase), own
    count = len(phases)
    lead = _lead(period, count)
    near = int(0.25 * count)
    places = [k for k in range(lead + count) if k + near >= lead or (lead - near - k) % 4 == 0]
    turned = np.array([(k + 2 * count - lead % count) % count for k in places], dtype=np.intp)
    return of_cycle[turned, 0], of_cycle[turned, 1]


def _lead(period: float, count: int) -> int:
    """Samples of a cycle that run ahead of it: 0.15 s, in half cycles."""
    half_cycles = math.floor(2.0 * min(max(0.15 / period, 1.5), 3.5) + 0.5)
    return int(0.5 * half_cycles * count)


def _at(time: Numbers, values: Numbers, t: Numbers) -> Numbers:
    """A channel at times: on a cubic through the four samples around each; beyond the ends the last value holds."""
    n = len(time)
    t = np.clip(t, time[0], time[-1])
    right = np.clip(np.searchsorted(time, t, side="right"), 1, n - 1)
    first = np.minimum(np.maximum(right - 2, 0), max(n - 4, 0))
    size = min(4, n)
    around = time[first[:, None] + np.arange(size)]
    out = np.zeros(len(t))
    for i in range(size):
        weight = np.ones(len(t))
        for j in range(size):
            if j != i:
                weight *= (t - around[:, j]) / (around[:, i] - around[:, j])
        out += weight * values[first + i]
    return out


def _across_a_jump(record: Record, time: Numbers, force: Numbers, t: float) -> bool:
    """Whether a time lies between two samples between which the force jumps: nothing can be interpolated there."""
    right = int(np.searchsorted(time, t, side="right"))
    if right < 2 or right + 1 >= len(time):
        return False
    left = right - 1
    share = (t - time[left]) / (time[right] - time[left])
    if not _AT_SAMPLE <= share <= 1 - _AT_SAMPLE:
        return False
    before, here, after = np.abs(np.diff(force[left - 1 : left + 3]))
    return bool(here > _STEEPER * (0.5 * (before + after) + record.noise.force_rms))


def _noise(y: Numbers) -> float:
    d = np.abs(np.diff(y, 4))
    return float(np.sort(d)[len(d) // 2]) / (0.6745 * math.sqrt(70.0)) if len(d) else 0.0


def smoothed(record: Record) -> tuple[Numbers, Numbers]:
    """Displacement and velocity freed of noise, as ``src/records/src/smoothing.rs`` does it."""
    t, x, v = record.time, record.displacement, record.velocity
    n = len(t)
    w = math.tau * record.frequency if record.frequency > 0 else max(record.peak_velocity / max(record.amplitude, 1e-9), 1.0)
    peak = max(record.peak_velocity, 1e-9)
    r = np.diag([max(_noise(x), 1e-9 * peak / w) ** 2, max(_noise(v), 1e-9 * peak) ** 2])
    q = peak * peak * w**3
    eye = np.eye(3)
    mean = np.array([x[0], v[0], 0.0])
    cov = np.diag([r[0, 0], r[1, 1], (peak * w) ** 2])
    means, covs, predicted = np.empty((n, 3)), np.empty((n, 3, 3)), np.empty((n, 3, 3))
    for i in range(n):
        if i > 0:
            a, noise = _transition(float(t[i] - t[i - 1]), q)
            mean, cov = a @ mean, a @ cov @ a.T + noise
        predicted[i] = cov
        s = cov[:2, :2] + r
        det = s[0, 0] * s[1, 1] - s[0, 1] * s[1, 0]
        if det != 0:
            gain = cov[:, :2] @ (np.array([[s[1, 1], -s[0, 1]], [-s[1, 0], s[0, 0]]]) / det)
            mean = mean + gain @ (np.array([x[i], v[i]]) - mean[:2])
            keep = eye.copy()
            keep[:, :2] -= gain
            cov = keep @ cov @ keep.T + gain @ r @ gain.T
        means[i], covs[i] = mean, cov
    out = means.copy()
    if n > 1:
        steps: Callable[[int], tuple[Numbers, Numbers]] = lambda i: _transition(float(t[i + 1] - t[i]), q)  # noqa: E731
        moves = np.array([steps(i)[0] for i in range(n - 1)])
        back = covs[:-1] @ np.transpose(moves, (0, 2, 1)) @ np.linalg.inv(predicted[1:])
        ahead = np.einsum("nij,nj->ni", moves, means[:-1])
        for i in range(n - 2, -1, -1):
            out[i] = means[i] + back[i] @ (out[i + 1] - ahead[i])
    return out[:, 0].copy(), out[:, 1].copy()


def _transition(dt: float, q: float) -> tuple[Numbers, Numbers]:
    """Transition over ``dt`` and the noise it collects from white jerk of density ``q``."""
    d2, d3 = dt * dt, dt * dt * dt
    a = np.array([[1.0, dt, 0.5 * d2], [0.0, 1.0, dt], [0.0, 0.0, 1.0]])
    noise = np.array([[d3 * d2 / 20, d2 * d2 / 8, d3 / 6], [d2 * d2 / 8, d3 / 3, d2 / 2], [d3 / 6, d2 / 2, dt]])
    return a, noise * q
