"""From records to a model, and what a model lacks."""

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


def _dimensions(path: str | None) -> list[str]:
    """The option of the command that names a file of dimensions; nothing without one."""
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
    """Identifies a damper from records; as ``dashpot fit``.

    FV curve from the peak velocities, friction and gas force from the slow tests, everything refined together; the variants of
    friction, springs, the series path and measurement errors are chosen by one search over structures. ``model.fit`` holds the estimates with their 95 % intervals.

    :param campaign: a :class:`Campaign`, part of one (``campaign[2:]``), or some of its records: ``[r for r in campaign if r.peak_velocity < 0.6]``.
    :param setting: what the tests were set to: ``"current"``, ``"clicks"``, or the name in ``campaign.toml``. One damper over it is fitted, a :class:`FittedFamily`.
    :param family: ``"thesis"``; or, to compare with, ``"fv"`` (plain FV curve), ``"piecewise"``, ``"lag"``. The other models of the literature,
        which no host runs, are identified by :func:`fit_literature`.
    :param elements: elements that the fit may use; all of the model's if not given.
    :param hold_out: names of tests to leave out; ``*`` matches any text.
    :param dimensions: path of a TOML file with the dimensions of the damper, which make priors of what follows from them; the command's ``--dimensions``.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :raises DimensionsError: if the dimensions are unusable. The message names file, line and key.
    :raises FitError: where no model can be fitted to these records.
    """
    wanted = None if elements is None else words(elements)
    drawing = None if dimensions is None else os.fspath(dimensions)
    if setting is not None:
        if not isinstance(setting, str):
            raise TypeError(f'setting is the name of what the tests were set to, such as "current", not a {type(setting).__name__}')
        if family != "thesis":
            raise ValueError(f"setting fits the family thesis over the setting, not {family}; leave one of the two out")
        with needs(dimensions), watched(progress) as told:
            text, said = _native.fit_family(native_of(campaign, "campaign"), setting, wanted, words(hold_out), told, drawing)
        return FittedFamily(text, "family.toml", FamilyFitResult.from_dict(loads(said)))
    with needs(dimensions), watched(progress) as told:
        text, said, found = _native.fit(native_of(campaign, "campaign"), family, wanted, words(hold_out), told, drawing)
    chosen = [] if family == "thesis" else ["--model", family]
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
    """Says where a model and records disagree, and which physical effect is missing; as ``dashpot diagnose``.

    A :class:`Family` is diagnosed at each setting of the records.

    :param setting: that of tests that say none, for a :class:`Family`.
    :param reference: records of the same tests on a damper known to be good, on the same rig. The question is then what
        changed, and what the model's form leaves on both dampers alike is taken out of it: the surest way wherever there is one.
    :param hold_out: tests that no refit sees, by name; chosen over all amplitudes and speeds if not given.
    :param max_effects: most effects to add.
    :param candidates: effects that may be named; all if not given.
    :param seed: chooses which tests are left out.
    :param dimensions: path of a TOML file with the dimensions of the damper, which narrow the priors; the command's ``--dimensions``.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :raises DimensionsError: if the dimensions are unusable. The message names file, line and key.
    :raises DiagnosisError: where there is nothing to look at.
    """
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
    _check(model)
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
    """Says of many dampers or settings at once what changed against the same reference; as ``dashpot diagnose --group``.

    :param data: paths of files or folders, or a :class:`Campaign` or some of its records.
    :param group: what tells the groups apart. ``"folders"``: every folder in ``data`` is one. Or a pattern of the tests' names with ``{}`` where the
        group stands and ``*`` for anything, such as ``"*_c{}_*"``. Or a list (CSV with a heading, tests or folders in its first column) and the
        column that tells them apart, such as ``"tests.csv:clicks"``.
    :param reference: records of the same tests on a damper known to be good, or paths of theirs, which are read as ``data`` are; the first of the
        groups if not given.
    :param chain: compares each group with the one before it, in their order: what one click of an adjuster, or one stage of wear, changes.
    :param max_effects: most effects to add.
    :param candidates: effects that may be named; all if not given.
    :param seed: chooses which tests no refit sees.
    :param progress: function that receives the completed fraction, 0 to 1, and a description of the current work.
    :param reading: how paths are read: arguments of :meth:`Campaign.read`.
    :raises RecordError: for the first file that cannot be read or trusted.
    :raises DiagnosisError: where the data are not split so, or a group cannot be diagnosed.

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
    # Only what is read now needs to know how, and a reference alone is read as it stands.
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
    """The options of the command that say what a diagnosis may do."""
    numbers = [("--max-effects", max_effects, 3), ("--seed", seed, 0)]
    return option("candidates", words(candidates or ())) + [word for name, value, usual in numbers if value != usual for word in (name, str(value))]


def _are_records(data: object) -> bool:
    return isinstance(data, Campaign) or (isinstance(data, (list, tuple)) and any(isinstance(one, Record) for one in data))


def _data(name: str, data: Path | Sequence[Path] | Sequence[Record]) -> tuple[Data, str]:
    """Records as the compiled part takes them, and what they are called."""
    if not _are_records(data):
        paths = paths_of(name, data)
        return {"paths": paths, "read": None}, ", ".join(paths)
    records: Sequence[Record] = data  # type: ignore[assignment]
    # Part of a campaign is no path that could be read.
    if isinstance(records, Campaign) and records.paths:
        return {"paths": list(records.paths), "read": records._native}, ", ".join(records.paths)
    return {"paths": [], "read": native_of(records, name)}, several([record.name for record in records])


def _read_by(reference: object, read_by: How) -> bool:
    """Whether the command reads the reference of groups so, as it reads the others."""
    return not _are_records(reference) or (isinstance(reference, Campaign) and reference._reading == read_by)


def _compared_with(campaign: Sequence[Record], reference: Sequence[Record] | None) -> list[str] | None:
    """The option of the command that names the reference; none where it does not read those records, which it reads as it reads the others."""
    if reference is None:
        return []
    if not (isinstance(reference, Campaign) and isinstance(campaign, Campaign) and reference._reading == campaign._reading):
        return None
    return [word for path in reference.paths for word in ("--reference", path)]
