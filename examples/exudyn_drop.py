"""A mass on a spring and a dashpot damper in exudyn (PyPI), an implicit multibody solver. The damper is a user function of a SpringDamper. Newton's
method evaluates it any number of times within a step, and it advances at the end of the step.

    python examples/exudyn_drop.py target/release/libdashpot.so demo/damper.toml

Prints time (s), position (m) and damper force (N) every 10 ms."""
import sys

import exudyn as exu
from dashpot_damper import Damper
from exudyn.utilities import CoordinateSpringDamper, MarkerNodeCoordinate, Mass1D, Node1D, NodePointGround

MASS, STIFFNESS, DROP, STEP, END = 100.0, 24000.0, 0.03, 1e-3, 1.0

damper = Damper(sys.argv[1], sys.argv[2], DROP)
rest = damper.rest(0.0)
damper.rest(DROP)
container = exu.SystemContainer()
system = container.AddSystem()
node = system.AddNode(Node1D(referenceCoordinates=[0.0], initialCoordinates=[DROP], initialVelocities=[0.0]))
system.AddObject(Mass1D(nodeNumber=node, mass=MASS))
ground = system.AddNode(NodePointGround())
ends = [system.AddMarker(MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, node)]
last = [0.0]


def force(system, t, item, u, v, *given):
    """Returns the force that pulls the mass back, N. The spring's preload balances the static force of the damper."""
    dt = max(t - last[0], 0.0)
    return STIFFNESS * u + damper.try_step(u, v, dt)[0] - rest


def commit(system, t):
    u = system.GetNodeOutput(node, exu.OutputVariableType.Coordinates)
    v = system.GetNodeOutput(node, exu.OutputVariableType.Coordinates_t)
    told = damper.step(float(u), float(v), t - last[0])
    last[0] = t
    if round(t / STEP) % 10 == 0:
        print(f"{t:.3f} {float(u):.9g} {told:.9g}")
    return True


system.AddObject(CoordinateSpringDamper(markerNumbers=ends, springForceUserFunction=force))
system.Assemble()
system.SetPostStepUserFunction(commit)
settings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = round(END / STEP)
settings.timeIntegration.endTime = END
settings.timeIntegration.verboseMode = 0
settings.timeIntegration.newton.useModifiedNewton = False
settings.solution.file.write = False
system.SolveDynamic(settings)
