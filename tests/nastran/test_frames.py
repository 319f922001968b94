"""`flexair import nastran` beside a frame model of our own (`frame.py`): coordinate systems within one another, offsets in all of their
frames, masses in basic, rectangular and cylindrical ones, inches and pounds; masses and natural frequencies.

FLEXAIR is the command; without it the one of a release."""

import json
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from frame import Frame, read

ROOT = Path(__file__).parents[2]
FLEXAIR = os.environ.get("FLEXAIR", str(ROOT / "target/release/flexair"))
DECKS = Path(__file__).parent / "decks"

# x forward, y right, z down of x aft, y right, z up.
TO_BODY = np.diag([-1.0, 1.0, -1.0])

INCH = 0.0254
POUND = 0.45359237 * 9.80665

# A deck, its units by options, a length in m, a force in N, and how far frequencies may be apart: ten times what was measured.
CASES = [
    ("t-tail-inch", ["--units", "in"], INCH, POUND, 5e-7),
    ("frames-in-frames", [], 1.0, 1.0, 1.5e-4),
]


@pytest.fixture(scope="module", params=CASES, ids=lambda case: case[0])
def case(request, tmp_path_factory):
    """The frame of a deck, its units, and what the command describes of the file with all of the beams' give."""
    name, options, length, force, tolerance = request.param
    file = tmp_path_factory.mktemp("frames") / f"{name}.toml"
    deck = DECKS / f"{name}.bdf"
    run = subprocess.run([FLEXAIR, "import", "nastran", deck, "--output", file, *options], capture_output=True, text=True)
    assert run.returncode in (0, 2), run.stderr
    text = file.read_text().replace('mode_basis = "bending_torsion"', 'mode_basis = "full"')
    file.write_text(text.replace('model = "geometrically_exact"\n', ""))
    described = subprocess.run([FLEXAIR, "describe", file, "--json", "-"], capture_output=True, text=True, check=True)
    root = int(re.search(r"^O: GRID (\d+)", run.stdout, re.MULTILINE)[1])
    return Frame(read(deck)), json.loads(described.stdout), root, (length, force, tolerance)


def test_mass_centre_and_inertia(case):
    frame, described, root, (length, force, _) = case
    mass, centre, inertia = frame.mass_properties()
    assert described["mass"] == pytest.approx(mass * force / length, rel=2e-12)
    arm = TO_BODY @ (centre - frame.places[root]) * length
    assert np.array(described["centre_of_mass"]) == pytest.approx(arm, abs=1e-11 * np.linalg.norm(arm))
    theirs = TO_BODY @ inertia @ TO_BODY * force * length
    ours = np.array(described["inertia"]["about_centre_of_mass"])
    assert ours == pytest.approx(theirs, abs=1e-11 * np.abs(theirs).max())


def test_natural_frequencies(case):
    frame, described, root, (_, _, tolerance) = case
    theirs = frame.frequencies(root)[:12]
    ours = [mode["frequency"] for mode in described["modes"]][:12]
    assert len(ours) == 12
    assert np.array(ours) / theirs == pytest.approx(np.ones(12), abs=tolerance)
