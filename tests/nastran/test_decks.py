"""`flexair import nastran` beside pyNastran, a reader that others keep: the same grids, masses, centre and inertia of one deck.

FLEXAIR is the command; without it the one of a release."""

import json
import os
import re
import subprocess
import tomllib
from pathlib import Path

import numpy as np
import pytest
from pyNastran.bdf.bdf import BDF
from pyNastran.bdf.mesh_utils.mass_properties import mass_properties

ROOT = Path(__file__).parents[2]
FLEXAIR = os.environ.get("FLEXAIR", str(ROOT / "target/release/flexair"))
DECK = ROOT / "examples/nastran/transport.bdf"

# x forward, y right, z down of x aft, y right, z up.
TO_BODY = np.diag([-1.0, 1.0, -1.0])


@pytest.fixture(scope="module")
def deck():
    """The deck as pyNastran reads it."""
    model = BDF(debug=None)
    model.read_bdf(str(DECK))
    return model


@pytest.fixture(scope="module")
def imported(tmp_path_factory):
    """The aircraft file, as tables and as a path, and what the import said."""
    file = tmp_path_factory.mktemp("nastran") / "transport.toml"
    run = subprocess.run([FLEXAIR, "import", "nastran", DECK, "--output", file], capture_output=True, text=True)
    assert run.returncode == 2, run.stderr
    return tomllib.loads(file.read_text()), file, run.stdout


@pytest.fixture(scope="module")
def origin(deck, imported):
    """The place of O in the deck: of the grid that the import names."""
    return np.asarray(deck.nodes[int(re.search(r"^O: GRID (\d+)", imported[2], re.MULTILINE)[1])].get_position())


def body(model, grid, origin):
    """The place of a grid in body axes from O."""
    return TO_BODY @ (model.nodes[grid].get_position() - origin)


def nodes(tables):
    """The nodes of each component by its name, as the format says: corners, elements between them, images in y = 0."""
    placed = {}
    for component in tables["component"]:
        counts = component["elements"] if isinstance(component["elements"], list) else [component["elements"]]
        corners = np.array(component["axis_m"], dtype=float)
        steps = [start + (end - start) * step / count for start, end, count in zip(corners, corners[1:], counts) for step in range(1, count + 1)]
        line = np.vstack([corners[:1], steps])
        if component["attached_to"] != "origin":
            parent = placed[component["attached_to"]["component"]]
            lengths = np.r_[0, np.cumsum(np.linalg.norm(np.diff(parent, axis=0), axis=1))]
            line = line + parent[np.argmin(abs(lengths - component["attached_to"]["at"] * lengths[-1]))]
        placed[component["name"]] = line
        if "mirror" in component:
            placed[component["mirror"]] = line * [1, -1, 1]
    return placed


def test_every_grid_with_an_element_is_a_node(deck, imported, origin):
    found = np.vstack(list(nodes(imported[0]).values()))
    for element in deck.elements.values():
        for grid in element.node_ids:
            distance = np.linalg.norm(found - body(deck, grid, origin), axis=1).min()
            assert distance < 1e-9, f"GRID {grid} is {distance} m from the next node"


def test_mass_centre_and_inertia_are_those_of_the_kept_reader(deck, imported, origin):
    run = subprocess.run([FLEXAIR, "describe", imported[1], "--json", "-"], capture_output=True, text=True, check=True)
    described = json.loads(run.stdout)
    mass, centre, inertia = mass_properties(deck)
    assert described["mass"] == pytest.approx(mass, rel=1e-9)
    assert np.array(described["centre_of_mass"]) == pytest.approx(TO_BODY @ (centre - origin), abs=1e-8)
    xx, yy, zz, xy, xz, yz = inertia
    theirs = TO_BODY @ np.array([[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]]) @ TO_BODY
    # pyNastran has an element's mass at its middle: what a rod has about it.
    for element in deck.elements.values():
        one, other = (body(deck, grid, origin) for grid in element.node_ids)
        along = other - one
        theirs += element.Mass() / 12 * (along @ along * np.eye(3) - np.outer(along, along))
    # Of both engines the pitching moment alone is given: the import adds as much in yaw, as of a body along x, and says so.
    assert "CONM2 3201: no body has the principal moments 0.000000, 0.000000, 310.000000" in imported[2]
    theirs += 2 * np.diag([0.0, 0.0, 310.0])
    ours = np.array(described["inertia"]["about_centre_of_mass"])
    assert ours == pytest.approx(theirs, rel=1e-8, abs=1e-8 * np.abs(theirs).max())
