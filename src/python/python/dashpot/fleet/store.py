"""Results on disk: parts that are written during the run, and the table that is made from them.

A part is written to a temporary file and then renamed, so that it is complete or absent. A killed run loses only unfinished work. The rows of
the table have the order of the campaigns. Its bytes therefore do not depend on the number of workers or of interruptions.
"""

from __future__ import annotations

import os
import tempfile
from collections import OrderedDict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

import pyarrow as pa
import pyarrow.parquet as pq

from .._native import OutputError
from .examine import VELOCITIES, force_column
from .settings import FleetSettings, column, place_of

_NUMBER = pa.struct(
    [
        ("name", pa.string()),
        ("index", pa.int32()),
        ("value", pa.float64()),
        ("low", pa.float64()),
        ("high", pa.float64()),
        ("unit", pa.string()),
        ("standing", pa.string()),
        ("setting", pa.float64()),
    ]
)
_CHANGE = pa.struct(
    [
        ("name", pa.string()),
        ("reference", pa.float64()),
        ("value", pa.float64()),
        ("low", pa.float64()),
        ("high", pa.float64()),
        ("unit", pa.string()),
        ("probability", pa.float64()),
        ("force_n_rms", pa.float64()),
        ("velocity_m_s", pa.float64()),
        ("setting", pa.float64()),
    ]
)
#: Verdict of a diagnosis, with its effect or suspect.
_VERDICT = [
    ("verdict", pa.string()),
    ("effect", pa.string()),
    ("effect_form", pa.string()),
    ("effect_confidence", pa.float64()),
    ("suspect", pa.string()),
    ("suspect_confidence", pa.float64()),
]
_AT_SETTING = pa.struct(
    [
        ("setting", pa.float64()),
        ("tests", pa.int32()),
        ("error_percent", pa.float64()),
        ("rmse_n", pa.float64()),
        ("fv_error_percent", pa.float64()),
        ("forces", pa.list_(pa.float64())),
        *_VERDICT,
    ]
)
#: Columns that only parts contain: keys of the jobs, and measured values for limits.
OF_PARTS = ("key", "measured")
#: Suffix of the key of a row that the table shows but that does not count as finished. The next run evaluates its campaign again.
NOT_DONE = "~"
#: Columns of a part. The table has three further columns (value, low, high) for every parameter that any damper has. A parameter that depends
#: on the setting has these columns at each setting of the fleet, such as ``coulomb_force_at_0.8_A``. So have errors and forces. Parameters of
#: the actuator, such as ``setting_time_up``, have columns if tests with a changing setting identify them.
SCHEMA = pa.schema(
    [
        ("key", pa.string()),
        ("campaign", pa.string()),
        ("serial", pa.string()),
        ("batch", pa.string()),
        ("date", pa.string()),
        ("status", pa.string()),
        ("reason", pa.string()),
        ("judgement", pa.string()),
        ("missed", pa.list_(pa.string())),
        ("measured", pa.string()),
        ("setting", pa.string()),
        ("setting_unit", pa.string()),
        ("settings", pa.list_(_AT_SETTING)),
        ("tests", pa.int32()),
        ("positive", pa.string()),
        ("positive_confidence", pa.float64()),
        ("misfit", pa.float64()),
        ("error_percent", pa.float64()),
        ("rmse_n", pa.float64()),
        ("fv_error_percent", pa.float64()),
        *_VERDICT,
        ("summary", pa.string()),
        ("changes", pa.list_(_CHANGE)),
        *((force_column(v), pa.float64()) for v in VELOCITIES),
        ("elements", pa.list_(pa.string())),
        ("parameters", pa.list_(_NUMBER)),
        ("notes", pa.list_(pa.string())),
        ("model", pa.string()),
    ]
)
#: Number of rows in a row group of the Parquet table. Only one group is in memory while the table is written.
GROUP = 256
#: Number of parts in memory while the table is written. A few suffice, because neighboring campaigns are in the same parts.
KEPT = 8


#: Function that returns entries to overwrite in a row of the table, from the index of the row and the row.
Finish = Callable[[int, Mapping[str, Any]], Mapping[str, Any]]


class Store:
    """Parts of one table, in the folder ``OUT.parts``. A lock allows only one run at a time."""

    def __init__(self, out: str | os.PathLike[str]) -> None:
        self.out = Path(out)
        self.folder = self.out.with_name(self.out.name + ".parts")
        if not self.out.parent.is_dir():
            raise OutputError(f"cannot write {self.out}: there is no folder {self.out.parent}; make it first")
        if self.out.is_dir():
            raise OutputError(f"cannot write {self.out}: it is a folder; name a file in it")
        if self.out.exists() and self.out.stat().st_size and not _is_parquet(self.out):
            raise OutputError(f"cannot write {self.out}: it is there already and is no Parquet file; name another")
        self.folder.mkdir(exist_ok=True)
        self._lock: IO[str] = (self.folder / "lock").open("w")
        _lock(self._lock, self.out)
        for half in self.folder.glob(".half-*"):
            half.unlink()
        #: Part and row index of each finished campaign, by its key.
        self.done: dict[str, tuple[str, int]] = {}
        #: Names of unreadable parts, which were renamed. Their campaigns are evaluated again.
        self.damaged: list[str] = []
        for part in self._parts():
            try:
                keys = pq.read_table(part, columns=["key"])["key"].to_pylist()
            except (pa.ArrowException, OSError, KeyError):
                self._set_aside(part)
                continue
            self._take(part.name, keys)

    def _parts(self) -> list[Path]:
        return sorted(self.folder.glob("part-*.parquet"))

    def _set_aside(self, part: Path) -> None:
        part.replace(part.with_name(f"damaged-{part.name}"))
        self.damaged.append(part.name)

    def place(self, key: str) -> tuple[str, int]:
        """Returns part and row index of a campaign that was evaluated, even if it does not count as finished."""
        return self.done[key] if key in self.done else self.done[key + NOT_DONE]

    def _take(self, part: str, keys: Iterable[str]) -> None:
        self.done.update((key, (part, row)) for row, key in enumerate(keys))

    def forget(self, keys: Iterable[str]) -> None:
        """Removes campaigns from the finished ones."""
        for key in keys:
            self.done.pop(key, None)

    def failed(self) -> list[str]:
        """Returns the keys of campaigns whose last evaluation failed."""
        out: list[str] = []
        for part in self._parts():
            table = pq.read_table(part, columns=["key", "status"])
            pairs = zip(table["key"].to_pylist(), table["status"].to_pylist(), strict=True)
            out.extend(key for row, (key, status) in enumerate(pairs) if status == "failed" and self.done.get(key) == (part.name, row))
        return out

    def add(self, rows: Sequence[Mapping[str, Any]]) -> None:
        """Writes rows as a part."""
        keys = [row["key"] for row in rows]
        # Parts have increasing numbers, because the row of a campaign in a later part replaces that of an earlier part.
        number = 1 + max((int(part.name.split("-")[1]) for part in self._parts()), default=-1)
        name = f"part-{number:07d}-{keys[0][:12]}.parquet"
        _write_whole(self.folder / name, [_table(rows, SCHEMA)], SCHEMA)
        self._take(name, keys)

    def rows(self, keys: Iterable[str]) -> Iterator[dict[str, Any]]:
        """Yields the stored rows in the order of ``keys``, with at most :data:`KEPT` parts in memory.

        :raises OutputError: if a part is damaged. The part is renamed.
        """
        parts: OrderedDict[str, list[dict[str, Any]]] = OrderedDict()
        for key in keys:
            part, row = self.place(key)
            if part not in parts:
                try:
                    parts[part] = pq.read_table(self.folder / part).to_pylist()
                except (pa.ArrowException, OSError) as error:
                    self._set_aside(self.folder / part)
                    raise OutputError(
                        f"{self.folder / part} is damaged and was set aside ({error}); start the run again to redo it"
                    ) from error
                if len(parts) > KEPT:
                    parts.popitem(last=False)
            parts.move_to_end(part)
            # The row is copied, because the table may contain a campaign twice.
            yield dict(parts[part][row])

    def table(self, keys: Sequence[str], finish: Finish | None = None) -> int:
        """Writes the table of the campaigns with these keys, in their order. Returns the number of failed campaigns.

        :param finish: function that returns entries to overwrite in a row, from the index of the row and the row.
        """
        units: dict[str, str] = {}
        failed = 0
        over = FleetSettings()
        for row in self.rows(keys):
            failed += row["status"] == "failed"
            over.take(row)
            for number in row["parameters"] or ():
                if number["index"] is None:
                    units.setdefault(number["name"], number["unit"])
        units = {name: over.number_unit(name, unit) for name, unit in units.items()}
        names = sorted(units)
        fields = [f for f in SCHEMA if f.name not in OF_PARTS]
        for name in names:
            unit = {"unit": units[name]}
            if name not in over.varying:
                fields.extend(pa.field(n, pa.float64(), metadata=unit) for n in (name, f"{name}_low", f"{name}_high"))
        at_settings = {value: over.label(value) for value in over.values()}
        for value, shown in at_settings.items():
            said = {"setting": repr(value), "setting_name": shown}
            for name, own_unit in (("error_percent", "%"), *((force_column(v), "N") for v in VELOCITIES)):
                fields.append(pa.field(column(name, shown), pa.float64(), metadata={**said, "quantity": name, "unit": own_unit}))
            for name in sorted(over.varying):
                own, metadata = column(name, shown), {**said, "quantity": name, "unit": units[name]}
                fields.extend(pa.field(n, pa.float64(), metadata=metadata) for n in (own, f"{own}_low", f"{own}_high"))
        schema = pa.schema(fields)
        _write_whole(self.out, self._groups(keys, schema, finish, over, at_settings), schema)
        return failed

    def _groups(
        self, keys: Sequence[str], schema: pa.Schema, finish: Finish | None, over: FleetSettings, at_settings: Mapping[float, str]
    ) -> Iterator[pa.Table]:
        for start in range(0, len(keys), GROUP):
            rows = []
            for at, row in enumerate(self.rows(keys[start : start + GROUP]), start):
                if finish is not None:
                    row.update(finish(at, row))
                # A damper has values only at its own settings. At all others it was not measured.
                own = {one["setting"]: _shown(one["setting"], row, over, at_settings) for one in row["settings"] or ()}
                for one in row["settings"] or ():
                    shown = own[one["setting"]]
                    if shown is not None:
                        row[column("error_percent", shown)] = one["error_percent"]
                        row.update({column(force_column(v), shown): force for v, force in zip(VELOCITIES, one["forces"], strict=True)})
                for number in row["parameters"] or ():
                    # A parameter that the data does not determine has no value in the table, because its number is a default.
                    if number["index"] is None and number["standing"] != "not_identified":
                        name, columns = number["name"], [number["name"]]
                        if name in over.varying:
                            there = own.values() if number["setting"] is None else [own.get(number["setting"])]
                            columns = [column(name, shown) for shown in there if shown is not None]
                        value, low, high = (over.own_number(row, name, number[end]) for end in ("value", "low", "high"))
                        for key in columns:
                            row[key], row[f"{key}_low"], row[f"{key}_high"] = value, low, high
                rows.append(row)
            yield _table(rows, schema)

    def close(self) -> None:
        """Releases the lock on the parts."""
        self._lock.close()


def _shown(setting: float, row: Mapping[str, Any], over: FleetSettings, at_settings: Mapping[float, str]) -> str | None:
    """Returns the text of the fleet's setting at which a damper was measured, or None if its unit belongs to another quantity."""
    value = over.own(row, setting)
    place = None if value is None else place_of(list(at_settings), value)
    return None if place is None else at_settings[place]


def _table(rows: Sequence[Mapping[str, Any]], schema: pa.Schema) -> pa.Table:
    return pa.Table.from_pylist([dict(row) for row in rows], schema=schema)


def _write_whole(path: Path, tables: Iterable[pa.Table], schema: pa.Schema) -> None:
    handle, half = tempfile.mkstemp(prefix=".half-", suffix=".parquet", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            with pq.ParquetWriter(file, schema, compression="zstd") as writer:
                for table in tables:
                    writer.write_table(table)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(half, 0o666 & ~_umask())
        os.replace(half, path)
    except BaseException:
        Path(half).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _is_parquet(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(4) == b"PAR1"


def _lock(file: IO[str], out: Path) -> None:
    try:
        import fcntl
    except ImportError:  # Windows has no fcntl. There, a second run fails when it replaces an open part.
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise OutputError(f"another run is writing {out}; wait for it, or name another file") from None
