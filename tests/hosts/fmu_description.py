"""Prints the description of an FMU and the messages of its validation as JSON. Argument: FMU."""
import json
import sys
import zipfile
from xml.etree import ElementTree

from fmpy import read_model_description
from fmpy.validation import validate_fmu

description = read_model_description(sys.argv[1])
xml = ElementTree.fromstring(zipfile.ZipFile(sys.argv[1]).read("modelDescription.xml"))
capabilities = ("canHandleVariableCommunicationStepSize", "canGetAndSetFMUstate", "canSerializeFMUstate",
                "providesDirectionalDerivative", "canBeInstantiatedOnlyOncePerProcess", "needsExecutionTool")
print(json.dumps({
    "messages": validate_fmu(sys.argv[1]),
    "version": description.fmiVersion,
    "kinds": {
        # FMI 3.0 spells some capabilities differently.
        name: {c: any(xml.find(tag).get(s) == "true" for s in (c, c + "s", c.replace("FMUstate", "FMUState"))) for c in capabilities}
        for name, tag in (("cs", "CoSimulation"), ("me", "ModelExchange"))},
    "states": description.numberOfContinuousStates,
    "units": [u.name for u in description.unitDefinitions],
    "variables": {
        v.name: {
            "type": v.type, "causality": v.causality, "variability": v.variability, "start": v.start, "min": v.min,
            "max": v.max, "unit": v.unit, "description": v.description,
            "items": [i.name for i in v.declaredType.items] if v.declaredType is not None else []}
        for v in description.modelVariables},
    "files": zipfile.ZipFile(sys.argv[1]).namelist(),
}))
