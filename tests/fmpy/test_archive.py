"""The archive and its model description, without flying."""

import subprocess
import zipfile
from pathlib import Path

import fmpy
import pytest
from fmpy.validation import validate_fmu

from conftest import ROOT


def test_fmpy_validates_it_without_remarks(fmu):
    assert validate_fmu(str(fmu)) == []


def test_the_archive_has_what_importers_and_people_look_for(fmu):
    names = zipfile.ZipFile(fmu).namelist()
    assert names[0] == "modelDescription.xml"
    assert any(name.startswith(f"binaries/{fmpy.platform}/FlexibleAircraft.") for name in names)
    for name in ["model.png", "resources/aircraft.toml", "documentation/index.html", "documentation/scene.html"]:
        assert name in names
    assert "documentation/licenses/flexible-aircraft-0.1.0/LICENSE-MIT" in names


def test_the_documentation_lists_every_variable(fmu, model_description):
    page = zipfile.ZipFile(fmu).read("documentation/index.html").decode()
    missing = [v.name for v in model_description.modelVariables if f"<code>{v.name}</code>" not in page]
    assert missing == []
    assert "{{" not in page


def test_packaging_again_gives_the_same_bytes(fmu, tmp_path):
    again = tmp_path / "again.fmu"
    command = ["cargo", "run", "--release", "--quiet", "--", "package", "--no-check", "--output", again]
    subprocess.run(command, cwd=ROOT, check=True)
    assert again.read_bytes() == fmu.read_bytes()


@pytest.mark.parametrize("check", ["check.c", "check3.c"])
def test_our_c_headers_agree_with_the_official_ones(check):
    official = Path(fmpy.__file__).parent / "c-code"
    compile_ = ["cc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"]
    check = ROOT / "fmi-headers" / check
    subprocess.run([*compile_, "-I", official, check], check=True)
    subprocess.run([*compile_, "-DOURS", check], check=True)
