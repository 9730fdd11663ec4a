"""Statistics of a fleet: median and spread, outliers, drift, batches and control charts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]
Places = npt.NDArray[np.intp]

#: Distance from the median, in robust standard deviations, above which a damper is reported as an outlier (Iglewicz and Hoaglin, How to
#: Detect and Handle Outliers, 1993).
OUTLIER = 3.5
#: Ratio of the standard deviation of a normal distribution to its median absolute deviation.
PER_MAD = 1.4826
#: Ratio of the standard deviation of a normal distribution to its mean absolute deviation.
PER_MEAN = 1.2533
#: Lower bound of the standard deviation relative to the median magnitude of the values. It is twice the repeatability of a good rig (ISO 376,
#: class 00 load cells: 0.05 %). Values that the fit took from a prior agree to many digits. Without the bound, a damper with a different value
#: would be 1e10 deviations from the median.
RESOLUTION = 1e-3
#: Ratio of the half-width of the limits of an individuals chart to the mean moving range: 3 / d2 for two values (Montgomery, Introduction to
#: Statistical Quality Control, 6.4).
PER_RANGE = 2.66
#: Number of consecutive values on one side of the center that count as a shift (Nelson's second rule).
RUN = 9
#: Ratio of a slope to its standard deviation above which a drift is reported. By chance, about one of a thousand parameters exceeds it.
DRIFT = 3.3


@dataclass(frozen=True)
class Spread:
    """Median, spread and range of the values of a fleet."""

    count: int
    median: float
    deviation: float
    """Robust standard deviation."""
    low: float
    high: float


def spread(values: Numbers) -> Spread:
    """Computes median, robust standard deviation and range of the finite values. Without finite values, they are NaN."""
    there = values[np.isfinite(values)]
    if not len(there):
        return Spread(0, np.nan, np.nan, np.nan, np.nan)
    middle = float(np.median(there))
    deviation = PER_MAD * float(np.median(np.abs(there - middle)))
    return Spread(len(there), middle, deviation, float(there.min()), float(there.max()))


def far_off(values: Numbers, least: float = 0.0) -> Numbers:
    """Computes the distance of each value from the median, in robust standard deviations.

    The distance is 0 if all values are equal, and NaN for a missing value. The standard deviation has two lower bounds: :data:`RESOLUTION` times
    the median magnitude of the values, and ``least``, the uncertainty of one value.

    If more than half of the values are equal, their median absolute deviation is 0. Then the mean absolute deviation replaces it (Iglewicz and
    Hoaglin).
    """
    usual = spread(values)
    none = 1e-12 * max(1.0, abs(usual.median))
    deviation = usual.deviation
    there = values[np.isfinite(values)]
    if not deviation > none and usual.count:
        deviation = PER_MEAN * float(np.mean(np.abs(there - usual.median)))
    if not deviation > none:
        return np.where(np.isfinite(values), 0.0, np.nan)
    size = float(np.median(np.abs(there)))
    return (values - usual.median) / max(deviation, RESOLUTION * size, least)


@dataclass(frozen=True)
class Drift:
    """Slope of a linear regression over time or over the order of manufacture."""

    slope: float
    deviation: float
    """Standard deviation of the slope."""

    @property
    def stands_out(self) -> bool:
        """Whether the slope is significant, because its magnitude exceeds :data:`DRIFT` times its standard deviation."""
        return self.deviation > 0 and abs(self.slope) > DRIFT * self.deviation


def drift(at: Numbers, values: Numbers) -> Drift | None:
    """Computes the slope of the values by least squares, without outliers.

    Returns None with fewer than five values, or if all values have the same abscissa ``at``.
    """
    kept = np.isfinite(at) & np.isfinite(values)
    kept &= np.abs(np.nan_to_num(far_off(values))) <= OUTLIER
    x, y = at[kept], values[kept]
    if len(x) < 5 or np.ptp(x) == 0:
        return None
    x = x - x.mean()
    square = float(x @ x)
    slope = float(x @ y) / square
    left = y - y.mean() - slope * x
    return Drift(slope, float(np.sqrt(left @ left / (len(x) - 2) / square)))


@dataclass(frozen=True)
class Batch:
    """Mean of one batch, with its interval."""

    name: str
    count: int
    mean: float
    low: float
    high: float
    """Upper end of the 95 % interval of the mean; ``low`` is its lower end. Both are NaN for a single value."""


def batches(names: Sequence[str], values: Numbers) -> list[Batch]:
    """Computes the mean of every batch with its interval, in the order of the batches' names."""
    out = []
    for name in sorted({n for n in names if n}):
        own = values[[n == name for n in names]]
        own = own[np.isfinite(own)]
        if len(own):
            half = 1.96 * float(own.std(ddof=1)) / np.sqrt(len(own)) if len(own) > 1 else np.nan
            out.append(Batch(name, len(own), float(own.mean()), float(own.mean() - half), float(own.mean() + half)))
    return out


@dataclass(frozen=True)
class Control:
    """Individuals control chart: center, limits from the moving range, and the values that violate a rule."""

    centre: float
    low: float
    high: float
    beyond: tuple[int, ...]
    """Indices of values outside the limits."""
    shifted: tuple[int, ...]
    """Indices of values that are the ninth or a later one in a run on one side of the center."""


def control(values: Numbers) -> Control | None:
    """Computes the control chart of values in the order of manufacture. Returns None with fewer than three finite values."""
    places = np.flatnonzero(np.isfinite(values))
    there = values[places]
    if len(there) < 3:
        return None
    centre = float(there.mean())
    half = PER_RANGE * float(np.abs(np.diff(there)).mean())
    beyond = tuple(int(p) for p in places[np.abs(there - centre) > half])
    shifted, run, side = [], 0, 0.0
    for place, value in zip(places, there, strict=True):
        now = float(np.sign(value - centre))
        run = run + 1 if now == side and now != 0 else 1
        side = now
        if run >= RUN:
            shifted.append(int(place))
    return Control(centre, centre - half, centre + half, beyond, tuple(shifted))
