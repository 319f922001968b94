"""What the FMU refuses, and what it then says."""

import fmpy
import pytest
from fmpy.fmi1 import FMICallException


@pytest.fixture
def refusal(fmu, capsys):
    """A function that runs a simulation which must fail: what was refused, and the errors logged.

    It reads what FMPy prints: a logger of our own would be called after its end, by later simulations (FMPy
    0.3.32 passes all log messages to the last logger it was given, and does not keep that alive).
    """

    def refusal(**simulation):
        with pytest.raises(FMICallException) as refused:
            fmpy.simulate_fmu(str(fmu), debug_logging=True, stop_time=0.1, **simulation)
        lines = capsys.readouterr().out.splitlines()
        return refused.value.function, [line for line in lines if line.startswith("[ERROR]")]

    return refusal


@pytest.mark.parametrize(
    "parameter, value, function",
    [
        ("airspeed", -127.0, "fmi2SetReal"),
        ("stiffness_scale", 0.0, "fmi2SetReal"),
        ("structural_damping", -0.01, "fmi2SetReal"),
        ("tolerance", 0.0, "fmi2SetReal"),
        ("altitude", float("nan"), "fmi2SetReal"),
        ("mode_count", 27, "fmi2SetInteger"),
        ("inflow_states", 9, "fmi2SetInteger"),
    ],
)
def test_a_wrong_parameter_is_refused_with_its_name(refusal, parameter, value, function):
    refused, log = refusal(start_values={parameter: value})
    assert refused == function
    assert len(log) == 1 and parameter in log[0]


def test_more_modes_than_the_family_has_are_refused_at_initialisation(refusal):
    parameters = {"mode_family": 2, "mode_count": 20}
    refused, log = refusal(start_values=parameters)
    assert refused == "fmi2ExitInitializationMode"
    assert len(log) == 1 and "mode_count" in log[0]


def test_a_flight_without_trim_is_refused_with_what_was_tried(refusal):
    refused, log = refusal(start_values={"airspeed": 1.0})
    assert refused == "fmi2ExitInitializationMode"
    assert len(log) == 1 and "no steady level flight found at 1 m/s and 7620 m" in log[0]
