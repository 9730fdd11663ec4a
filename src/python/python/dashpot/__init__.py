"""dashpot identifies a suspension damper from rig records, and simulates it with the same code in every host.

>>> import dashpot                                          # doctest: +SKIP
>>> campaign = dashpot.Campaign.read("campaign/")           # doctest: +SKIP
>>> model = dashpot.fit(campaign)                           # doctest: +SKIP
>>> model.validate(campaign).overall.error_percent          # doctest: +SKIP
>>> model.simulate(t, displacement_m=x).force               # doctest: +SKIP
>>> model.write("damper.toml")                              # doctest: +SKIP

All values are in SI units; extension (rebound) velocity and tension force are positive everywhere. Results have the same digits and
the same sentences as those of the command ``dashpot``. Long work releases the interpreter lock, so that other threads can run. It uses
all processors unless :func:`set_threads` limits their number. Ctrl-C or an exception of a ``progress`` function stops it. Campaigns, models
and results can be pickled, so that other processes can receive them.
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
    """Imports the submodules ``fleet`` and ``plot`` at first access, because they are slow to import or require other packages."""
    if name in ("fleet", "plot"):
        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*__all__, "fleet", "plot"})
