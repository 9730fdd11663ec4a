"""All result classes: dataclasses with the keys of the command's JSON.

SI units; extension (rebound) velocity and tension force are positive everywhere.
"""

from __future__ import annotations

from ._result import Result
from .reading import Delay, Noise, Note, SignFinding, Unusable
from .fitted import Estimate, FitResult, InventoryItem, Measured
from .certificate import Certificate, Checked, LimitValue, PeakPoint
from .host import HostCheck
from .validation import (
    Against, AgainstSummary, AgainstTest, Deviation, ErrorMatrix, Errors, GapBin, Hysteresis, JudgedValidation, MatrixCell, MatrixRow, OfEach,
    PeakForce, ResponseTimes, SettingDoubt, SettingSummary, StepGroup, StepResponse, Summary, TestValidation, TimeUncertainty, Validation,
)
from .diagnosis import (
    Branch, Change, CouldNotTest, Diagnosis, Evidence, Figures, Finding, Findings, NextTest,
    OverWholeRecords, Region, Rival, Shift, TestOutcome, Tried, Value,
)
from .diagnosis_settings import ChangeAtSetting, ChangeOverSettings, EffectAtSetting, EffectOverSettings, FamilyDiagnosis, SettingDiagnosis
from .explanation import Contradiction, Explanation, Gap, Quantity
from .family_fit import ActuatorDecision, ActuatorFit, FamilyEstimate, FamilyFitResult, FamilyItem, ForceAtSetting, SettingAxis, SettingDependence, SettingError, SettingReport
from .groups import Group, GroupsDiagnosis
from .literature import LiteratureModel

__all__ = [
    "ActuatorDecision", "ActuatorFit", "Against", "AgainstSummary", "AgainstTest", "Branch", "Certificate", "Change", "ChangeAtSetting", "ChangeOverSettings", "Checked", "Contradiction", "CouldNotTest", "Delay", "Deviation", "Diagnosis", "EffectAtSetting", "EffectOverSettings", "ErrorMatrix", "Errors", "Estimate",
    "Evidence", "Explanation", "FamilyDiagnosis", "FamilyEstimate", "FamilyFitResult", "FamilyItem", "Figures", "Finding", "Findings", "FitResult", "ForceAtSetting", "Gap", "GapBin", "Group", "GroupsDiagnosis", "HostCheck", "Hysteresis", "InventoryItem", "JudgedValidation", "LimitValue", "LiteratureModel", "MatrixCell", "MatrixRow", "Measured", "NextTest",
    "Noise", "Note", "OfEach", "OverWholeRecords", "PeakForce", "PeakPoint", "Quantity", "Region", "ResponseTimes", "Result", "Rival", "SettingAxis", "SettingDependence", "SettingDiagnosis", "SettingDoubt", "SettingError", "SettingReport", "SettingSummary", "Shift", "SignFinding", "StepGroup", "StepResponse", "Summary", "TestOutcome", "TimeUncertainty", "Unusable",
    "TestValidation", "Tried", "Validation", "Value",
]
