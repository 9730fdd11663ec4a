import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import final

import numpy as np
import numpy.typing as npt

from ._given import Bench, Fmu, Grouping, Page, Tests

_Array = npt.NDArray[np.float64]
_Progress = Callable[[float, str], object] | None

#: Name, quantity, velocity, low, high, amplitude, setting of a limit.
_Limit = tuple[str, str, float | None, float | None, float | None, float | None, float | None]

VERSION: str
UNWINDS: bool
LOUD_NOTES: list[str]

class DashpotError(Exception): ...
class RecordError(DashpotError): ...
class ModelError(DashpotError): ...
class DimensionsError(DashpotError): ...
class FitError(DashpotError): ...
class ValidationError(DashpotError): ...
class DiagnosisError(DashpotError): ...
class MotionError(DashpotError): ...
class StepError(DashpotError): ...
class ExportError(DashpotError): ...
class RigError(DashpotError): ...
class OutputError(DashpotError): ...

@final
class Campaign:
    @staticmethod
    def read(paths: Sequence[str], mapping: str, strict: bool, progress: _Progress = None) -> Campaign: ...
    def json(self) -> str: ...
    def __len__(self) -> int: ...
    def channels(self, index: int) -> dict[str, _Array]: ...
    def fingerprint(self, index: int) -> str: ...
    def state(self, only: int | None = None) -> tuple[str, list[dict[str, _Array]], list[str | None], list[Path]]: ...
    @staticmethod
    def again(
        json: str,
        channels: Sequence[Mapping[str, _Array]],
        as_read: Sequence[str | None],
        files: Sequence[str | os.PathLike[str]],
    ) -> Campaign: ...

@final
class Model:
    @staticmethod
    def read(path: str) -> Model: ...
    @staticmethod
    def parse(text: str, name: str) -> Model: ...
    @property
    def text(self) -> str: ...
    def json(self) -> str: ...
    def velocity_range(self) -> tuple[float, float]: ...
    def steady_force(self, velocity: npt.ArrayLike, progress: _Progress = None) -> _Array: ...
    def simulate(
        self,
        time: npt.ArrayLike,
        displacement: npt.ArrayLike | None,
        velocity: npt.ArrayLike | None,
        side_force: npt.ArrayLike | None,
        temperature: npt.ArrayLike | None,
        initial_position: float | None,
        step: float | None,
        progress: _Progress = None,
    ) -> list[_Array]: ...

@final
class Figures:
    @staticmethod
    def measure(campaign: Campaign, progress: _Progress = None) -> Figures: ...
    @staticmethod
    def parse(text: str) -> Figures: ...
    @property
    def text(self) -> str: ...
    def judge(self, limits: Sequence[_Limit]) -> str: ...

@final
class Dampers:
    def __new__(
        cls,
        models: Sequence[Model],
        initial_position: Sequence[float],
        initial_velocity: Sequence[float],
        side_force: Sequence[float],
        temperature: Sequence[float],
    ) -> Dampers: ...
    def __len__(self) -> int: ...
    def step(
        self,
        velocity: npt.ArrayLike,
        dt: float,
        displacement: npt.ArrayLike | None,
        side_force: npt.ArrayLike,
        temperature: npt.ArrayLike,
        out: _Array,
    ) -> bool: ...
    @property
    def state(self) -> _Array: ...
    @state.setter
    def state(self, rows: npt.ArrayLike) -> None: ...

@final
class Family:
    @staticmethod
    def parse(text: str, name: str | os.PathLike[str]) -> Family: ...
    @property
    def text(self) -> str: ...
    def setting(self) -> tuple[list[float], float, str, str]: ...
    def at(self, setting: float, name: str | os.PathLike[str]) -> Model: ...
    def steady_force(self, velocity: npt.ArrayLike, setting: npt.ArrayLike) -> _Array: ...
    def simulate(
        self,
        time: npt.ArrayLike,
        displacement: npt.ArrayLike | None,
        velocity: npt.ArrayLike | None,
        setting: npt.ArrayLike,
        initial_position: float | None,
    ) -> list[_Array]: ...
    def validate(
        self, campaign: Campaign, given: float | None = None, progress: _Progress = None, limits: Sequence[_Limit] | None = None
    ) -> tuple[str, list[tuple[_Array, _Array]], Campaign, list[str]]: ...

@final
class Fitted: ...

@final
class Diagnosed: ...

@final
class Grouped: ...

def fit(
    campaign: Campaign,
    family: str,
    elements: Sequence[str] | None = None,
    hold_out: Sequence[str] = ...,
    progress: _Progress = None,
    dimensions: str | None = None,
    lumped: bool = False,
) -> tuple[str, str, Fitted]: ...
def fit_family(
    campaign: Campaign,
    setting: str,
    elements: Sequence[str] | None = None,
    hold_out: Sequence[str] = ...,
    progress: _Progress = None,
    dimensions: str | None = None,
) -> tuple[str, str]: ...
def fit_literature(campaign: Campaign, name: str, hold_out: Sequence[str] = ..., progress: _Progress = None) -> tuple[str, str]: ...
def validate(
    model: Model,
    campaign: Campaign,
    progress: _Progress = None,
    limits: Sequence[_Limit] | None = None,
    against: Sequence[str] = ...,
) -> tuple[str, list[tuple[_Array, _Array]], Campaign, str | None, list[tuple[str, list[_Array]]]]: ...
def read_limits(path: str) -> list[_Limit]: ...
def check_limits(limits: Sequence[_Limit]) -> None: ...
def diagnose(
    model: Model,
    campaign: Campaign,
    reference: Campaign | None = None,
    hold_out: Sequence[str] = ...,
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    progress: _Progress = None,
    dimensions: str | None = None,
) -> tuple[str, str, list[dict[str, _Array]], Diagnosed]: ...
def diagnose_family(
    family: Family,
    campaign: Campaign,
    given: float | None = None,
    reference: Campaign | None = None,
    hold_out: Sequence[str] = ...,
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    progress: _Progress = None,
    dimensions: str | None = None,
) -> tuple[str, list[list[dict[str, _Array]]]]: ...
def diagnose_groups(
    model: Model,
    grouping: Grouping,
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    progress: _Progress = None,
) -> tuple[str, str, list[list[dict[str, _Array]]], Grouped]: ...
def write_validation(
    what: str,
    path: str,
    page: Page,
    model: Model,
    campaign: Campaign,
    forces: Sequence[tuple[_Array, _Array]],
    windows: Sequence[_Limit] | None,
    rivals: Sequence[tuple[str, Sequence[_Array]]],
) -> list[Path]: ...
def write_diagnosis(what: str, path: str, page: Page, found: Diagnosed) -> list[Path]: ...
def write_groups(what: str, path: str, page: Page, found: Grouped) -> None: ...
def write_next_tests(path: str, found: Diagnosed, force: bool) -> int: ...
def write_fit(path: str, page: Page, found: Fitted) -> None: ...
def measure(
    folder: str,
    tests: Tests,
    bench: Bench,
    hide: Sequence[tuple[str, float | None]] | None,
    severity: bool,
    progress: _Progress = None,
) -> int: ...
def test_matrix(tests: Tests) -> tuple[str, int]: ...
def write(path: str, text: str, force: bool) -> None: ...
def export_fmu(models: Sequence[Model], path: str, wanted: Fmu) -> list[str]: ...
def export_adams(
    model: Model,
    folder: str,
    length: str | None,
    library: str | None,
    host_step: float,
    wheel_mass: float,
    for_step: float | None,
    force: bool,
) -> list[str]: ...
def export_dpr(model: Model, path: str, name: str, model_curve: bool, force: bool) -> tuple[int, list[str]]: ...
def export_adm(source: str, path: str, dampers: Sequence[tuple[str, str, str]], replace_preload: bool, force: bool) -> list[str]: ...
def import_dpr(path: str) -> str: ...
def import_peaks(
    path: str,
    positive: str | None,
    units: Mapping[str, str],
    columns: Mapping[str, str],
    clicks: float | None,
    gas_force: float,
    friction: float,
    is_family: bool,
) -> tuple[str, str, bool, list[str]]: ...
def check(model: Model, host_step: float, wheel_mass: float, for_step: float | None = None) -> tuple[str, list[str], str]: ...
def explain(model: Model, dimensions: str) -> tuple[str, list[str]]: ...
def explain_family(family: Family, dimensions: str, setting: float) -> tuple[str, list[str]]: ...
def set_threads(count: int) -> None: ...
