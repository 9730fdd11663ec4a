"""Conversion and checks of numbers and names in arguments."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt


def column(name: str, values: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Converts values to a one-dimensional array of floats.

    Dates, complex numbers and masked values are errors, because numpy would convert dates to numbers and drop imaginary parts and masks.
    """
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ValueError(f"{name} has masked values; leave them out or fill them")
    try:
        array = np.asarray(values)
        if array.dtype.kind == "O":
            array = array.astype(float)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name} is no array of numbers: {error}") from error
    if array.dtype.kind in "mM":
        raise TypeError(f"{name} holds dates or spans of time; give seconds as numbers, such as (t - t[0]) / numpy.timedelta64(1, 's')")
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name} is no array of real numbers but of {array.dtype.name}")
    if array.ndim != 1:
        shape = " by ".join(str(n) for n in array.shape) or "a single number"
        raise ValueError(f"{name} is one column of numbers, not {shape}")
    return array.astype(np.float64, copy=False)


def real(name: str, value: object) -> None:
    """Rejects a complex number or array of numpy, because a conversion to float only warns when it drops the imaginary part."""
    if isinstance(value, np.complexfloating) or (isinstance(value, np.ndarray) and value.dtype.kind == "c"):
        raise TypeError(f"{name} is no real number but of {value.dtype.name}")


def length_of(name: str, value: float | str) -> str:
    """Converts a length to the text that the extension module parses: a number in m, or a number followed by its unit."""
    if isinstance(value, str):
        return value.strip()
    real(name, value)
    try:
        return repr(float(value))
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name} is a length in m, or a text with its unit such as '412.5mm', not {value!r}") from error


#: Largest plausible amplitude, m, and velocity, m/s, of a damper's motion. A larger value causes a warning here, and the reader of records
#: rejects the file. A long suspension has half this travel, and a kerb strike reaches about 10 m/s.
LARGEST_AMPLITUDE_M, HIGHEST_SPEED_M_S = 0.5, 20.0


def warn_of_units(
    displacement_m: npt.NDArray[np.float64] | None = None, velocity_m_s: npt.NDArray[np.float64] | None = None, *, level: int = 3
) -> None:
    """Warns of a motion that is too large for a damper, usually because it is in millimeters."""
    if displacement_m is not None and len(displacement_m):
        amplitude = float(displacement_m.max() - displacement_m.min()) / 2.0
        if amplitude > LARGEST_AMPLITUDE_M:
            warnings.warn(
                f"displacement_m has an amplitude of {amplitude:.4g} m, which no damper has; it is in meters: divide millimeters by 1000",
                stacklevel=level,
            )
            return
    if velocity_m_s is not None and len(velocity_m_s):
        speed = float(np.abs(velocity_m_s).max())
        if speed > HIGHEST_SPEED_M_S:
            warnings.warn(
                f"a velocity of {speed:.4g} m/s is none of a damper; velocities are in m/s, displacements in meters and times in seconds: "
                "divide mm/s and mm by 1000",
                stacklevel=level,
            )


def words(given: str | Iterable[str]) -> list[str]:
    """Converts one name or several names to a list."""
    return [given] if isinstance(given, str) else list(given)


def several(names: Sequence[str], most: int = 12) -> str:
    """Joins the first ``most`` names, and appends the number of the remaining ones."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
