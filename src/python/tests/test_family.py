"""A damper that depends on a setting."""

from pathlib import Path

import numpy as np
import pytest

import dashpot

FILE = Path(__file__).resolve().parents[3] / "examples/semi_active.toml"


def test_a_family_at_a_setting_is_an_ordinary_damper() -> None:
    family = dashpot.Family.read(FILE)
    assert (family.name, family.unit, family.start) == ("current", "A", 0.6)
    assert list(family.grid) == [0.0, 0.4, 0.8, 1.2, 1.6]
    forces = [family.at(setting).steady_force([0.2])[0] for setting in np.linspace(0.0, 1.6, 33)]
    assert np.all(np.diff(forces) > 0.0)
    t = np.linspace(0.0, 1.0, 1001)
    x = 0.02 * np.sin(10.0 * t)
    constant = family.simulate(t, x, setting=0.8).force
    # The hysteresis of the valve is nothing at a setting that was always there.
    assert np.allclose(constant, family.at(0.8).simulate(t, x).force, rtol=0.0, atol=1e-6 * np.max(np.abs(constant)))
    stepped = family.simulate(t, x, setting=np.where(t < 0.5, 0.8, 1.6)).force
    assert np.array_equal(stepped[:500], constant[:500]) and np.max(np.abs(stepped[520:] - constant[520:])) > 100.0


def test_an_ordinary_model_is_no_family_and_the_other_way_round() -> None:
    with pytest.raises(dashpot.ModelError, match="setting"):
        dashpot.Model.read(FILE)
    ordinary = 'format = 1\nelements = ["fv_curve"]\n'
    with pytest.raises(dashpot.ModelError, match="setting"):
        dashpot.Family(ordinary)
    family = dashpot.Family.read(FILE)
    with pytest.raises(ValueError, match="setting"):
        family.simulate([0.0, 1.0], [0.0, 0.01], setting=[0.0, np.nan])
