"""Evaluation of one campaign, which gives one row of the table: reading, fit, validation, check of limits, diagnosis."""

from __future__ import annotations

import json
import os
from collections import Counter
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from .. import _native
from ..campaign import Campaign
from ..family import Family, FittedFamily
from ..identification import NO_SETTING, diagnose, fit
from ..limits import Limit, rows
from ..model import FittedModel, Model
from ..certificate import missed
from .files import Stamp, stamps
from .jobs import Job
from .settings import at_each_setting, diagnosed, has, label, named_option, settings_in, verdict_of

#: Velocities, m/s, at which rows contain the force of the damper, so that FV curves with different points are comparable. They are peak
#: velocities of the thesis's test matrix.
VELOCITIES = (-1.047, -0.524, -0.262, -0.131, -0.052, 0.052, 0.131, 0.262, 0.524, 1.047)

#: Key that marks a row with a temporary failure, such as files that a worker cannot access. The next run evaluates the campaign again.
PASSING = "passing"

#: Version of the columns of rows. Campaigns with rows of another version are evaluated again.
ROWS = 3

#: Version of the measured values for limits in rows. Campaigns with values of another version are evaluated again.
FIGURES = 2

#: Largest ratio of a velocity of :data:`VELOCITIES` to the end of the FV curve at which a row contains the force. The ratio may exceed 1,
#: because the curve ends at the rig's actual peak velocity, which scatters about the nominal one.
PEAK_SCATTER = 1.05


@dataclass(frozen=True)
class Plan:
    """Settings of the evaluation of all campaigns."""

    family: str = "thesis"
    setting: str | None = None
    """Name of the setting over which each damper is fitted, such as ``"current"``. ``"none"`` fits tests at several settings as one damper."""
    elements: tuple[str, ...] | None = None
    hold_out: tuple[str, ...] = ()
    mapping: dict[str, Any] = field(default_factory=dict)
    """Arguments of :meth:`dashpot.Campaign.read`, by name."""
    limits: tuple[Limit, ...] = ()
    reference: str | None = None
    """Path of the reference damper's campaign."""
    reference_model: str | None = None
    """Text of the model file of the reference damper; if not given, the model is fitted to ``reference``."""
    diagnose: str = "all"
    """Campaigns to diagnose against the reference: ``all``, ``failed`` (those that violate a limit), ``none``."""
    max_effects: int = 1
    candidates: tuple[str, ...] | None = None
    """Effects that a diagnosis may find; all if not given."""
    retries: int = 2
    """Number of retries after a failure that the campaign did not cause, such as an unreachable file server."""
    threads: int = 1
    """Number of threads in one worker. It is 1 by default, because the workers already run campaigns in parallel."""

    @property
    def over(self) -> str | None:
        """Name of the setting on which the dampers depend; None for dampers without a setting."""
        return None if self.setting == NO_SETTING else self.setting

    @property
    def subfolders(self) -> bool:
        """Whether records in subfolders belong to a campaign, even if its ``campaign.toml`` does not state this."""
        return bool(self.mapping.get("subfolders", False))

    def said(self) -> str:
        """Returns as JSON everything that affects the rows, including the version of their columns."""
        decides = {k: v for k, v in asdict(self).items() if k not in ("retries", "threads")}
        if self.diagnose != "failed" or self.reference is None:
            # The values of the limits do not affect the rows. Rows contain the measured values, and the table applies the limits later.
            decides["limits"] = FIGURES if self.limits else False
        made_of = stamps(self.reference, self.subfolders) if self.reference is not None else []
        return json.dumps([_native.VERSION, ROWS, decides, made_of], sort_keys=True)


def in_two_directions(positive: Iterable[str | None], confidence: Iterable[float | None]) -> str | None:
    """Returns a message if different positive directions were determined for the campaigns, because one rig has only one. None otherwise."""
    counts = Counter(p for p, c in zip(positive, confidence, strict=True) if p is not None and c is not None)
    if len(counts) < 2:
        return None
    told = " and ".join(f"{count} as counting {name} positive" for name, count in sorted(counts.items()))
    return f"campaigns were read {told}; where all come from one rig, give --positive (the columns positive and positive_confidence have each)"


def force_column(velocity: float) -> str:
    """Returns the name of the column with the force at a velocity, m/s."""
    return f"force_at_{velocity:+g}_m_s"


@lru_cache(maxsize=2)
def _reference(path: str, mapping: str, made_of: tuple[Stamp, ...]) -> Campaign:
    """Reads the campaign of the reference damper.

    The cache depends on the stamps ``made_of`` of its files, because the files may change while a worker of a cluster lives.
    """
    return Campaign.read(path, **json.loads(mapping))


def examine(job: Job, key: str, plan: Plan) -> dict[str, Any]:
    """Evaluates a campaign and returns its row. A failure is not raised, but is stated in the row."""
    row: dict[str, Any] = {"key": key, **asdict(job), "status": "ok", "reason": None}
    if not os.path.exists(job.campaign):
        return {**row, "status": "failed", "reason": f"{job.campaign}: there is no such file or folder", PASSING: True}
    for attempt in range(plan.retries + 1):
        try:
            return {**row, **_figures(job, plan)}
        except (_native.DashpotError, ValueError) as error:
            # The campaign caused the error, so a retry would fail too.
            return {**row, "status": "failed", "reason": str(error)}
        except (KeyboardInterrupt, SystemExit):
            raise
        except BaseException as error:  # a fault of the program in the compiled part is no Exception
            told = f"{type(error).__name__}: {error}"
            if attempt == plan.retries:
                row = {**row, "status": "failed", "reason": f"{told} (tried {attempt + 1} times)", PASSING: True}
    return row


def fitted(campaign: Campaign, plan: Plan) -> FittedModel | FittedFamily:
    """Fits the damper of a campaign: over the setting if the plan names one and the tests have several, else an ordinary damper.

    :raises FitError: if no damper can be fitted. If the tests have several settings and the plan names none, the message names the option.
    """
    if plan.over is not None and len(settings_in(campaign, plan.over)) != 1:
        return fit(campaign, setting=plan.over, elements=plan.elements, hold_out=plan.hold_out)
    try:
        if plan.setting == NO_SETTING:
            # A plan without a setting makes the same fit where the tests have one setting or none.
            return fit(campaign, setting=NO_SETTING, family=plan.family, elements=plan.elements, hold_out=plan.hold_out)
        return fit(campaign, family=plan.family, elements=plan.elements, hold_out=plan.hold_out)
    except _native.FitError as error:
        raise named_option(campaign, error) from None


def _figures(job: Job, plan: Plan) -> dict[str, Any]:
    campaign = Campaign.read(job.campaign, **plan.mapping)
    model = fitted(campaign, plan)
    with warnings.catch_warnings():
        # The doubts about settings are in the notes of the row, with the name of the damper.
        warnings.simplefilter("ignore")
        validation = model.validate(campaign)
    compared = validation.campaign or campaign
    unit, settings = _settings(model, compared, validation, plan)
    measured: _native.Figures | _native.SettingsFigures | None = None
    if plan.limits:
        # Limits apply to the corrected records, as in the command.
        if isinstance(model, FittedFamily):
            measured = model._native.measure(compared._native)
        elif plan.over is not None:
            measured = _native.SettingsFigures.at(compared._native, settings[0]["setting"])
        else:
            measured = _native.Figures.measure(compared._native)
    parts = model if isinstance(model, Model) else model.at(settings[0]["setting"])
    doubts = (
        f"{d.test}: its forces are those at {label(d.fitting, unit)}, and it is labeled {label(d.stated, unit)}" for d in validation.setting_doubts
    )
    actuator = model.fit.actuator if isinstance(model, FittedFamily) else None
    valve = actuator.estimates if actuator is not None else ()
    figures: dict[str, Any] = {
        "setting": plan.over,
        "setting_unit": unit if plan.over is not None else None,
        "settings": settings,
        "tests": len(campaign),
        "positive": campaign.sign.positive,
        "positive_confidence": None if campaign.sign.is_stated else campaign.sign.confidence,
        "misfit": model.fit.misfit,
        "error_percent": validation.overall.error_percent,
        "rmse_n": validation.overall.rmse_n,
        "fv_error_percent": validation.overall.fv_only.error_percent,
        "measured": measured.text if measured is not None else None,
        **judged(plan.limits, measured, unit, [one["setting"] for one in settings]),
        "elements": list(parts.elements),
        "parameters": [
            {"name": e.name, "index": e.index, "value": e.value, "low": e.low, "high": e.high, "unit": e.unit, "standing": e.standing,
             "setting": getattr(e, "setting", None)}
            for e in (*model.fit.parameters, *valve)
        ],
        # Unusable files and tests come first, because a reader of the row must know that they were left out.
        "notes": [*(u.why for u in campaign.unusable), *doubts, *model.fit.notes],
        "model": model.text,
    }  # fmt: skip
    if isinstance(model, Model):
        low, high = model.velocity_range
        forces = model.steady_force(np.array(VELOCITIES))
        for velocity, force in zip(VELOCITIES, forces, strict=True):
            # Outside the velocities of the campaign, the curve is extrapolated and therefore omitted.
            shown = low <= velocity / PEAK_SCATTER <= high
            figures[force_column(velocity)] = float(force) if shown and plan.over is None else None
    if plan.reference is not None and (plan.diagnose == "all" or plan.diagnose == "failed" and figures["judgement"] == "failed"):
        if plan.over is None:
            figures.update(_diagnosed(campaign, plan))
        else:
            _diagnose_over_settings(campaign, plan, figures)
    return figures


def _settings(model: FittedModel | FittedFamily, compared: Campaign, validation: Any, plan: Plan) -> tuple[str, list[dict[str, Any]]]:
    """Returns the unit of the setting and the entries of a row for each setting. Without a setting, there are none."""
    if plan.over is None:
        return "", []
    unit = model.unit if isinstance(model, Family) else next(r.setting.unit for r in compared if r.setting is not None)
    return unit, at_each_setting(model, compared, validation, VELOCITIES, PEAK_SCATTER)


def judged(
    limits: Sequence[Limit],
    measured: _native.Figures | _native.SettingsFigures | None,
    unit: str = "",
    settings: Sequence[float] | None = None,
) -> dict[str, Any]:
    """Returns the entries of a row that depend on limits: verdict and descriptions of the limits that are not passed.

    :param unit: unit of the setting of a damper that depends on one.
    :param settings: settings at which this damper was measured.
    """
    if not limits or measured is None:
        return {"judgement": None, "missed": []}
    # The JSON is used without conversion to result classes, because every table of ten thousand dampers evaluates all limits again.
    found = json.loads(measured.judge(rows(limits)))
    judgement = {"pass": "passed", "fail": "failed", "incomplete": "incomplete"}[found["overall"]]
    return {"judgement": judgement, "missed": [told for one in found["limits"] if (told := missed(one, unit, settings))]}


def _good(plan: Plan) -> Campaign:
    assert plan.reference is not None
    return _reference(plan.reference, json.dumps(plan.mapping, sort_keys=True), tuple(stamps(plan.reference, plan.subfolders)))


def _diagnosed(campaign: Campaign, plan: Plan) -> dict[str, Any]:
    assert plan.reference_model is not None
    reference = Model(plan.reference_model, "reference.toml")
    found = diagnose(reference, campaign, _good(plan), max_effects=plan.max_effects, candidates=plan.candidates)
    return {
        **verdict_of(found),
        "summary": found.summary,
        "changes": [{**asdict(change), "setting": None} for change in found.changes],
    }


def _diagnose_over_settings(campaign: Campaign, plan: Plan, figures: dict[str, Any]) -> None:
    """Adds the diagnosis against the reference at each setting that both dampers were measured at. A note names the other settings."""
    assert plan.reference_model is not None
    reference = Family(plan.reference_model, "reference.toml")
    good = _good(plan)
    known = settings_in(good, plan.over)
    is_one_unit = {r.setting.unit for r in (*campaign, *good) if r.setting is not None} == {figures["setting_unit"]}
    # Records in another unit are converted by the diagnosis itself.
    common = [r for r in campaign if not is_one_unit or r.setting is not None and has(known, r.setting.value)]
    apart = [one["setting"] for one in figures["settings"] if is_one_unit and not has(known, one["setting"])]
    if apart:
        listed = ", ".join(label(value, figures["setting_unit"]) for value in apart)
        figures["notes"].append(f"not compared at {listed}: the reference was not measured there")
    if not common:
        return
    found = diagnose(reference, common, good, max_effects=plan.max_effects, candidates=plan.candidates)
    said, each = diagnosed(found)
    figures.update(said)
    for one in figures["settings"]:
        one.update(next((own for setting, own in each.items() if has([setting], one["setting"])), {}))


def examine_all(jobs: Sequence[tuple[Job, str]], plan: Plan) -> list[Mapping[str, Any]]:
    """Evaluates a chunk of campaigns in a worker and returns their rows."""
    _native.set_threads(plan.threads)
    return [examine(job, key, plan) for job, key in jobs]
