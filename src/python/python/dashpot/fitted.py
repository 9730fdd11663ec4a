"""Results of a fit. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import _native
from ._papers import Origin, figures_alone, page
from ._result import Result, Row, folded, table
from ._work import watched
from .reading import SignFinding, Unusable
from .validation import Deviation

if TYPE_CHECKING:
    import datetime

    from .campaign import Path


@dataclass(frozen=True, repr=False)
class Estimate(Result):
    """Estimate of one number of the model, with its 95 % interval."""

    name: str
    index: int | None
    value: float
    low: float | None
    high: float | None
    unit: str
    source: str = field(metadata={"key": "from"})
    standing: str = "identified"


@dataclass(frozen=True, repr=False)
class InventoryItem(Result):
    """One effect of a model, with its force and its probability."""

    effect: str
    form: str
    force_n_rms: float
    """Rms change of the model's force over the fitted tests if only this effect is removed, N."""
    share: float
    """Ratio of ``force_n_rms`` to the root mean square of the measured force."""
    probability: float
    status: str
    """``kept``, ``added``, ``replaced`` or ``removed``. It is always ``added`` in a fit, because a fit begins without a model."""
    replaces: str | None = field(default=None, metadata={"omitted": True})
    """Effect of the given model that this effect replaces; None if it replaces none."""


@dataclass(frozen=True, repr=False)
class Measured(Result):
    """Measurement error of the records. The comparison corrects it, and the model does not contain it."""

    name: str
    value: float
    low: float
    high: float
    unit: str
    option: str | None = None


def _described(item: InventoryItem) -> str:
    form = f" ({item.form})" if item.form else ""
    return f"{item.effect}{form}: {item.force_n_rms:.4g} N rms, {item.share:.0%} of the force, probability {item.probability:.0%}"


@dataclass(frozen=True, repr=False)
class FitResult(Result):
    """Result of a fit; the JSON of ``dashpot fit`` without the file name."""

    tests: tuple[str, ...]
    parameters: tuple[Estimate, ...]
    inventory: tuple[InventoryItem, ...]
    measured: tuple[Measured, ...]
    notes: tuple[str, ...]
    misfit: float
    over_whole_records: Deviation
    """Errors over all samples of the fitted tests, computed as in a validation, after correction of the errors ``measured``."""
    sign: SignFinding
    unusable: tuple[Unusable, ...] = ()
    """Files and tests that could not be used."""
    _made_from: tuple[_native.Fitted, Origin] | None = field(default=None, metadata={"hidden": True}, compare=False, repr=False)

    def write_excel(
        self, path: Path, *, model: str = "damper.toml", language: str = "en", date: str | datetime.date | None = None, force: bool = False
    ) -> None:
        """Writes every table of the fit as a sheet of one Excel workbook. Its bytes are those of ``dashpot fit --excel``.

        Nothing is fitted again. The files of records are read once more, because the workbook contains their hashes. If all records of a
        campaign were fitted, the workbook names the command that gives the same fit.

        :param model: name of the model file, which the workbook mentions.
        :param language: language of the workbook: ``"en"``, ``"de"``, ``"fr"`` or ``"zh"``.
        :param date: date in the workbook. By default it is the date of ``SOURCE_DATE_EPOCH``, or none.
        :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
        :raises OutputError: if the output cannot be written, or would replace another file.
        :raises ValueError: if the language is unknown, or if this result was pickled or made from a dictionary. In the latter case, fit again.
        """
        if self._made_from is None:
            raise figures_alone("dashpot.fit", "was pickled or made from a dictionary; fit again")
        found, origin = self._made_from
        with watched():
            _native.write_fit(os.fspath(path), page("fit", origin, None, language=language, date=date, force=force, name=os.fspath(model)), found)

    def __getstate__(self) -> dict[str, Any]:
        # The extension module's data of the fit cannot be pickled.
        return {**self.__dict__, "_made_from": None}

    def __str__(self) -> str:
        """Returns the text that ``print`` shows: errors, parameters with their 95 % intervals, measurement errors, effects and notes."""
        whole = self.over_whole_records
        lines = [
            "[[Fit]]",
            f"    tests               = {len(self.tests)}",
            f"    mean error          = {whole.mean_error_n:.4g} N ({whole.error_percent:.3g} % of the largest force)",
            f"    rms error           = {whole.rmse_n:.4g} N",
            f"    parameters          = {sum(p.standing == 'identified' for p in self.parameters)} identified of {len(self.parameters)}",
            "[[Parameters]]",
        ]
        names = [p.name if p.index is None else f"{p.name}[{p.index}]" for p in self.parameters]
        wide = max((len(name) for name in names), default=0) + 1
        for name, p in zip(names, self.parameters, strict=True):
            shown = f"    {name + ':':<{wide}} {p.value:>12.6g} {p.unit:<7}"
            if p.low is not None and p.high is not None and p.standing == "identified":
                half = 0.5 * (p.high - p.low)
                percent = f" ({100.0 * half / abs(p.value):.2f} %)" if p.value != 0.0 else ""
                lines.append(f"{shown} +/- {half:.4g}{percent}  [{p.low:.6g}, {p.high:.6g}]")
            else:
                lines.append(f"{shown} ({p.standing}: {p.source})")
        if self.measured:
            lines.append("[[Measurement errors]] (taken out of the records)")
            lines += [f"    {m.name}: {m.value:.4g} {m.unit}  [{m.low:.4g}, {m.high:.4g}]" for m in self.measured]
        if self.inventory:
            lines.append("[[Inventory]]")
            lines += [f"    {_described(item)}" for item in self.inventory]
        said = [*self.notes, *(u.why for u in self.unusable)]
        if said:
            lines.append("[[Notes]]")
            lines += [f"    {note}" for note in said]
        return "\n".join(lines)

    def _rows(self) -> list[Row]:
        return [p.to_dict() for p in self.parameters]

    def _repr_html_(self) -> str:
        said = [_described(item) for item in self.inventory]
        said += [f"{m.name} of the measurement: {m.value:.4g} {m.unit} ({m.low:.4g} to {m.high:.4g})" for m in self.measured]
        said += [*self.notes, *(u.why for u in self.unusable)]
        shown = table(f"Fit to {len(self.tests)} tests", self._rows(), said)
        return shown + folded({name or "figures": rows for name, rows in self._tables().items() if name != "parameters"})
