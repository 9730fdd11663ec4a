"""Identification of models of the literature, for comparison. SI units; extension (rebound) velocity and tension force are positive."""

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

    No host can run the model. :meth:`write` makes a file for ``model.validate(campaign, against=...)`` and ``dashpot validate --against``.
    """

    tests: tuple[str, ...]
    """Names of the tests from which the model was identified."""
    numbers: dict[str, Any]
    """Parameters of the model, with units in their names. The entry ``literature_model`` is the name of the model."""
    sign: SignFinding
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    _text: str | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    @property
    def name(self) -> str:
        """Name of the model, as in the argument of :func:`dashpot.fit_literature`."""
        return str(self.numbers["literature_model"]).replace("_", "-")

    @property
    def text(self) -> str:
        """Text of the model's file. Its format differs from that of dashpot's model files.

        :raises ValueError: if this result was made from a dictionary.
        """
        if self._text is None:
            raise figures_alone("dashpot.fit_literature", "was made from a dictionary; fit again")
        return self._text

    def write(self, path: Path, *, force: bool = False) -> None:
        """Writes the model's file atomically. Its bytes are those of ``dashpot fit --model``.

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
    """Identifies a model of the literature from records, for comparison, like ``dashpot fit --model``.

    :param campaign: a :class:`Campaign`, or some of its records.
    :param name: ``"surface"``, ``"dahl"``, ``"bouc-wen"``, ``"spencer"``, ``"kwok"`` or ``"network"``. :func:`fit` identifies the models that
        a host can run (``"fv"``, ``"piecewise"``, ``"lag"``) by its argument ``family``.
    :param hold_out: names of tests to leave out; ``*`` matches any text.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :raises FitError: if the name is unknown, or the model cannot be fitted to the records.
    """
    with watched(progress) as told:
        text, said = _native.fit_literature(native_of(campaign, "campaign"), name, words(hold_out), told)
    return replace(LiteratureModel.from_dict(loads(said)), _text=text)
