"""Report of a fleet as one HTML file: distributions, drift, batches, outliers and control charts."""

from __future__ import annotations

import base64
import datetime
import html
import io
import os
import re
import tempfile
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq

from .._native import DashpotError, OutputError
from ..plot import plain
from .examine import VELOCITIES, force_column, in_two_directions
from .settings import label
from .statistics import OUTLIER, Control, Numbers, Places, batches, control, drift, far_off, spread

#: Largest number of dampers in the table of outliers, which begins with the worst. The Parquet file contains all dampers.
OUTLIERS = 100
#: Beginning of the description of an untested limit (:func:`dashpot.certificate.missed`).
_UNTESTED = "not tested"
#: Largest number of failed campaigns that the report lists with their reasons.
REASONS = 20
#: Pattern of the tag in the head of every page that dashpot writes.
_GENERATED = re.compile(r'<meta name="?generator"? content="?dashpot')
_HEAD = """<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="generator" content="dashpot">
<title>Fleet of dampers</title><style>
body{font:15px/1.45 system-ui,sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#1b1f24}
table{border-collapse:collapse;margin:.6em 0}td,th{padding:2px 10px;border-bottom:1px solid #d8dee4;text-align:right}
td:first-child,th:first-child{text-align:left}.t{text-align:left}img{max-width:100%}.warn{color:#9a3412}
.scroll{max-height:36em;overflow:auto}@media print{.scroll{max-height:none;overflow:visible}body{margin:0;max-width:none}td,th{font-size:8pt;padding:2px 5px;overflow-wrap:break-word}}
</style></head><body>"""


@dataclass(frozen=True)
class Quantity:
    """Values of one quantity for all dampers."""

    name: str
    unit: str
    values: Numbers
    setting: str = ""
    """Setting with its unit, such as ``0.8 A``; empty for a quantity without a setting."""
    known_to: float = 0.0
    """Median over the fleet of the standard deviation of one value in the fit; 0 if the fit states none."""

    @property
    def title(self) -> str:
        """The name with the setting: "coulomb_force at 0.8 A"."""
        return f"{self.name} at {self.setting}" if self.setting else self.name

    @property
    def off(self) -> Numbers:
        """Distance of each damper from the median, in robust standard deviations."""
        return far_off(self.values, self.known_to)


def write_report(results: str | os.PathLike[str], path: str | os.PathLike[str]) -> None:
    """Writes the report on a table of results. Requires matplotlib.

    :raises DashpotError: if matplotlib is missing, the table has no rows, or the path is unsuitable.
    """
    target = check_target(path)
    text = report(results)
    handle, half = tempfile.mkstemp(prefix=".half-", dir=target.parent)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", errors="replace") as file:
            file.write(text)
        os.chmod(half, 0o644)
        os.replace(half, target)
    except BaseException:
        Path(half).unlink(missing_ok=True)
        raise


def check_target(path: str | os.PathLike[str]) -> Path:
    """Checks that a report can be made and written, and returns its path.

    :raises DashpotError: if matplotlib is missing, or the path is unsuitable for a report.
    """
    try:
        import matplotlib.figure  # noqa: F401
    except ImportError as error:
        raise DashpotError("the report needs matplotlib: pip install 'dashpot[plot]'") from error
    target = Path(path)
    if not target.parent.is_dir():
        raise OutputError(f"cannot write {target}: there is no folder {target.parent}; make it first")
    if target.is_dir():
        raise OutputError(f"cannot write {target}: it is a folder; name a file in it")
    # Like the command, replaces only pages of dashpot, which name it as their generator.
    if target.exists() and target.stat().st_size and not _GENERATED.search(target.read_text(encoding="utf-8", errors="replace")[:4096]):
        raise OutputError(f"cannot write {target}: it is there already and is no report of dashpot; name another file")
    return target


def report(results: str | os.PathLike[str]) -> str:
    """Renders the report as HTML."""
    file = pq.ParquetFile(results)
    schema = file.schema_arrow
    said = ["campaign", "serial", "batch", "date", "status", "reason", "positive", "positive_confidence", "judgement", "missed", "verdict", "effect",
            "effect_confidence", "suspect", "changes", "setting_unit", "settings"]  # fmt: skip
    table = file.read(columns=said).to_pydict()
    count = len(table["campaign"])
    if not count:
        raise DashpotError(f"{results}: there is no damper in it")
    quantities = list(_quantities(file, schema))
    dates = np.array([_day(d) for d in table["date"]])
    serials = np.array(sorted(range(count), key=lambda k: _natural(table["serial"][k])), dtype=np.intp)
    # The assumed order of manufacture: by date, then by serial number. Dampers without a date come last.
    order = serials[np.argsort(np.where(np.isfinite(dates), dates, np.inf)[serials], kind="stable")]
    settings = _settings_of(schema)
    parts = [_HEAD, "<h1>Fleet of dampers</h1>", _summary(table, count), _over_settings(quantities, settings, count)]
    parts.append(_dampers(table, quantities, settings))
    parts.append(_outliers(table, quantities))
    parts.append("<h2>Every quantity</h2><p>Left: how often which value. Then over date and over the order of making with the limits "
                 "of an individuals chart (centre ± 2.66 mean moving ranges; red: outside, orange: ninth in a row on one side); "
                 "right: mean of every batch with its 95 % interval.</p>")  # fmt: skip
    parts.extend(_quantity(q, dates, serials, order, table["batch"]) for q in quantities)
    parts.append("</body></html>\n")
    return "".join(parts)


def _said(schema: Any, name: str, key: str) -> str:
    """Returns an entry of the metadata of a column, or an empty text."""
    said = (schema.field(name).metadata or {}).get(key.encode(), b"")
    return str(said.decode())


def _settings_of(schema: Any) -> list[str]:
    """Returns the settings of the fleet with their units, increasing; none for dampers without a setting."""
    named = {_said(schema, n, "setting_name"): float(_said(schema, n, "setting")) for n in schema.names if _said(schema, n, "setting")}
    return sorted(named, key=lambda name: named[name])


def _quantities(file: Any, schema: Any) -> Iterable[Quantity]:
    names = [n[: -len("_low")] for n in schema.names if n.endswith("_low") and f"{n[: -len('_low')]}_high" in schema.names]
    over = [n for n in schema.names if _said(schema, n, "setting") and not n.endswith(("_low", "_high"))]
    # All settings of a quantity follow each other.
    order = {name: k for k, name in enumerate(dict.fromkeys(_said(schema, n, "quantity") for n in over))}
    over.sort(key=lambda n: (order[_said(schema, n, "quantity")], float(_said(schema, n, "setting"))))
    units = {n: _said(schema, n, "unit") for n in dict.fromkeys([*(n for n in names if n not in over), *over])}
    units |= {force_column(v): "N" for v in VELOCITIES} | {"error_percent": "%"}
    titles = {force_column(v): f"force at {1e3 * v:+g} mm/s" for v in VELOCITIES}
    for name, unit in units.items():
        # Columns are read one at a time, and the model texts are not read, to limit the memory.
        values = np.array(file.read(columns=[name])[name].to_pylist(), dtype=float)
        if np.isfinite(values).any():
            factor, shown = _shown(unit)
            own = _said(schema, name, "quantity") or name
            known_to = factor * _known_to(file, name) if name in names else 0.0
            yield Quantity(titles.get(own, own), shown, factor * values, _said(schema, name, "setting_name"), known_to)


#: Factors from SI units to the units of reports, and these units. The table of results stays in SI units.
_WORKSHOP = {"m": (1e3, "mm"), "m/s": (1e3, "mm/s"), "N/m": (1e-3, "N/mm"), "-": (1.0, "")}


def _shown(unit: str) -> tuple[float, str]:
    """Returns the factor from an SI unit to the unit of reports, and the latter unit."""
    return _WORKSHOP.get(unit, (1.0, unit))


def _known_to(file: Any, name: str) -> float:
    """Returns the median standard deviation of a parameter over the fleet, from its 95 % intervals; 0 without intervals."""
    ends = file.read(columns=[f"{name}_low", f"{name}_high"]).to_pydict()
    low, high = (np.array(ends[f"{name}_{end}"], dtype=float) for end in ("low", "high"))
    width = (high - low)[np.isfinite(high - low)]
    return float(np.median(width)) / (2 * 1.96) if len(width) else 0.0


def _natural(text: str) -> list[tuple[int, int, str]]:
    """Returns a sort key that compares numbers in a text by value, so that D9 precedes D10."""
    return [(0, int(part), "") if part.isdecimal() else (1, 0, part) for part in re.split(r"(\d+)", text or "")]


def _day(date: str | None) -> float:
    return datetime.datetime.fromisoformat(date).timestamp() / 86400 if date else np.nan


def _row(cells: Iterable[object], tag: str = "td") -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(str(c))}</{tag}>" for c in cells) + "</tr>"


def _number(value: float) -> str:
    return "–" if not np.isfinite(value) else f"{value:.4g}"


#: Largest distance from the median, in robust standard deviations, that the report shows as a number. A larger one appears as "beyond +99".
_FARTHEST = 99.0


def _distance(deviations: float) -> str:
    return f"{deviations:+.1f}" if abs(deviations) <= _FARTHEST else f"beyond {'+' if deviations > 0 else '-'}{_FARTHEST:.0f}"


#: Largest number of dampers in the table of dampers. Of a larger fleet, it lists failed dampers and dampers far from the median.
DAMPERS = 300
_VERDICTS = {"passed": "PASS", "failed": "FAIL", "incomplete": "INCOMPLETE"}


#: Text in the place of a value at a setting at which a damper was not measured.
_NOT_MEASURED = "not measured"


def _over_settings(quantities: Sequence[Quantity], settings: Sequence[str], count: int) -> str:
    """Renders the table of the quantities that depend on the setting: median, robust deviation and number of dampers at each setting."""
    if not settings:
        return ""
    by_name: dict[str, dict[str, Quantity]] = {}
    for q in quantities:
        if q.setting:
            by_name.setdefault(q.name, {})[q.setting] = q

    def cell(q: Quantity | None) -> str:
        usual = spread(q.values if q is not None else np.array([]))
        return f"{_number(usual.median)} ± {_number(usual.deviation)} ({usual.count})" if usual.count else "–"

    measured = {s: spread(by_name["error_percent"][s].values).count if s in by_name.get("error_percent", {}) else 0 for s in settings}
    rows = [_row(("dampers measured", *(f"{measured[s]} of {count}" for s in settings)))]
    for name, own in by_name.items():
        unit = next(iter(own.values())).unit
        title = "mean error" if name == "error_percent" else name
        rows.append(_row((f"{title}, {unit}" if unit else title, *(cell(own.get(s)) for s in settings))))
    head = _row(("median ± robust deviation (dampers)", *(f"at {s}" for s in settings)), "th")
    text = "<p>A damper counts only at the settings at which it was measured.</p>"
    return f"<h2>Over the setting</h2>{text}<table>{head}{''.join(rows)}</table>"


def _dampers(table: dict[str, list[Any]], quantities: Sequence[Quantity], settings: Sequence[str]) -> str:
    """Renders the table of dampers, with one row for each damper."""
    count = len(table["campaign"])
    signed = np.nan_to_num(np.array([q.off for q in quantities])).reshape(-1, count)
    off = np.abs(signed)
    worst = off.max(axis=0) if len(off) else np.zeros(count)
    rank = {"failed": 0, "incomplete": 1}
    listed = list(range(count))
    if count > DAMPERS:
        listed = sorted(listed, key=lambda k: (table["status"][k] == "ok", rank.get(table["judgement"][k] or "", 2), -worst[k], k))[:DAMPERS]
    by_name = {q.name: q.values for q in quantities if not q.setting}
    at_settings = {q.setting: q.values for q in quantities if q.setting and q.name == "error_percent"}
    error = by_name.get("error_percent", np.full(count, np.nan))
    rows = []
    for k in listed:
        furthest = int(off[:, k].argmax()) if len(off) else 0
        unusual = f"{quantities[furthest].title} ({_distance(float(signed[furthest, k]))})" if worst[k] > OUTLIER else "–"
        is_ok = table["status"][k] == "ok"
        verdict = _VERDICTS.get(table["judgement"][k] or "", "–")
        missed = "; ".join(table["missed"][k] or ())
        rows.append(
            _row(
                (
                    table["serial"][k] or table["campaign"][k], table["batch"][k] or "–", (table["date"][k] or "–")[:10],
                    _number(float(error[k])) if is_ok else "not identified",
                    *(_at_setting(at_settings.get(s), k) if is_ok else "–" for s in settings), f"{verdict}: {missed}" if missed else verdict, unusual,
                    _effect(table, k) if is_ok else "–",
                )
            )
        )  # fmt: skip
    over = [f"at {s}, %" for s in settings]
    head = _row(("damper", "batch", "date", "mean error, %", *over, "limits", "most unusual (robust deviations)", "changed against the reference"), "th")
    more = f"<p>{count - DAMPERS} more are in the Parquet table: those that miss a limit or are far off are listed.</p>" if count > DAMPERS else ""
    return f'<h2>Dampers</h2><div class="scroll"><table>{head}{"".join(rows)}</table></div>{more}'


def _at_setting(values: Numbers | None, k: int) -> str:
    return _number(float(values[k])) if values is not None and np.isfinite(values[k]) else _NOT_MEASURED


def _summary(table: dict[str, list[Any]], count: int) -> str:
    failed = [(c, r) for c, s, r in zip(table["campaign"], table["status"], table["reason"], strict=True) if s != "ok"]
    judged = Counter(j for j in table["judgement"] if j)
    out = [f"<p>{count} dampers, {count - len(failed)} identified, {len(failed)} not."]
    if judged:
        counts = [(judged["passed"], "PASS"), (judged["failed"], "FAIL"), (judged["incomplete"], "INCOMPLETE (no limit missed, not all tested)")]
        out.append(f" Limits: {', '.join(f'{count} {word}' for count, word in counts if count)}.")
    out.append("</p>")
    # A table of an earlier version lacks these columns.
    turned = in_two_directions(table.get("positive", ()), table.get("positive_confidence", ()))
    if turned:
        out.append(f'<p class="warn">{html.escape(turned[0].upper() + turned[1:])}.</p>')
    # The description of a limit follows the last colon, because the name of a limit may contain colons.
    told = [text.rsplit(": ", 1) for all_of in table["missed"] for text in all_of or ()]
    missed = Counter(name for name, found in told if not found.startswith(_UNTESTED))
    untested = Counter(name for name, found in told if found.startswith(_UNTESTED))
    if told:
        names = sorted({*missed, *untested}, key=lambda name: (-missed[name], -untested[name], name))
        rows = "".join(_row((name, missed[name], untested[name])) for name in names)
        out.append(f"<h2>Limits missed</h2><table>{_row(('limit', 'dampers that miss it', 'dampers not tested'), 'th')}{rows}</table>")
    effects = Counter(e for e in table["effect"] if e)
    if effects:
        rows = "".join(_row(pair) for pair in effects.most_common())
        out.append(f"<h2>What changed against the reference</h2><table>{_row(('effect', 'dampers'), 'th')}{rows}</table>")
    if failed:
        # Most reasons begin with the path of a file, which includes the campaign. Other reasons get the campaign as a prefix.
        reasons = [r if str(r).startswith(c) else f"{c}: {r}" for c, r in failed[:REASONS]]
        rows = "".join(f'<li class="warn">{html.escape(text)}</li>' for text in reasons)
        more = f"<p>{len(failed) - REASONS} more are in the table.</p>" if len(failed) > REASONS else ""
        out.append(f"<h2>Campaigns that could not be identified</h2><ul>{rows}</ul>{more}")
    return "".join(out)


def _change(change: dict[str, Any]) -> str:
    """Formats the reference's value and the damper's value in one unit: "2 to 2.4 N/mm"."""
    factor, unit = _shown(change["unit"])
    return f"{_number(factor * change['reference'])} to {_number(factor * change['value'])} {unit}"


def _named(change: dict[str, Any]) -> str:
    velocity = change["velocity_m_s"]
    return change["name"] if velocity is None else f"{change['name']} at {1e3 * velocity:.0f} mm/s"


def _changed(changes: Sequence[dict[str, Any]], unit: str) -> list[str]:
    """Formats changes, each name once: "coulomb_force 30 to 90 N at 0.8 A (also at 0 A)"."""
    by_name: dict[str, list[dict[str, Any]]] = {}
    for change in changes:
        by_name.setdefault(change["name"], []).append(change)
    out = []
    for first, *others in by_name.values():
        text = f"{_named(first)} {_change(first)}"
        if first.get("setting") is not None:
            text += f" at {label(first['setting'], unit)}"
            also = sorted({c["setting"] for c in others} - {first["setting"]})
            text += f" (also at {', '.join(label(s, unit) for s in also)})" if also else ""
        out.append(text)
    return out


def _found_at(table: dict[str, list[Any]], k: int, kind: str) -> str:
    """Returns the settings at which a damper has its effect or suspect: " at 0 A, 0.8 A"; empty for a damper without a setting."""
    settings = (table.get("settings") or {k: None})[k] or ()
    at = [label(one["setting"], table["setting_unit"][k] or "") for one in settings if one[kind] == table[kind][k]]
    return f" at {', '.join(at)}" if at else ""


def _effect(table: dict[str, list[Any]], k: int) -> str:
    """Formats the result of the diagnosis of a damper: effect, suspect, changed values or verdict."""
    if table["effect"][k]:
        return f"{table['effect'][k]}{_found_at(table, k, 'effect')} ({100 * table['effect_confidence'][k]:.0f} % sure)"
    if table["suspect"][k]:
        return f"suspect: {table['suspect'][k]}{_found_at(table, k, 'suspect')}"
    # The damper has the effects of the reference, so only values differ. The change with the largest force comes first.
    changed = sorted(table["changes"][k] or (), key=lambda c: -c["force_n_rms"])
    if changed:
        unit = (table.get("setting_unit") or {k: None})[k] or ""
        return "changed: " + ", ".join(_changed(changed, unit)[:3])
    words = {"nothing_missing": "nothing that the tests show", "unknown_effect": "no known effect", "cannot_tell": "undecided"}
    return words.get(table["verdict"][k] or "", "not diagnosed")


def _outliers(table: dict[str, list[Any]], quantities: Sequence[Quantity]) -> str:
    if not quantities:
        return ""
    distances = [q.off for q in quantities]
    off = np.abs(np.nan_to_num(np.array(distances)))
    worst = off.max(axis=0)
    found = [int(k) for k in np.argsort(-worst, kind="stable") if worst[k] > OUTLIER]
    text = f"<h2>Outliers</h2><p>{len(found)} dampers have a quantity more than {OUTLIER} robust deviations from the median.</p>"
    if not found:
        return text
    rows = []
    for k in found[:OUTLIERS]:
        by = np.argsort(-off[:, k], kind="stable")[:3]
        quoted = ", ".join(
            f"{quantities[i].title} {_number(quantities[i].values[k])} {quantities[i].unit} ({_distance(float(distances[i][k]))})"
            for i in by
            if off[i, k] > OUTLIER
        )
        rows.append(_row((table["serial"][k] or table["campaign"][k], table["batch"][k], (table["date"][k] or "")[:10], quoted, _effect(table, k))))
    head = _row(("damper", "batch", "date", "what is unusual (robust deviations)", "what makes it so"), "th")
    return f"{text}<table>{head}{''.join(rows)}</table>"


def _quantity(q: Quantity, dates: Numbers, serials: Places, order: Places, names: Sequence[str]) -> str:
    usual = spread(q.values)
    slope = drift(dates, q.values)
    chart = control(q.values[order])
    groups = batches(names, q.values)
    said = [f"median {_number(usual.median)} {q.unit}, robust deviation {_number(usual.deviation)}, "
            f"{_number(usual.low)} to {_number(usual.high)}, {usual.count} dampers"]  # fmt: skip
    if slope is not None and slope.stands_out:
        half = 30 * 1.96 * slope.deviation
        said.append(f"drifts by {30 * slope.slope:+.3g} ± {half:.2g} {q.unit} in 30 days")
    slope = drift(np.arange(len(serials), dtype=float), q.values[serials])
    if slope is not None and slope.stands_out:
        half = 100 * 1.96 * slope.deviation
        said.append(f"drifts by {100 * slope.slope:+.3g} ± {half:.2g} {q.unit} in 100 serial numbers")
    if chart is not None and (chart.beyond or chart.shifted):
        said.append(f"{len(chart.beyond)} outside the limits of the control chart, {len(chart.shifted)} in runs")
    picture = _picture(q, dates, order, chart, groups)
    return f"<h3>{html.escape(q.title)}</h3><p>{html.escape('; '.join(said))}.</p>{picture}"


def _picture(q: Quantity, dates: Numbers, order: Places, chart: Control | None, groups: Sequence[Any]) -> str:
    out = io.BytesIO()
    # The image contains no version and no date, so that equal results give equal bytes.
    figure_of(q, dates, order, chart, groups).savefig(out, format="png", dpi=DPI, metadata={"Software": None})
    return f'<img alt="{html.escape(q.title)}" src="data:image/png;base64,{base64.b64encode(out.getvalue()).decode()}">'


#: Resolution of a picture, dots per inch. At 90, a label of 9 points has 11 px.
DPI = 90
#: Size of the tick labels, points, and the width of a digit and the height of a line at this size, px.
_LABEL, _DIGIT, _LINE = 9, 7.2, 15.0
#: Largest ratio of the range of the values to their median at which the picture shows differences from a common value. Otherwise, the labels
#: of the ticks would differ only in their last digits.
_FINE = 1e-3


def figure_of(q: Quantity, dates: Numbers, order: Places, chart: Control | None, groups: Sequence[Any]) -> Any:
    """Draws the values of one quantity: their distribution, over date, over the order of manufacture, and by batch."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(12.5, 3.2), dpi=DPI)
    axes = figure.subplots(1, 4, width_ratios=[1, 1.2, 1.6, 1])
    # The margins are fixed, because automatic layout takes longer than drawing.
    figure.subplots_adjust(left=0.065, right=0.985, bottom=0.34, top=0.96, wspace=0.36)
    there = q.values[np.isfinite(q.values)]
    base = _base(there)
    unit = q.unit if base == 0 else f"difference from {base:.10g} {q.unit}"
    axes[0].hist(there - base, bins=min(40, max(5, int(np.sqrt(len(there))))), color="#4f7cac")
    axes[0].set_xlabel(unit, fontsize=_LABEL)
    dated = np.isfinite(dates) & np.isfinite(q.values)
    if dated.any():
        axes[1].plot((dates[dated] - dates[dated].min()), q.values[dated] - base, ".", ms=3, color="#4f7cac")
        first = datetime.datetime.fromtimestamp(86400 * float(dates[dated].min())).date().isoformat()
        axes[1].set_xlabel(f"days from {first}", fontsize=_LABEL)
    else:
        _empty(axes[1], "no dates")
    values = q.values[order] - base
    axes[2].plot(values, ".-", ms=3, lw=0.4, color="#4f7cac")
    if chart is not None:
        for level, style in ((chart.centre, "-"), (chart.low, "--"), (chart.high, "--")):
            axes[2].axhline(level - base, ls=style, lw=0.8, color="#6b7280")
        for places, colour in ((chart.shifted, "#d97706"), (chart.beyond, "#dc2626")):
            axes[2].plot(list(places), values[list(places)], "o", ms=4, color=colour)
    axes[2].set_xlabel("order of making", fontsize=_LABEL)
    if groups:
        at = np.arange(len(groups))
        means = np.array([g.mean for g in groups]) - base
        half = np.nan_to_num(np.array([g.high - g.low for g in groups]) / 2)
        axes[3].errorbar(at, means, yerr=half, fmt="o", ms=4, capsize=3, color="#4f7cac")
        axes[3].set_xlim(-0.5, len(groups) - 0.5)
        axes[3].set_xlabel("batch", fontsize=_LABEL)
    else:
        _empty(axes[3], "no batches")
    for k, axis in enumerate(axes):
        axis.tick_params(labelsize=_LABEL)
        if axis.get_xticks().size:
            _set_ticks(axis, axis.yaxis, whole=k == 0)
            if k == 3:
                _name_batches(axis, [g.name for g in groups])
            else:
                _set_ticks(axis, axis.xaxis, whole=k == 2)
    return figure


def _base(values: Numbers) -> float:
    """Returns the value from which a picture shows differences, or 0 if it shows the values."""
    middle = float(np.median(values))
    span = float(np.ptp(values))
    return float(f"{middle:.6g}") if 0 < span < _FINE * abs(middle) else 0.0


def _set_ticks(axes: Any, way: Any, whole: bool) -> None:
    """Sets the largest number of ticks at which labels are complete, differ from each other and do not overlap."""
    from matplotlib.ticker import FixedFormatter, FixedLocator, MaxNLocator

    is_x = way is axes.xaxis
    box = axes.get_position()
    width, height = (DPI * axes.figure.get_size_inches() * (box.width, box.height)).tolist()
    low, high = axes.get_xlim() if is_x else axes.get_ylim()
    for most in (5, 4, 3, 2, 1):
        locator = MaxNLocator(most, integer=whole, steps=[1, 2, 2.5, 5, 10], min_n_ticks=1)
        at = [float(tick) for tick in locator.tick_values(low, high) if low <= tick <= high]
        labels = _labels(at)
        needed = sum(_DIGIT * len(label) + 10 for label in labels) if is_x else _LINE * len(labels)
        if at and needed <= (width if is_x else height):
            break
    way.set_major_locator(FixedLocator(at))
    way.set_major_formatter(FixedFormatter(labels))


def _labels(at: Sequence[float]) -> list[str]:
    """Formats ticks with the fewest digits that state each of them. Every label is a complete number, without a power of ten in a corner."""
    step = min((b - a for a, b in zip(at, at[1:], strict=False)), default=max((abs(tick) for tick in at), default=1.0)) or 1.0
    exact = [0.0 if abs(tick) < 1e-9 * step else tick for tick in at]
    for digits in range(1, 16):
        labels = [f"{tick:.{digits}g}" for tick in exact]
        if all(abs(float(label) - tick) <= 1e-6 * step for label, tick in zip(labels, exact, strict=True)):
            break
    # From a million on and below a ten-thousandth, numbers have an exponent.
    return [_plain_number(float(label)) for label in labels]


def _plain_number(value: float) -> str:
    if value == 0 or 1e-4 <= abs(value) < 1e6:
        return f"{value:.10f}".rstrip("0").rstrip(".")
    mantissa, exponent = f"{value:.10e}".split("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{int(exponent)}"


#: Largest number of characters of a batch's name below its tick. A longer name would be cut by the edge of the picture.
_NAME = 12


def _name_batches(axes: Any, names: Sequence[str]) -> None:
    """Labels batches, as many as have space at 45 degrees. Names that are equal after shortening get a number."""
    width = DPI * float(axes.figure.get_size_inches()[0]) * axes.get_position().width
    # Two lines at 45 degrees are apart by the square root of one half of the distance of their ticks.
    every = max(1, int(np.ceil(len(names) * _LINE * np.sqrt(2) / width)))
    shown = [_shortened(name, k) for k, name in enumerate(names)]
    at = list(range(0, len(names), every))
    axes.set_xticks(at, [plain(shown[k]) for k in at], rotation=45, ha="right", rotation_mode="anchor", fontsize=_LABEL)


def _shortened(name: str, number: int) -> str:
    if len(name) <= _NAME:
        return name
    return f"{name[: _NAME - 6]}\N{HORIZONTAL ELLIPSIS}{name[-2:]} {number + 1}"


def _empty(axis: Any, why: str) -> None:
    axis.text(0.5, 0.5, why, ha="center", va="center", transform=axis.transAxes, color="#6b7280")
    axis.set_xticks([])
    axis.set_yticks([])
