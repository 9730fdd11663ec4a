"""Which campaigns: folders, files, or a list of them with serial number, batch and date."""

from __future__ import annotations

import csv
import datetime
import hashlib
import json
import os
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from .._native import RecordError

#: Endings of record files; those that the reader takes out of a folder.
RECORDS = {".csv", ".txt", ".tsv", ".asc", ".dat", ".xlsx", ".xlsm", ".mat", ".rsp", ".drv", ".tim"}
#: Columns of a list of campaigns; all but the first may be missing.
COLUMNS = ("campaign", "serial", "batch", "date")


@dataclass(frozen=True)
class Job:
    """One campaign of one damper."""

    campaign: str
    serial: str = ""
    batch: str = ""
    date: str = ""
    """ISO date, ``2026-11-23``, with or without a time."""

    def key(self, said: str) -> str:
        """What makes this work the same as work done before: the campaign, its files as they are now, and the plan."""
        files = []
        path = Path(self.campaign)
        for file in sorted(path.iterdir()) if path.is_dir() else [path]:
            try:
                stat = file.stat()
                files.append((file.name, stat.st_size, stat.st_mtime_ns))
            except OSError:
                files.append((file.name, -1, -1))
        text = json.dumps([asdict(self), files, said], sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()[:32]


def find_jobs(paths: Sequence[str | os.PathLike[str]]) -> list[Job]:
    """The campaigns that the paths stand for, in their order, each once.

    A folder with records is a campaign; a folder of such folders is all of them; a CSV file with the column ``campaign`` is a
    list, whose paths count from its own folder and which may have the columns serial, batch and date.

    :raises RecordError: where a path is not there or a list is wrong. A campaign in a list that is not there becomes a row.
    """
    jobs: dict[str, Job] = {}
    for given in paths:
        path = Path(given)
        if not path.exists():
            raise RecordError(f"{path}: there is no such file or folder")
        for job in _listed(path) if _is_list(path) else _folder(path):
            jobs.setdefault(job.campaign, job)
    if not jobs:
        raise RecordError("there is no campaign: give folders with records, a folder of such folders, or a list (CSV)")
    return list(jobs.values())


def _is_list(path: Path) -> bool:
    if path.suffix.lower() != ".csv" or path.is_dir():
        return False
    with path.open(encoding="utf-8-sig", errors="replace") as file:
        return "campaign" in [c.strip().lower() for c in file.readline().split(",")]


def _listed(path: Path) -> list[Job]:
    with path.open(encoding="utf-8-sig", newline="") as file:
        reader = csv.reader(file)
        head = [c.strip().lower() for c in next(reader)]
        unknown = [c for c in head if c not in COLUMNS]
        if unknown:
            raise RecordError(f"{path}, line 1: there is no column {unknown[0]!r}; the columns are {', '.join(COLUMNS)}")
        jobs = []
        for row in reader:
            if not any(cell.strip() for cell in row):
                continue
            line = reader.line_num
            if len(row) != len(head):
                raise RecordError(f"{path}, line {line}: {len(row)} cells where the first line has {len(head)}")
            said = {name: cell.strip() for name, cell in zip(head, row, strict=True)}
            try:
                said["date"] = datetime.datetime.fromisoformat(said["date"]).isoformat() if said.get("date") else ""
            except ValueError:
                raise RecordError(
                    f"{path}, line {line}: {said['date']!r} is no date; write it as 2026-11-23 or 2026-11-23T14:05"
                ) from None
            said["campaign"] = os.path.join(path.parent, said["campaign"])
            jobs.append(Job(**said))
    return jobs


def _folder(path: Path) -> list[Job]:
    if not path.is_dir() or _has_records(path):
        return [Job(str(path), path.stem if path.is_file() else path.name)]
    inside = sorted(p for p in path.iterdir() if p.is_dir() and not p.name.startswith("."))
    return [Job(str(p), p.name) for p in inside]


def _has_records(path: Path) -> bool:
    return any(p.is_file() and p.suffix.lower() in RECORDS for p in path.iterdir())
