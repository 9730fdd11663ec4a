"""Models of dampers: model file, parameters, simulation, comparison with records, and export."""

from __future__ import annotations

import difflib
import os
import warnings
from collections.abc import Iterator, KeysView, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Union, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._arguments import as_arguments, loads
from ._files import needs, write_new
from ._result import Result, Row, dataset, folded, frame, held, table
from ._numbers import column, length_of, real, several, warn_of_units
from ._work import watched
from .campaign import Campaign, Path, Progress, Record, native_of
from .host import HostCheck
from .limits import Limit, Limits, rows
from ._papers import option, origin
from .fitted import FitResult
from .validation import Compared, JudgedValidation, Validation

if TYPE_CHECKING:
    import pandas
    import xarray


@dataclass(frozen=True, repr=False)
class Parameter(Result):
    """One parameter in use, with its 95 % interval if a fit determined one."""

    name: str
    element: str
    unit: str
    meaning: str
    value: Union[float, str, list[float]]
    interval: Union[list[float], list[list[float]], None]
    source: str | None
    identified: bool


@dataclass(frozen=True, repr=False, eq=False)
class Response(Result):
    """Motion and simulated force of a model. SI units; extension (rebound) velocity and tension force are positive."""

    time: npt.NDArray[np.float64] = field(repr=False, metadata={"key": "time_s"})
    displacement: npt.NDArray[np.float64] = field(repr=False, metadata={"key": "displacement_m"})
    velocity: npt.NDArray[np.float64] = field(repr=False, metadata={"key": "velocity_m_s"})
    force: npt.NDArray[np.float64] = field(repr=False, metadata={"key": "force_N"})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Response):
            return NotImplemented
        return all(np.array_equal(a, b) for a, b in zip(self._columns().values(), other._columns().values(), strict=True))

    def __hash__(self) -> int:
        return hash((len(self.time), float(self.time[-1]), float(self.force[-1])) if len(self.time) else 0)

    def to_dict(self) -> dict[str, Any]:
        """Returns lists of numbers by the column names of ``dashpot simulate``."""
        return {name: column.tolist() for name, column in self._columns().items()}

    def _columns(self) -> dict[str, npt.NDArray[np.float64]]:
        return {
            "time_s": self.time,
            "displacement_m": self.displacement,
            "velocity_m_s": self.velocity,
            "force_N": self.force,
        }

    def to_pandas(self) -> pandas.DataFrame:
        """Returns one row for each instant. Requires pandas."""
        return frame(self._columns())

    def to_xarray(self) -> xarray.Dataset:
        """Returns the channels over time, with their units. Requires xarray."""
        return dataset(
            "time", {"time": (self.time, "s")},
            {"displacement": (self.displacement, "m"), "velocity": (self.velocity, "m/s"), "force": (self.force, "N")},
        )  # fmt: skip

    def _tables(self) -> dict[str, list[Row]]:
        columns = self._columns()
        return {"": [dict(zip(columns, row, strict=True)) for row in zip(*(c.tolist() for c in columns.values()), strict=True)]}

    def tables(self) -> dict[str, pandas.DataFrame]:
        """Returns the table of :meth:`to_pandas` as the only table, with the name ``""``."""
        return {"": self.to_pandas()}

    def _repr_html_(self) -> str:
        row = {
            "instants": len(self.time),
            "from s": float(self.time[0]),
            "to s": float(self.time[-1]),
            "lowest force N": float(self.force.min()),
            "highest force N": float(self.force.max()),
        }
        return table("Force for a motion", [row])

    def __repr__(self) -> str:
        span = f"{self.time[0]:.6g} to {self.time[-1]:.6g} s"
        return f"<dashpot.Response of {len(self.time)} instants, {span}, {self.force.min():.6g} to {self.force.max():.6g} N>"


class Model:
    """An identified damper. :func:`dashpot.fit` and :meth:`read` make models. The constructor makes a model from the text of a model file.

    SI units; extension (rebound) velocity and tension force are positive.
    """

    def __init__(self, text: str, name: Path = "model") -> None:
        if not isinstance(text, str):
            raise TypeError(f"text is the text of a model file, not a {type(text).__name__}; dashpot.Model.read(path) reads one")
        if "\n" not in text and text.endswith(".toml"):
            raise _native.ModelError(f"{text!r} is no text of a model file; dashpot.Model.read({text!r}) reads one by its path")
        self._native = _native.Model.parse(text, os.fspath(name))
        self._name = os.fspath(name)
        # Path of the file that contains the model; None without a file.
        self._file: str | None = None

    @classmethod
    def read(cls, path: Path) -> Model:
        """Reads a model file.

        :raises ModelError: if the file is invalid. The message names file, line and parameter.
        :raises FileNotFoundError: if the file does not exist. The exception is also a :class:`ModelError`.
        """
        # The extension module reads the file, so that error messages are those of the command.
        with needs(path):
            model = cls(_native.Model.read(os.fspath(path)).text, path)
        model._file = model._name
        return model

    @classmethod
    def from_dpr(cls, path: Path) -> Model:
        """Makes a model from a damper property file of Adams Car (TeimOrbit or XML), like ``dashpot import dpr``.

        The model contains the FV curve, and the gas force if the file has one. Comments in :attr:`text` state how closely the curve follows that
        of Adams, and what was left out.

        :raises ModelError: if the file is unreadable or gives no valid model.
        """
        with needs(path):
            return cls(_native.import_dpr(os.fspath(path)), _named_after(path))

    @classmethod
    def from_peaks(
        cls,
        path: Path,
        *,
        positive: str | None = None,
        units: Mapping[str, str] | None = None,
        columns: Mapping[str, str | int] | None = None,
        clicks: float | None = None,
        gas_force_n: float = 0.0,
        friction_n: float = 0.0,
    ) -> Model:
        """Makes a preliminary model from a table of peak forces over peak velocities (PVP, CVP), CSV or Excel, like ``dashpot import peaks``.

        The model has no hysteresis, because that requires records (:func:`dashpot.fit`). A warning reports forces that contradict the assumed
        rebound direction.

        :param positive: positive direction of a table with signs, ``"rebound"`` (default) or ``"compression"``.
        :param units: unit of ``velocity`` or ``force`` if the headings have none or a wrong one: ``{"force": "lbf"}``.
        :param columns: heading, or number from 1, of a column: ``velocity`` and ``force``; for one stroke ``rebound_velocity``,
            ``rebound_force``, ``compression_velocity`` and ``compression_force``.
        :param clicks: number of clicks whose curve is used, for a table with a curve for each number of clicks.
        :param gas_force_n: gas force in the table's forces, N. It is subtracted from the curve.
        :param friction_n: friction in the table's forces, N. It is subtracted from the curve.
        :raises ModelError: if the table is unreadable, the meaning of a column is unclear, or the forces give no valid model. The message
            names the table and the line.
        """
        for name, value in (("clicks", clicks), ("gas_force_n", gas_force_n), ("friction_n", friction_n)):
            real(name, value)
        with needs(path):
            text, direction, is_doubtful, _ = _native.import_peaks(
                os.fspath(path), positive, dict(units or {}), {k: str(v) for k, v in (columns or {}).items()}, clicks, gas_force_n, friction_n,
                False,
            )  # fmt: skip
        if is_doubtful:
            warnings.warn(as_arguments(direction), stacklevel=2)
        return cls(text, _named_after(path))

    def write(self, path: Path, *, force: bool = False) -> None:
        """Writes the model file atomically. Later reports and FMUs use the name of this file as the name of the model.

        :param force: replaces an existing file, even one of another kind or a write-protected file.
        :raises OutputError: if the file cannot be written.
        :raises FileExistsError: if another file exists and ``force`` is not given. The exception is also an :class:`OutputError`.
        """
        write_new(path, self.text, force)
        self._file = self._name = os.fspath(path)

    @property
    def text(self) -> str:
        """Text of the model file: lines ``name = value``, with units, intervals and sources as comments."""
        return self._native.text

    @property
    def fit(self) -> FitResult | None:
        """Results of the fit of a :class:`FittedModel`; None for any other model."""
        return None

    def _said(self) -> dict[str, Any]:
        said: dict[str, Any] = loads(self._native.json())
        return said

    @property
    def elements(self) -> tuple[str, ...]:
        """Names of the active elements."""
        return tuple(self._said()["elements"])

    @property
    def parameters(self) -> dict[str, Parameter]:
        """Parameters in use, by name. A change of such a parameter changes the damper.

        Parameters of inactive elements are omitted, as are those of a form that is not selected, such as the knees of an FV curve that is given
        as a table. Solver settings such as ``substeps`` are included unless they have their default, as in the model file.
        """
        return {p["name"]: Parameter.from_dict(p) for p in self._said()["parameters"]}

    @property
    def tests(self) -> tuple[str, ...]:
        """Names of the tests that the fit used."""
        return tuple(self._said()["tests"])

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes of the fit."""
        return tuple(self._said()["notes"])

    @property
    def velocity_range(self) -> tuple[float, float]:
        """Lowest and highest velocity (m/s) of the FV curve. Outside this range, the curve is extrapolated linearly."""
        return self._native.velocity_range()

    def keys(self) -> KeysView[str]:
        """Returns the names of the :attr:`parameters`. With this method, ``dict(model)`` gives the values by name."""
        return self.parameters.keys()

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())

    def __contains__(self, name: object) -> bool:
        return name in self.keys()

    def __getitem__(self, name: str) -> Any:
        """Returns the value of a parameter in use."""
        parameters = self.parameters
        if name in parameters:
            return parameters[name].value
        near = difflib.get_close_matches(str(name), parameters, 1)
        hint = f"did you mean {near[0]!r}?" if near else f"there are {several(list(parameters))}"
        raise KeyError(f"there is no parameter {name!r} in use here; {hint}")

    def steady_force(self, velocity_m_s: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Returns the force (N) in steady motion at each velocity (m/s) through displacement 0: the FV curve with friction and gas force."""
        velocities = column("velocity_m_s", np.atleast_1d(velocity_m_s) if np.isscalar(velocity_m_s) else velocity_m_s)
        warn_of_units(velocity_m_s=velocities)
        with watched() as told:
            return self._native.steady_force(velocities, told)

    @overload
    def validate(
        self, campaign: Sequence[Record], *, limits: None = None, against: Path | Sequence[Path] = (), progress: Progress | None = None
    ) -> Validation: ...
    @overload
    def validate(
        self, campaign: Sequence[Record], *, limits: Sequence[Limit], against: Path | Sequence[Path] = (), progress: Progress | None = None
    ) -> JudgedValidation: ...
    def validate(
        self,
        campaign: Sequence[Record],
        *,
        limits: Sequence[Limit] | None = None,
        against: Path | Sequence[Path] = (),
        progress: Progress | None = None,
    ) -> Validation:
        """Compares the model and its plain FV curve with records, like ``dashpot validate``.

        Measurement errors that the model's fit found in these records (a delayed force, a mass on the load cell) are corrected.
        :attr:`Validation.campaign` contains the compared records, with a note on the correction.

        :param campaign: a :class:`Campaign`, or some of its records.
        :param limits: limits that the damper must keep, such as those of :func:`dashpot.read_limits`. :attr:`Validation.limits` contains the
            verdicts on the damper and on the model.
        :param against: models of the literature for comparison: ``"fv"``, ``"piecewise"``, ``"lag"``, ``"surface"``, ``"dahl"``, ``"bouc-wen"``,
            ``"spencer"``, ``"kwok"``, ``"network"``, several of them, or ``"all"``. They are identified from the tests to which this model was
            fitted. Paths of their files (:meth:`LiteratureModel.write`) are also possible. :attr:`Validation.against` contains their errors and
            parameters.
        :raises ValidationError: if the records cannot be compared, a limit is invalid, or a model for comparison is unknown.
        """
        windows = None if limits is None else rows(limits)
        rivals = [os.fspath(name) for name in ([against] if isinstance(against, (str, os.PathLike)) else against)]
        files = [name for name in rivals if os.path.splitext(name)[1]]
        with watched(progress) as told, needs(*files):
            said, forces, as_compared, note, rival_forces = _native.validate(self._native, native_of(campaign, "campaign"), told, windows, rivals)
        if note is not None:
            warnings.warn(note, stacklevel=2)
        kind = Validation if limits is None else JudgedValidation
        table = limits.path if isinstance(limits, Limits) else None
        # The command accepts only limits from a file.
        from_file = [] if limits is None else None if table is None else ["--limits", table]
        compared = Campaign(as_compared, campaign.paths if isinstance(campaign, Campaign) else ())
        compared._reading = campaign._reading if isinstance(campaign, Campaign) else None
        made_from = Compared(self, windows, tuple(rival_forces), origin(campaign, option("against", rivals), from_file, files=[table] if table else []))
        return replace(kind.from_dict(loads(said)), _forces=tuple(forces), campaign=compared, _compared=made_from)

    def simulate(
        self,
        time_s: npt.ArrayLike,
        displacement_m: npt.ArrayLike | None = None,
        velocity_m_s: npt.ArrayLike | None = None,
        *,
        side_force_n: npt.ArrayLike | None = None,
        temperature_c: npt.ArrayLike | None = None,
        initial_position_m: float | None = None,
        step_s: float | None = None,
        progress: Progress | None = None,
    ) -> Response:
        """Simulates the force for a motion, like ``dashpot simulate``.

        If displacement (m) and velocity (m/s) are given, both drive the model. Displacement alone is differentiated by a cubic spline. Velocity
        alone is integrated from ``initial_position_m`` (m). Extension is positive. The damper starts in equilibrium at its first position.
        A warning reports a motion that is too large for a damper, for example in millimeters. This method does not smooth the motion, so the
        series stiffness multiplies the noise of a measured displacement. :meth:`validate` smooths it.

        :param time_s: times, s, increasing.
        :param step_s: fixed step, s; by default, each step ends at one of the given times.
        :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
        :raises MotionError: if a number overflows, or the position or step is invalid.
        :raises ValueError, TypeError: if a channel is not one-dimensional or does not contain one finite real number for every time.
        """
        channels = (
            column("time_s", time_s),
            None if displacement_m is None else column("displacement_m", displacement_m),
            None if velocity_m_s is None else column("velocity_m_s", velocity_m_s),
            None if side_force_n is None else column("side_force_n", side_force_n),
            None if temperature_c is None else column("temperature_c", temperature_c),
        )
        for name, value in (("initial_position_m", initial_position_m), ("step_s", step_s)):
            real(name, value)
        with watched(progress) as told:
            response = Response(*self._native.simulate(*channels, initial_position_m, step_s, told))
        # Stroke and velocity are both checked, because a slow motion in millimeters has a large stroke, and a small fast one a large velocity.
        warn_of_units(displacement_m=response.displacement, velocity_m_s=response.velocity)
        return response

    def check(self, *, host_step_s: float = 1e-3, wheel_mass_kg: float = 40.0, for_step_s: float | None = None) -> HostCheck[Model]:
        """Checks whether the damper chatters in a host with a zero-order hold of its force, like ``dashpot check``.

        :param host_step_s: step of the host, s.
        :param wheel_mass_kg: smallest mass that the damper moves, kg.
        :param for_step_s: step of the host, s, instead of ``host_step_s``. Friction that chatters at this step is replaced by presliding
            friction. :attr:`HostCheck.ready` is the damper for this host, which can be written or exported.
        :raises ModelError: if the step or the mass is invalid.
        """
        for name, value in (("host_step_s", host_step_s), ("wheel_mass_kg", wheel_mass_kg), ("for_step_s", for_step_s)):
            real(name, value)
        with watched():
            said, told, text = _native.check(self._native, host_step_s, wheel_mass_kg, for_step_s)
        found: HostCheck[Model] = HostCheck.from_dict(loads(said))
        ready = self if for_step_s is None else Model(text, self._name)
        return replace(found, told=tuple(as_arguments(line) for line in told), _ready=ready)

    def export_adams(
        self,
        folder: Path,
        *,
        length_m: float | str | None = None,
        library: Path | None = None,
        host_step_s: float = 1e-3,
        wheel_mass_kg: float = 40.0,
        for_step_s: float | None = None,
        force: bool = False,
    ) -> list[str]:
        """Writes a run folder for Adams with model file, library, commands and a test rig, like ``dashpot export adams``.

        :param folder: output folder, which is created if it is missing. Its ``README.txt`` describes the files.
        :param length_m: distance of the damper's markers at zero displacement, m, or a text with unit: ``"412.5mm"``, ``"0.4125m"``.
            The default is 0.4 m, and a note states this.
        :param library: library to copy into the folder; by default, the libraries with which this package was built.
        :param host_step_s: step, s, of a program that is coupled to Adams. Chatter is checked at this step.
        :param wheel_mass_kg: smallest mass that the damper moves, kg.
        :param for_step_s: step, s, of a program that is coupled to Adams. Friction that chatters at this step is replaced by presliding friction.
        :param force: also replaces files of another kind and write-protected files, like the command's ``--force``.
        :returns: notes on the export.
        :raises ExportError: if the length is implausible, the step or mass is invalid, or the library lacks the routines.
        :raises OutputError: if the output cannot be written, or would replace another file.
        """
        for name, value in (("host_step_s", host_step_s), ("wheel_mass_kg", wheel_mass_kg), ("for_step_s", for_step_s)):
            real(name, value)
        with watched():
            return _said_of(
                _native.export_adams(
                    self._native, os.fspath(folder), None if length_m is None else length_of("length_m", length_m), None if library is None else os.fspath(library),
                    host_step_s, wheel_mass_kg, for_step_s, force,
                )
            )  # fmt: skip

    def export_dpr(self, path: Path, *, model_curve: bool = False, force: bool = False) -> list[str]:
        """Writes the FV curve as a damper property file of Adams Car, like ``dashpot export dpr``.

        Such a file contains only a curve. Therefore it gets the plain FV curve of the fit in the model file, which has the smallest weighted
        error on the fitted tests.
        Without this curve, or if parameters were changed after the fit, it gets the model's own curve without friction.

        :param path: path of the output. A name that ends in ``.xml`` selects the XML format, which also contains the gas preload.
        :param model_curve: writes the model's own curve, which is that of its valves without friction, even if there is a plain FV curve of a fit.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :returns: notes on the origin of the curve and on what is left out. The file contains them as comments.
        :raises ExportError: if the model has no curve.
        :raises OutputError: if the output cannot be written, or would replace another file.
        """
        _, remarks = _native.export_dpr(self._native, os.fspath(path), os.path.basename(self._name), model_curve, force)
        return _said_of(remarks)

    def export_fmu(
        self,
        path: Path,
        *,
        others: Model | Sequence[Model] = (),
        fmi: int = 2,
        four: bool = False,
        motion_scale: float | None = None,
        force_scale: float | None = None,
        position_offset_m: float = 0.0,
        inputs: str | None = None,
        carmaker_length_m: float | str | None = None,
        model_curve: bool = False,
        sources: bool = True,
        hide_parameters: bool = False,
        library: Path | None = None,
        binaries: Mapping[str, Path] | None = None,
        host_step_s: float = 1e-3,
        wheel_mass_kg: float = 40.0,
        for_step_s: float | None = None,
        name: str | None = None,
        force: bool = False,
    ) -> list[str]:
        """Writes a functional mock-up unit (co-simulation and model exchange), like ``dashpot export fmu``.

        :param others: further dampers of a vehicle: the rear damper, or R1, L2 and R2. This model is the front damper or L1.
        :param fmi: FMI version, 2 or 3.
        :param four: uses this model for all four corners of a vehicle.
        :param motion_scale: extension in m per unit of the host's motion, such as 0.001 for mm. The default is 1 for one damper and -1 for a
            vehicle. The FMU declares the resulting unit, but no unit if the scale contains a motion ratio.
        :param force_scale: the host's force per N of tension, such as 0.001 for kN. The default is 1 for one damper and -1 for a vehicle. The
            FMU declares the resulting unit, but no unit if the scale contains a motion ratio.
        :param position_offset_m: extension from the rig's zero, m, at which the host's displacement is 0.
        :param inputs: time at which the importer sets the inputs of a co-simulation step: ``"begin"``, like FMPy (the FMU extrapolates), or
            ``"end"`` (default). With the default, an importer that sets inputs at the beginning gets the force one step late.
        :param carmaker_length_m: length of the damper at which the displacement in the records was 0, m, or a text with unit: ``"412.5mm"``,
            ``"0.4125m"``. It selects an FMU for IPG CarMaker, with signs and zero of its class Susp_Damper. Next to the FMU, it also writes the
            ``.pluginfo`` file with which CarMaker loads the FMU.
        :param model_curve: requires ``carmaker_length_m``. CarMaker's search for the equilibrium uses the model's own curve without friction,
            even if the model file contains the plain FV curve that was fitted to the same tests.
        :param sources: whether the FMU contains the sources of kernel and FMU.
        :param hide_parameters: hides all parameters of the damper from the FMU's variables and files. This is obfuscation, not protection, see
            ``dashpot export fmu --help``.
        :param library: static library ``libdashpot.a`` for this computer. The binary is then compiled on this computer, which requires a C
            compiler. Without it, the FMU contains this package's binaries for Linux, and for Windows if the package was built with them.
        :param binaries: library files for further platforms, compiled from this FMU's own sources: ``{"darwin64": "dashpot_damper.dylib"}``.
        :param host_step_s: step of the host, s, at which chatter is checked. The page of the FMU contains the result.
        :param wheel_mass_kg: smallest mass that the damper moves, kg.
        :param for_step_s: step of the host, s. Friction that chatters at this step is replaced by presliding friction. :meth:`check` reports the
            resulting change of the force.
        :param name: name of the model in the FMU.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :returns: platforms on which the FMU runs.
        :raises ExportError: if there is no binary, the compiler fails, or a length, step or mass is invalid.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: if ``carmaker_length_m`` is combined with another argument for signs or zero, or if ``model_curve`` is given
            without it.
        """
        if carmaker_length_m is not None and (four or motion_scale is not None or force_scale is not None or position_offset_m != 0.0):
            raise ValueError("carmaker_length_m sets signs, units and zero; give it without four, motion_scale, force_scale and position_offset_m")
        if model_curve and carmaker_length_m is None:
            raise ValueError("model_curve chooses the curve for CarMaker's equilibrium; give carmaker_length_m, the length of the damper, too")
        for number, value in (("host_step_s", host_step_s), ("wheel_mass_kg", wheel_mass_kg), ("for_step_s", for_step_s)):
            real(number, value)
        beside = [others] if isinstance(others, Model) else list(others)
        for other in beside:
            if not isinstance(other, Model):
                raise TypeError(f"others are dashpot.Model, not {type(other).__name__}; dashpot.Model.read(path) reads one")
        models = [self._native, *(m._native for m in beside)]
        stem = os.path.splitext(os.path.basename(self._name))[0]
        vehicle = four or len(models) > 1
        usual = f"dashpot vehicle, four dampers ({stem})" if vehicle else f"dashpot {stem}"
        with watched(), needs(library, *(binaries or {}).values()):
            return _native.export_fmu(
                models,
                os.fspath(path),
                {
                    "name": name or usual,
                    "model_file": os.path.basename(self._name),
                    "fmi": fmi,
                    "four": four,
                    "inputs": inputs,
                    "motion_scale": motion_scale,
                    "force_scale": force_scale,
                    "position_offset": position_offset_m,
                    "carmaker": None if carmaker_length_m is None else length_of("carmaker_length_m", carmaker_length_m),
                    "model_curve": model_curve,
                    "sources": sources,
                    "hide_parameters": hide_parameters,
                    "library": None if library is None else os.fspath(library),
                    "binaries": [(platform, os.fspath(file)) for platform, file in (binaries or {}).items()],
                    "host_step": host_step_s,
                    "wheel_mass": wheel_mass_kg,
                    "for_step": for_step_s,
                    "force": bool(force),
                },
            )

    def to_dict(self) -> dict[str, Any]:
        """Returns elements, parameters, and the fit's tests and notes from the model file, as a dictionary."""
        return self._said()

    def to_pandas(self) -> pandas.DataFrame:
        """Returns one row for each parameter. Requires pandas."""
        return frame(self._said()["parameters"])

    def __reduce__(self) -> tuple[Any, ...]:
        return (Model, (self.text, self._name), {"_file": self._file})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and other.text == self.text

    def __hash__(self) -> int:
        return hash(self.text)

    def _tables(self) -> dict[str, list[Row]]:
        own, several = held(self._said())
        return {"": [own], **several}

    def tables(self) -> dict[str, pandas.DataFrame]:
        """Returns the content of the model file as tables. The table ``""`` has the values of the whole model. Requires pandas."""
        return {name: frame(rows) for name, rows in self._tables().items()}

    def _repr_html_(self) -> str:
        rows = [{k: v for k, v in p.items() if k not in ("meaning", "source")} for p in self._said()["parameters"]]
        shown = table(f"Damper: {', '.join(self.elements)}", rows, self.notes)
        return shown + folded({name or "fit": rows for name, rows in self._tables().items()})

    def __repr__(self) -> str:
        return f"<dashpot.Model of {', '.join(self.elements)}>"


def _named_after(path: Path) -> str:
    """Returns the name of a model that was made from a file of another kind: the name of this file, with ``.toml``."""
    return os.path.splitext(os.path.basename(os.fspath(path)))[0] + ".toml"


def _said_of(notes: Sequence[str]) -> list[str]:
    return [as_arguments(note) for note in notes]


class FittedModel(Model):
    """A model that was made by :func:`dashpot.fit`, with the results of the fit."""

    def __init__(self, text: str, name: Path, fit: FitResult) -> None:
        super().__init__(text, name)
        self._fit = fit

    @property
    def fit(self) -> FitResult:
        """Results of the fit: estimates with their 95 % intervals, the inventory of effects, and measurement errors of the records."""
        return self._fit

    def __reduce__(self) -> tuple[Any, ...]:
        return (FittedModel, (self.text, self._name, self._fit), {"_file": self._file})
