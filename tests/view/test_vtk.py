"""meshio reads what `flexair view --vtk` writes: strips with lift, beams with section loads, as `flexair simulate` has them.

The command is the one named by the environment variable FLEXAIR.
"""

import json
import os
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

import meshio
import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
FLEXAIR = Path(os.environ.get("FLEXAIR", ROOT / "target/release/flexair")).absolute()

RATE = 20
FRAMES = 11
GUST = ["--set", "gust.shape=one_minus_cosine", "--set", "gust.gradient=15", "--set", "gust.start=0.1"]

LOADS = {"bending": "N m", "torsion": "N m", "shear": "N", "bending_chordwise": "N m", "shear_chordwise": "N", "axial": "N"}
UNITS = {
    "strips": {"displacement": "m", "lift": "N/m"},
    "beams": {"displacement": "m", "twist": "rad", "acceleration": "m/s²", **LOADS},
}


@dataclass
class Aircraft:
    file: str
    flight: list[str]
    station: str
    # At the root of the first component.
    cut: str | None = None
    is_free: bool = True
    # How far from a table its points may stand, m, and how far off loads may be, in parts of their peak: numbers are single.
    near: float = 1.5e-5
    close: float = 5e-7


AIRCRAFT = [
    Aircraft("aircraft/generic-business-jet.toml", GUST, "wing_tip_right", cut="wing_root_right"),
    Aircraft("tests/data/twin-boom.toml", GUST, "tip_left"),
    # Geometrically exact: with a section at every node, as pages have it, it bends a little otherwise.
    Aircraft(
        "aircraft/very-flexible-wing.toml",
        ["--input", "wind_down=sine:-2@0.1:1"],
        "tip",
        cut="root",
        is_free=False,
        near=3e-4,
        close=1e-2,
    ),
]


def run(*options):
    return subprocess.run([FLEXAIR, *map(str, options)], check=True, capture_output=True, encoding="utf-8").stdout


def listed(list_file):
    """The times and files of a .pvd."""
    root = ElementTree.parse(list_file).getroot()
    assert (root.tag, root.get("type")) == ("VTKFile", "Collection")
    sets = root.findall("./Collection/DataSet")
    return [float(one.get("timestep")) for one in sets], [list_file.parent / one.get("file") for one in sets]


class Flight:
    """A flight as files for ParaView and as a table."""

    def __init__(self, aircraft, folder):
        self.aircraft = aircraft
        self.folder = folder / "vtk"
        file = ROOT / aircraft.file
        flight = [*aircraft.flight, "--duration", (FRAMES - 1) / RATE]
        run("view", file, *flight, "--rate", RATE, "--vtk", self.folder, "--output", folder / "page.html")
        run("simulate", "--aircraft", file, *flight, "--step", 1 / RATE, "--output", folder / "flight.csv")
        self.table = np.genfromtxt(folder / "flight.csv", delimiter=",", names=True, deletechars="")
        self.described = json.loads(run("describe", file, "--json", "-"))
        lists = {what: list(self.folder.glob(f"*-{what}.pvd")) for what in UNITS}
        assert [len(found) for found in lists.values()] == [1, 1]
        self.lists = {what: found[0] for what, found in lists.items()}
        self.meshes = {what: [meshio.read(file) for file in listed(found)[1]] for what, found in self.lists.items()}

    def columns(self, name, *parts):
        return np.stack([self.table[f"{name}{part}"] for part in parts], axis=1)


@pytest.fixture(scope="module", params=AIRCRAFT, ids=lambda aircraft: Path(aircraft.file).stem)
def flight(request, tmp_path_factory):
    return Flight(request.param, tmp_path_factory.mktemp("view"))


def to_north_west_up(vectors):
    """From north, east, down."""
    return vectors * [1, -1, -1]


def turned(quaternions, vectors):
    """Vectors, turned by quaternions whose scalar comes first."""
    scalar, axis = quaternions[:, :1], quaternions[:, 1:]
    across = np.cross(axis, vectors)
    return vectors + 2 * (scalar * across + np.cross(axis, across))


def tip(flight):
    """The point of the beams that is nearest to the station in the first frame."""
    origin = flight.columns("position.", "north", "east", "down")[0]
    station = flight.columns(f"station.{flight.aircraft.station}.position.", "north", "east", "down")
    places = to_north_west_up(station - origin)
    return np.linalg.norm(flight.meshes["beams"][0].points - places[0], axis=1).argmin(), places


def test_a_list_has_a_file_for_each_frame_and_there_are_no_others(flight):
    every = []
    for found in flight.lists.values():
        times, files = listed(found)
        assert times == pytest.approx(np.arange(FRAMES) / RATE, abs=1e-12)
        assert times == pytest.approx(flight.table["time"], abs=1e-12)
        every += [found, *files]
    assert len(set(every)) == 2 * (FRAMES + 1)
    assert sorted(every) == sorted(path for path in flight.folder.rglob("*") if path.is_file())


def test_strips_are_quadrilaterals_and_elements_lines_in_every_frame(flight):
    counts = flight.described["counts"]
    nodes = counts["elements"] + counts["components"]
    for what, kind, cells, points in [
        ("strips", "quad", counts["strips"], 4 * counts["strips"]),
        ("beams", "line", counts["elements"], nodes),
    ]:
        for mesh in flight.meshes[what]:
            assert [(block.type, len(block.data)) for block in mesh.cells] == [(kind, cells)]
            assert mesh.points.shape == (points, 3)
            # Each point is of some cell.
            assert set(mesh.cells[0].data.flat) == set(range(points))


def test_fields_are_finite_and_have_units(flight):
    for what, units in UNITS.items():
        for mesh in flight.meshes[what]:
            fields = {**mesh.point_data, **{name: blocks[0] for name, blocks in mesh.cell_data.items()}}
            assert fields.keys() == units.keys()
            for name, values in {"points": mesh.points, **fields}.items():
                assert np.isfinite(values).all(), name
            assert all(values.ndim == 1 + (name == "displacement") for name, values in fields.items())
        for file in listed(flight.lists[what])[1]:
            arrays = ElementTree.parse(file).getroot().findall(".//DataArray")
            said = {array.get("Name"): array.findtext("InformationKey[@name='UNITS_LABEL']") for array in arrays}
            geometry = dict.fromkeys(["connectivity", "offsets", "types"])
            assert said == {"points": "m", **geometry, **units}


def test_the_lift_of_the_strips_carries_the_weight(flight):
    if not flight.aircraft.is_free:
        pytest.skip("the tunnel's wall carries the weight")
    mesh = flight.meshes["strips"][0]
    leading_in, leading_out, trailing_out, trailing_in = mesh.points[mesh.cells[0].data].astype(float).transpose(1, 0, 2)
    areas = np.cross(trailing_out - leading_in, trailing_in - leading_out) / 2
    areas *= np.where(areas[:, 2:] < 0, -1, 1)
    chords = (np.linalg.norm(leading_in - trailing_in, axis=1) + np.linalg.norm(leading_out - trailing_out, axis=1)) / 2
    # A strip is as wide as its area over its chord; lift acts across it.
    lift = (mesh.cell_data["lift"][0] * areas[:, 2] / chords).sum()
    begin = flight.table[0]
    thrust = sum(begin[name] for name in begin.dtype.names if name.startswith("engine.") and name.endswith(".thrust"))
    # The air's force along the chords carries the rest.
    weight = flight.described["mass"] * 9.80665
    assert lift + thrust * np.sin(begin["attitude.pitch"]) == pytest.approx(weight, rel=0.01)


def test_beams_stand_and_bend_as_simulate_says(flight):
    point, places = tip(flight)
    bent = flight.columns(f"deflection.{flight.aircraft.station}.", "x", "y", "z")
    attitude = flight.columns("attitude.quaternion", *(f"[{part}]" for part in range(1, 5)))
    displacements = to_north_west_up(turned(attitude, bent))
    meshes = flight.meshes["beams"]
    assert np.ptp(np.linalg.norm(bent, axis=1)) > 1e-3
    assert np.array([mesh.points[point] for mesh in meshes]) == pytest.approx(places, abs=flight.aircraft.near)
    written = np.array([mesh.point_data["displacement"][point] for mesh in meshes])
    assert written == pytest.approx(displacements, abs=flight.aircraft.near)


def test_section_loads_are_those_of_a_cut_at_the_same_node(flight):
    if flight.aircraft.cut is None:
        pytest.skip("the file names no cut")
    for load in LOADS:
        written = np.array([mesh.point_data[load][0] for mesh in flight.meshes["beams"]])
        cut = flight.table[f"loads.{flight.aircraft.cut}.{load}"]
        assert written == pytest.approx(cut, rel=0, abs=flight.aircraft.close * np.abs(cut).max()), load


def test_a_shorter_flight_leaves_no_frames_of_a_longer_one(tmp_path):
    view = ["view", ROOT / "aircraft/very-flexible-wing.toml", "--rate", 10, "--output", tmp_path / "page.html"]
    view += ["--vtk", tmp_path / "vtk"]
    run(*view, "--duration", 0.4)
    assert len(list(tmp_path.rglob("*.vtu"))) == 2 * 5
    run(*view, "--duration", 0.2)
    assert len(list(tmp_path.rglob("*.vtu"))) == 2 * 3
