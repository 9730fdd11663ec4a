"""Makes and initializes one instance of an FMU in FMPy, of either version and kind."""
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave


def begun(description, folder, exchange, prepare=lambda fmu: None):
    """Returns an initialized instance, for model exchange if `exchange`, else for co-simulation. `prepare` sets values before initialization."""
    three = description.fmiVersion.startswith("3")
    kind = {(False, False): FMU2Slave, (False, True): FMU2Model, (True, False): FMU3Slave, (True, True): FMU3Model}
    face = description.modelExchange if exchange else description.coSimulation
    fmu = kind[three, exchange](
        guid=description.guid, unzipDirectory=folder, modelIdentifier=face.modelIdentifier, instanceName="damper")
    fmu.instantiate()
    prepare(fmu)
    if three:
        fmu.enterInitializationMode(startTime=0.0)
    else:
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    if exchange:
        fmu.updateDiscreteStates() if three else fmu.newDiscreteStates()
        fmu.enterContinuousTimeMode()
    return fmu
