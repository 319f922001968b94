"""What the libraries export and what they need of their system, as their files say."""

import re

import lief
import pytest

from conftest import ROOT

# glibc 2.17 is that of CentOS 7, the oldest system that simulation tools are still run on.
NEWEST_GLIBC = (2, 17)
# The parts of glibc: libpthread and libdl were apart from libc until 2.34; ld-linux gives access to thread-local data.
OF_GLIBC = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "ld-linux-x86-64.so.2"}
# Of Windows itself, 10 and newer.
OF_WINDOWS = {
    "api-ms-win-core-synch-l1-2-0.dll", "bcryptprimitives.dll", "kernel32.dll", "msvcrt.dll", "ntdll.dll",
    "userenv.dll", "ws2_32.dll",
}  # fmt: skip
OF_MACOS = {"/usr/lib/libSystem.B.dylib"}
# zig adds these for macOS, whatever is to be exported: they belong to its linker and its run-time library.
OF_ZIG = {"__mh_dylib_header", "___dso_handle", "___isPlatformVersionAtLeast", "___isOSVersionAtLeast"}
ELF_PLATFORMS = ["linux64", "aarch64-linux"]


def declared_functions():
    """Those of FMI 2.0 and of FMI 3.0: one library serves both."""
    headers = [ROOT / f"fmi-headers/flexible_aircraft_fmi{version}.h" for version in (2, 3)]
    declared = [re.findall(r"^\w[\w ]*[ *](fmi[23]\w+)\(", header.read_text(), re.MULTILINE) for header in headers]
    assert list(map(len, declared)) == [44, 75]
    return set(declared[0] + declared[1])


@pytest.mark.parametrize("platform", ELF_PLATFORMS)
def test_linux_needs_no_newer_glibc_than_2_17(library, platform):
    binary = lief.ELF.parse(library(platform))
    versions = {aux.name for needed in binary.symbols_version_requirement for aux in needed.get_auxiliary_symbols()}
    assert versions
    for version in versions:
        name, _, number = version.partition("_")
        assert name == "GLIBC"
        assert tuple(int(part) for part in number.split(".")) <= NEWEST_GLIBC, version


@pytest.mark.parametrize("platform", ELF_PLATFORMS)
def test_linux_links_nothing_but_glibc(library, platform):
    binary = lief.ELF.parse(library(platform))
    assert set(binary.libraries) <= OF_GLIBC


def test_windows_links_nothing_but_windows(library):
    binary = lief.PE.parse(library("win64"))
    assert {imported.name.lower() for imported in binary.imports} <= OF_WINDOWS


def test_macos_links_nothing_but_its_system_library(library):
    own_name = lief.MachO.LoadCommand.TYPE.ID_DYLIB
    universal = lief.MachO.parse(library("darwin64"))
    for image in universal:
        assert {needed.name for needed in image.libraries if needed.command != own_name} <= OF_MACOS


def test_macos_library_is_for_both_processors(library):
    cpu = lief.MachO.Header.CPU_TYPE
    universal = lief.MachO.parse(library("darwin64"))
    assert {image.header.cpu_type for image in universal} == {cpu.X86_64, cpu.ARM64}


@pytest.mark.parametrize("platform", [*ELF_PLATFORMS, "win64", "darwin64"])
def test_the_functions_of_the_headers_are_exported_and_nothing_else(library, platform):
    file = library(platform)
    for exported in exports(file, platform):
        assert exported == declared_functions()


def exports(file, platform):
    """The names exported by each image in a file."""
    # lief's objects live as long as what they were read into.
    if platform == "win64":
        binary = lief.PE.parse(file)
        return [{entry.name for entry in binary.get_export().entries}]
    if platform == "darwin64":
        universal = lief.MachO.parse(file)
        names = [{symbol.name for symbol in image.exported_symbols} for image in universal]
        return [{name.removeprefix("_") for name in of_image - OF_ZIG} for of_image in names]
    binary = lief.ELF.parse(file)
    return [{symbol.name for symbol in binary.exported_symbols}]


def test_no_library_knows_the_folders_of_its_builder(unpacked):
    libraries = [path for path in (unpacked / "binaries").rglob("*") if path.is_file()]
    assert libraries
    for path in libraries:
        content = path.read_bytes()
        assert str(ROOT).encode() not in content, path
        assert b"/.cargo/registry" not in content, path
