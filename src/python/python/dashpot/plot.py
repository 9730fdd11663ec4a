"""Plots with matplotlib. Requires ``pip install 'dashpot[plot]'``.

Every function draws into the given axes, or into new axes, and returns them. Forces are in N, tension positive. Velocities are in m/s,
extension (rebound) positive.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .campaign import Campaign
from .model import Model
from .diagnosis import Diagnosis
from .validation import Validation

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["campaign", "changed", "curve", "errors", "improvement", "loop"]

#: Colors of measured force, model and FV curve. They are the colors of the command's reports.
MEASURED, MODEL, FV_ONLY = "#111111", "#1f6feb", "#d97706"


def plain(text: str) -> str:
    """Escapes dollar signs, because matplotlib formats text between two dollar signs as a formula."""
    return text.replace("$", r"\$")


def _axes(axes: Axes | None) -> Axes:
    if axes is not None:
        return axes
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("dashpot.plot needs matplotlib: pip install 'dashpot[plot]'") from error
    drawn: Axes = pyplot.subplots(layout="constrained")[1]
    return drawn


def campaign(records: Campaign, axes: Axes | None = None) -> Axes:
    """Plots the force over velocity of every test of a campaign."""
    drawn = _axes(axes)
    for record in records:
        # matplotlib omits labels that begin with an underscore, so an invisible character precedes it.
        label = plain(record.name)
        drawn.plot(record.velocity, record.force, lw=0.6, label=f"\u200b{label}" if label.startswith("_") else label)
    drawn.set(xlabel="velocity, m/s (extension positive)", ylabel="force, N (tension positive)")
    return drawn


def loop(validation: Validation, records: Campaign, test: str, over: str = "velocity", axes: Axes | None = None) -> Axes:
    """Plots measured force, model and FV curve of one test over ``"velocity"``, ``"displacement"`` or ``"time"``."""
    drawn = _axes(axes)
    record = (validation.campaign or records)[test]
    at = getattr(record, over)
    model, fv_only = validation.forces(test)
    drawn.plot(at, record.force, color=MEASURED, lw=1.0, label="measured")
    drawn.plot(at, fv_only, color=FV_ONLY, lw=1.0, ls="--", label="FV curve")
    drawn.plot(at, model, color=MODEL, lw=1.2, label="model")
    units = {"velocity": "m/s", "displacement": "m", "time": "s"}
    drawn.set(xlabel=f"{over}, {units[over]}", ylabel="force, N", title=plain(test))
    drawn.legend()
    return drawn


def curve(model: Model, axes: Axes | None = None, **style: Any) -> Axes:
    """Plots the force in steady motion over the velocity range of the FV curve. The force includes friction and gas force."""
    drawn = _axes(axes)
    low, high = model.velocity_range
    velocity = np.linspace(low, high, 401)
    drawn.plot(velocity, model.steady_force(velocity), **{"color": MODEL, **style})
    drawn.set(xlabel="velocity, m/s (extension positive)", ylabel="force, N (tension positive)")
    return drawn


def errors(validation: Validation, axes: Axes | None = None) -> Axes:
    """Plots the mean error of model and FV curve for every test, in percent of the test's largest force."""
    drawn = _axes(axes)
    tests = sorted(validation.tests, key=lambda t: (-t.amplitude_m, t.peak_velocity_m_s))
    at = np.arange(len(tests))
    drawn.barh(at - 0.2, [t.fv_only.error_percent for t in tests], 0.4, color=FV_ONLY, label="FV curve")
    drawn.barh(at + 0.2, [t.error_percent for t in tests], 0.4, color=MODEL, label="model")
    drawn.set_yticks(at, [plain(t.name if t.used_in_fit else f"{t.name} (left out)") for t in tests], fontsize=7)
    drawn.invert_yaxis()
    drawn.set(xlabel="mean error, % of the largest force")
    drawn.legend()
    return drawn


def improvement(found: Diagnosis, test: str, axes: Axes | None = None) -> Axes:
    """Plots the mean cycle of one test: measured force, force of the given model, and force with the identified effects."""
    drawn = _axes(axes)
    curves = found.curves(test)
    for name, colour in (("measured", MEASURED), ("before", FV_ONLY), ("after", MODEL)):
        drawn.plot(curves["velocity"], curves[name], color=colour, lw=1.0, label=name)
    drawn.set(xlabel="velocity, m/s (extension positive)", ylabel="force, N (tension positive)", title=plain(test))
    drawn.legend()
    return drawn


def changed(found: Diagnosis, axes: Axes | None = None) -> Axes:
    """Plots the ratio of each changed value to the reference damper's value, with its 95 % interval. Values with reference zero are omitted."""
    drawn = _axes(axes)
    rows = [c for c in found.changes if c.reference]
    at = np.arange(len(rows))
    share = np.array([[c.value / c.reference, c.low / c.reference, c.high / c.reference] for c in rows]).reshape(-1, 3)
    share = np.column_stack([share[:, 0], share[:, 1:].min(axis=1, initial=np.inf), share[:, 1:].max(axis=1, initial=-np.inf)])
    spread = np.abs(share[:, 1:].T - share[:, 0])
    drawn.errorbar(share[:, 0], at, xerr=spread, fmt="o", capsize=3, color=MODEL)
    drawn.axvline(1.0, color=MEASURED, lw=0.8)
    drawn.set_yticks(at, [c.label for c in rows])
    drawn.set(xlabel="value over that of the reference")
    return drawn
