"""Explanation of a model by physical quantities of the damper's gas, oil and valves. SI units, unless a quantity states its unit."""

from __future__ import annotations

import os
from dataclasses import dataclass, field, replace

from . import _native
from ._arguments import loads
from ._files import needs
from ._result import Result, Row, folded, table
from ._numbers import real
from .campaign import Path
from .family import Family
from .model import Model


@dataclass(frozen=True, repr=False)
class Quantity(Result):
    """A quantity of the damper with its 95 % interval, in ``unit``."""

    name: str
    value: float | None
    """Value; None if one end of the interval is open."""
    low: float | None
    """Lower end of the interval; None if it is open."""
    high: float | None
    """Upper end of the interval; None if it is open."""
    unit: str
    #: Parameters of the model and entries of the dimensions from which the quantity is computed.
    sources: tuple[str, ...] = field(metadata={"key": "from"})
    model_error: float
    """Factor that covers the error of the model's form in 95 of 100 dampers. The interval includes it."""
    note: str | None = field(default=None, metadata={"omitted": True})


@dataclass(frozen=True, repr=False)
class Gap(Result):
    """A quantity that cannot be computed from the model and the dimensions."""

    name: str
    why: str
    entries: tuple[str, ...]
    """Missing entries of the dimensions."""
    parameters: tuple[str, ...]
    """Missing parameters of the model."""


@dataclass(frozen=True, repr=False)
class Cause(Result):
    """An entry of the drawing that, with another value, would explain a contradiction."""

    entry: str
    value: float
    """Value that explains the contradiction, in the unit of the drawing."""
    tolerances: float
    """Ratio of the logarithmic change of the entry to its tolerance."""


@dataclass(frozen=True, repr=False)
class Contradiction(Result):
    """A parameter of the model whose value contradicts the dimensions."""

    parameter: str
    model: float
    dimensions: float
    ratio: float
    """Ratio of ``model`` to ``dimensions``."""
    unit: str
    text: str
    entries: tuple[str, ...] = ()
    """Entries of the drawing from which ``dimensions`` was computed. At least one of them, or the model, is wrong."""
    causes: tuple[Cause, ...] = ()
    """Entries that would explain the contradiction if only that entry had another value, the smallest change first."""


@dataclass(frozen=True, repr=False)
class Explanation(Result):
    """Physical quantities of the damper of a model; the JSON of ``dashpot explain`` without the names of the two files."""

    quantities: tuple[Quantity, ...]
    unknown: tuple[Gap, ...]
    contradictions: tuple[Contradiction, ...]
    lines: tuple[str, ...] = field(default=(), metadata={"hidden": True}, compare=False)
    """Output lines of the command."""

    def __getitem__(self, name: str) -> Quantity:
        """Returns the quantity with a name, such as ``"gas_pressure"``.

        :raises KeyError: if there is no such quantity. :attr:`unknown` may contain the reason.
        """
        for quantity in self.quantities:
            if quantity.name == name:
                return quantity
        raise KeyError(f"there is no quantity {name!r}; there are {', '.join(q.name for q in self.quantities) or 'none'}")

    def _rows(self) -> list[Row]:
        return [quantity.to_dict() for quantity in self.quantities]

    def _repr_html_(self) -> str:
        said = [f"Contradiction: {found.text}" for found in self.contradictions]
        return table("Explained by its dimensions", self._rows(), said) + folded({"unknown": [gap.to_dict() for gap in self.unknown]})


def explain(model: Model | Family, dimensions: Path, *, setting: float | None = None) -> Explanation:
    """Computes physical quantities from a model and the dimensions of its damper, like ``dashpot explain``.

    The quantities are, for example, gas pressure, air, moduli and passages of the valves.

    :param setting: setting at which a :class:`Family` is explained.
    :param dimensions: path of a TOML file with the dimensions and a unit in every key, like the command's ``--dimensions``.
    :raises DimensionsError: if the dimensions are unusable. The message names file, line and key.
    :raises FileNotFoundError: if the file does not exist. The exception is also a :class:`DimensionsError`.
    """
    if isinstance(model, Family):
        if setting is None:
            raise TypeError("a damper over a setting is explained at one: give setting")
        real("setting", setting)
        if not model.grid[0] <= setting <= model.grid[-1]:
            raise ValueError(f"the setting {setting:g} lies outside those of the model, {model.grid[0]:g} to {model.grid[-1]:g}")
        with needs(dimensions):
            said, lines = _native.explain_family(model._native, os.fspath(dimensions), setting)
        return replace(Explanation.from_dict(loads(said)), lines=tuple(lines))
    if not isinstance(model, Model):
        raise TypeError(f"model is a dashpot.Model or a dashpot.Family, not a {type(model).__name__}")
    if setting is not None:
        raise TypeError("setting is that of a damper that depends on one; this model depends on none")
    with needs(dimensions):
        said, lines = _native.explain(model._native, os.fspath(dimensions))
    return replace(Explanation.from_dict(loads(said)), lines=tuple(lines))
