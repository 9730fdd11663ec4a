"""Checks of a plan before the first campaign is evaluated."""

from __future__ import annotations

import inspect
import json
import os
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np

from .. import _native
from .._native import DashpotError, DiagnosisError, FitError, RecordError, ValidationError
from .._numbers import words
from ..campaign import Campaign
from ..certificate import _TIMES
from ..family import Family
from ..identification import diagnose, fit
from ..limits import Limit, rows
from ..model import Model
from .examine import Plan

#: Allowed values of ``Plan.diagnose``, which selects the campaigns to diagnose.
DIAGNOSED = ("all", "failed", "none")


def checked(plan: Plan) -> Plan:
    """Checks a plan. Returns it with paths as absolute texts and names as tuples.

    :raises DashpotError: if an argument is invalid. The message names the argument.
    """
    if plan.diagnose not in DIAGNOSED:
        raise DashpotError(f"Plan.diagnose is {plan.diagnose!r}; it is {', '.join(DIAGNOSED)}")
    for name, least in (("max_effects", 0), ("retries", 0), ("threads", 1)):
        number = getattr(plan, name)
        if isinstance(number, bool) or not isinstance(number, int) or number < least:
            raise DashpotError(f"Plan.{name} is {number!r}; it is a whole number, {least} at least")
    if isinstance(plan.limits, (str, os.PathLike)):
        raise DashpotError(f"Plan.limits is {os.fspath(plan.limits)!r}; give what dashpot.fleet.read_limits of that file returns")
    if not all(isinstance(limit, Limit) for limit in plan.limits):
        raise DashpotError("Plan.limits is a sequence of dashpot.fleet.Limit; dashpot.fleet.read_limits reads them from a file")
    try:
        _native.check_limits(rows(plan.limits))
    except (TypeError, ValidationError) as error:
        raise DashpotError(f"Plan.limits: {error}") from None
    _setting(plan)
    reference: Any = plan.reference
    if reference is not None:
        if not isinstance(reference, (str, os.PathLike)):
            raise DashpotError(f"Plan.reference is the path of a campaign, not {reference!r}")
        # A worker may have another working directory.
        reference = os.path.abspath(os.fspath(reference))
        if not os.path.exists(reference):
            raise DashpotError(f"the reference {plan.reference}: there is no such file or folder")
    plan = replace(
        plan,
        elements=_names("elements", plan.elements),
        hold_out=_names("hold_out", plan.hold_out) or (),
        candidates=_names("candidates", plan.candidates),
        limits=tuple(plan.limits),
        reference=reference,
    )
    _mapping(plan.mapping)
    _known(plan)
    return plan


def _setting(plan: Plan) -> None:
    """Checks that setting, family and limits of a plan fit together.

    :raises DashpotError: if they do not.
    """
    setting: Any = plan.setting
    if setting is not None and (not isinstance(setting, str) or not setting):
        raise DashpotError(f'Plan.setting is the name of what the tests were set to, such as "current", not {setting!r}')
    if plan.over is not None and plan.family != "thesis":
        raise DashpotError(f"Plan.setting fits the family thesis over the setting, not {plan.family}; leave one of the two out")
    if plan.over is not None and plan.reference_model is not None:
        Family(plan.reference_model, "Plan.reference_model")
    for limit in plan.limits:
        name = limit.label or limit.quantity
        if plan.over is None and limit.setting is not None:
            raise DashpotError(
                f"Plan.limits: {name} holds at the setting {limit.setting:g}: give the name of the setting, --setting NAME or Plan(setting=NAME)"
            )
        if plan.over is not None and limit.setting is None and limit.quantity not in _TIMES:
            raise DashpotError(f"Plan.limits: {name} has no setting: each limit of a force over {plan.over} needs one, in the column setting")


def _names(name: str, given: str | Iterable[str] | None) -> tuple[str, ...] | None:
    if given is None:
        return None
    names = words(given)
    if not all(isinstance(n, str) for n in names):
        raise DashpotError(f"Plan.{name} is names, not {given!r}")
    return tuple(names)


def _mapping(mapping: dict[str, Any]) -> None:
    """Checks the arguments for reading records, without records.

    :raises DashpotError: if an argument is unknown or invalid.
    """
    known = [name for name in inspect.signature(Campaign.read).parameters if name not in ("path", "progress")]
    for name in mapping:
        if name not in known:
            near = get_close_matches(str(name), known, 1)
            raise DashpotError(
                f"Plan.mapping: Campaign.read has no {name!r}; "
                + (f"did you mean {near[0]!r}?" if near else f"there are {', '.join(known)}")
            )
    try:
        json.dumps(mapping)
        Campaign.read([], **mapping)
    except RecordError as error:
        # The reader checks its arguments first, so the error for missing records means that they are valid.
        if "no record given" not in str(error):
            raise DashpotError(f"how records are read (Plan.mapping): {error}") from None
    except (TypeError, ValueError, AttributeError) as error:
        raise DashpotError(f"how records are read (Plan.mapping): {error}") from None


class _Begun(Exception):
    """Raised at the first progress report of a fit or diagnosis, whose arguments are then valid."""


def _stop(_: float, __: str) -> None:
    raise _Begun


#: Text of a minimal model file, with which a diagnosis can start.
_DAMPER = 'format = 1\nelements = ["fv_curve"]\nfv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [-1000.0, 0.0, 1000.0]\n'


def _known(plan: Plan) -> None:
    """Checks the names of family, elements and candidates. A fit and a diagnosis of one small synthetic test are started and then stopped.

    :raises DashpotError: if a name is unknown.
    """
    if plan.family == "thesis" and plan.elements is None and plan.candidates is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        phase = 2 * np.pi * np.arange(301) / 100
        table = np.column_stack([phase / 10, 0.025 * np.sin(phase), 0.25 * np.cos(phase), 250 * np.cos(phase)])
        np.savetxt(Path(folder) / "t.csv", table, "%.9g", ",", header="time_s,displacement_m,velocity_m_s,force_N", comments="")
        campaign = Campaign.read(folder)
    _begin(lambda: fit(campaign, family=plan.family, elements=plan.elements, progress=_stop))
    if plan.candidates is not None:
        _begin(lambda: diagnose(Model(_DAMPER), campaign, candidates=plan.candidates, max_effects=plan.max_effects, progress=_stop))


def _begin(work: Callable[[], object]) -> None:
    try:
        work()
    except _Begun:
        pass
    except (FitError, DiagnosisError) as error:
        # Any other error concerns the synthetic test, not the names.
        if str(error).startswith(("there is no ", "elements chooses")):
            raise DashpotError(str(error)) from None
