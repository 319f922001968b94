"""What the FMU refuses, and what it then says."""

import fmpy
import pytest
from fmpy.fmi1 import FMICallException


def refusal(fmu, **simulation):
    """Function that FMPy complains about, and the log lines of a simulation that must fail."""
    lines = []

    def log(environment, instance, status, category, message):
        lines.append(f"{category.decode()}: {message.decode()}")

    with pytest.raises(FMICallException) as refused:
        fmpy.simulate_fmu(str(fmu), logger=log, debug_logging=True, **simulation)
    return refused.value.function, [line for line in lines if line.startswith("logStatusError: ")]


@pytest.mark.parametrize(
    "parameter, value, function",
    [
        ("airspeed", -127.0, "fmi2SetReal"),
        ("stiffness_scale", 0.0, "fmi2SetReal"),
        ("structural_damping", -0.01, "fmi2SetReal"),
        ("tolerance", 0.0, "fmi2SetReal"),
        ("altitude", float("nan"), "fmi2SetReal"),
        ("mode_count", 21, "fmi2SetInteger"),
        ("inflow_states", 9, "fmi2SetInteger"),
    ],
)
def test_a_wrong_parameter_is_refused_with_its_name(fmu, parameter, value, function):
    refused, log = refusal(fmu, start_values={parameter: value}, stop_time=0.1)
    assert refused == function
    assert len(log) == 1 and parameter in log[0]


def test_more_modes_than_the_family_has_are_refused_at_initialisation(fmu):
    parameters = {"mode_family": 2, "mode_count": 20}
    refused, log = refusal(fmu, start_values=parameters, stop_time=0.1)
    assert refused == "fmi2ExitInitializationMode"
    assert len(log) == 1 and "mode_count" in log[0]


def test_a_flight_without_trim_is_refused_with_what_was_tried(fmu):
    refused, log = refusal(fmu, start_values={"airspeed": 1.0}, stop_time=0.1)
    assert refused == "fmi2ExitInitializationMode"
    assert len(log) == 1 and "no steady level flight found at 1 m/s and 7620 m" in log[0]
