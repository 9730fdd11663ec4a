"""Replacement of dampers in a compiled Adams Car model."""

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
    """Writes a compiled Adams Car model (``.adm``) with replaced dampers, like ``dashpot export adm``. All other bytes stay unchanged.

    >>> export_adm("car.adm", "car_dashpot.adm", {"SFORCE/12": ("412.5mm", "front.toml"), "SFORCE/14": ("388mm", "rear.toml")})  # doctest: +SKIP

    :param source: path of the compiled model.
    :param path: path of the output.
    :param dampers: for each damper, by the name of its SFORCE or by ``SFORCE/id``: its length at zero displacement. The length is a number in
        the unit of the model (UNITS), or a text with a unit (``"412.5mm"``, ``"0.4125m"``). A damper with another model file than
        ``model_file`` has a tuple of its length and the path of its model file.
    :param model_file: path of the model file from which the solver reads it.
    :param replace_preload: replaces also a force at rest, which is a constant in addition to the spline. The model file must contain it as
        gas force.
    :param force: also replaces a file of another kind or a write-protected file, like the command's ``--force``.
    :returns: notes on the export.
    :raises ExportError: if an SFORCE is not found, is no damper, or has an implausible length.
    :raises OutputError: if the output cannot be written, or would replace another file.
    """
    if not dampers:
        raise ValueError("dampers is empty; name the SFORCE of at least one damper with its length")
    rows = []
    for name, given in dampers.items():
        length, of_it = given if isinstance(given, tuple) else (given, model_file)
        rows.append((name, length_of(f"the length of {name}", length), os.fspath(of_it)))
    with needs(source):
        return [as_arguments(note) for note in _native.export_adm(os.fspath(source), os.fspath(path), rows, replace_preload, force)]
