"""Results of the diagnosis of many dampers, or of one damper at many settings, in comparison with a reference.

SI units; extension (rebound) velocity and tension force are positive.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _native
from ._papers import Origin, Tables, figures_alone, page
from ._result import Result, Row, folded, table
from ._work import watched
from .diagnosis import Findings
from .reading import Note, Unusable

if TYPE_CHECKING:
    import datetime
    import pathlib

    from .campaign import Path
    from .model import Model


@dataclass(frozen=True, repr=False)
class Group(Result):
    """Result for one group of tests: one damper or one setting."""

    group: str
    """Name of the group: name of its folder, text that a pattern matched in the names of its tests, or entry in a column of a list."""
    reference: str
    """Name of the reference. In a chain, it is the preceding group."""
    tests: int
    """Number of tests."""
    diagnosis: Findings
    """Changes against the reference."""


@dataclass(frozen=True, repr=False)
class GroupsDiagnosis(Tables, Result):
    """Changes of many dampers or settings against a reference; the JSON of ``dashpot diagnose --group``.

    ``found["17"]`` is the result for the group "17". ``list(found)`` gives the names of the groups, in the order of :attr:`groups`.
    """

    reference: str
    """Name of the reference. In a chain, it is the reference of the first compared group only."""
    left_aside: tuple[str, ...]
    """Tests, or folders, that belong to no group."""
    without_test: tuple[str, ...] = field(default=(), metadata={"omitted": True})
    """Lines of the list of groups that name none of the tests."""
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used, including those of the reference."""
    as_the_fit_saw: str | None = field(default=None, metadata={"omitted": True})
    """Note on the measurement errors that the model's fit found in its own records, and on whether the records of this result were corrected."""
    groups: tuple[Group, ...] = ()
    """All groups except the reference, in the order of their names. If all names are numbers, in numerical order."""
    notes: tuple[Note, ...] = field(default=(), metadata={"hidden": True}, compare=False, repr=False)
    """Notes on the campaigns that were read; empty in a result made from a dictionary."""
    _made_from: tuple[_native.Grouped, Model, Origin] | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    def __getitem__(self, name: str) -> Findings:
        """Returns the changes of a group by its name."""
        for one in self.groups:
            if one.group == name:
                return one.diagnosis
        raise KeyError(f"there is no group {name!r} beside the reference {self.reference!r}; there are {', '.join(map(repr, self))}")

    def __iter__(self) -> Iterator[str]:
        return iter([one.group for one in self.groups])

    def __len__(self) -> int:
        return len(self.groups)

    def write_report(self, path: Path, *, language: str = "en", date: str | datetime.date | None = None, force: bool = False) -> None:
        """Writes the report on all groups as one HTML file without external resources. Its bytes are those of ``dashpot diagnose --group --report``.

        Nothing is fitted again. The records are read once more, because the report contains their hashes. The report names the command that
        makes the same report if there is one. That requires paths or all records of a campaign, and a model that was read from a file or written.

        :param language: language of the report: ``"en"``, ``"de"``, ``"fr"`` or ``"zh"``.
        :param date: date in the report. By default it is the date of ``SOURCE_DATE_EPOCH``, or none, so that equal input gives an equal report.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: if the language is unknown, or if this result was pickled or made from a dictionary. In the latter case, diagnose again.
        """
        self._write("report", path, language, date, force)

    def _write(self, what: str, path: Path, language: str, date: str | datetime.date | None, force: bool) -> list[pathlib.Path]:
        if self._made_from is None:
            raise figures_alone("dashpot.diagnose_groups", "was pickled or made from a dictionary; diagnose again")
        found, model, origin = self._made_from
        how = page("diagnose", origin, model, language=language, date=date, force=force)
        with watched():
            _native.write_groups(what, os.fspath(path), how, found)
        return []

    def __getstate__(self) -> dict[str, Any]:
        # The extension module's data of the diagnoses cannot be pickled.
        return {**self.__dict__, "_made_from": None}

    def _title(self) -> str:
        return f"Compared with {self.reference}"

    def _rows(self) -> list[Row]:
        """Returns one row for each effect of each group, and one row for a group without effects."""
        rows: list[Row] = []
        for one in self.groups:
            found = one.diagnosis
            of_it: Row = {"group": one.group, "tests": one.tests, "verdict": found.verdict}
            errors: Row = {"before_rmse_n": found.before.rmse_n, "after_rmse_n": found.after.rmse_n, "noise_n": found.before.noise_n}
            for effect in found.findings or (None,):
                named: Row = {name: None if effect is None else getattr(effect, name) for name in ("effect", "form", "confidence", "fraction")}
                rows.append({**of_it, **named, **errors, "summary": found.summary})
        return rows

    def _repr_html_(self) -> str:
        said = [self.as_the_fit_saw] if self.as_the_fit_saw else []
        for text, names in (("belong to no group", self.left_aside), ("are in the list and not in the data", self.without_test)):
            said += [f"{', '.join(names)} {text}"] if names else []
        said += [*(n.text for n in self.notes), *(u.why for u in self.unusable)]
        shown = table(self._title(), self._rows(), said)
        return shown + folded({name or "figures": rows for name, rows in self._tables().items()})
