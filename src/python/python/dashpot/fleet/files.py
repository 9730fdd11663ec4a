"""Which files a campaign is made of, and when they changed: what the reader looks at, without reading it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from .._native import DashpotError
from ..campaign import Campaign
from ._text import text_of

#: Endings of record files: those that the reader takes out of a folder (``EXTENSIONS`` in ``src/records/src/file_extensions.rs``).
RECORDS = frozenset(
    f".{e}" for e in ("csv", "txt", "asc", "dat", "tsv", "tra", "lvm", "xlsx", "xlsm", "mat", "mf4", "mdf", "tdms", "rsp", "drv", "tim")
)
#: Of these the ones that are text, and those of workbooks.
_TEXTS = frozenset(f".{e}" for e in ("csv", "txt", "asc", "dat", "tsv", "tra", "lvm"))
_WORKBOOKS = frozenset((".xlsx", ".xlsm"))
#: What is known about the records of a folder.
PROFILE = "campaign.toml"
#: How many folders deep the reader looks for records.
DEEPEST = 4
#: Rows of numbers from which a text is taken for a record, and characters of it that are looked at.
_ROWS, _LOOKED_AT = 5, 65536

#: Name, size and time of change of a file.
Stamp = tuple[str, int, int]


def stamps(campaign: str | os.PathLike[str], subfolders: bool = False) -> list[Stamp]:
    """The files that decide what a campaign is: its records, and what ``campaign.toml`` beside them says.

    :param subfolders: whether records in subfolders are read whatever ``campaign.toml`` says.
    """
    path = Path(campaign)
    if path.is_dir():
        files = sorted([*_records(path, DEEPEST if subfolders or has_subfolders(path) else 0), *_profiles(path)])
        return [_stamp(file, file.relative_to(path).as_posix()) for file in files]
    return [_stamp(path, path.name), *(_stamp(file, file.name) for file in _profiles(path.parent))]


def _stamp(file: Path, name: str) -> Stamp:
    try:
        stat = file.stat()
    except OSError:
        return name, -1, -1
    return name, stat.st_size, stat.st_mtime_ns


def _profiles(folder: Path) -> list[Path]:
    file = folder / PROFILE
    return [file] if file.is_file() else []


def has_subfolders(folder: Path) -> bool:
    """Whether the records in the subfolders of a folder are of the same campaign, as its ``campaign.toml`` says."""
    return any(re.search(r"^\s*subfolders\s*=\s*true\b", text_of(file), re.MULTILINE) for file in _profiles(folder))


def _entries(folder: Path) -> list[Path]:
    """What lies in a folder, but for hidden files and the lock files of a spreadsheet."""
    try:
        return sorted(p for p in folder.iterdir() if not p.name.startswith((".", "~$")))
    except OSError:
        return []


def folders_in(folder: Path) -> list[Path]:
    """The folders in a folder."""
    return [p for p in _entries(folder) if p.is_dir()]


def _records(folder: Path, deep: int) -> Iterator[Path]:
    """Files with the name of a record in a folder, and so many folders deep; with what the profiles there say."""
    for entry in _entries(folder):
        if entry.is_dir():
            if deep > 0:
                yield from _records(entry, deep - 1)
                yield from _profiles(entry)
        elif entry.suffix.lower() in RECORDS:
            yield entry


def is_campaign(folder: Path) -> bool:
    """Whether a folder is one campaign, and not a folder of campaigns.

    Its own records make it one. Where folders with records lie in it, a list or notes beside them do not.
    """
    if has_subfolders(folder):
        return True
    own = list(_records(folder, 0))
    if not own or not any(True for inside in folders_in(folder) for _ in _records(inside, DEEPEST - 1)):
        return bool(own)
    return any(_is_record(file) for file in own)


def _is_record(file: Path) -> bool:
    """Whether a file with the name of a record may be one, by what is in it."""
    ending = file.suffix.lower()
    if ending in _TEXTS:
        try:
            lines = text_of(file)[:_LOOKED_AT].splitlines()
        except OSError:
            return True
        return sum(_is_row(line) for line in lines) >= _ROWS
    if ending in _WORKBOOKS:
        try:
            Campaign.read(file)
        except DashpotError:
            return False
    return True


def _is_row(line: str) -> bool:
    """Whether a line is two numbers or more and nothing else."""
    cells = [cell for cell in re.split(r"[;\t|,\s]+", line.strip()) if cell]
    try:
        return len([float(cell) for cell in cells]) > 1
    except ValueError:
        return False
