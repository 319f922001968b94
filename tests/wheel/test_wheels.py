"""What is in the wheels, as their files say: those of other systems cannot be run here."""

import zipfile
from pathlib import Path

import lief
import pytest

WHEELS = Path(__file__).with_name("wheels")
NEWEST_GLIBC = (2, 17)
OF_GLIBC = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "ld-linux-x86-64.so.2"}


def wheel(part):
    found = list(WHEELS.glob(f"*{part}*.whl"))
    if not found:
        pytest.skip(f"no wheel for {part} was built")
    [path] = found
    return zipfile.ZipFile(path)


def native(archive, tmp_path):
    [name] = [name for name in archive.namelist() if "/_native." in name and not name.endswith(".pyi")]
    return archive.extract(name, tmp_path)


@pytest.mark.parametrize("part", ["manylinux2014_x86_64", "win_amd64"])
def test_a_wheel_has_libraries_aircraft_licences_and_types(part):
    archive = wheel(part)
    assert "-cp311-abi3-" in archive.filename
    names = {name.removeprefix("flexair/") for name in archive.namelist()}
    data = {name.removeprefix("flexair-data/") for name in names if name.startswith("flexair-data/")}
    assert {"py.typed", "_native.pyi"} <= names
    assert {"binaries/linux64/FlexibleAircraft.so", "aircraft/generic-business-jet.toml", "aircraft/README.md"} <= data
    assert {"documentation/licenses/README.txt", "licences-of-the-command/README.txt"} <= data
    listed = archive.read("flexair/flexair-data/licences-of-the-command/README.txt").decode()
    for linked in ("pyo3 ", "numpy ", "clap ", "nalgebra "):
        assert f"\n{linked}" in listed


def test_the_wheel_for_linux_needs_no_newer_glibc_than_2_17(tmp_path):
    binary = lief.ELF.parse(native(wheel("manylinux2014_x86_64"), tmp_path))
    versions = {aux.name for needed in binary.symbols_version_requirement for aux in needed.get_auxiliary_symbols()}
    numbers = {tuple(map(int, version.removeprefix("GLIBC_").split("."))) for version in versions}
    assert numbers and max(numbers) <= NEWEST_GLIBC
    assert set(binary.libraries) <= OF_GLIBC


def test_the_wheel_for_windows_links_nothing_but_windows_and_the_stable_interface_of_python(tmp_path):
    binary = lief.PE.parse(native(wheel("win_amd64"), tmp_path))
    others = {imported.name.lower() for imported in binary.imports}
    system = {name for name in others if name.startswith(("api-ms-win-", "ext-ms-win-"))}
    system |= {"kernel32.dll", "ntdll.dll", "msvcrt.dll", "bcryptprimitives.dll", "userenv.dll", "ws2_32.dll", "advapi32.dll"}
    assert "python3.dll" in others and others - system == {"python3.dll"}
    assert "PyInit__native" in {entry.name for entry in binary.get_export().entries}
