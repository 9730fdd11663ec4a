"""A mass on a spring and a dashpot damper in Drake (PyPI). The damper is a LeafSystem whose states are continuous states of Drake, and Drake's
error-controlled integrator integrates all of them. The state of the internal mass is its deflection from the moving end.

    python examples/drake_drop.py target/release/libdashpot.so demo/damper.toml

Prints time (s), position (m) and damper force (N) every 10 ms."""
import sys

from dashpot_damper import Damper, State
from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator
from pydrake.systems.framework import LeafSystem

MASS, STIFFNESS, DROP, END = 100.0, 24000.0, 0.03, 1.0


class Drop(LeafSystem):
    """States: position and velocity of the mass; deflection and velocity of the internal mass; eight internal states of the elements."""

    def __init__(self, damper):
        super().__init__()
        self.damper, self.rest = damper, damper.rest(0.0)
        damper.rest(DROP)
        self.DeclareContinuousState(12)

    def asked(self, x):
        state = State(x[0], x[1], x[0] + x[2], x[3])
        state.internal[:] = x[4:]
        return self.damper.evaluate(state, x[0], x[1])

    def start(self):
        settled = self.damper.state
        return [DROP, 0.0, settled.mass_displacement - settled.displacement, settled.mass_velocity, *settled.internal]

    def DoCalcTimeDerivatives(self, context, derivatives):
        x = context.get_continuous_state_vector().CopyToVector()
        force, rate = self.asked(x)
        pull = STIFFNESS * x[0] + force - self.rest
        derivatives.SetFromVector(
            [x[1], -pull / MASS, rate.mass_displacement - x[1], rate.mass_velocity, *rate.internal])


drop = Drop(Damper(sys.argv[1], sys.argv[2], DROP))
simulator = Simulator(drop)
simulator.get_mutable_context().SetContinuousState(drop.start())
ResetIntegratorFromFlags(simulator, "implicit_euler", 1e-3)
integrator = simulator.get_mutable_integrator()
integrator.set_target_accuracy(1e-6)
simulator.Initialize()
for k in range(1, round(END / 0.01) + 1):
    simulator.AdvanceTo(0.01 * k)
    x = simulator.get_context().get_continuous_state_vector().CopyToVector()
    print(f"{0.01 * k:.3f} {x[0]:.9g} {drop.asked(x)[0]:.9g}")
