"""Runs an exported FMU 2.0 in libcosim, the co-simulation host of the Open Simulation Platform: see beside_library.py."""
from beside_library import STEP, STEPS, compare, fmu
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave
from sine import motion


def of_host(test):
    execution = CosimExecution.from_step_size(step_size=round(1e9 * STEP))  # in nanoseconds
    damper = execution.add_local_slave(CosimLocalSlave(fmu_path=fmu, instance_name="front_left"))
    reference = {v.name.decode(): v.reference for v in execution.slave_variables(damper)}
    place = [reference["displacement"], reference["velocity"]]
    for number, value in zip(place, motion(*test, 0.0)):
        execution.real_initial_value(damper, number, value)
    hand, eye = CosimManipulator.create_override(), CosimObserver.create_last_value()
    execution.add_manipulator(hand)
    execution.add_observer(eye)
    forces = []
    for k in range(STEPS):
        hand.slave_real_values(damper, place, motion(*test, (k + 1) * STEP))
        assert execution.step(), f"step {k}"
        forces.append(eye.last_real_values(damper, [reference["force"]])[0])
    return forces


compare(of_host, 1e-6)
