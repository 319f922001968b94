"""modelDescription.xml, read by the checkers and parsers of others."""

import subprocess
import sys
import zipfile
from pathlib import Path

import fmpy
import fmureader.fmi2
import pytest
from fmpy.validation import validate_fmu
from lxml import etree

from conftest import ROOT

SCHEMA = Path(fmpy.__file__).parent / "schema/fmi2/fmi2ModelDescription.xsd"


@pytest.fixture(scope="module")
def document(fmu):
    return zipfile.ZipFile(fmu).read("modelDescription.xml")


def test_it_is_valid_under_the_schema_of_fmi_2(document):
    schema = etree.XMLSchema(etree.parse(SCHEMA))
    schema.assertValid(etree.fromstring(document))
    with pytest.raises(etree.DocumentInvalid):
        schema.assertValid(etree.fromstring(document.replace(b'causality="input"', b'causality="inlet"', 1)))


def test_fmpy_finds_no_problem(fmu):
    assert validate_fmu(str(fmu)) == []


def test_the_fmu_manipulation_toolbox_finds_no_problem(fmu):
    tool = Path(sys.executable).with_name("fmutool")
    report = subprocess.run([tool, "-input", fmu, "-check"], capture_output=True, text=True, check=True)
    lines = (report.stdout + report.stderr).splitlines()
    assert any("This FMU seems to be compliant with FMI-2.0." in line for line in lines)
    assert any("No semantic error against the FMI-2 standard." in line for line in lines)
    assert [line for line in lines if line.startswith(("ERROR", "WARNING"))] == []


def test_fmureader_reads_what_is_there(fmu, description):
    read = fmureader.fmi2.read_model_description(fmu)
    assert read.guid == description.guid
    assert {variable.name: variable.value_reference for variable in read.model_variables} == {
        name: variable.reference for name, variable in description.variables.items()
    }


def test_what_is_tested_is_what_compatibility_md_names():
    document = (ROOT / "COMPATIBILITY.md").read_text(encoding="utf-8")
    pins = [pin for file in Path(__file__).parent.glob("requirements*.txt") for pin in file.read_text().split()]
    named = {pin: " ".join(pin.split("==")) for pin in pins}
    assert [text for text in named.values() if text not in document] == []
