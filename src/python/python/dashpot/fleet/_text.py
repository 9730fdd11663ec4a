"""Reading of tables that spreadsheets write, with separators other than the comma and encodings other than UTF-8."""

from __future__ import annotations

import codecs
import csv
import io
from collections.abc import Iterator
from pathlib import Path

from .._native import DashpotError


def text_of(path: Path) -> str:
    """Reads the text of a file. The encoding is UTF-16 with a byte order mark, UTF-8, or otherwise the Windows code page 1252."""
    data = path.read_bytes()
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", errors="replace")


def delimiter_of(heading: str) -> str:
    """Returns the most frequent separator of a heading, or a comma without any separator."""
    return max(",;\t|", key=heading.count)


def rows_of(text: str, delimiter: str, at: Path) -> Iterator[tuple[int, list[str]]]:
    """Yields the line number and the trimmed cells of each row. Empty rows, and rows that begin with #, are skipped."""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, skipinitialspace=True)
    try:
        for row in reader:
            cells = [cell.strip() for cell in row]
            if any(cells) and not cells[0].startswith("#"):
                yield reader.line_num, cells
    except csv.Error as error:
        raise DashpotError(f"{at}, line {reader.line_num}: {error}") from error


def heading_of(text: str) -> str:
    """Returns the first line that is neither empty nor a comment."""
    return next((line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")), "")
