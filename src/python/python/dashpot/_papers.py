"""What reports, workbooks and certificates say of how they came about, and how they are written: by the compiled part, as the command writes them."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from ._numbers import several
from .campaign import Campaign, Record

if TYPE_CHECKING:
    import pathlib

    from . import _native
    from ._given import Page
    from .campaign import Path


class NamedModel(Protocol):
    """A model as a report names it."""

    _name: str
    _file: str | None
    _native: _native.Model


@dataclass(frozen=True)
class Origin:
    """What a result was made from."""

    data: str
    """Name of the records, as a report calls them."""
    arguments: tuple[str, ...] | None
    """What the command is given behind the verb and the model to make the same of the same records; none where no command does."""
    files: tuple[str, ...] = ()
    """Files read beside the model and the records, such as a table of limits."""


def origin(campaign: Sequence[Record], *more: Sequence[str] | None, files: Sequence[str] = ()) -> Origin:
    """Where a result of these records comes from; none among the further arguments says that no command gives it."""
    if not isinstance(campaign, Campaign) or not campaign.paths:
        # Some tests of a campaign, which a command knows by no name of their own.
        return Origin(several([record.name for record in campaign]), None, tuple(files))
    data = ", ".join(campaign.paths)
    if campaign._reading is None or any(one is None for one in more):
        return Origin(data, None, tuple(files))
    rest = [word for one in more if one is not None for word in one]
    return Origin(data, (*campaign.paths, *campaign._reading.options, *rest), tuple(files))


def option(name: str, values: Sequence[str]) -> list[str]:
    """An option of the command that takes several words separated by commas; nothing where there are none."""
    return [f"--{name}", ",".join(values)] if values else []


def page(
    verb: str, source: Origin, model: NamedModel | None, *, language: str, date: str | datetime.date | None, force: bool, full: bool = False, name: str = ""
) -> Page:
    """How a paper is written, as the compiled part takes it.

    :param model: the model that the verb is given; it has to be a file to be part of a command.
    :param name: what the model is called where none is given.
    :raises TypeError: where a date is no date.
    """
    if not isinstance(language, str):
        raise TypeError(f'language is "en", "de", "fr" or "zh", not a {type(language).__name__}')
    if not (date is None or isinstance(date, (str, datetime.date))):
        raise TypeError(f'date is a text such as "2026-03-11" or a datetime.date, not a {type(date).__name__}')
    command: list[str] = []
    if source.arguments is not None and (model is None or model._file is not None):
        command = ["dashpot", verb, *([] if model is None or model._file is None else [model._file]), *source.arguments]
        command += [] if language == "en" else ["--language", language]
        command += ["--full"] if full else []
    return {
        "language": language,
        "date": date.isoformat() if isinstance(date, datetime.date) else date,
        "full": full,
        "force": bool(force),
        "model": name if model is None else model._name,
        "is_file": model is not None and model._file is not None,
        "data": source.data,
        "command": command,
        "files": list(source.files),
    }


class Tables:
    """What results with a report of tables can write beside it."""

    def write_excel(self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, force: bool = False) -> None:
        """Writes every table of the report as a sheet of one Excel workbook, numbers as numbers; as the command's ``--excel``.

        Parameters and errors as of :meth:`write_report`.
        """
        self._write("workbook", path, language, date, force)

    def _write(self, what: str, path: Path, language: str, date: str | datetime.date | None, force: bool) -> list[pathlib.Path]:
        raise NotImplementedError


class Papers(Tables):
    """The same where the report has figures too."""

    def write_svg(self, folder: Path, *, language: str = "en", force: bool = False) -> list[pathlib.Path]:
        """Writes every figure of the report as an SVG file into a folder, which is made if missing; as the command's ``--svg``.

        Parameters and errors as of :meth:`write_report`.

        :returns: the files, in the order of the report.
        """
        return self._write("figures", folder, language, None, force)


def figures_alone(by: str, lost: str) -> ValueError:
    """The refusal of a result that holds no more than its figures."""
    return ValueError(f"what is written is made from more than these figures, which is kept by {by} alone, not by a result that {lost}")
