"""Dampers of a compiled Adams Car model."""

from __future__ import annotations

import os
from collections.abc import Mapping

from . import _native
from ._arguments import as_arguments
from ._files import needs
from ._numbers import length_of
from .campaign import Path


def export_adm(
    source: Path,
    path: Path,
    dampers: Mapping[str, float | str | tuple[float | str, Path]],
    *,
    model_file: Path = "damper.toml",
    replace_preload: bool = False,
    force: bool = False,
) -> list[str]:
    """Writes a compiled Adams Car model (``.adm``) with dampers replaced, leaving every other byte alone; as ``dashpot export adm``.

    >>> export_adm("car.adm", "car_dashpot.adm", {"SFORCE/12": ("412.5mm", "front.toml"), "SFORCE/14": ("388mm", "rear.toml")})  # doctest: +SKIP

    :param source: the compiled model.
    :param path: where to write.
    :param dampers: by the name of the damper's SFORCE, or ``SFORCE/id``: its length at zero displacement, a number in the unit of the model
        (UNITS) or a text with its own (``"412.5mm"``, ``"0.4125m"``); or that length with its model file where that is not ``model_file``.
    :param model_file: path of the model file as the solver will find it.
    :param replace_preload: replace also a force at rest (a constant beside the spline): the model file holds it as its gas force.
    :param force: also over a file of another kind, or a write-protected one; the command's ``--force``.
    :returns: what is to be known of it, in sentences.
    :raises ExportError: where a damper is not found, is none, or has a length that no damper has.
    :raises OutputError: where it cannot be written, or would take another file's place.
    """
    if not dampers:
        raise ValueError("dampers is empty; name the SFORCE of at least one damper with its length")
    rows = []
    for name, given in dampers.items():
        length, of_it = given if isinstance(given, tuple) else (given, model_file)
        rows.append((name, length_of(f"the length of {name}", length), os.fspath(of_it)))
    with needs(source):
        return [as_arguments(note) for note in _native.export_adm(os.fspath(source), os.fspath(path), rows, replace_preload, force)]
