"""Origin of reports, workbooks and certificates. The extension module writes them with the code of the command."""

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
    """A model with the name and the file that a report mentions."""

    _name: str
    _file: str | None
    _native: _native.Model


@dataclass(frozen=True)
class Origin:
    """The input from which a result was computed."""

    data: str
    """Name of the records, as a report calls them."""
    arguments: tuple[str, ...] | None
    """Arguments of the command, after verb and model, that give the same result; None if no command does."""
    files: tuple[str, ...] = ()
    """Further input files, in addition to the model and the records, such as a table of limits."""


def origin(campaign: Sequence[Record], *more: Sequence[str] | None, files: Sequence[str] = ()) -> Origin:
    """Returns the origin of a result of these records. ``more`` has further arguments of the command, or None if no command gives the result."""
    if not isinstance(campaign, Campaign) or not campaign.paths:
        # Part of a campaign has no path of its own, so no command reads it.
        return Origin(several([record.name for record in campaign]), None, tuple(files))
    data = ", ".join(campaign.paths)
    if campaign._reading is None or any(one is None for one in more):
        return Origin(data, None, tuple(files))
    rest = [word for one in more if one is not None for word in one]
    return Origin(data, (*campaign.paths, *campaign._reading.options, *rest), tuple(files))


def option(name: str, values: Sequence[str]) -> list[str]:
    """Returns an option of the command with comma-separated values, or an empty list without values."""
    return [f"--{name}", ",".join(values)] if values else []


def page(
    verb: str, source: Origin, model: NamedModel | None, *, language: str, date: str | datetime.date | None, force: bool, full: bool = False, name: str = ""
) -> Page:
    """Builds the settings of a report, workbook or certificate for the extension module.

    :param model: model argument of the verb. The page names a command only if this model has a file.
    :param name: name of the model if ``model`` is None.
    :raises TypeError: if ``language`` is no text, or ``date`` is neither a text nor a date.
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
    """Base of results whose report contains tables. It writes these tables as a workbook."""

    def write_excel(self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, force: bool = False) -> None:
        """Writes every table of the report as a sheet of one Excel workbook, like the command's ``--excel``. Numbers are numeric cells.

        Parameters and errors are those of :meth:`write_report`.
        """
        self._write("workbook", path, language, date, force)

    def _write(self, what: str, path: Path, language: str, date: str | datetime.date | None, force: bool) -> list[pathlib.Path]:
        raise NotImplementedError


class Papers(Tables):
    """Base of results whose report contains tables and figures. It writes the tables as a workbook and the figures as SVG files."""

    def write_svg(self, folder: Path, *, language: str = "en", force: bool = False) -> list[pathlib.Path]:
        """Writes every figure of the report as an SVG file into a folder, like the command's ``--svg``. A missing folder is created.

        Parameters and errors are those of :meth:`write_report`.

        :returns: paths of the files, in the order of the report.
        """
        return self._write("figures", folder, language, None, force)


def figures_alone(by: str, lost: str) -> ValueError:
    """Makes the error of a result that cannot write a report because it contains only its numbers.

    :param by: function whose results can write reports.
    :param lost: how this result lost the data of its report.
    """
    return ValueError(f"what is written is made from more than these figures, which is kept by {by} alone, not by a result that {lost}")
