"""From records to a model, and what a model lacks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from . import _native
from ._arguments import loads
from ._numbers import words
from ._work import watched
from ._papers import option, origin
from .campaign import Campaign, Progress, Record, native_of
from .model import FittedModel, Model
from .diagnosis import Diagnosis
from .fitted import FitResult


def fit(
    campaign: Sequence[Record],
    *,
    family: str = "thesis",
    elements: Sequence[str] | None = None,
    hold_out: Sequence[str] = (),
    progress: Progress | None = None,
) -> FittedModel:
    """Identifies a damper from records; as ``dashpot fit``.

    FV curve from the peak velocities, friction and gas force from the slow tests, everything refined together; the variants of
    friction and spring are chosen by tests left out of the fit. ``model.fit`` holds the estimates with their 95 % intervals.

    :param campaign: a :class:`Campaign`, or some of its records: ``campaign[2:]``, ``[r for r in campaign if r.peak_velocity < 0.6]``.
    :param family: ``"thesis"``; or, to compare with, ``"fv"`` (plain FV curve), ``"piecewise"``, ``"lag"``.
    :param elements: elements that the fit may use; all of the model's if not given.
    :param hold_out: tests to leave out, by name; ``*`` stands for anything.
    :param progress: is told the share done and what is being done.
    :raises FitError: where no model can be fitted to these records.
    """
    wanted = None if elements is None else words(elements)
    with watched(progress) as told:
        text, said, found = _native.fit(native_of(campaign, "campaign"), family, wanted, words(hold_out), told)
    chosen = [] if family == "thesis" else ["--model", family]
    made_from = origin(campaign, chosen, option("elements", wanted or ()), option("hold-out", words(hold_out)))
    return FittedModel(text, "damper.toml", replace(FitResult.from_dict(loads(said)), _made_from=(found, made_from)))


def diagnose(
    model: Model,
    campaign: Sequence[Record],
    reference: Sequence[Record] | None = None,
    *,
    hold_out: Sequence[str] = (),
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    progress: Progress | None = None,
) -> Diagnosis:
    """Says where a model and records disagree, and which physical effect is missing; as ``dashpot diagnose``.

    :param reference: records of the same tests on a damper known to be good, on the same rig. The question is then what
        changed, and what the model's form leaves on both dampers alike is taken out of it: the surest way wherever there is one.
    :param hold_out: tests that no refit sees, by name; chosen over all amplitudes and speeds if not given.
    :param max_effects: most effects to add.
    :param candidates: effects that may be named; all if not given.
    :param seed: chooses which tests are left out.
    :param progress: is told the share done and what is being done.
    :raises DiagnosisError: where there is nothing to look at.
    """
    if not isinstance(model, Model):
        raise TypeError(f"model is a dashpot.Model, not a {type(model).__name__}; dashpot.Model.read(path) reads one")
    with watched(progress) as told:
        own, good = native_of(campaign, "campaign"), None if reference is None else native_of(reference, "reference")
        said, improved, curves, made_from = _native.diagnose(
            model._native, own, good, words(hold_out), max_effects, None if candidates is None else words(candidates), seed, told
        )
    found = Diagnosis.from_dict(loads(said))
    numbers = ([] if max_effects == 3 else ["--max-effects", str(max_effects)], [] if seed == 0 else ["--seed", str(seed)])
    compared_with = _compared_with(campaign, reference)
    came_from = origin(campaign, compared_with, option("hold-out", words(hold_out)), option("candidates", words(candidates or ())), *numbers)
    return replace(found, _improved=Model(improved, "improved.toml"), _curves=tuple(curves), _made_from=(made_from, model, came_from))


def _compared_with(campaign: Sequence[Record], reference: Sequence[Record] | None) -> list[str] | None:
    """The option of the command that names the reference; none where it does not read those records, which it reads as it reads the others."""
    if reference is None:
        return []
    if not (isinstance(reference, Campaign) and isinstance(campaign, Campaign) and reference._reading == campaign._reading):
        return None
    return [word for path in reference.paths for word in ("--reference", path)]
