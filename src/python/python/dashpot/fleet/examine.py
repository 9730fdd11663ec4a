"""One campaign becomes one row: read, fitted, compared, judged, diagnosed."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from .. import _native
from ..campaign import Campaign
from ..identification import diagnose, fit
from ..limits import Limit, rows
from ..model import Model
from ..certificate import missed
from .files import Stamp, stamps
from .jobs import Job

#: Velocities, m/s, at which the force of every damper is told, so that curves with other points can be compared: peak
#: velocities of the thesis's matrix.
VELOCITIES = (-1.047, -0.524, -0.262, -0.131, -0.052, 0.052, 0.131, 0.262, 0.524, 1.047)

#: Marks a row whose failure may be gone at the next start: files that a worker does not see, a file server that went away.
PASSING = "passing"

#: Which columns rows have; another number has campaigns done anew whose rows have others.
ROWS = 2

#: Which figures rows keep for limits; another number has what was kept in another form measured anew.
FIGURES = 2

#: By so much a peak velocity may be missed: the end of the curve is where the rig was, not where it was told to be.
PEAK_SCATTER = 1.05


@dataclass(frozen=True)
class Plan:
    """What is done with every campaign."""

    family: str = "thesis"
    elements: tuple[str, ...] | None = None
    hold_out: tuple[str, ...] = ()
    mapping: dict[str, Any] = field(default_factory=dict)
    """How records are read: arguments of :meth:`dashpot.Campaign.read`."""
    limits: tuple[Limit, ...] = ()
    reference: str | None = None
    """Campaign of the reference damper."""
    reference_model: str | None = None
    """Text of the model file of the reference damper; fitted to its campaign if not given."""
    diagnose: str = "all"
    """Which are diagnosed against the reference: ``all``, ``failed`` (those that miss a limit), ``none``."""
    max_effects: int = 1
    candidates: tuple[str, ...] | None = None
    """Effects that may be named; all if not given."""
    retries: int = 2
    """How often a campaign is tried again after a fault that is not its own, such as a file server that went away."""
    threads: int = 1
    """Threads inside one worker; campaigns, not tests, are what is shared out."""

    @property
    def subfolders(self) -> bool:
        """Whether records in the subfolders of a campaign are its tests whatever its ``campaign.toml`` says."""
        return bool(self.mapping.get("subfolders", False))

    def said(self) -> str:
        """All that decides what comes out, as text, and which columns that has."""
        decides = {k: v for k, v in asdict(self).items() if k not in ("retries", "threads")}
        if self.diagnose != "failed" or self.reference is None:
            # Rows keep what was measured, and the table is judged when it is made.
            decides["limits"] = FIGURES if self.limits else False
        made_of = stamps(self.reference, self.subfolders) if self.reference is not None else []
        return json.dumps([_native.VERSION, ROWS, decides, made_of], sort_keys=True)


def in_two_directions(positive: Iterable[str | None], confidence: Iterable[float | None]) -> str | None:
    """A sentence where some campaigns were found to count rebound positive and others compression: of one rig, some were taken the wrong way round."""
    counts = Counter(p for p, c in zip(positive, confidence, strict=True) if p is not None and c is not None)
    if len(counts) < 2:
        return None
    told = " and ".join(f"{count} as counting {name} positive" for name, count in sorted(counts.items()))
    return f"campaigns were read {told}; where all come from one rig, give --positive (the columns positive and positive_confidence have each)"


def force_column(velocity: float) -> str:
    """Name of the column with the force at a velocity."""
    return f"force_at_{velocity:+g}_m_s"


@lru_cache(maxsize=2)
def _reference(path: str, mapping: str, made_of: tuple[Stamp, ...]) -> Campaign:
    """The campaign of the reference damper as its files are now: workers of a cluster outlive a run, and the files may change."""
    return Campaign.read(path, **json.loads(mapping))


def examine(job: Job, key: str, plan: Plan) -> dict[str, Any]:
    """The row of a campaign. Never raises: what goes wrong is in the row."""
    row: dict[str, Any] = {"key": key, **asdict(job), "status": "ok", "reason": None}
    if not os.path.exists(job.campaign):
        return {**row, "status": "failed", "reason": f"{job.campaign}: there is no such file or folder", PASSING: True}
    for attempt in range(plan.retries + 1):
        try:
            return {**row, **_figures(job, plan)}
        except (_native.DashpotError, ValueError) as error:
            # The campaign's own: trying again changes nothing.
            return {**row, "status": "failed", "reason": str(error)}
        except (KeyboardInterrupt, SystemExit):
            raise
        except BaseException as error:  # a fault of the program in the compiled part is no Exception
            told = f"{type(error).__name__}: {error}"
            if attempt == plan.retries:
                row = {**row, "status": "failed", "reason": f"{told} (tried {attempt + 1} times)", PASSING: True}
    return row


def _figures(job: Job, plan: Plan) -> dict[str, Any]:
    campaign = Campaign.read(job.campaign, **plan.mapping)
    model = fit(campaign, family=plan.family, elements=plan.elements, hold_out=plan.hold_out)
    validation = model.validate(campaign)
    measured = None
    if plan.limits:
        # The records as they were compared, which are those that the command judges.
        measured = _native.Figures.measure((validation.campaign or campaign)._native)
    figures: dict[str, Any] = {
        "tests": len(campaign),
        "positive": campaign.sign.positive,
        "positive_confidence": None if campaign.sign.is_stated else campaign.sign.confidence,
        "misfit": model.fit.misfit,
        "error_percent": validation.overall.error_percent,
        "rmse_n": validation.overall.rmse_n,
        "fv_error_percent": validation.overall.fv_only.error_percent,
        "measured": measured.text if measured is not None else None,
        **judged(plan.limits, measured),
        "elements": list(model.elements),
        "parameters": [
            {"name": e.name, "index": e.index, "value": e.value, "low": e.low, "high": e.high, "unit": e.unit, "standing": e.standing}
            for e in model.fit.parameters
        ],
        # Tests and files that were left out first: a row must not look as if it rested on all of them.
        "notes": [*(u.why for u in campaign.unusable), *model.fit.notes],
        "model": model.text,
    }  # fmt: skip
    low, high = model.velocity_range
    forces = model.steady_force(np.array(VELOCITIES))
    for velocity, force in zip(VELOCITIES, forces, strict=True):
        # Beyond the speeds of the campaign the curve is a guess.
        shown = low <= velocity / PEAK_SCATTER <= high
        figures[force_column(velocity)] = float(force) if shown else None
    if plan.reference is not None and (plan.diagnose == "all" or plan.diagnose == "failed" and figures["judgement"] == "failed"):
        figures.update(_diagnosed(campaign, plan))
    return figures


def judged(limits: Sequence[Limit], measured: _native.Figures | None) -> dict[str, Any]:
    """What of a row depends on limits."""
    if not limits or measured is None:
        return {"judgement": None, "missed": []}
    # Taken as it comes: a table of ten thousand dampers is judged anew whenever it is made.
    found = json.loads(measured.judge(rows(limits)))
    judgement = {"pass": "passed", "fail": "failed", "incomplete": "incomplete"}[found["overall"]]
    return {"judgement": judgement, "missed": [told for one in found["limits"] if (told := missed(one))]}


def _diagnosed(campaign: Campaign, plan: Plan) -> dict[str, Any]:
    assert plan.reference is not None and plan.reference_model is not None
    good = _reference(plan.reference, json.dumps(plan.mapping, sort_keys=True), tuple(stamps(plan.reference, plan.subfolders)))
    reference = Model(plan.reference_model, "reference.toml")
    found = diagnose(reference, campaign, good, max_effects=plan.max_effects, candidates=plan.candidates)
    said: dict[str, Any] = {
        "verdict": found.verdict,
        "summary": found.summary,
        "changes": [asdict(change) for change in found.changes],
    }
    if found.findings:
        first = found.findings[0]
        said.update(effect=first.effect, effect_form=first.form, effect_confidence=first.confidence)
    elif found.suspects:
        said.update(suspect=found.suspects[0].effect, suspect_confidence=found.suspects[0].confidence)
    return said


def examine_all(jobs: Sequence[tuple[Job, str]], plan: Plan) -> list[Mapping[str, Any]]:
    """The rows of a chunk of campaigns; runs in a worker."""
    _native.set_threads(plan.threads)
    return [examine(job, key, plan) for job, key in jobs]
