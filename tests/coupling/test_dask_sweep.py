"""The Dask example has the same rows whether or not a worker dies, and those of `flexair sweep`."""

import csv
import sys

import pyarrow.parquet
import pytest
from distributed import Client

from conftest import ROOT, killer

POINTS = 24


@pytest.fixture(scope="module")
def swept(aircraft, on_cluster):
    """A function that runs the example on a cluster: its table as a file. `after(lines, cluster)` is called for each result."""

    def swept(name, after=None):
        return on_cluster("dask_sweep", POINTS, name, "--fmu", aircraft, after=after)

    return swept


@pytest.fixture(scope="module")
def undisturbed(swept):
    return swept("undisturbed.csv")


def test_a_worker_that_is_killed_changes_no_bit_of_the_table(swept, undisturbed):
    killed, kill = killer(5)
    disturbed = swept("disturbed.csv", kill)
    assert len(killed) == 1
    assert disturbed.read_bytes() == undisturbed.read_bytes()
    rows = list(csv.DictReader(undisturbed.open(encoding="utf-8")))
    assert [row["point"] for row in rows] == [str(number) for number in range(POINTS)]
    assert {row["status"] for row in rows} == {"ok"}


def test_parquet_has_the_same_numbers(swept, undisturbed):
    table = pyarrow.parquet.read_table(swept("gusts.parquet")).to_pylist()
    rows = list(csv.DictReader(undisturbed.open(encoding="utf-8")))
    for row, expected in zip(table, rows, strict=True):
        assert {name: str(value) for name, value in row.items()} == expected


def test_flexair_sweep_flies_the_same_gusts(undisturbed, sweep):
    rows = list(csv.DictReader(undisturbed.open(encoding="utf-8")))
    varied = "gust.gradient", "gust.peak"
    for row in rows[:3]:
        vary = "".join(f'[[vary]]\nname = "{name}"\nvalues = [{row[name]}]\n' for name in varied)
        keep = "".join(
            f'[[keep]]\noutput = "{output}"\nreduce = ["max", "min"]\n'
            for output in ("load_factor.z", "deflection.wing_tip_right.up")
        )
        table = sweep(f'{vary}[run]\nkind = "gust"\nduration = 5\nstep = 0.01\n{keep}')
        [found] = table.to_pylist()
        for name, value in found.items():
            if name not in ("point", "status", "message"):
                assert value == float(row[name]), name


def test_what_cannot_be_flown_is_a_row_that_says_why(aircraft):
    """Too slow for the wings; a gust beyond all numbers; one of a length that none has."""
    sys.path.insert(0, str(ROOT / "examples"))
    import dask_sweep

    gust = {"gust.gradient": 30.0, "gust.peak": 1.0}
    points = [{"airspeed": 40.0, **gust}, {**gust, "gust.peak": 1e300}, {**gust, "gust.gradient": 1e9}]
    points = [{"point": number, **point} for number, point in enumerate(points)]
    with Client(n_workers=1, threads_per_worker=1, dashboard_address=":0") as client:
        client.upload_file(str(ROOT / "examples/dask_sweep.py"))
        found = dask_sweep.rows(client, dask_sweep.fly, points, fmu=str(aircraft.resolve()))
        rows = sorted(found, key=lambda row: row["point"])
    expected = [("no_trim", "too slow: "), ("left_validity", "no longer finite"), ("invalid", "allowed is 0.01 to ")]
    for row, (status, message) in zip(rows, expected, strict=True):
        assert row["status"] == status and message in row["message"] and "%%" not in row["message"]
        assert "load_factor.z.max" not in row
