"""What `flexair ssp` writes is valid, the same every time, and refused where it would not work."""

import zipfile

import fmpy.ssp.ssd
import pytest
from lxml import etree

from conftest import LAWS


@pytest.mark.parametrize("law", LAWS)
def test_the_system_structure_is_valid_ssp(system, law):
    ssp, _ = system(law)
    description = fmpy.ssp.ssd.read_ssd(str(ssp), validate=True)
    # Where the gust is a wind, an FMU gives it, with its rate and one parameter.
    _, gust, connections = LAWS[law]
    parts = ["aircraft", "law"] if gust is None else ["aircraft", "law", "gust"]
    assert [component.name for component in description.system.elements] == parts
    assert len(description.system.connections) == len(connections) + (0 if gust is None else 2)
    with zipfile.ZipFile(ssp) as archive:
        assert archive.namelist() == ["SystemStructure.ssd", *(f"resources/{part}.fmu" for part in sorted(parts))]
        # The parameters that the structure carries inline, after their own schema.
        structure = etree.fromstring(archive.read("SystemStructure.ssd"))
    sets = structure.findall(".//ssv:ParameterSet", fmpy.ssp.ssd.ns)
    assert len(sets) == (0 if gust is None else 1)
    for parameters in sets:
        fmpy.ssp.ssd.validate_tree(parameters, "SystemStructureParameterValues.xsd")


def test_equal_systems_give_equal_bytes(flexair, aircraft, fmus, tmp_path):
    archives = [tmp_path / "one.ssp", tmp_path / "two.ssp"]
    for archive in archives:
        options = ["--component", f"gust={fmus / 'VerticalGust.fmu'}", "--connect", "aircraft.wind_down=gust.wind_down"]
        assert flexair(aircraft, *options, "--output", archive).returncode == 0
    assert archives[0].read_bytes() == archives[1].read_bytes()


def test_the_fmus_go_in_unchanged(system, aircraft, fmus):
    ssp, osp = system("pitch_attitude_hold")
    sources = {"aircraft": aircraft, "law": fmus / "PitchAttitudeHold.fmu", "gust": fmus / "VerticalGust.fmu"}
    with zipfile.ZipFile(ssp) as archive:
        for name, source in sources.items():
            assert archive.read(f"resources/{name}.fmu") == (osp / f"{name}.fmu").read_bytes() == source.read_bytes()


@pytest.mark.parametrize(
    "options, reasons",
    [
        (["--connect", "law.elevatr=aircraft.elevator"], ["`law` has no variable `elevatr`", "`elevator`"]),
        (["--connect", "hold.elevator=aircraft.elevator"], ["found the component `hold`", "aircraft, law"]),
        (["--connect", "law.pitch=aircraft.elevator"], ["the input `law.pitch` and the input `aircraft.elevator`"]),
        (["--connect", "aircraft.airspeed=law.pitch"], ["the parameter `aircraft.airspeed`"]),
        (["--connect", "aircraft.rate.y=law.pitch"], ["the output is in rad/s, the input in rad"]),
        (
            ["--connect", "aircraft.attitude.pitch=law.pitch", "--connect", "law.pitch=aircraft.attitude.roll"],
            ["the input `law.pitch` is fed by `aircraft.attitude.pitch` already"],
        ),
        (["--set", "law.limit=much"], ["found the value `much`", "a finite number in rad is allowed"]),
        (["--set", "aircraft.model=9"], ["found the value `9`", "allowed is 1 (exact)", "5 (rigid)"]),
        (["--set", "aircraft.altitude=35000"], ["found the value `35000`", "allowed is -1000 to 30000 m"]),
        (["--set", "aircraft.model=rigid", "--osp", "osp"], ["libcosim has no enumerations"]),
        (["--set", "aircraft.rate.y=2"], ["found the output `aircraft.rate.y`"]),
        (["--component", "law=README.md"], ["README.md: not an FMU"]),
        (["--component", "two.names=law.fmu"], ["found the component name `two.names`", "letters, digits"]),
        (["--connect", "law=aircraft"], ["found `law`, expected COMPONENT.VARIABLE"]),
        (["--step", "0"], ["found a step of 0 s"]),
    ],
)
def test_what_does_not_fit_is_refused_with_the_reason(flexair, aircraft, fmus, tmp_path, options, reasons):
    output = tmp_path / "system.ssp"
    law = ["--component", f"law={fmus / 'PitchAttitudeHold.fmu'}"]
    refused = flexair(aircraft, *law, *options, "--output", output)
    assert refused.returncode != 0 and not output.exists()
    for reason in reasons:
        assert reason in refused.stderr


def test_all_that_does_not_fit_is_told_at_once(flexair, aircraft, tmp_path):
    wrong = ["--connect", "aircraft.elevator=aircraft.rudder", "--connect", "aircraft.nothing=aircraft.rudder"]
    refused = flexair(aircraft, *wrong, "--output", tmp_path / "system.ssp")
    assert refused.stderr.count("error: ") == 2
