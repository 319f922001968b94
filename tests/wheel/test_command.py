"""The command that `pip install` brings."""

import os
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import flexair
import fmpy
import numpy as np
import pytest


def test_there_is_no_cargo_here():
    assert shutil.which("cargo") is None and shutil.which("rustc") is None


def test_an_own_aircraft_is_packaged_for_every_platform_of_the_package_and_flies(run, own_aircraft, tmp_path):
    packaged = run("package", "--aircraft", own_aircraft)
    assert packaged.returncode == 0, packaged.stderr
    fmu = tmp_path / "FlexibleAircraft.fmu"
    libraries = {path.parent.name for path in (Path(flexair.__file__).parent / "flexair-data/binaries").glob("*/*")}
    names = zipfile.ZipFile(fmu).namelist()
    assert {Path(name).parent.name for name in names if name.startswith("binaries/")} == libraries >= {"linux64"}
    assert any(name.startswith("documentation/licenses/nalgebra-") for name in names)
    flown = fmpy.simulate_fmu(str(fmu), stop_time=1.0, output_interval=0.1, output=["attitude.pitch", "air.speed"])
    assert np.isfinite(flown["attitude.pitch"]).all() and len(flown) == 11
    assert np.ptp(flown["air.speed"]) < 1e-3


def test_outputs_go_to_the_working_directory_and_names_of_aircraft_are_found(run, tmp_path):
    analysed = run("flutter", "goland-wing", "--from", 130, "--to", 145, "--points", 4)
    assert analysed.returncode == 0, analysed.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["flexair-out"]
    assert (tmp_path / "flexair-out/flutter/goland-wing-roots.csv").is_file()
    listed = run("aircraft", program=(sys.executable, "-m", "flexair"))
    assert "goland-wing " in listed.stdout and listed.returncode == 0


def test_exit_codes_and_messages_are_those_of_the_command(run):
    usage, failed, help_ = run("trim", "--sped", 1), run("trim", "no/such.toml"), run("trim", "--help")
    assert (usage.returncode, failed.returncode, help_.returncode) == (2, 1, 0)
    assert "unexpected argument '--sped'" in usage.stderr and "Usage: flexair trim" in help_.stdout
    assert failed.stderr.startswith("error: no/such.toml: cannot read the aircraft file: ")


def test_bench_says_what_it_needs_and_reproduce_finds_everything(run, tmp_path):
    bench = run("bench")
    assert bench.returncode == 1 and "`flexair package` writes one" in bench.stderr
    reproduced = run("reproduce")
    assert reproduced.returncode == 0, reproduced.stderr
    assert (tmp_path / "flexair-out/reproduce/index.html").is_file()


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_ends_the_command_and_leaves_nothing(tmp_path):
    program = Path(sys.executable).with_name("flexair")
    command = [program, "simulate", "--duration", "90000", "--output", "flight.csv"]
    # A shell that starts tests in the background has them ignore it.
    heeded = lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)  # noqa: E731
    with subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, preexec_fn=heeded) as running:
        deadline = time.monotonic() + 60
        while not list(tmp_path.iterdir()) and time.monotonic() < deadline:
            time.sleep(0.05)
        assert list(tmp_path.iterdir()), "nothing was begun"
        running.send_signal(signal.SIGINT)
        try:
            assert running.wait(timeout=60) == 130
        finally:
            running.kill()
    assert list(tmp_path.iterdir()) == []
