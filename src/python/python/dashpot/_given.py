"""Dictionaries that the extension module receives instead of many arguments."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypedDict

if TYPE_CHECKING:
    from . import _native


class Page(TypedDict):
    """Settings of a report, workbook or certificate, and its description of the origin."""

    language: str
    date: str | None
    full: bool
    force: bool
    model: str
    is_file: bool
    data: str
    command: Sequence[str]
    files: Sequence[str]


class Data(TypedDict):
    """Records: paths, or a campaign that was read before."""

    paths: Sequence[str]
    read: _native.Campaign | None


class Grouping(TypedDict):
    """Records of many dampers, the rule that divides them into groups, and the reference of the comparison."""

    data: Data
    by: str
    reference: Data | None
    reference_name: str
    chain: bool
    mapping: str
    strict: bool


class Tests(TypedDict):
    """Tests of the virtual rig."""

    matrix: str | None
    plan: str | None
    amplitudes_m: Sequence[float] | None
    peak_velocities_m_s: Sequence[float] | None
    frequency_limit_hz: float | None
    slow_tests: bool


class Bench(TypedDict):
    """The virtual rig and its sensors."""

    seed: int
    noise_percent: float
    sample_rate_hz: float | None
    noise_colour: float
    hum_n: float
    bits: int | None
    side_force: bool
    temperature: bool
    start_temperature_c: float | None
    noise_seed: int | None
    order: int | None


class Fmu(TypedDict):
    """Content of an FMU, and properties of its host."""

    name: str
    model_file: str
    fmi: int
    four: bool
    inputs: str | None
    motion_scale: float | None
    force_scale: float | None
    position_offset: float
    carmaker: str | None
    model_curve: bool
    sources: bool
    hide_parameters: bool
    library: str | None
    binaries: Sequence[tuple[str, str]]
    host_step: float
    wheel_mass: float
    for_step: float | None
    force: bool
