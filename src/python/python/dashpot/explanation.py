"""What a model says of gas, oil and valves of its damper. SI units but for those that a quantity states itself."""

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
    """None where one end of the interval is open."""
    low: float | None
    """Lower end of the interval; None where it has none."""
    high: float | None
    """Upper end of the interval; None where it has none."""
    unit: str
    #: Parameters of the model and entries of the dimensions that it follows from.
    sources: tuple[str, ...] = field(metadata={"key": "from"})
    model_error: float
    """Factor of the error of the model's form in 95 of 100 dampers; the interval includes it."""
    note: str | None = field(default=None, metadata={"omitted": True})


@dataclass(frozen=True, repr=False)
class Gap(Result):
    """A quantity that model and dimensions do not give."""

    name: str
    why: str
    entries: tuple[str, ...]
    """Entries of the dimensions that are missing."""
    parameters: tuple[str, ...]
    """Parameters of the model that are missing."""


@dataclass(frozen=True, repr=False)
class Contradiction(Result):
    """A number of the model that the dimensions contradict."""

    parameter: str
    model: float
    dimensions: float
    ratio: float
    """``model`` over ``dimensions``."""
    unit: str
    text: str


@dataclass(frozen=True, repr=False)
class Explanation(Result):
    """What a model says of its damper; the JSON of ``dashpot explain`` without the names of the two files."""

    quantities: tuple[Quantity, ...]
    unknown: tuple[Gap, ...]
    contradictions: tuple[Contradiction, ...]
    lines: tuple[str, ...] = field(default=(), metadata={"hidden": True}, compare=False)
    """What the command prints."""

    def __getitem__(self, name: str) -> Quantity:
        """The quantity of a name, such as ``"gas_pressure"``.

        :raises KeyError: where the model does not give it; :attr:`unknown` may say why.
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
    """Explains a model by the dimensions of its damper: gas pressure, air, moduli, passages of the valves; as ``dashpot explain``.

    :param setting: setting at which a :class:`Family` is explained.
    :param dimensions: path of a TOML file with the unit in every key; the command's ``--dimensions``.
    :raises DimensionsError: naming file, line and key, where the dimensions cannot be used.
    :raises FileNotFoundError: the same error, where there is no such file.
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
