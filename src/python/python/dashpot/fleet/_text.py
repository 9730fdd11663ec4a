"""Tables as spreadsheets write them: other separators than the comma, other encodings than UTF-8."""

from __future__ import annotations

import codecs
import csv
import io
from collections.abc import Iterator
from pathlib import Path

from .._native import DashpotError


def text_of(path: Path) -> str:
    """The text of a file; where it is no UTF-8 it is what a spreadsheet saves, UTF-16 with a mark or the Windows code page."""
    data = path.read_bytes()
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", errors="replace")


def delimiter_of(heading: str) -> str:
    """The separator that makes most columns of a heading; a comma where none is there."""
    return max(",;\t|", key=heading.count)


def rows_of(text: str, delimiter: str, at: Path) -> Iterator[tuple[int, list[str]]]:
    """Rows with the number of their line, cells trimmed; empty ones and those that begin with # are left out."""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, skipinitialspace=True)
    try:
        for row in reader:
            cells = [cell.strip() for cell in row]
            if any(cells) and not cells[0].startswith("#"):
                yield reader.line_num, cells
    except csv.Error as error:
        raise DashpotError(f"{at}, line {reader.line_num}: {error}") from error


def heading_of(text: str) -> str:
    """The first line that says something."""
    return next((line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")), "")
