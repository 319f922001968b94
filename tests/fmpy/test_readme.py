"""The README does what it says: scripts, commands, lists, figures."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from conftest import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")
# The command line, built already if the environment says so.
FLEXAIR = ["cargo", "run", "--release", "--quiet", "--manifest-path", ROOT / "Cargo.toml", "--"]
if "FLEXAIR" in os.environ:
    FLEXAIR = [Path(os.environ["FLEXAIR"]).resolve()]


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


@pytest.fixture
def folder(fmu, tmp_path):
    """A folder with the FMU where the README has it, and what its commands read."""
    packaged = tmp_path / "target" / "fmu" / "FlexibleAircraft.fmu"
    packaged.parent.mkdir(parents=True)
    shutil.copy(fmu, packaged)
    for name in ("aircraft", "examples", "fmi-headers"):
        (tmp_path / name).symlink_to(ROOT / name)
    return tmp_path


def test_the_script_of_the_readme_draws_its_picture(folder):
    [script] = [script for script in blocks("python") if "savefig" in script]
    subprocess.run([sys.executable, "-c", script], cwd=folder, check=True)
    assert (folder / "first-flight.png").read_bytes().startswith(b"\x89PNG")


def test_the_control_law_of_the_readme_holds_the_pitch_angle(folder):
    [script] = [script for script in blocks("python") if "doStep" in script]

    def deviations(script):
        run = subprocess.run([sys.executable, "-c", script], cwd=folder, check=True, capture_output=True, text=True)
        return [abs(float(value)) for value in re.findall(r"pitch ([+-][\d.]+) rad", run.stdout)]

    closed, open_ = deviations(script), deviations(script.replace("[law, gust]", "[0.0, gust]"))
    assert len(closed) == len(open_) == 15
    # The law takes away most of what the gust does, and its last second is quiet.
    assert max(closed) < 0.6 * max(open_), (closed, open_)
    assert closed[-1] < 0.1 * max(closed), closed


def test_the_table_of_the_readme_becomes_a_flight_worth_plotting(folder):
    [commands] = [commands for commands in blocks("sh") if "inputs.csv" in commands]
    flexair = " ".join(f"'{part}'" for part in FLEXAIR)
    commands = commands.replace("cargo run --release --", flexair)
    subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, check=True)
    inputs = np.genfromtxt(folder / "inputs.csv", delimiter=",", names=True)
    flight = np.genfromtxt(folder / "flight.csv", delimiter=",", names=True, deletechars="")
    assert len(inputs) == len(flight) == 1501
    # Unit times of 2, 3, 1 and 1 from 1 s on, the first pulse nose-up.
    edges = inputs["time"][1:][np.diff(inputs["elevator"]) != 0]
    assert edges == pytest.approx([1.0, 2.4, 4.5, 5.2, 5.9])
    assert set(inputs["elevator"]) == {0.0, 0.05, -0.05} and inputs["elevator"][150] == -0.05
    assert np.ptp(flight["attitude.pitch"]) > 0.02


@pytest.mark.skipif(sys.platform != "linux", reason="the commands are those for Linux")
def test_the_commands_of_the_readme_fly_the_fmu_from_c_and_from_python_alike(folder):
    [commands] = [commands for commands in blocks("sh") if "fly.c" in commands]
    shell = ["bash", "-euo", "pipefail", "-c", commands]
    lines = subprocess.run(shell, cwd=folder, check=True, capture_output=True, text=True).stdout.splitlines()
    assert len(lines) == 16 and lines[:8] == lines[8:], lines


def test_the_fourteen_commands_of_the_readme_run(folder):
    """But for the sweep, which takes minutes, and for the FMU, which all these tests have already."""
    [commands] = [commands for commands in blocks("sh") if commands.startswith("flexair ")]
    lines = [shlex.split(line, comments=True)[1:] for line in commands.splitlines()]
    assert len(lines) == 14
    for line in lines:
        if line[0] not in ("sweep", "package"):
            run = subprocess.run([*FLEXAIR, *line], cwd=folder, stdout=subprocess.DEVNULL)
            # The deck has what beams do not hold.
            assert run.returncode == (2 if line[0] == "import" else 0), line
    assert len(np.genfromtxt(folder / "flight.csv", delimiter=",", names=True, deletechars="")) > 1000


def test_the_readme_names_every_example():
    stems = {path.stem for path in (ROOT / "examples").glob("*.*")}
    assert [stem for stem in sorted(stems) if not re.search(rf"\b{stem}\b", README)] == []


def test_the_readme_lists_what_goes_in_and_what_comes_out(model_description):
    section = README.split("\n## What goes in, what comes out\n")[1].split("\n## ")[0]
    names = re.findall(r"`([^`]+)`", section)

    def pattern(name):
        parts = re.split(r"<\w+>|\*", name)
        return re.compile("[^.]+".join(map(re.escape, parts)))

    variables = [variable.name for variable in model_description.modelVariables]
    matched = {name: [v for v in variables if pattern(name).fullmatch(v)] for name in names}
    assert [name for name, found in matched.items() if not found] == [], "listed, but not in the FMU"
    listed = {variable for found in matched.values() for variable in found}
    assert sorted(set(variables) - listed) == [], "in the FMU, but not listed"


@pytest.mark.parametrize(("inflow_states", "speed"), [("6", "32.13"), ("8", "32.54")])
def test_the_readme_says_which_settings_give_patils_flutter_speeds(folder, inflow_states, speed):
    [command] = [command for command in blocks("sh") if "patil-wing" in command]
    options = command.split("cargo run --release -- ")[1].split()
    assert options[-2:] == ["--inflow-states", "6"]
    run = subprocess.run(
        [*FLEXAIR, *options[:-1], inflow_states], cwd=folder, check=True, capture_output=True, text=True
    )
    assert re.search(rf"\b{speed}\b", run.stdout + run.stderr), run.stdout + run.stderr
    assert speed in README
