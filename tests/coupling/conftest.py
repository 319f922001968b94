"""Systems of the aircraft, a control law and a gust, how the same loops go in Rust, and linear models.

The FMU of the aircraft is the file named by the environment variable FMU, the command the one named by FLEXAIR, examples are
in the folder named by EXAMPLES.
"""

import csv
import functools
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest
from distributed import LocalCluster

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"

# Where the aircraft's parameters start that flies through a gust of its own, as in the README.
IN_GUST = [
    "gust.shape=one_minus_cosine",
    "gust.gradient=63.5",
    "actuator.aileron_symmetric.frequency=40",
    "actuator.aileron_symmetric.rate_limit=0.7",
]

# Of each law: its FMU, the duration of the gust that is a wind, its connections. Names as in the README.
LAWS = {
    "pitch_attitude_hold": (
        "PitchAttitudeHold",
        4.0,
        ["aircraft.attitude.pitch=law.pitch", "aircraft.rate.y=law.pitch_rate", "law.elevator=aircraft.elevator"],
    ),
    "gust_load_alleviation": (
        "GustLoadAlleviation",
        None,
        [
            "aircraft.station.wing_tip_right.specific_force.z=law.force_right",
            "aircraft.station.wing_tip_left.specific_force.z=law.force_left",
            "law.aileron_symmetric=aircraft.aileron_symmetric",
        ],
    ),
}


@pytest.fixture(scope="session")
def aircraft():
    """Path of the aircraft's FMU."""
    path = Path(os.environ.get("FMU", ROOT / "target/fmu/FlexibleAircraft.fmu"))
    assert path.is_file(), f"{path} does not exist: run `cargo run --release -- package`"
    return path


@pytest.fixture(scope="session")
def flexair():
    """A function that runs `flexair ssp` with some options."""
    program = os.environ.get("FLEXAIR", ROOT / "target/release/flexair")

    def flexair(*options):
        return subprocess.run([program, "ssp", *map(str, options)], capture_output=True, encoding="utf-8")

    return flexair


@pytest.fixture(scope="session")
def linearise():
    """A function that runs `flexair linearise` with some options."""
    program = Path(os.environ.get("FLEXAIR", ROOT / "target/release/flexair")).absolute()

    def linearise(*options):
        command = [program, "linearise", ROOT / "aircraft/generic-business-jet.toml", *map(str, options)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

    return linearise


@pytest.fixture(scope="session")
def sweep(tmp_path_factory):
    """A function that runs `flexair sweep` with the text of a sweep file: its table."""
    program = os.environ.get("FLEXAIR", ROOT / "target/release/flexair")

    def sweep(text):
        folder = tmp_path_factory.mktemp("sweep")
        file, output = folder / "sweep.toml", folder / "out"
        file.write_text(text, encoding="utf-8")
        swept = subprocess.run([program, "sweep", file, "--output", output], capture_output=True, encoding="utf-8")
        assert swept.returncode == 0, swept.stderr
        return pyarrow.parquet.read_table(sorted(output.glob("part-*.parquet")))

    return sweep


def killer(number):
    """Whom it has killed, and a function for `on_cluster` that kills a worker after so many results."""
    killed = []

    def kill(lines, cluster):
        if len(lines) == number:
            worker = cluster.workers[0].pid
            os.kill(worker, signal.SIGKILL)
            killed.append(worker)

    return killed, kill


@pytest.fixture(scope="session")
def on_cluster(tmp_path_factory):
    """A function that runs an example on a cluster of two workers: the table that it writes. `after(lines, cluster)` is called
    for each result."""

    def on_cluster(example, points, table, *options, after=None):
        output = tmp_path_factory.mktemp(example) / table
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster:
            command = [sys.executable, EXAMPLES / f"{example}.py", "--points", str(points), *options]
            command += ["--scheduler", cluster.scheduler_address, "--output", output]
            with subprocess.Popen(command, stdout=subprocess.PIPE, encoding="utf-8") as run:
                lines = []
                for line in run.stdout:
                    if f" of {points}: " in line:
                        lines.append(line)
                        if after is not None:
                            after(lines, cluster)
            assert run.returncode == 0
        assert len(lines) == points
        return output

    return on_cluster


@pytest.fixture(scope="session")
def aircraft_in_gust(tmp_path_factory):
    """Path of the aircraft's FMU whose parameters start in a gust, with an actuator."""
    program = os.environ.get("FLEXAIR", ROOT / "target/release/flexair")
    output = tmp_path_factory.mktemp("in_gust") / "InGust.fmu"
    starts = [f"--set={start}" for start in IN_GUST]
    subprocess.run([program, "package", "--no-check", "--output", output, *starts], cwd=ROOT, check=True)
    return output


@pytest.fixture(scope="session")
def fmus(tmp_path_factory):
    """Folder with the FMUs of the laws and the gust, which pythonfmu makes."""
    folder = tmp_path_factory.mktemp("fmus")
    for script in [*LAWS, "vertical_gust"]:
        command = [sys.executable, "-m", "pythonfmu", "build", "--file", EXAMPLES / f"{script}.py", "--dest", folder]
        subprocess.run([*command, EXAMPLES / "fmu_with_units.py", EXAMPLES / "alleviation_law.py"], check=True)
    return folder


@pytest.fixture(scope="session")
def write_system(flexair, aircraft, aircraft_in_gust, fmus):
    """A function that writes a law's system into a folder: the .ssp and the OSP folder."""

    def write_system(law, folder, settings=()):
        fmu, duration, connections = LAWS[law]
        ssp, osp = folder / f"{law}.ssp", folder / "osp"
        options = ["--component", f"law={fmus / fmu}.fmu"]
        gust, duration_of_gust = [], []
        if duration:
            options += ["--component", f"gust={fmus / 'VerticalGust.fmu'}"]
            gust = [f"gust.{name}=aircraft.{name}" for name in ("wind_down", "wind_rate_down")]
            duration_of_gust = [f"gust.duration={duration}"]
        for connection in [*connections, *gust]:
            options += ["--connect", connection]
        for setting in [*duration_of_gust, *settings]:
            options += ["--set", setting]
        written = flexair(aircraft if duration else aircraft_in_gust, *options, "--output", ssp, "--osp", osp)
        assert written.returncode == 0, written.stderr
        return ssp, osp

    return write_system


@pytest.fixture(scope="session")
def system(write_system, tmp_path_factory):
    """A function that gives the .ssp and the OSP folder of a law's system, written once."""
    return functools.cache(lambda law: write_system(law, tmp_path_factory.mktemp(law)))


@pytest.fixture(scope="session")
def in_rust():
    """A function that flies a loop in Rust, closed unless `open` is said too: columns by name."""

    @functools.cache
    def in_rust(*arguments):
        program = Path(os.environ.get("EXAMPLES", ROOT / "target/checked/examples")).absolute() / "closed_loop"
        assert program.is_file(), f"{program} does not exist: run `cargo build --release --examples`"
        command = [program, *arguments]
        table = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        rows = list(csv.reader(table.splitlines()))
        return dict(zip(rows[0], np.array(rows[1:], dtype=float).T))

    return in_rust
