"""Models of the literature, to be compared with. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from . import _native
from ._arguments import loads
from ._numbers import words
from ._files import write_new
from ._papers import figures_alone
from ._result import Result
from ._work import watched
from .campaign import Path, Progress, Record, native_of
from .reading import SignFinding, Unusable


@dataclass(frozen=True, repr=False)
class LiteratureModel(Result):
    """A model of the literature, identified from records; the JSON of ``dashpot fit --model`` without the file name.

    No host runs it: :meth:`write` makes the file that ``model.validate(campaign, against=...)`` and ``dashpot validate --against`` compare with.
    """

    tests: tuple[str, ...]
    """Names of the tests that it was identified from."""
    numbers: dict[str, Any]
    """Its numbers, with their units in their names; ``literature_model`` says which model it is."""
    sign: SignFinding
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    _text: str | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    @property
    def name(self) -> str:
        """Its name, as :func:`dashpot.fit_literature` takes it."""
        return str(self.numbers["literature_model"]).replace("_", "-")

    @property
    def text(self) -> str:
        """Its file, which is no model file of dashpot.

        :raises ValueError: if this result was made from a dictionary.
        """
        if self._text is None:
            raise figures_alone("dashpot.fit_literature", "was made from a dictionary; fit again")
        return self._text

    def write(self, path: Path, *, force: bool = False) -> None:
        """Writes its file, whole or not at all, to the bytes of ``dashpot fit --model``.

        :param force: replaces an existing file, even one of another kind or a write-protected file.
        :raises OutputError: if the file cannot be written.
        :raises FileExistsError: if another file exists and ``force`` is not given. The exception is also an :class:`OutputError`.
        :raises ValueError: if this result was made from a dictionary.
        """
        write_new(path, self.text, force)

    def _title(self) -> str:
        return f"{self.name}, identified from {len(self.tests)} tests"


def fit_literature(
    campaign: Sequence[Record], name: str, *, hold_out: Sequence[str] = (), progress: Progress | None = None
) -> LiteratureModel:
    """Identifies a model of the literature from records, to compare with; as ``dashpot fit --model``.

    :param campaign: a :class:`Campaign`, or some of its records.
    :param name: ``"surface"``, ``"dahl"``, ``"bouc-wen"``, ``"spencer"``, ``"kwok"`` or ``"network"``. Those that a host can run (``"fv"``,
        ``"piecewise"``, ``"lag"``) are families of :func:`fit`.
    :param hold_out: names of tests to leave out; ``*`` matches any text.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :raises FitError: where there is no such model, or none can be fitted to these records.
    """
    with watched(progress) as told:
        text, said = _native.fit_literature(native_of(campaign, "campaign"), name, words(hold_out), told)
    return replace(LiteratureModel.from_dict(loads(said)), _text=text)
