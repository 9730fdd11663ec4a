"""Files of a campaign, with their sizes and times of change. The files are those that the reader would open."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from .._native import DashpotError
from ..campaign import Campaign
from ._text import text_of

#: Extensions of record files that the reader reads from a folder (``EXTENSIONS`` in ``src/records/src/file_extensions.rs``).
RECORDS = frozenset(
    f".{e}" for e in ("csv", "txt", "asc", "dat", "tsv", "tra", "lvm", "xlsx", "xlsm", "mat", "mf4", "mdf", "tdms", "rsp", "drv", "tim")
)
#: Extensions of record files that are text, and those of workbooks.
_TEXTS = frozenset(f".{e}" for e in ("csv", "txt", "asc", "dat", "tsv", "tra", "lvm"))
_WORKBOOKS = frozenset((".xlsx", ".xlsm"))
#: Name of the file with the properties of the records in its folder.
PROFILE = "campaign.toml"
#: Largest depth of subfolders in which the reader searches records.
DEEPEST = 4
#: Smallest number of rows of numbers with which a text counts as a record, and number of its characters that are searched for them.
_ROWS, _LOOKED_AT = 5, 65536

#: Name, size in bytes, and time of change in ns of a file. A missing file has size and time -1.
Stamp = tuple[str, int, int]


def stamps(campaign: str | os.PathLike[str], subfolders: bool = False) -> list[Stamp]:
    """Returns the stamps of all files of a campaign: its records and each ``campaign.toml``.

    :param subfolders: includes records in subfolders, even if ``campaign.toml`` does not state this.
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
    """Returns whether the ``campaign.toml`` of a folder states that records in its subfolders belong to the same campaign."""
    return any(re.search(r"^\s*subfolders\s*=\s*true\b", text_of(file), re.MULTILINE) for file in _profiles(folder))


def _entries(folder: Path) -> list[Path]:
    """Returns the entries of a folder, without hidden files and the lock files of spreadsheets. An unreadable folder has none."""
    try:
        return sorted(p for p in folder.iterdir() if not p.name.startswith((".", "~$")))
    except OSError:
        return []


def folders_in(folder: Path) -> list[Path]:
    """Returns the subfolders of a folder."""
    return [p for p in _entries(folder) if p.is_dir()]


def _records(folder: Path, deep: int) -> Iterator[Path]:
    """Yields the files with the extension of a record in a folder and its subfolders down to depth ``deep``.

    Also yields each ``campaign.toml`` in the subfolders.
    """
    for entry in _entries(folder):
        if entry.is_dir():
            if deep > 0:
                yield from _records(entry, deep - 1)
                yield from _profiles(entry)
        elif entry.suffix.lower() in RECORDS:
            yield entry


def is_campaign(folder: Path) -> bool:
    """Returns whether a folder is one campaign, and not a folder of campaigns.

    A folder with records of its own is a campaign. If its subfolders also contain records, a list or notes in the folder do not count as records.
    """
    if has_subfolders(folder):
        return True
    own = list(_records(folder, 0))
    if not own or not any(True for inside in folders_in(folder) for _ in _records(inside, DEEPEST - 1)):
        return bool(own)
    return any(_is_record(file) for file in own)


def _is_record(file: Path) -> bool:
    """Returns whether the content of a file with the extension of a record may be a record."""
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
    """Returns whether a line contains two or more numbers and nothing else."""
    cells = [cell for cell in re.split(r"[;\t|,\s]+", line.strip()) if cell]
    try:
        return len([float(cell) for cell in cells]) > 1
    except ValueError:
        return False
