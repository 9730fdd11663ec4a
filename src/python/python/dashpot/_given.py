"""What the compiled part is given as dictionaries, in place of many arguments in a row."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypedDict


class Page(TypedDict):
    """How a paper is written, and what it says of what it was made from."""

    language: str
    date: str | None
    full: bool
    force: bool
    model: str
    is_file: bool
    data: str
    command: Sequence[str]
    files: Sequence[str]
