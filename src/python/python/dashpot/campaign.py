"""Rig records: reading of files, and the cleaned records of a campaign."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Union, overload

from . import _native
from ._arguments import loads
from ._reading import How, how
from ._files import needs
from ._result import Result, Row, by_test, dataset, folded, frame, held, table
from ._work import watched
from .reading import Delay, Noise, Note, Setting, SignFinding, Unusable

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas
    import xarray

    Channel = npt.NDArray[np.float64]

#: Kinds of notes that also cause a Python warning, because results may be wrong if the user does not act on them.
_LOUD = _native.LOUD_NOTES

#: Path of a file or folder.
Path = Union[str, "os.PathLike[str]"]
#: Function that receives the completed fraction, 0 to 1, and a description of the current work.
Progress = Callable[[float, str], object]


@dataclass(frozen=True, repr=False)
class Record(Result):
    """One cleaned test. SI units; extension (rebound) velocity and tension force are positive."""

    name: str
    source: str
    cycles: tuple[dict[str, int], ...]
    amplitude: float
    frequency: float
    peak_velocity: float
    mean_displacement: float
    noise: Noise
    notes: tuple[Note, ...]
    #: Date and time of the record's time zero, s since 1970 by the rig's clock; None if the file has no date.
    begins: float | None = None
    #: Setting of the damper, from a channel or from the name of the test; None if both are missing.
    setting: Setting | None = field(default=None, metadata={"omitted": True})
    #: The campaign's clock at the record's time zero, s; 0 if every record has its own clock.
    clock_s: float = 0.0
    _native: _native.Campaign | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)
    _index: int = field(default=0, metadata={"hidden": True}, compare=False, repr=False)

    def _channels(self) -> dict[str, Channel]:
        if self._native is None:
            raise ValueError("only records of a Campaign hold their channels")
        return self._native.channels(self._index)

    @property
    def time(self) -> Channel:
        """Time, s."""
        return self._channels()["time"]

    @property
    def displacement(self) -> Channel:
        """Displacement, m, extension positive."""
        return self._channels()["displacement"]

    @property
    def velocity(self) -> Channel:
        """Velocity, m/s, extension (rebound) positive."""
        return self._channels()["velocity"]

    @property
    def force(self) -> Channel:
        """Force, N, tension positive."""
        return self._channels()["force"]

    @property
    def side_force(self) -> Channel | None:
        """Side force, N; None if the rig did not measure it."""
        return self._channels().get("side_force")

    @property
    def temperature(self) -> Channel | None:
        """Damper temperature, °C; None if the rig did not measure it."""
        return self._channels().get("temperature")

    @property
    def fingerprint(self) -> str:
        """Hash of the content. Equal measurements have equal fingerprints, regardless of the names of their files."""
        if self._native is None:
            raise ValueError("only records of a Campaign have a fingerprint")
        return self._native.fingerprint(self._index)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._native is None:
            return (_plain_record, (self.to_dict(),))
        return (_record, self._native.state(self._index))

    def _tables(self) -> dict[str, list[Row]]:
        own, several = held(self)
        channels = self._columns() if self._native is not None else {}
        rows = [dict(zip(channels, row, strict=True)) for row in zip(*(c.tolist() for c in channels.values()), strict=True)]
        return {"": [own], **several, **({"channels": rows} if rows else {})}

    def _columns(self) -> dict[str, Channel]:
        units = {"time": "s", "displacement": "m", "velocity": "m_s", "force": "N", "side_force": "N", "temperature": "C"}
        return {f"{name}_{units[name]}": values for name, values in self._channels().items()}

    def to_pandas(self) -> pandas.DataFrame:
        """Returns the channels as columns with their units. Requires pandas."""
        return frame(self._columns())

    def to_xarray(self) -> xarray.Dataset:
        """Returns the channels over time, with their units. Requires xarray."""
        units = {"displacement": "m", "velocity": "m/s", "force": "N", "side_force": "N", "temperature": "degC"}
        channels = self._channels()
        measured = {name: (values, units[name]) for name, values in channels.items() if name != "time"}
        return dataset("time", {"time": (channels["time"], "s")}, measured, name=self.name, source=self.source)

    def _repr_html_(self) -> str:
        # The channels are omitted, because they are too long to read.
        own, several = held(self)
        return table(f"Test {self.name}", [own], [n.text for n in self.notes]) + folded(several)


class Campaign(Sequence[Record]):
    """The cleaned records of a campaign, as a sequence of :class:`Record`. :meth:`read` makes it.

    SI units; extension (rebound) velocity and tension force are positive, regardless of the sign convention of the files.
    """

    def __init__(self, native: _native.Campaign, paths: Sequence[str]) -> None:
        self._native = native
        self.paths: tuple[str, ...] = tuple(paths)
        """The paths that were read."""
        # Settings with which the paths were read; None for a campaign that no command can read.
        self._reading: How | None = None
        said: dict[str, Any] = loads(native.json())
        self.sign: SignFinding = SignFinding.from_dict(said["sign"])
        """Positive direction in the files, and its confidence."""
        self.delay: Delay | None = Delay.from_dict(said["delay"]) if said["delay"] else None
        """Delay of the force channel; None if no clear delay was found."""
        self.notes: tuple[Note, ...] = tuple(Note.from_dict(n) for n in said["notes"])
        """Notes on the campaign as a whole."""
        self.unusable: tuple[Unusable, ...] = tuple(Unusable.from_dict(u) for u in said["unusable"])
        """Files and tests that could not be used, with their reasons."""
        self._said = said
        self._records = tuple(
            Record(**{**_fields(r), "_native": native, "_index": k}) for k, r in enumerate(said["records"])
        )

    @classmethod
    def read(
        cls,
        path: Path | Sequence[Path],
        *,
        positive: str | None = None,
        flip: Sequence[str] = (),
        columns: Mapping[str, str | int] | None = None,
        units: Mapping[str, str] | None = None,
        ignore: Sequence[str] = (),
        exclude: Sequence[str] = (),
        subfolders: bool = False,
        delay_s: float = 0.0,
        force_zero_n: float = 0.0,
        displacement_zero_m: float = 0.0,
        gain: float = 1.0,
        gains: Mapping[str, float] | None = None,
        rig_mass_kg: float = 0.0,
        sample_rate_hz: float | None = None,
        dates: str | None = None,
        initial_position_m: float = 0.0,
        strict: bool = False,
        progress: Progress | None = None,
    ) -> Campaign:
        """Reads record files (text, XLSX, MAT, MDF, TDMS, RPC III), or folders of them, as one campaign.

        A ``campaign.toml`` in the folder of the records has entries of the same names, which apply to arguments that are not given. A warning
        reports what may make a result wrong: an uncertain direction, tests of several or changing settings, or a truncated file.

        :param path: a file or folder, or several.
        :param positive: positive direction in the files, ``"rebound"`` or ``"compression"``; determined from the records if not given.
        :param flip: channels whose sign is reversed: ``"force"``, ``"motion"``.
        :param columns: heading, or number from 1, of a channel's column: ``{"force": "Load Cell 1"}``.
        :param units: unit of a channel whose heading has none: ``{"force": "kN"}``.
        :param ignore: channels that are not read, such as ``"velocity"``.
        :param exclude: names of files or tests to leave out; ``*`` matches any text.
        :param subfolders: reads the records in the subfolders of a folder as tests of the same campaign. The names of these tests begin with
            the name of the subfolder.
        :param delay_s: delay of the recorded force relative to the motion, s, which is corrected.
        :param force_zero_n: reading of the force channel without force, N, in the file's direction. It is subtracted.
        :param displacement_zero_m: reading of the displacement channel at zero, m, in the file's direction. It is subtracted.
        :param gain: factor of the force, applied after the subtraction of ``force_zero_n``.
        :param gains: factors of other channels: ``{"displacement": 1.02}``.
        :param rig_mass_kg: mass between load cell and damper that moves with the damper's end, kg, 0 or more. Its inertia force is subtracted.
        :param sample_rate_hz: sample rate of files without a column of time, Hz.
        :param dates: order of day and month in dates such as 3/11/2026, ``"day-first"`` or ``"month-first"``; determined from the files
            if not given.
        :param initial_position_m: displacement at the first sample, m, of files with velocity but without displacement.
        :param strict: raises an error for files that are no records, and for tests with a fault of their own. Otherwise they are left out.
        :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
        :raises RecordError: for the first file that is unreadable or implausible.
        :raises FileNotFoundError: if a path does not exist. The exception is also a :class:`RecordError`.

        >>> campaign = Campaign.read("campaign/", units={"force": "kN"})  # doctest: +SKIP
        """
        named = paths_of("path", path)
        read_by = how(
            positive=positive, flip=flip, columns=columns, units=units, ignore=ignore, exclude=exclude, subfolders=subfolders,
            delay_s=delay_s, force_zero_n=force_zero_n, displacement_zero_m=displacement_zero_m, gain=gain, gains=gains,
            rig_mass_kg=rig_mass_kg, sample_rate_hz=sample_rate_hz, dates=dates, initial_position_m=initial_position_m, strict=strict,
        )  # fmt: skip
        with watched(progress) as told, needs(*named):
            campaign = cls(_native.Campaign.read(named, read_by.mapping, read_by.strict, told), named)
        campaign._reading = read_by
        for note in campaign.notes:
            if note.kind in _LOUD:
                warnings.warn(note.text, stacklevel=2)
        return campaign

    def __len__(self) -> int:
        return len(self._records)

    def __iter__(self) -> Iterator[Record]:
        return iter(self._records)

    @overload
    def __getitem__(self, key: int | str) -> Record: ...
    @overload
    def __getitem__(self, key: slice) -> Campaign: ...
    def __getitem__(self, key: int | str | slice) -> Record | Campaign:
        """Returns a test by its index or its name. A slice gives a campaign of these tests, with the findings on the whole campaign."""
        if isinstance(key, str):
            for record in self._records:
                if record.name == key:
                    return record
            raise KeyError(f"there is no test {key!r}; the first is called {self._records[0].name!r}")
        return self._part(self._records[key]) if isinstance(key, slice) else self._records[key]

    def _part(self, records: tuple[Record, ...]) -> Campaign:
        """Makes a campaign of some tests of this one. It has no paths, because a command would read all tests of the paths."""
        if records:
            native = _of_records(records, "campaign")
        else:
            said = json.loads(self._native.state()[0])
            native = _native.Campaign.again(json.dumps({**said, "records": []}), [], [], [])
        part = Campaign(native, ())
        # The records keep their reference to the original campaign, so that records of several parts can be combined again.
        part._records = records
        return part

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the tests."""
        return tuple(r.name for r in self._records)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_campaign, (self.paths, *self._native.state()), {"_reading": self._reading})

    def to_dict(self) -> dict[str, Any]:
        """Returns the findings of reading, without the channels."""
        copied: dict[str, Any] = loads(self._native.json())
        return copied

    def _rows(self) -> list[Row]:
        rows = []
        for record in self._records:
            row = held(record)[0]
            row["cycles"] = len(record.cycles)
            row["notes"] = tuple(note.text for note in record.notes)
            rows.append(row)
        return rows

    def _tables(self) -> dict[str, list[Row]]:
        own, several = held({name: value for name, value in self.to_dict().items() if name != "records"})
        return {"": [own], **several, **held({"records": self._records})[1]}

    def to_pandas(self) -> pandas.DataFrame:
        """Returns one row for each test, with the test's name as index."""
        return by_test(self._rows())

    def to_xarray(self) -> xarray.Dataset:
        """Returns amplitude, frequency, peak velocity and mean displacement of each test, by its name.

        Requires xarray. :meth:`Record.to_xarray` returns the channels of one test.
        """
        records = self._records
        return dataset(
            "test",
            {"test": ([r.name for r in records], "")},
            {
                "amplitude": ([r.amplitude for r in records], "m"),
                "frequency": ([r.frequency for r in records], "Hz"),
                "peak_velocity": ([r.peak_velocity for r in records], "m/s"),
                "mean_displacement": ([r.mean_displacement for r in records], "m"),
            },
        )

    def tables(self) -> dict[str, pandas.DataFrame]:
        """Returns all findings as tables. The table ``""`` has the values of the whole campaign, and each list has its own table."""
        return {name: frame(rows) for name, rows in self._tables().items()}

    def _repr_html_(self) -> str:
        said = [*(n.text for n in self.notes), *(u.why for u in self.unusable)]
        said += [f"{record.name}: {note.text}" for record in self._records for note in record.notes]
        # The notes are listed above the table, because they are too long for its cells.
        rows = [{k: v for k, v in row.items() if k not in ("notes", "source")} for row in self._rows()]
        shown = table(f"Campaign of {len(self)} tests", rows, said)
        return shown + folded({name or "figures": rows for name, rows in self._tables().items()})

    def __repr__(self) -> str:
        origin = f" from {', '.join(self.paths)}" if self.paths else ""
        return f"<dashpot.Campaign of {len(self)} tests{origin}>"


def _fields(said: dict[str, Any]) -> dict[str, Any]:
    """Returns the public fields of a record from its JSON."""
    record = Record.from_dict(said)
    return {name: getattr(record, name) for name in Record.__dataclass_fields__ if not name.startswith("_")}


def paths_of(name: str, path: object) -> list[str]:
    """Converts one path or several paths to a list of texts. Anything else is a TypeError that names the argument ``name``."""
    paths = [path] if isinstance(path, (str, os.PathLike)) else path
    if isinstance(paths, bytes) or not (isinstance(paths, Sequence) and all(isinstance(p, (str, os.PathLike)) for p in paths)):
        raise TypeError(f"{name} is a file or folder as str or pathlib.Path, or a list of them, not {path!r}")
    return [os.fspath(p) for p in paths]


def native_of(campaign: Sequence[Record], name: str) -> _native.Campaign:
    """Returns the campaign of the extension module. An argument that is no campaign and no list of its records is a TypeError."""
    if isinstance(campaign, Campaign):
        return campaign._native
    if not isinstance(campaign, (list, tuple)) or not campaign or not all(isinstance(r, Record) for r in campaign):
        raise TypeError(f"{name} is a dashpot.Campaign, not a {type(campaign).__name__}; dashpot.Campaign.read(path) reads one")
    return _of_records(campaign, name)


def _of_records(records: Sequence[Record], name: str) -> _native.Campaign:
    """Makes a campaign of the extension module from some records of one campaign, with the findings on that whole campaign."""
    whole = records[0]._native
    if whole is None or any(r._native is not whole for r in records):
        raise ValueError(f"{name} holds records that are not of one dashpot.Campaign; read their files together, as a list of paths")
    if len({r._index for r in records}) < len(records):
        raise ValueError(f"{name} holds a record twice")
    said: dict[str, Any] = {}
    channels: list[dict[str, Channel]] = []
    as_read: list[str | None] = []
    files: dict[Any, None] = {}
    for record in records:
        of_one, its_channels, its_origin, its_files = whole.state(record._index)
        one = json.loads(of_one)
        one["records"] = [*said.get("records", []), *one["records"]]
        one["messages"] = [*said.get("messages", []), *one["messages"]]
        said = one
        channels.extend(its_channels)
        as_read.extend(its_origin)
        files.update(dict.fromkeys(its_files))
    return _native.Campaign.again(json.dumps(said), channels, as_read, list(files))


# Pickle rebuilds campaigns and records by the next three functions.
def _campaign(paths: tuple[str, ...], *state: Any) -> Campaign:
    return Campaign(_native.Campaign.again(*state), paths)


def _record(*state: Any) -> Record:
    return _campaign((), *state)[0]


def _plain_record(data: dict[str, Any]) -> Record:
    return Record.from_dict(data)
