"""What the model description promises beyond its schema."""

import subprocess
import zipfile
from xml.etree import ElementTree

import pytest

from conftest import ROOT


@pytest.fixture(scope="module")
def xml(fmu):
    return ElementTree.fromstring(zipfile.ZipFile(fmu).read("modelDescription.xml"))


@pytest.fixture(scope="module")
def variables(xml):
    """Type element by name, in order, with the attributes of the variable."""
    return {v.get("name"): (v, v[0]) for v in xml.find("ModelVariables")}


def test_every_capability_that_is_there_is_said(xml):
    slave = xml.find("CoSimulation")
    for flag in [
        "canGetAndSetFMUstate",
        "canSerializeFMUstate",
        "canInterpolateInputs",
        "providesDirectionalDerivative",
    ]:
        assert slave.get(flag) == "true", flag
    assert slave.get("canHandleVariableCommunicationStepSize") == "true"
    assert slave.get("canBeInstantiatedOnlyOncePerProcess", "false") == "false"
    assert slave.get("needsExecutionTool", "false") == slave.get("canRunAsynchronuously", "false") == "false"


def test_value_references_and_names_are_unique(xml, variables):
    elements = list(xml.find("ModelVariables"))
    assert len(variables) == len(elements)
    assert len({v.get("valueReference") for v in elements}) == len(elements)


def test_every_real_but_the_modal_coordinates_has_a_unit_that_is_defined_and_angles_are_shown_in_degrees(xml, variables):
    units = {unit.get("name"): unit for unit in xml.find("UnitDefinitions")}
    used = set()
    for name, (_, kind) in variables.items():
        # Modal coordinates are in √kg m, which no grammar of units has.
        if kind.tag != "Real" or name.startswith("modal."):
            assert kind.get("unit") is None, name
            continue
        used.add(kind.get("unit"))
        shown = [display.get("name") for display in units[kind.get("unit")].findall("DisplayUnit")]
        assert kind.get("displayUnit") in (shown or [None]), name
        assert ("rad" in kind.get("unit")) == ("deg" in (kind.get("displayUnit") or "")), name
    assert used == set(units), "units that no variable has"
    degrees = units["rad"].find("DisplayUnit")
    assert degrees.get("name") == "deg"
    assert float(degrees.get("factor")) == pytest.approx(57.29577951308232, rel=1e-15)
    assert units["N"].find("BaseUnit").attrib == {"kg": "1", "m": "1", "s": "-2"}
    assert units["m/s2"].find("BaseUnit").attrib == {"m": "1", "s": "-2"}
    assert units["rad"].find("BaseUnit").attrib == {"rad": "1"}


def test_enumerations_are_type_definitions_and_start_at_one_of_their_items(xml, variables):
    types = {kind.get("name"): kind.find("Enumeration") for kind in xml.find("TypeDefinitions")}
    enumerations = {name: kind for name, (_, kind) in variables.items() if kind.tag == "Enumeration"}
    assert {kind.get("declaredType") for kind in enumerations.values()} == set(types)
    for name in ["model", "input_reference", "mode_family"]:
        assert name in enumerations
    for name, kind in enumerations.items():
        items = [item.get("value") for item in types[kind.get("declaredType")]]
        assert items == [str(i + 1) for i in range(len(items))]
        assert kind.get("start") in items, name


def test_the_model_structure_lists_every_output_once_and_depends_on_what_is_known(xml, variables):
    elements = [element for element, _ in variables.values()]
    outputs = [str(i + 1) for i, v in enumerate(elements) if v.get("causality") == "output"]
    allowed = {"Outputs": {"input"}, "InitialUnknowns": {"input", "parameter"}}
    for part, causalities in allowed.items():
        unknowns = list(xml.find("ModelStructure").find(part))
        assert [unknown.get("index") for unknown in unknowns] == outputs, part
        for unknown in unknowns:
            on = [int(index) for index in unknown.get("dependencies").split()]
            assert on == sorted(set(on))
            assert {elements[index - 1].get("causality") for index in on} <= causalities
    assert any(unknown.get("dependencies") for unknown in xml.find("ModelStructure").find("Outputs"))


def test_outputs_are_calculated_and_all_else_has_a_start(variables):
    for name, (element, kind) in variables.items():
        if element.get("causality") == "output":
            assert element.get("initial") == "calculated" and kind.get("start") is None, name
        else:
            assert kind.get("start") is not None, name
        assert element.get("description"), name


def test_the_default_experiment_is_complete_and_consistent(xml, variables):
    experiment = {name: float(value) for name, value in xml.find("DefaultExperiment").attrib.items()}
    assert set(experiment) == {"startTime", "stopTime", "tolerance", "stepSize"}
    assert experiment["startTime"] < experiment["stopTime"]
    assert 0 < experiment["stepSize"] < experiment["stopTime"]
    assert experiment["tolerance"] == float(variables["tolerance"][1].get("start"))


def test_another_aircraft_has_another_guid_and_the_same_one_the_same(xml, tmp_path):
    def guid(aircraft):
        output = tmp_path / "aircraft.fmu"
        command = ["cargo", "run", "--release", "--quiet", "--", "package", "--no-check"]
        subprocess.run([*command, "--aircraft", aircraft, "--output", output], cwd=ROOT, check=True)
        return ElementTree.fromstring(zipfile.ZipFile(output).read("modelDescription.xml")).get("guid")

    jet = ROOT / "aircraft/generic-business-jet.toml"
    heavier = tmp_path / "heavier.toml"
    text = jet.read_text(encoding="utf-8")
    assert "gravity_m_s2" in text
    changed = [line + "1" if line.startswith("gravity_m_s2") else line for line in text.splitlines()]
    heavier.write_text("\n".join(changed), encoding="utf-8")
    assert guid(jet) == xml.get("guid") != guid(heavier)
