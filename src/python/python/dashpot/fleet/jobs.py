"""Campaigns of a fleet, from folders, from files, or from a list with serial number, batch and date."""

from __future__ import annotations

import datetime
import hashlib
import json
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from .._native import RecordError
from ._text import delimiter_of, heading_of, rows_of, text_of
from .files import folders_in, is_campaign, stamps

#: Columns of a list of campaigns. Only the first is required.
COLUMNS = ("campaign", "serial", "batch", "date")


@dataclass(frozen=True)
class Job:
    """One campaign of one damper."""

    campaign: str
    serial: str = ""
    batch: str = ""
    date: str = ""
    """ISO date, ``2026-11-23``, with or without a time."""

    def key(self, said: str, subfolders: bool = False) -> str:
        """Returns a hash of the campaign's path, the stamps of its files, and the plan ``said``. Work with an equal key was done before.

        The hash does not depend on serial number, batch and date, because they affect no computed value of the table.
        """
        path = os.path.abspath(self.campaign)
        text = json.dumps([path, stamps(path, subfolders), said], sort_keys=True)
        return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()[:32]

    def checked(self) -> Job:
        """Returns the job with text in every field. Numbers, paths and dates, for example from a pandas table, are converted.

        :raises RecordError: if a field is invalid. The message names the field.
        """
        campaign = self.campaign
        if not isinstance(campaign, (str, os.PathLike)):
            raise RecordError(f"Job.campaign is a path as str or pathlib.Path, not {campaign!r}")
        campaign = os.fspath(campaign)
        if not isinstance(campaign, str) or not campaign:
            raise RecordError(f"Job.campaign is a path as str or pathlib.Path, not {campaign!r}")
        words = {name: _word(name, getattr(self, name), campaign) for name in ("serial", "batch")}
        date: object = self.date
        if date is None or date != date:  # pandas has NaN or NaT for a missing date
            date = ""
        if isinstance(date, datetime.date):
            date = date.isoformat()
        if not isinstance(date, str):
            raise RecordError(f"Job.date of {campaign} is {date!r}; write it as 2026-11-23 or 2026-11-23T14:05, or give a datetime.date")
        try:
            return replace(self, campaign=campaign, date=iso(date), **words)
        except ValueError:
            raise RecordError(f"Job.date of {campaign}: {date!r} is no date; write it as 2026-11-23 or 2026-11-23T14:05") from None


def _word(name: str, value: object, campaign: str) -> str:
    if value is None or value != value:
        return ""
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise RecordError(f"Job.{name} of {campaign} is {value!r}; it is text or a whole number")
    return str(value)


def iso(date: str) -> str:
    """Converts a date to ISO format. A final Z is replaced, because Python 3.10 cannot parse it. An empty text stays empty.

    :raises ValueError: if the text is no date.
    """
    date = date.strip()
    if date.endswith(("Z", "z")):
        date = date[:-1] + "+00:00"
    return datetime.datetime.fromisoformat(date).isoformat() if date else ""


def find_jobs(paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]]) -> list[Job]:
    """Returns the campaigns of the paths, in their order and without duplicates.

    A folder with records is a campaign. A folder of such folders gives all of them. A CSV file with the column ``campaign`` is a list. Its paths
    are relative to its own folder, and it may have the columns serial, batch and date. If a campaign is in a list and is also given as a folder,
    the entry of the list applies.

    :raises RecordError: if a path does not exist, a list is invalid, or lists contradict each other on a campaign. A missing campaign of a list
        is no error, but becomes a row with the reason.
    """
    found: dict[str, tuple[Job, str]] = {}
    for given in [paths] if isinstance(paths, (str, os.PathLike)) else paths:
        path = Path(given)
        if not path.exists():
            raise RecordError(f"{path}: there is no such file or folder")
        for job, said in _listed(path) if _is_list(path) else _folder(path):
            place = os.path.abspath(job.campaign)
            before, there = found.get(place, (job, ""))
            if said and there and (said.split(", line")[0] == there.split(", line")[0] or replace(before, campaign=job.campaign) != job):
                raise RecordError(f"{said}: the campaign {job.campaign} is listed already ({there}); a campaign is one damper and one row")
            if place not in found or (said and not there):
                found[place] = job, said
    if not found:
        raise RecordError("there is no campaign: give folders with records, a folder of such folders, or a list (CSV)")
    return [job for job, _ in found.values()]


def _is_list(path: Path) -> bool:
    if path.suffix.lower() != ".csv" or path.is_dir():
        return False
    heading = heading_of(text_of(path))
    return "campaign" in [c.lower() for _, row in rows_of(heading, delimiter_of(heading), path) for c in row]


def _listed(path: Path) -> list[tuple[Job, str]]:
    """Returns the campaigns of a list, each with the file and line of its entry."""
    text = text_of(path)
    rows = rows_of(text, delimiter_of(heading_of(text)), path)
    first, head = next(rows)
    # Headings and error messages follow those of a table of limits (src/identification/src/limits/table.rs).
    head = [c.lower().replace(" ", "_").replace("-", "_") for c in head]
    unknown = [c for c in head if c not in COLUMNS]
    if unknown:
        raise RecordError(f"{path}, line {first}: there is no column {unknown[0]!r} in a list of campaigns; the columns are {', '.join(COLUMNS)}")
    twice = [c for c in head if head.count(c) > 1]
    if twice:
        raise RecordError(f"{path}, line {first}: the column {twice[0]!r} stands there twice")
    jobs = []
    for line, row in rows:
        at = f"{path}, line {line}"
        if len(row) != len(head):
            raise RecordError(f"{at}: has {len(row)} fields where the header has {len(head)}")
        said = dict(zip(head, row, strict=True))
        if not said["campaign"]:
            raise RecordError(f"{at}: the cell of the campaign is empty")
        try:
            said["date"] = iso(said.get("date", ""))
        except ValueError:
            raise RecordError(f"{at}: {said['date']!r} is no date; write it as 2026-11-23 or 2026-11-23T14:05") from None
        said["campaign"] = os.path.join(path.parent, said["campaign"])
        jobs.append((Job(**said), at))
    return jobs


def _folder(path: Path) -> list[tuple[Job, str]]:
    if not path.is_dir() or is_campaign(path):
        return [(Job(str(path), path.stem if path.is_file() else path.name), "")]
    return [(Job(str(p), p.name), "") for p in folders_in(path)]
