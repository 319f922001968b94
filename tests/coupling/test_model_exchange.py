"""What a master that linearises gets from the model exchange archive: the matrices of `flexair linearise`.

The archive lies beside the FMU: as in conftest.py.
"""

import ctypes
import os
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Model

ROOT = Path(__file__).parents[2]
LEFT_OUT = {"position.north", "position.east", "attitude.yaw"}


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    """An instance, ready to be integrated, and the references of its variables by their names."""
    fmu = Path(os.environ.get("FMU", ROOT / "target/fmu/FlexibleAircraft.fmu")).with_name("FlexibleAircraft.me.fmu")
    description = fmpy.read_model_description(str(fmu))
    folder = fmpy.extract(str(fmu), tmp_path_factory.mktemp("exchange"))
    identifier = description.modelExchange.modelIdentifier
    instance = FMU2Model(guid=description.guid, unzipDirectory=folder, modelIdentifier=identifier, instanceName="a")
    instance.instantiate()
    instance.setupExperiment()
    instance.enterInitializationMode()
    instance.exitInitializationMode()
    instance.enterContinuousTimeMode()
    yield instance, {variable.name: variable.valueReference for variable in description.modelVariables}
    instance.terminate()
    instance.freeInstance()


def jacobian(instance, unknowns, knowns):
    """A column for each known."""
    columns = [instance.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]
    return np.array(columns).T


@pytest.fixture(scope="module")
def linear(linearise, tmp_path_factory):
    folder = tmp_path_factory.mktemp("linear")
    linearise("--format", "npz", "--output", folder)
    with np.load(folder / "generic-business-jet-linear.npz") as arrays:
        return dict(arrays)


def test_the_jacobian_is_what_flexair_linearise_writes(model, linear):
    """Over states, inputs and outputs that both have; position north and east and yaw are no states of the linear model."""
    instance, references = model
    states, inputs = list(map(str, linear["x_names"])), list(map(str, linear["u_names"]))
    kept = [i for i, name in enumerate(map(str, linear["y_names"])) if name not in LEFT_OUT]
    outputs = [str(linear["y_names"][i]) for i in kept]
    assert len(states) > 500 and len(outputs) > 150
    unknowns = [references[f"der({name})"] for name in states] + [references[name] for name in outputs]
    rates = [name.replace("wind_", "wind_rate_") for name in inputs if name.startswith("wind_")]
    winds = [i for i, name in enumerate(inputs) if name.startswith("wind_")]
    for knowns, of_rates, of_outputs in [
        (states, linear["A"], linear["C"]),
        (inputs, linear["B"], linear["D"]),
        (rates, linear["Bd"][:, winds], linear["Dd"][:, winds]),
    ]:
        found = jacobian(instance, unknowns, [references[name] for name in knowns])
        expected = np.vstack([of_rates, of_outputs[kept]])
        largest = np.abs(expected).max(axis=1, keepdims=True)
        deviation = np.abs(found - expected)
        assert (deviation <= 1e-8 * largest + 1e-14).all(), (deviation / np.maximum(largest, 1e-300)).max()


def test_states_and_their_rates_are_those_of_the_trim(model, linear):
    instance, references = model
    states = list(map(str, linear["x_names"]))
    found = instance.getReal([references[name] for name in states])
    assert np.allclose(found, linear["x0"], rtol=1e-12, atol=1e-12)
    count = 572
    rates = (ctypes.c_double * count)()
    instance.getDerivatives(rates, count)
    assert max(map(abs, rates[3:])) < 1e-7
