"""Identification of models from records, and diagnosis of the effects that a model lacks."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, overload

from . import _native
from ._arguments import loads
from ._files import needs
from ._given import Data
from ._numbers import real, several, words
from ._reading import How, Reading, how
from ._work import watched
from ._papers import Origin, option, origin
from .campaign import Campaign, Path, Progress, Record, native_of, paths_of
from .model import FittedModel, Model
from .diagnosis import Diagnosis
from .diagnosis_settings import FamilyDiagnosis
from .family import Family, FittedFamily
from .family_fit import FamilyFitResult
from .fitted import FitResult
from .groups import GroupsDiagnosis
from .reading import Note

if TYPE_CHECKING:
    from typing_extensions import Unpack


_NO_SETTING = "none"
"""Setting that stands for none: tests at several settings are fitted as one damper."""


def _dimensions(path: str | None) -> list[str]:
    """Returns the option of the command for a file of dimensions, or an empty list without a file."""
    return [] if path is None else ["--dimensions", path]


@overload
def fit(
    campaign: Sequence[Record],
    *,
    setting: str,
    family: str = "thesis",
    elements: Sequence[str] | None = None,
    hold_out: Sequence[str] = (),
    dimensions: Path | None = None,
    progress: Progress | None = None,
) -> FittedFamily: ...
@overload
def fit(
    campaign: Sequence[Record],
    *,
    setting: None = None,
    family: str = "thesis",
    elements: Sequence[str] | None = None,
    hold_out: Sequence[str] = (),
    dimensions: Path | None = None,
    progress: Progress | None = None,
) -> FittedModel: ...
def fit(
    campaign: Sequence[Record],
    *,
    setting: str | None = None,
    family: str = "thesis",
    elements: Sequence[str] | None = None,
    hold_out: Sequence[str] = (),
    dimensions: Path | None = None,
    progress: Progress | None = None,
) -> FittedModel | FittedFamily:
    """Identifies a damper from records, like ``dashpot fit``.

    The FV curve comes from the peak velocities, and friction and gas force come from the slow tests. Then all parameters are refined together.
    One search over structures selects the variants of friction, springs, the series path and measurement errors. ``model.fit`` contains the
    estimates with their 95 % intervals.

    :param campaign: a :class:`Campaign`, part of one (``campaign[2:]``), or some of its records: ``[r for r in campaign if r.peak_velocity < 0.6]``.
    :param setting: name of the setting of the tests: ``"current"``, ``"clicks"``, or the name in ``campaign.toml``. With it, the result is a
        :class:`FittedFamily`, one damper that depends on this setting. ``"none"`` fits tests at several settings as one damper.
    :param family: ``"thesis"``; or, for comparison, ``"fv"`` (plain FV curve), ``"piecewise"`` or ``"lag"``. :func:`fit_literature` identifies
        the other models of the literature, which no host can run.
    :param elements: elements that the fit may use; all elements of the model if not given.
    :param hold_out: names of tests to leave out; ``*`` matches any text.
    :param dimensions: path of a TOML file with the dimensions of the damper, like the command's ``--dimensions``. They give priors of parameters.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :raises DimensionsError: if the dimensions are unusable. The message names file, line and key.
    :raises FitError: if no model can be fitted to the records.
    """
    wanted = None if elements is None else words(elements)
    drawing = None if dimensions is None else os.fspath(dimensions)
    lumped = setting == _NO_SETTING
    if setting is not None and not lumped:
        if not isinstance(setting, str):
            raise TypeError(f'setting is the name of what the tests were set to, such as "current", not a {type(setting).__name__}')
        if family != "thesis":
            raise ValueError(f"setting fits the family thesis over the setting, not {family}; leave one of the two out")
        with needs(dimensions), watched(progress) as told:
            text, said = _native.fit_family(native_of(campaign, "campaign"), setting, wanted, words(hold_out), told, drawing)
        return FittedFamily(text, "family.toml", FamilyFitResult.from_dict(loads(said)))
    with needs(dimensions), watched(progress) as told:
        text, said, found = _native.fit(native_of(campaign, "campaign"), family, wanted, words(hold_out), told, drawing, lumped)
    chosen = [] if family == "thesis" else ["--model", family]
    if lumped:
        chosen += ["--setting", _NO_SETTING]
    made_from = origin(campaign, chosen, option("elements", wanted or ()), option("hold-out", words(hold_out)), _dimensions(drawing))
    return FittedModel(text, "damper.toml", replace(FitResult.from_dict(loads(said)), _made_from=(found, made_from)))


@overload
def diagnose(
    model: Model,
    campaign: Sequence[Record],
    reference: Sequence[Record] | None = None,
    *,
    setting: None = None,
    hold_out: Sequence[str] = (),
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    dimensions: Path | None = None,
    progress: Progress | None = None,
) -> Diagnosis: ...
@overload
def diagnose(
    model: Family,
    campaign: Sequence[Record],
    reference: Sequence[Record] | None = None,
    *,
    setting: float | None = None,
    hold_out: Sequence[str] = (),
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    dimensions: Path | None = None,
    progress: Progress | None = None,
) -> FamilyDiagnosis: ...
def diagnose(
    model: Model | Family,
    campaign: Sequence[Record],
    reference: Sequence[Record] | None = None,
    *,
    setting: float | None = None,
    hold_out: Sequence[str] = (),
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    dimensions: Path | None = None,
    progress: Progress | None = None,
) -> Diagnosis | FamilyDiagnosis:
    """Finds where a model and records disagree, and which physical effects the model lacks, like ``dashpot diagnose``.

    A :class:`Family` is diagnosed at each setting of the records.

    :param setting: setting of tests without a setting of their own, for a :class:`Family`.
    :param reference: records of the same tests on a good damper, from the same rig. The diagnosis then finds what changed. Use a reference
        if there is one, because model errors that are common to both dampers cancel.
    :param hold_out: names of tests that no refit uses; selected over all amplitudes and speeds if not given.
    :param max_effects: largest number of effects to add.
    :param candidates: effects that the diagnosis may find; all if not given.
    :param seed: seed of the selection of left-out tests.
    :param dimensions: path of a TOML file with the dimensions of the damper, like the command's ``--dimensions``. They narrow the priors.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :raises DimensionsError: if the dimensions are unusable. The message names file, line and key.
    :raises DiagnosisError: if the records cannot be diagnosed.
    """
    # The model comes first in the call, so exchanged arguments are reported for it.
    if not isinstance(model, Family):
        _check(model)
    own, good = native_of(campaign, "campaign"), None if reference is None else native_of(reference, "reference")
    drawing = None if dimensions is None else os.fspath(dimensions)
    if isinstance(model, Family):
        real("setting", setting)
        with needs(dimensions), watched(progress) as told:
            said, cycles = _native.diagnose_family(
                model._native, own, setting, good, words(hold_out), max_effects, None if candidates is None else words(candidates), seed, told, drawing
            )
        over = FamilyDiagnosis.from_dict(loads(said))
        return replace(over, settings=tuple(replace(one, _curves=tuple(of_one)) for one, of_one in zip(over.settings, cycles, strict=True)))
    if setting is not None:
        raise TypeError("setting is that of tests that say none, for a damper that depends on one; this model depends on none")
    with needs(dimensions), watched(progress) as told:
        said, improved, curves, made_from = _native.diagnose(
            model._native, own, good, words(hold_out), max_effects, None if candidates is None else words(candidates), seed, told, drawing
        )
    found = Diagnosis.from_dict(loads(said))
    compared_with = _compared_with(campaign, reference)
    came_from = origin(campaign, compared_with, option("hold-out", words(hold_out)), _dimensions(drawing), _bounds(candidates, max_effects, seed))
    return replace(found, _improved=Model(improved, "improved.toml"), _curves=tuple(curves), _made_from=(made_from, model, came_from))


def diagnose_groups(
    model: Model,
    data: Path | Sequence[Path] | Sequence[Record],
    group: str,
    reference: Path | Sequence[Path] | Sequence[Record] | None = None,
    *,
    chain: bool = False,
    max_effects: int = 3,
    candidates: Sequence[str] | None = None,
    seed: int = 0,
    progress: Progress | None = None,
    **reading: Unpack[Reading],
) -> GroupsDiagnosis:
    """Finds what changed in many dampers or settings against a reference, like ``dashpot diagnose --group``.

    :param data: paths of files or folders, or a :class:`Campaign` or some of its records.
    :param group: rule that divides the tests into groups. With ``"folders"``, every folder in ``data`` is a group. A pattern of the tests'
        names has ``{}`` for the group and ``*`` for any text, such as ``"*_c{}_*"``. A list is a CSV file with a heading, and with tests or
        folders in its first column. It is followed by the column with the groups, such as ``"tests.csv:clicks"``.
    :param reference: records of the same tests on a good damper, or their paths, which are read with the same settings as ``data``. By default,
        the first group is the reference.
    :param chain: compares each group with the preceding group, in their order. The result shows the effect of one click or one stage of wear.
    :param max_effects: largest number of effects to add.
    :param candidates: effects that the diagnosis may find; all if not given.
    :param seed: seed of the selection of tests that no refit uses.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :param reading: arguments of :meth:`Campaign.read` for reading paths.
    :raises RecordError: for the first file that is unreadable or implausible.
    :raises DiagnosisError: if the rule does not divide the tests into groups, or a group cannot be diagnosed.

    >>> found = diagnose_groups(model, "fleet/", "folders", reference="good/")  # doctest: +SKIP
    >>> found["sn17"].summary  # doctest: +SKIP
    """
    _check(model)
    if not isinstance(group, str):
        raise TypeError(f'group is a text such as "folders", "*_c{{}}_*" or "tests.csv:clicks", not a {type(group).__name__}')
    if _are_records(data):
        if reading:
            raise TypeError(f"{', '.join(reading)}: the records of data are read already; give paths, or these arguments to dashpot.Campaign.read")
        read_by = data._reading if isinstance(data, Campaign) else None
    else:
        read_by = how(**reading)
    own, named = _data("data", data)
    if group == "folders" and not own["paths"]:
        raise ValueError("group: these records are of no folder that could be looked into; give the path that has a folder for each damper")
    good, called = (None, "") if reference is None else _data("reference", reference)
    # If only the reference is read now, it uses the settings of the campaign in `data`, or the defaults without such settings.
    reads = read_by or how(**reading)
    paths = [*own["paths"], *(good["paths"] if good else ())]
    with watched(progress) as told, needs(*paths):
        said, notes, cycles, made_from = _native.diagnose_groups(
            model._native,
            {"data": own, "by": group, "reference": good, "reference_name": called, "chain": chain, "mapping": reads.mapping, "strict": reads.strict},
            max_effects,
            None if candidates is None else words(candidates),
            seed,
            told,
        )
    found = GroupsDiagnosis.from_dict(loads(said))
    answers = tuple(replace(one, diagnosis=replace(one.diagnosis, _curves=tuple(of_one))) for one, of_one in zip(found.groups, cycles, strict=True))
    noticed = tuple(Note.from_dict(note) for note in loads(notes))
    arguments: tuple[str, ...] | None = None
    if read_by is not None and (good is None or _read_by(reference, read_by)):
        compared_with = [word for path in (good["paths"] if good else ()) for word in ("--reference", path)]
        arguments = (*own["paths"], *read_by.options, "--group", group, *(("--chain",) if chain else ()), *compared_with, *_bounds(candidates, max_effects, seed))
    return replace(found, groups=answers, notes=noticed, _made_from=(made_from, model, Origin(named, arguments)))


def _check(model: object) -> None:
    if isinstance(model, Family):
        raise TypeError("model depends on a setting; give the damper at one, model.at(setting), with its records, or the family to dashpot.diagnose")
    if not isinstance(model, Model):
        raise TypeError(f"model is a dashpot.Model, not a {type(model).__name__}; dashpot.Model.read(path) reads one")


def _bounds(candidates: Sequence[str] | None, max_effects: int, seed: int) -> list[str]:
    """Returns the options of the command for the candidates, the number of effects and the seed. Defaults are omitted."""
    numbers = [("--max-effects", max_effects, 3), ("--seed", seed, 0)]
    return option("candidates", words(candidates or ())) + [word for name, value, usual in numbers if value != usual for word in (name, str(value))]


def _are_records(data: object) -> bool:
    return isinstance(data, Campaign) or (isinstance(data, (list, tuple)) and any(isinstance(one, Record) for one in data))


def _data(name: str, data: Path | Sequence[Path] | Sequence[Record]) -> tuple[Data, str]:
    """Returns records in the form that the extension module accepts, and their name in reports."""
    if not _are_records(data):
        paths = paths_of(name, data)
        return {"paths": paths, "read": None}, ", ".join(paths)
    records: Sequence[Record] = data  # type: ignore[assignment]
    # Part of a campaign has no path of its own.
    if isinstance(records, Campaign) and records.paths:
        return {"paths": list(records.paths), "read": records._native}, ", ".join(records.paths)
    return {"paths": [], "read": native_of(records, name)}, several([record.name for record in records])


def _read_by(reference: object, read_by: How) -> bool:
    """Returns whether the command reads the reference with the same settings as the groups. It has only one set of reading options."""
    return not _are_records(reference) or (isinstance(reference, Campaign) and reference._reading == read_by)


def _compared_with(campaign: Sequence[Record], reference: Sequence[Record] | None) -> list[str] | None:
    """Returns the option of the command for the reference, or None if the command cannot read the same records.

    The command reads campaign and reference with the same settings.
    """
    if reference is None:
        return []
    if not (isinstance(reference, Campaign) and isinstance(campaign, Campaign) and reference._reading == campaign._reading):
        return None
    return [word for path in reference.paths for word in ("--reference", path)]
