"""The clearance flies what the FMU alone and the coupled system fly, and keeps its rows when a worker dies."""

import csv
import os
import sys
import tomllib

import numpy as np
import pyarrow.parquet
import pytest
from fmpy import extract, read_model_description, simulate_fmu

from conftest import EXAMPLES, ROOT, killer

sys.path.insert(0, str(EXAMPLES))
import clearance  # noqa: E402

POINTS = 20
PROGRAM = os.environ.get("FLEXAIR", ROOT / "target/release/flexair")


@pytest.fixture(scope="module")
def cases(tmp_path_factory):
    """Folder with the FMUs of the mass cases, which the first run packages."""
    return tmp_path_factory.mktemp("cases")


@pytest.fixture(scope="module")
def cleared(on_cluster, cases):
    """A function that flies the first points on a cluster: the table as a file."""

    def cleared(table, after=None):
        return on_cluster("clearance", POINTS, table, "--flexair", PROGRAM, "--fmu", cases, after=after)

    return cleared


@pytest.fixture(scope="module")
def undisturbed(cleared):
    return cleared("undisturbed.csv")


@pytest.fixture(scope="module")
def rows(undisturbed):
    return list(csv.DictReader(undisturbed.open(encoding="utf-8")))


def test_a_mass_case_changes_the_fuel_and_nothing_else():
    text = clearance.AIRCRAFT.read_text(encoding="utf-8")
    changed = clearance.mass_case(text, 0.25)
    lines = zip(text.splitlines(), changed.splitlines(), strict=True)
    [(before, after)] = [(before, after) for before, after in lines if before != after]
    assert "2110.5" in before and after.partition("#")[2] == before.partition("#")[2] == " fuel"
    expected, found = tomllib.loads(text), tomllib.loads(changed)
    [wing] = [component for component in expected["component"] if component["name"] == "wing_right"]
    wing["distributed_mass"][0]["parts"][1]["total_kg"] *= 0.25
    assert found == expected
    assert clearance.mass_case(text, 1.0) == text
    with pytest.raises(SystemExit, match="no line with `total_kg`"):
        clearance.mass_case(text.replace("# fuel", "# paraffin"), 0.5)


def test_every_point_of_the_grid_is_flown_once():
    points = clearance.all_points()
    assert [point["point"] for point in points] == list(range(1000))
    assert len({tuple(point[name] for name in ("fuel", *clearance.GRID)) for point in points}) == 1000
    first = points[:POINTS]
    assert all(len({point[name] for point in first}) >= 4 for name in ("fuel", *clearance.GRID))


def test_a_worker_that_is_killed_changes_no_bit_of_the_table(cleared, undisturbed):
    killed, kill = killer(4)
    disturbed = cleared("disturbed.csv", kill)
    assert len(killed) == 1
    assert disturbed.read_bytes() == undisturbed.read_bytes()
    assert undisturbed.with_suffix(".png").read_bytes().startswith(b"\x89PNG")


def test_parquet_has_the_same_numbers(cleared, rows):
    table = pyarrow.parquet.read_table(cleared("rows.parquet")).to_pylist()
    for row, expected in zip(table, rows, strict=True):
        assert {name: "" if value is None else str(value) for name, value in row.items()} == expected


def test_what_has_no_trim_is_a_row_that_says_why(rows):
    assert [int(row["point"]) for row in rows] == list(range(POINTS))
    statuses = [row["status"] for row in rows]
    assert set(statuses) == {"ok", "no_trim"} and statuses.count("ok") >= 15
    for row in rows:
        if row["status"] == "no_trim":
            assert "the trim at " in row["message"] and "usual limit" in row["message"]
            assert row["bending.trim"] == row["bending.closed"] == ""
        else:
            assert row["message"] == ""


def test_the_law_takes_bending_off_everywhere(rows):
    flown = [row for row in rows if row["status"] == "ok"]
    bending = {loop: np.array([float(row[f"bending.{loop}"]) for row in flown]) for loop in ("trim", "open", "closed")}
    shares = (bending["open"] - bending["closed"]) / (bending["open"] - bending["trim"])
    assert shares.min() > 0.05
    assert bending["closed"].max() < 0.9 * bending["open"].max()


def test_without_the_law_it_is_the_flight_of_the_plain_fmu(rows, cases):
    flown = [row for row in rows if row["status"] == "ok"]
    for row in flown[:2]:
        starts = clearance.GUST | clearance.ACTUATOR | {name: float(row[name]) for name in clearance.GRID}
        bending, factors = [], []
        for gradient in clearance.GRADIENTS:
            flight = simulate_fmu(
                str(clearance.case(cases, float(row["fuel"]))),
                stop_time=clearance.STEP * clearance.STEPS,
                step_size=clearance.STEP,
                output_interval=clearance.STEP,
                start_values=starts | {"gust.gradient": gradient},
                output=clearance.KEPT,
            )
            assert len(flight) == clearance.STEPS + 1
            bending.append(flight[clearance.BENDING].max())
            factors.append(flight[clearance.LOAD_FACTOR].max())
        assert float(row["bending.open"]) == max(bending)
        assert float(row["gradient.open"]) == clearance.GRADIENTS[np.argmax(bending)]
        assert float(row["load_factor.open"]) == max(factors)


def test_the_loop_is_that_of_the_coupled_system(aircraft, in_rust, monkeypatch):
    """The law in Rust, in the gust of the README."""
    unpacked = extract(aircraft), read_model_description(aircraft)
    monkeypatch.setattr(clearance, "unpacked", lambda fmu: unpacked)
    monkeypatch.setattr(clearance, "GUST", {"gust.shape": 2})
    point = {"point": 0, "stiffness_scale": 1.0, "altitude": 7620.0, "airspeed": 127.0}
    for law, how in ((None, ["open"]), (clearance.AlleviationLaw(), [])):
        found = np.array(clearance.flight(aircraft, point, 63.5, law, [])[clearance.LOAD_FACTOR])
        expected = in_rust("gust_load_alleviation", *how)[clearance.LOAD_FACTOR][: len(found)]
        assert np.abs(found - expected).max() <= 1e-9 * np.abs(expected).max()
