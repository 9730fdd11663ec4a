"""Conversion of the arguments of :meth:`dashpot.Campaign.read` for the extension module, and to options of the command."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypedDict

from ._numbers import real, words

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Reading(TypedDict, total=False):
    """Arguments of :meth:`dashpot.Campaign.read`, except ``path`` and ``progress``."""

    positive: str | None
    flip: Sequence[str]
    columns: Mapping[str, str | int] | None
    units: Mapping[str, str] | None
    ignore: Sequence[str]
    exclude: Sequence[str]
    subfolders: bool
    delay_s: float
    force_zero_n: float
    displacement_zero_m: float
    gain: float
    gains: Mapping[str, float] | None
    rig_mass_kg: float
    sample_rate_hz: float | None
    dates: str | None
    initial_position_m: float
    strict: bool


@dataclass(frozen=True)
class How:
    """Settings of reading records."""

    mapping: str
    """Entries of a ``campaign.toml``, as JSON."""
    strict: bool
    """Whether a file that is no record, or a test with a fault of its own, is an error. Otherwise it is left out."""
    options: tuple[str, ...]
    """Equivalent options of the command, with which a user can reproduce a report."""


#: Arguments with a number, each with its option of the command and its default.
_NUMBERS = {
    "delay_s": ("--delay", 0.0),
    "force_zero_n": ("--force-zero", 0.0),
    "displacement_zero_m": ("--displacement-zero", 0.0),
    "gain": ("--gain", 1.0),
    "rig_mass_kg": ("--rig-mass", 0.0),
    "sample_rate_hz": ("--sample-rate", None),
    "initial_position_m": ("--initial-position", 0.0),
}
_ALL = frozenset(Reading.__annotations__)


def how(**given: Unpack[Reading]) -> How:
    """Converts arguments of :meth:`dashpot.Campaign.read` to settings of reading.

    :raises TypeError: if an argument is unknown.
    :raises ValueError: if a number is not finite.
    """
    for name in given:
        if name not in _ALL:
            raise TypeError(f"there is no argument {name!r}; records are read by {', '.join(sorted(_ALL))}")
    numbers: dict[str, Any] = {name: given.get(name, usual) for name, (_, usual) in _NUMBERS.items()}
    positive, dates, sample_rate_hz = given.get("positive"), given.get("dates"), numbers.pop("sample_rate_hz")
    for name, value in {**numbers, "sample_rate_hz": sample_rate_hz}.items():
        real(name, value)
    for name, value in numbers.items():
        if not math.isfinite(value):
            raise ValueError(f"{name} is {value}; it must be a finite number")
    mapping: dict[str, Any] = {
        "format": "dashpot campaign profile 1",
        "flip": words(given.get("flip", ())),
        "ignore": words(given.get("ignore", ())),
        "exclude": words(given.get("exclude", ())),
        "subfolders": bool(given.get("subfolders", False)),
        **{name: float(value) for name, value in numbers.items()},
        "gains": {k: float(v) for k, v in (given.get("gains") or {}).items()},
        "columns": {k: str(v) for k, v in (given.get("columns") or {}).items()},
        "units": dict(given.get("units") or {}),
    }
    if positive is not None:
        mapping["positive"] = positive
    if dates is not None:
        mapping["dates"] = dates
    if sample_rate_hz is not None:
        mapping["sample_rate_hz"] = float(sample_rate_hz)
    strict = bool(given.get("strict", False))
    return How(json.dumps(mapping), strict, tuple(_options(mapping, strict)))


def _options(mapping: Mapping[str, Any], strict: bool) -> Iterator[str]:
    for name in ("positive", "dates"):
        if name in mapping:
            yield from (f"--{name}", mapping[name])
    for name in ("flip", "ignore", "exclude"):
        for value in mapping[name]:
            yield from (f"--{name}", value)
    for option, name in (("--unit", "units"), ("--column", "columns"), ("--gain", "gains")):
        for channel, value in mapping[name].items():
            yield from (option, f"{channel}={value}")
    for name, (option, usual) in _NUMBERS.items():
        value = mapping.get(name, usual)
        if value != usual:
            # The equals sign is necessary, because a separate negative number would look like an option.
            yield f"{option}={value!r}"
    for name, is_on in (("--subfolders", mapping["subfolders"]), ("--strict", strict)):
        if is_on:
            yield name
