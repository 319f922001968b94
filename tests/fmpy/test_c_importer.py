"""An importer in C (tests/c/importer.c), compiled against the official headers of FMPy's package, drives the library."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import fmpy
import pytest

from conftest import ROOT

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the C importer loads with dlopen and reads /proc")

OUTPUTS = ["position.north", "attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up", "trim.thrust"]


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    program = tmp_path_factory.mktemp("c") / "importer"
    official = Path(fmpy.__file__).parent / "c-code"
    compile_ = ["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-Wall", "-Wextra", "-Werror", "-g", "-I", official]
    subprocess.run([*compile_, ROOT / "tests/c/importer.c", "-ldl", "-o", program], check=True)
    return program


@pytest.fixture
def importer(program, unpacked, model_description, tmp_path):
    """A function that runs the program in a folder of its own: what it prints, line by line."""
    unpacked = Path(unpacked)
    library = unpacked / "binaries" / fmpy.platform / f"FlexibleAircraft{fmpy.sharedLibraryExtension}"
    references = {v.name: str(v.valueReference) for v in model_description.modelVariables}
    arguments = [model_description.guid, (unpacked / "resources").as_uri()]
    arguments += [references[name] for name in ["elevator", *OUTPUTS]]

    def importer(command, under=(), **environment):
        environment = {**os.environ, "LC_ALL": "C", **environment}
        return subprocess.run(
            [*under, program, command, library, *arguments],
            cwd=tmp_path,
            env=environment,
            check=True,
            capture_output=True,
            text=True,
        )

    return importer


def bits(run):
    return [line.split()[0] for line in run.stdout.splitlines()]


def test_a_second_process_goes_on_from_the_bytes_of_the_first_bit_for_bit(importer):
    first = bits(importer("fly"))
    assert len(first) == len(OUTPUTS)
    assert bits(importer("go-on")) == first
    assert bits(importer("fly")) == first


def test_instances_and_steps_take_no_memory(importer):
    importer("endure")


@pytest.fixture(scope="session")
def decimal_comma(tmp_path_factory):
    """A folder for LOCPATH with the German locale, compiled here; Debian's package `locales` is fetched if need be."""
    folder = tmp_path_factory.mktemp("locales")
    sources = Path("/usr/share/i18n")
    if not (sources / "locales/de_DE").is_file() and shutil.which("apt-get") and shutil.which("dpkg"):
        subprocess.run(["apt-get", "download", "locales"], cwd=folder)
        for package in folder.glob("locales_*.deb"):
            subprocess.run(["dpkg", "-x", package, folder], check=True)
        sources = folder / "usr/share/i18n"
    if not (sources / "locales/de_DE").is_file() or not shutil.which("localedef"):
        pytest.skip("NOT TESTED: no decimal comma, for there is no localedef or no source of the locale de_DE")
    environment = {**os.environ, "I18NPATH": str(sources)}
    command = ["localedef", "--no-archive", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"]
    subprocess.run(command, check=True, env=environment)
    return folder


def test_a_decimal_comma_changes_nothing(importer, decimal_comma):
    expected = importer("fly")
    german = importer("fly", LC_ALL="de_DE.UTF-8", LOCPATH=str(decimal_comma))
    assert "decimal sign: ," in german.stderr and "decimal sign: ." in expected.stderr
    assert bits(german) == bits(expected)
    assert german.stdout == expected.stdout.replace(".", ",") != expected.stdout
    assert bits(importer("go-on", LC_ALL="de_DE.UTF-8", LOCPATH=str(decimal_comma))) == bits(expected)


def test_valgrind_finds_neither_errors_nor_leaks(importer):
    if not shutil.which("valgrind"):
        pytest.skip("NOT TESTED: valgrind is not installed")
    valgrind = ["valgrind", "--error-exitcode=9", "--leak-check=full", "--errors-for-leak-kinds=definite,possible"]
    importer("fly", under=valgrind)
    importer("go-on", under=valgrind)
