"""Sets the numbers of a curve one by one, so that they are inconsistent in between. Argument: an FMU of either version, with one corner or four.

Checks what the FMU's page states. Each number is stored as it is set. The set is checked by the first call that would use it. This call returns
an error, whose message names corner, parameter and numbers, and changes nothing. With consistent numbers the run continues."""
import shutil
import sys
from ctypes import c_double, c_size_t

from fmu_bare import ERROR, OK, Damper, Fmu

fmu = Fmu(sys.argv[1])
check = fmu.check
four = "L1.motion_scale" in fmu.reference
prefix, velocity, force = ("R2.", "Damper_Jounce_Rate_R2", "Damper_Force_R2") if four else ("", "velocity", "force")
one, two = prefix + "fv_force[3]", prefix + "fv_force[4]"


def told(what, parameter=prefix + "fv_force ", numbers="fv_force[3] = 5000, fv_force[4] = 4"):
    """Checks that one message was logged for a rejected call, and clears it."""
    check(len(fmu.said) == 1, f"{what}: one message")
    text = fmu.said.pop()
    for words in (parameter, numbers, "do not fit together", "set numbers that fit"):
        check(words in text, f"{what} does not say {words!r}: {text}")


def moved(damper, k):
    """Makes one step of a motion. Returns its status."""
    damper.real(velocity, 0.3 if k % 20 < 10 else -0.3)
    return damper.step(1e-3 * k, 1e-3)


def begun(exchange=False):
    damper = Damper(fmu, fmu.resources, exchange=exchange)
    check(damper.begin() == OK and damper.call("ExitInitializationMode") == OK, "begun")
    fmu.said.clear()
    return damper


# During a run: the force is kept, and steps are errors until the set is consistent. Then the run continues as if nothing had been tried.
tried, plain = begun(), begun()
for k in range(15):
    check(moved(tried, k) == OK and moved(plain, k) == OK, "a step")
usual, after = tried.real(one), tried.real(two)
check(usual < after < 500.0, f"the curve that this test was written for: {usual}, {after}")
tried.real(one, 5000.0)
before = tried.real(force)
for _ in range(3):
    check(tried.real(one) == 5000.0, "a number is kept as it is written")
    check(moved(tried, 15) == ERROR, "a step with a curve that falls")
    told("a step")
check(tried.real(force) == before, "a refused step moves the force")
tried.real(one, usual)
for k in range(15, 40):
    check(moved(tried, k) == OK and moved(plain, k) == OK, "a step")
    check(tried.real(force) == plain.real(force), "a refused step has left something behind")
# Raising the following number makes the set consistent, too. All later numbers must also rise, so all are set.
count = sum(name.startswith(prefix + "fv_force[") for name in fmu.reference)
tried.real(one, 5000.0)
check(moved(tried, 40) == ERROR, "a curve that falls")
fmu.said.clear()
for k in range(4, count + 1):
    tried.real(f"{prefix}fv_force[{k}]", 5000.0 + k)
check(moved(tried, 40) == OK and not fmu.said, "raised as a whole, it fits")
# A number outside its bounds is rejected at once.
check(tried.asked(one, 1e12)[0] == ERROR and tried.real(one) == 5000.0, "a number outside its bounds")
fmu.said.clear()
# A reset restores the start values.
tried.real(one, 9000.0)
check(moved(tried, 41) == ERROR, "a curve that falls")
fmu.said.clear()
check(tried.call("Reset") == OK and tried.real(one) == usual, "a reset")
check(tried.begin() == OK, "begun again")

# In initialization mode: all set numbers can be read. Outputs and the end of the mode are errors until the set is consistent.
tried.real(one, 5000.0)
check(tried.real(one) == 5000.0 and not fmu.said, "a number is read back while others do not fit")
check(tried.asked(force)[0] == ERROR, "an output of a set that does not fit")
told("an output")
check(tried.call("ExitInitializationMode") == ERROR, "the end of the initialization mode")
told("the end of the initialization mode")
tried.real(one, usual)
check(tried.call("ExitInitializationMode") == OK and moved(tried, 0) == OK, "numbers that fit lead on")

# Velocities of a curve must increase.
tried.real(prefix + "fv_velocity[3]", 5.0)
check(moved(tried, 1) == ERROR, "velocities that fall")
told("velocities", prefix + "fv_velocity ", "fv_velocity[3] = 5, fv_velocity[4] = ")
for damper in (tried, plain):
    damper.free()

# In model exchange, the set is checked at the end of event mode.
damper = begun(exchange=True)
damper.real(one, 5000.0)
check(damper.call("EnterContinuousTimeMode") == ERROR, "the end of event mode")
told("the end of event mode")
damper.real(one, usual)
rates = (c_double * fmu.description.numberOfContinuousStates)()
count = c_size_t(len(rates))
check(damper.discrete_states() == OK and damper.call("EnterContinuousTimeMode") == OK, "numbers that fit lead on")
name = "GetContinuousStateDerivatives" if fmu.three else "GetDerivatives"
check(damper.call(name, rates, count) == OK and not fmu.said, "rates")
damper.free()
shutil.rmtree(fmu.folder)
