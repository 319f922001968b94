"""The same flight on every platform that can be run here gives the same bits: all outputs, and the saved state."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from conftest import C_OPTIONS, ROOT, flight_of, zig_cc

FLY = ROOT / "tests/platforms/fly.c"
# Debian's package `wine64` puts it there, out of the way of `wine`.
WINE = shutil.which("wine64") or shutil.which("wine64", path="/usr/lib/wine")
MINGW = shutil.which("x86_64-w64-mingw32-gcc")
QEMU = shutil.which("qemu-aarch64") or shutil.which("qemu-aarch64-static")
ARM_SYSTEM = Path("/usr/aarch64-linux-gnu")


def test_the_flight_is_one(linux64_flight):
    """Without this, the comparisons below could be of nothing."""
    outputs = [line.split(": ")[1] for line in linux64_flight if line.startswith("model")]
    assert len(outputs) == 5 * 4
    assert len(set(outputs)) == len(outputs)
    assert sum(line.startswith("state of ") for line in linux64_flight) == 5


def test_the_library_of_this_machines_own_linker_flies_the_same(linux64_flight, flight_arguments, tmp_path):
    own = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release/libflexible_aircraft.so"
    if not own.is_file():
        pytest.skip("cargo has built none here")
    zig_cc("x86_64-linux-gnu", FLY, tmp_path / "fly")
    assert flight_of([tmp_path / "fly", own, *flight_arguments()]) == linux64_flight


@pytest.mark.skipif(not (WINE and MINGW), reason="needs wine64 and mingw")
def test_windows_flies_the_same(library, linux64_flight, flight_arguments, tmp_path):
    dll = library("win64")
    subprocess.run([MINGW, *C_OPTIONS, FLY, "-o", tmp_path / "fly.exe"], check=True)
    stand_in = [ROOT / "tests/platforms/bcryptprimitives.c", "-o", tmp_path / "bcryptprimitives.dll"]
    subprocess.run([MINGW, *C_OPTIONS, "-shared", *stand_in], check=True)
    environment = os.environ | {
        "WINEPREFIX": str(tmp_path / "prefix"),
        "WINEDEBUG": "-all",
        "WINEDLLOVERRIDES": "mscoree,mshtml=",
    }
    command = [WINE, tmp_path / "fly.exe", dll, *flight_arguments("Z:/")]
    assert flight_of(command, env=environment) == linux64_flight


@pytest.mark.skipif(not (QEMU and ARM_SYSTEM.is_dir()), reason="needs qemu-user and libc6-arm64-cross")
def test_linux_on_arm_flies_the_same(library, linux64_flight, flight_arguments, tmp_path):
    arm_library = library("aarch64-linux")
    zig_cc("aarch64-linux-gnu.2.17", FLY, tmp_path / "fly")
    command = [QEMU, "-L", ARM_SYSTEM, tmp_path / "fly", arm_library, *flight_arguments()]
    assert flight_of(command) == linux64_flight
