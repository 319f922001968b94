"""sofirpy (PyPI): couples FMUs and models in Python."""

import fmpy
import pytest
import sofirpy
from sofirpy import SimulationEntity

from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STRAIGHT


def signals(flight):
    """A model whose outputs are the inputs of a flight, each at the end of its step."""

    class Signals(SimulationEntity):
        def initialize(self, start_values):
            self.point = 0

        def do_step(self, time):
            self.point = round(time / 0.01) + 1

        def get_parameter_value(self, name):
            return float(flight.inputs[name][self.point])

        def set_parameter(self, name, value):
            raise NotImplementedError

    return Signals


def fly(fmu, flight, outputs):
    connections = [
        {"parameter_name": name, "connect_to_system": "signals", "connect_to_external_parameter": name}
        for name in flight.inputs
    ]
    table = sofirpy.simulate(
        stop_time=float(flight.time[-1]),
        step_size=0.01,
        fmu_paths={"aircraft": fmu},
        model_classes={"signals": signals(flight)},
        connections_config={"aircraft": connections},
        start_values={"aircraft": dict(flight.parameters)},
        parameters_to_log={"aircraft": outputs},
    )
    assert table["time"].to_numpy() == pytest.approx(flight.time, rel=1e-9)
    return {name: table[f"aircraft.{name}"].to_numpy() for name in outputs}


FLIGHTS = [STRAIGHT, MANOEUVRE, PARAMETERS, ENUMERATIONS]


@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(fmu, agrees, flight):
    """It reads the outputs after it has set the inputs of the next step: those are compared that do not see them."""
    outputs = fmpy.read_model_description(str(fmu)).outputs
    # Actuators are off: what they say in Booleans is compared elsewhere.
    outputs = [output for output in outputs if output.variable.type == "Real"]
    names = [output.variable.name for output in outputs if not (flight.inputs and output.dependencies)]
    assert len(names) > 80
    agrees("sofirpy", flight, fly(fmu, flight, names))
