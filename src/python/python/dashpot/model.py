"""A damper: its model file, its numbers, and the force for a motion."""

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
    """One parameter that is in use, with its 95 % interval where a fit left one."""

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
    """Force of a model for a motion. SI units; extension (rebound) velocity and tension force are positive."""

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
        """Lists under the column names of ``dashpot simulate``."""
        return {name: column.tolist() for name, column in self._columns().items()}

    def _columns(self) -> dict[str, npt.NDArray[np.float64]]:
        return {
            "time_s": self.time,
            "displacement_m": self.displacement,
            "velocity_m_s": self.velocity,
            "force_N": self.force,
        }

    def to_pandas(self) -> pandas.DataFrame:
        """One row an instant."""
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
        """The table of :meth:`to_pandas` alone."""
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
    """An identified damper. Made by :func:`dashpot.fit`, :meth:`read`, or from the text of a model file.

    SI units; extension (rebound) velocity and tension force are positive.
    """

    def __init__(self, text: str, name: Path = "model") -> None:
        if not isinstance(text, str):
            raise TypeError(f"text is the text of a model file, not a {type(text).__name__}; dashpot.Model.read(path) reads one")
        if "\n" not in text and text.endswith(".toml"):
            raise _native.ModelError(f"{text!r} is no text of a model file; dashpot.Model.read({text!r}) reads one by its path")
        self._native = _native.Model.parse(text, os.fspath(name))
        self._name = os.fspath(name)
        # The file that holds it, where there is one.
        self._file: str | None = None

    @classmethod
    def read(cls, path: Path) -> Model:
        """Reads a model file.

        :raises ModelError: naming file, line and parameter.
        :raises FileNotFoundError: the same error, where there is no such file.
        """
        # Read by the compiled part, for its sentences.
        with needs(path):
            model = cls(_native.Model.read(os.fspath(path)).text, path)
        model._file = model._name
        return model

    @classmethod
    def from_dpr(cls, path: Path) -> Model:
        """Makes a model from a damper property file of Adams Car, TeimOrbit or XML: the FV curve, and the gas force where it has one; as
        ``dashpot import dpr``.

        How far the curve follows the one that Adams makes of the file, and what was left out, stands in :attr:`text` as comments.

        :raises ModelError: where the file cannot be read, or makes no model.
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
        """Makes a model to begin with from a table of peak forces over peak velocities (PVP, CVP), CSV or Excel; as ``dashpot import peaks``.

        Hysteresis needs records (:func:`dashpot.fit`). A warning says where the table's forces speak against the side that was taken as rebound.

        :param positive: direction that a table with signs counts positive, ``"rebound"`` (if not given) or ``"compression"``.
        :param units: unit of ``velocity`` or ``force`` where the headings have none or a wrong one: ``{"force": "lbf"}``.
        :param columns: heading, or number from 1, of a column: ``velocity``, ``force``, and of one stroke ``rebound_velocity``,
            ``rebound_force``, ``compression_velocity``, ``compression_force``.
        :param clicks: the curve to take of a table that has one for each number of clicks.
        :param gas_force_n: gas force in the table's forces, N; taken out of the curve.
        :param friction_n: friction in the table's forces, N; taken out of the curve.
        :raises ModelError: naming the table and its line, where it cannot be read, what a column is cannot be told, or its forces make no model.
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
        """Writes the model file, whole or not at all. Reports and FMUs call the model by this name from then on.

        :param force: replaces an existing file, even one of another kind or a write-protected file.
        :raises OutputError: if the file cannot be written.
        :raises FileExistsError: if another file exists and ``force`` is not given. The exception is also an :class:`OutputError`.
        """
        write_new(path, self.text, force)
        self._file = self._name = os.fspath(path)

    @property
    def text(self) -> str:
        """The model file: flat ``name = value`` text with units, intervals and sources as comments."""
        return self._native.text

    @property
    def fit(self) -> FitResult | None:
        """What the fit said, where this model comes from one in this process: of a :class:`FittedModel` always."""
        return None

    def _said(self) -> dict[str, Any]:
        said: dict[str, Any] = loads(self._native.json())
        return said

    @property
    def elements(self) -> tuple[str, ...]:
        """Elements that are on."""
        return tuple(self._said()["elements"])

    @property
    def parameters(self) -> dict[str, Parameter]:
        """Parameters that are in use, by name: where another value would be another damper.

        Of elements that are off there are none, nor numbers of a form that was not chosen, such as the knees beside an FV table. Settings
        such as ``substeps`` are among them where they are not at their default, as in the model file.
        """
        return {p["name"]: Parameter.from_dict(p) for p in self._said()["parameters"]}

    @property
    def tests(self) -> tuple[str, ...]:
        """Names of the tests that the fit used."""
        return tuple(self._said()["tests"])

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks of the fit."""
        return tuple(self._said()["notes"])

    @property
    def velocity_range(self) -> tuple[float, float]:
        """Lowest and highest velocity (m/s) of the FV curve; beyond, it is prolonged straight."""
        return self._native.velocity_range()

    def keys(self) -> KeysView[str]:
        """Names of the :attr:`parameters` that are in use; with it ``dict(model)`` is their values by name."""
        return self.parameters.keys()

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())

    def __contains__(self, name: object) -> bool:
        return name in self.keys()

    def __getitem__(self, name: str) -> Any:
        """The value of a parameter that is in use."""
        parameters = self.parameters
        if name in parameters:
            return parameters[name].value
        near = difflib.get_close_matches(str(name), parameters, 1)
        hint = f"did you mean {near[0]!r}?" if near else f"there are {several(list(parameters))}"
        raise KeyError(f"there is no parameter {name!r} in use here; {hint}")

    def steady_force(self, velocity_m_s: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Force (N) of the damper moving steadily at each velocity (m/s) through displacement 0: its FV curve with friction and gas."""
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
        """Compares the model with records, beside the plain FV curve; as ``dashpot validate``.

        What the model's own fit found these records to be off by (a late force, a mass on the load cell) is taken out of them;
        :attr:`Validation.campaign` has them as they were compared, with a note.

        :param campaign: a :class:`Campaign`, or some of its records.
        :param limits: windows that the damper has to keep, of :func:`dashpot.read_limits`; :attr:`Validation.limits` says which it does,
            and which the model does.
        :param against: models of the literature that are identified from the tests that this model was fitted to, and compared with:
            ``"fv"``, ``"piecewise"``, ``"lag"``, ``"surface"``, ``"dahl"``, ``"bouc-wen"``, ``"spencer"``, ``"kwok"``, ``"network"``, or
            several of them; ``"all"``; or files of theirs (:meth:`LiteratureModel.write`). :attr:`Validation.against` has their errors and numbers.
        :raises ValidationError: where they cannot be compared, a limit cannot be kept, or a model to compare with is not known.
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
        # Limits that stand in no file cannot be given to the command.
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
        """The force for a motion; as ``dashpot simulate``.

        With displacement (m) and velocity (m/s) both drive the model; displacement alone is differentiated by a cubic spline;
        velocity alone is integrated from ``initial_position_m`` (m). Extension is positive. The damper starts settled in its
        first position. A warning says where a motion is none of a damper, as in millimeters. Noise of a measured displacement comes back multiplied by the series stiffness:
        :meth:`validate` smooths, this does not.

        :param time_s: times, s, increasing.
        :param step_s: fixed step, s; the times given if not.
        :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
        :raises MotionError: where a number overflows, or position or step cannot be.
        :raises ValueError, TypeError: where a channel is no column of finite real numbers, one for every time.
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
        # Of the motion that drove the model: a slow motion in millimeters shows by its stroke, a small fast one by its velocity.
        warn_of_units(displacement_m=response.displacement, velocity_m_s=response.velocity)
        return response

    def check(self, *, host_step_s: float = 1e-3, wheel_mass_kg: float = 40.0, for_step_s: float | None = None) -> HostCheck[Model]:
        """Whether the damper chatters in a host that holds its force over a step; as ``dashpot check``.

        :param host_step_s: step of the host, s.
        :param wheel_mass_kg: smallest mass that the damper moves, kg.
        :param for_step_s: step of a host, s, in place of ``host_step_s``: friction that chatters there is replaced by presliding friction, and
            :attr:`HostCheck.ready` is the damper for that host, to be written or exported.
        :raises ModelError: where step or mass cannot be.
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
        """Writes everything that a run folder of Adams needs: model file, library, commands, a test rig; as ``dashpot export adams``.

        :param folder: folder to write to; made if it is not there. It begins with ``README.txt``.
        :param length_m: distance of the damper's markers at zero displacement, m, or with its unit: ``"412.5mm"``, ``"0.4125m"``;
            if not given, 0.4 m, and a note says so.
        :param library: the library to hand out; if not given, those that this package was built with.
        :param host_step_s: step, s, of a program that Adams is coupled to, at which chatter is judged.
        :param wheel_mass_kg: smallest mass that the damper moves, kg.
        :param for_step_s: step, s, of such a program: friction that chatters there is replaced by presliding friction.
        :param force: also replaces files of another kind and write-protected files, like the command's ``--force``.
        :returns: what is to be known of it, in sentences.
        :raises ExportError: for a length that no damper has, a step or mass that cannot be, or a library without the routines.
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
        """Writes the FV curve as a damper property file of Adams Car; as ``dashpot export dpr``.

        It holds a curve alone, so it gets the plain FV curve that the fit left in the model file, the best that a curve can do; without one, or
        where the numbers were changed since, the model's own curve, without friction.

        :param path: where to write; a name that ends in ``.xml`` gets the XML form, which holds the gas preload too.
        :param model_curve: the model's own curve, which is that of its valves without friction, also where there is a plain one of a fit.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :returns: whose curve it is, and what is left out, in sentences; the file has them as comments.
        :raises ExportError: where the model has no curve.
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
        """Writes a functional mock-up unit (co-simulation and model exchange); as ``dashpot export fmu``.

        :param others: the rear damper of a vehicle, or R1, L2 and R2; this model is the front or L1.
        :param fmi: version, 2 or 3.
        :param four: four corners of this model alone.
        :param motion_scale: extension in m per unit of the host's motion, such as 0.001 for mm; 1 for one damper, -1 for a vehicle. The
            FMU declares that unit, and none where a motion ratio is in the scale.
        :param force_scale: the host's force per N of tension, such as 0.001 for kN; 1 for one damper, -1 for a vehicle. As for the motion.
        :param position_offset_m: extension from the rig's zero, m, where the host's displacement is 0.
        :param inputs: when the importer sets the inputs of a co-simulation step: ``"begin"``, as FMPy does (the FMU extrapolates), or ``"end"``.
            Without it they count at the end, and an importer of the first kind gets the force one step late.
        :param carmaker_length_m: for IPG CarMaker: signs and zero of its class Susp_Damper, and beside the FMU the ``.pluginfo`` file by which it takes it.
            The length of the damper at which the displacement in the records was 0, m, or with its unit: ``"412.5mm"``, ``"0.4125m"``.
        :param model_curve: with ``carmaker_length_m``: for the damper that CarMaker's equilibrium is looked for with, the model's own curve, without
            friction, also where the model file has the plain FV curve that was fitted to the same tests.
        :param sources: whether the sources of kernel and FMU go inside.
        :param hide_parameters: no number of the damper is a variable of the FMU or can be read off its files; a veil and no lock, see
            ``dashpot export fmu --help``.
        :param library: static library ``libdashpot.a`` for this computer: the binary is compiled here (needs a C compiler).
            Without it the binaries that this package holds for Linux, and for Windows where it was built with them, are put inside; that
            needs neither compiler nor library.
        :param binaries: library files for further platforms, compiled from this FMU's own sources: ``{"darwin64": "dashpot_damper.dylib"}``.
        :param host_step_s: step of the host, s, at which chatter is judged; what is to be known of it stands on the FMU's page.
        :param wheel_mass_kg: smallest mass that the damper moves, kg.
        :param for_step_s: step of a host, s: friction that chatters there is replaced by presliding friction (:meth:`check` says what that changes).
        :param name: name of the model in the FMU.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :returns: the platforms that it runs on.
        :raises ExportError: where there is no runtime, the compiler refuses, or a length, step or mass cannot be.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: where ``carmaker_length_m``, which sets signs and zero, stands beside what sets them too, or ``model_curve`` stands without it.
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
        """Elements, parameters, and what the fit left behind."""
        return self._said()

    def to_pandas(self) -> pandas.DataFrame:
        """One row a parameter."""
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
        """Everything that the model file says, as tables: what is of the whole under ``""``, and the parameters."""
        return {name: frame(rows) for name, rows in self._tables().items()}

    def _repr_html_(self) -> str:
        rows = [{k: v for k, v in p.items() if k not in ("meaning", "source")} for p in self._said()["parameters"]]
        shown = table(f"Damper: {', '.join(self.elements)}", rows, self.notes)
        return shown + folded({name or "fit": rows for name, rows in self._tables().items()})

    def __repr__(self) -> str:
        return f"<dashpot.Model of {', '.join(self.elements)}>"


def _named_after(path: Path) -> str:
    """What a model is called that was made from a file of another kind."""
    return os.path.splitext(os.path.basename(os.fspath(path)))[0] + ".toml"


def _said_of(notes: Sequence[str]) -> list[str]:
    return [as_arguments(note) for note in notes]


class FittedModel(Model):
    """A model that comes from :func:`dashpot.fit`, with what the fit said of it."""

    def __init__(self, text: str, name: Path, fit: FitResult) -> None:
        super().__init__(text, name)
        self._fit = fit

    @property
    def fit(self) -> FitResult:
        """What the fit said: estimates with their 95 % intervals, the inventory of effects, what the records are off by."""
        return self._fit

    def __reduce__(self) -> tuple[Any, ...]:
        return (FittedModel, (self.text, self._name, self._fit), {"_file": self._file})
