"""dashpot: a suspension damper identified from rig records once, run as the same code everywhere.

>>> import dashpot                                          # doctest: +SKIP
>>> campaign = dashpot.Campaign.read("campaign/")           # doctest: +SKIP
>>> model = dashpot.fit(campaign)                           # doctest: +SKIP
>>> model.validate(campaign).overall.error_percent          # doctest: +SKIP
>>> model.simulate(t, displacement_m=x).force               # doctest: +SKIP
>>> model.write("damper.toml")                              # doctest: +SKIP

SI units; extension (rebound) velocity and tension force are positive everywhere. What the package says has the same digits and
the same sentences as the command ``dashpot``. Long work gives the interpreter's lock back, so threads run beside it; it uses
all processors unless :func:`set_threads` says otherwise, and Ctrl-C or an exception of a ``progress`` function ends it. Campaigns, models
and results go through ``pickle``, so that they can be handed to other processes.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from ._native import (
    DashpotError,
    DiagnosisError,
    DimensionsError,
    ExportError,
    FitError,
    ModelError,
    MotionError,
    OutputError,
    RecordError,
    RigError,
    StepError,
    ValidationError,
    set_threads,
)
from ._native import VERSION as __version__
from .adams import export_adm
from .campaign import Campaign, Record
from .damper import Damper
from .explanation import explain
from .family import Family, FittedFamily
from .identification import diagnose, diagnose_groups, fit
from .limits import Limit, Limits, read_limits
from .literature import LiteratureModel, fit_literature
from .model import FittedModel, Model, Parameter, Response
from .rig import measure_virtual, write_test_matrix
from .results import Certificate, Diagnosis, Explanation, FamilyDiagnosis, FamilyFitResult, FitResult, GroupsDiagnosis, HostCheck, JudgedValidation, Validation

if TYPE_CHECKING:
    from . import plot as plot

__all__ = [
    "Campaign",
    "Certificate",
    "Damper",
    "DashpotError",
    "Diagnosis",
    "DiagnosisError",
    "DimensionsError",
    "Explanation",
    "ExportError",
    "Family",
    "FamilyDiagnosis",
    "FamilyFitResult",
    "FitError",
    "FitResult",
    "FittedFamily",
    "FittedModel",
    "GroupsDiagnosis",
    "HostCheck",
    "JudgedValidation",
    "Limit",
    "Limits",
    "LiteratureModel",
    "Model",
    "ModelError",
    "MotionError",
    "OutputError",
    "Parameter",
    "Record",
    "RecordError",
    "Response",
    "RigError",
    "StepError",
    "Validation",
    "ValidationError",
    "__version__",
    "diagnose",
    "diagnose_groups",
    "explain",
    "export_adm",
    "fit",
    "fit_literature",
    "measure_virtual",
    "read_limits",
    "set_threads",
    "write_test_matrix",
]


def __getattr__(name: str) -> Any:
    """What takes long to import, or needs other packages, comes when it is asked for."""
    if name in ("fleet", "plot"):
        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, "fleet", "plot"})
