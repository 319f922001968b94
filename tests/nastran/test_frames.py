"""What `flexair import nastran` writes swings as a frame of finite elements that reads the same deck by pyNastran (frames.py)."""

import json
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from frames import Frame, read

ROOT = Path(__file__).parents[2]
FLEXAIR = os.environ.get("FLEXAIR", str(ROOT / "target/release/flexair"))
DECKS = Path(__file__).parent / "decks"

# x forward, y right, z down of x aft, y right, z up.
TO_BODY = np.diag([-1.0, 1.0, -1.0])

INCH = 0.0254
POUND = 0.45359237 * 9.80665

# Coordinate systems within one another, offsets in all of their frames, masses in basic, rectangular and cylindrical ones, inches and pounds:
# a deck, its units by options, a length in m, a force in N, and how far frequencies may be from those of a frame with the same places of
# masses. Measured are 4.4e-8, and 6.1e-5 where a short stiff link is at each grid: by as much rounding moves the lowest frequency there, 8e-5
# either way when these links are made up to ten times as stiff.
FRAMED = [
    ("t-tail-inch", ["--units", "in"], INCH, POUND, 5e-7),
    ("frames-in-frames", [], 1.0, 1.0, 1.5e-4),
]

# A swept wing in pieces whose sections are skew and whose neutral axis is apart from the shear centre, with offsets, a mass and a rod below it.
SKEW = """MAT1,1,7.+10,,.3,2700.
PBEAM,1,1,.004,2.-5,8.-5,2.5-5,5.-5
+
+,0.,0.
+,.05,-.02,,,.04,-.06
PBAR,2,1,.003,1.-5,6.-5,4.-5
+
+,,,-1.2-5
PROD,3,1,3.-4
SPC1,1,123456,1
GRID,50,,.2,.3,-1.2
RBE2,50,1,123456,50
CROD,60,3,50,13
CONM2,70,20,,15.,.2,0.,.05
+,.4,.02,.6,-.01,.03,.9
""" + "".join(
    f"GRID,{grid},,{0.08 * (grid - 1):.4f},{0.35 * (grid - 1):.4f},{0.02 * (grid - 1):.4f}\n" for grid in range(1, 21)
) + "".join(
    f"{'CBEAM' if grid < 11 else 'CBAR'},{grid},{1 if grid < 11 else 2},{grid},{grid + 1},.1,0.,1.\n" for grid in range(1, 20)
)

# The same without the clamp and the rod: springs about the basic axes hold its root.
SPRUNG = SKEW.replace("SPC1,1,123456,1\n", "CBUSH,80,80,1,,,,,0\nPBUSH,80,K,,,,4.+5,2.+6,3.+5\n").replace("CROD,60,3,50,13\n", "")


def described(deck, folder, options=(), codes=(0,)):
    """What `describe` says of the imported file, with beams that stretch too, as those of a frame; what the file and the import say. The import
    ends with one of some codes: 2, with a report, where springs along axes are rigid."""
    file = folder / "aircraft.toml"
    imported = subprocess.run([FLEXAIR, "import", "nastran", deck, "--output", file, *options], capture_output=True, text=True)
    assert imported.returncode in codes, imported.stdout + imported.stderr
    written = file.read_text()
    full = written.replace('mode_basis = "bending_torsion"', 'mode_basis = "full"').replace('model = "geometrically_exact"\n', "")
    file.write_text(full)
    run = subprocess.run([FLEXAIR, "describe", file, "--modes", "12", "--json", "-"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout), written, imported.stdout


def both(deck, folder, code=0, **held):
    """Frequencies of the file, rad/s, by `describe`; of the frame, clamped; what the file says."""
    found, written, _ = described(deck, folder, codes=(code,))
    ours = np.array(sorted(mode["angular_frequency"] for mode in found["modes"]))
    return ours, Frame(read(deck)).frequencies(**held), written


def agree(ours, theirs):
    """Twelve frequencies to 1e-3, as fine as the elements are (3e-4 with the deck's struts of four); the first four to 1e-4."""
    assert len(ours) == 12
    assert ours / theirs[:12] == pytest.approx(1, abs=1e-3)
    assert ours[:4] / theirs[:4] == pytest.approx(1, abs=1e-4)


def test_a_braced_wing_swings_as_its_frame(tmp_path):
    ours, theirs, written = both(ROOT / "examples/nastran/braced.bdf", tmp_path, clamped=1)
    assert "symmetric = true" in written and 'model = "exact"' in written and written.count("\n[[joint]]") == 1
    agree(ours, theirs)


@pytest.mark.parametrize("text, held", [(SKEW, {}), (SPRUNG, {"components": range(3), "code": 2})], ids=["clamped", "sprung"])
def test_skew_sections_offset_axes_rods_and_springs_swing_as_their_frame(tmp_path, text, held):
    deck = tmp_path / "deck.bdf"
    deck.write_text(text)
    ours, theirs, written = both(deck, tmp_path, clamped=1, **held)
    assert "EI_yz_N_m2" in written and "tension_axis_y_m" in written
    agree(ours, theirs)


@pytest.fixture(scope="module", params=FRAMED, ids=lambda case: case[0])
def framed(request, tmp_path_factory):
    """The frame of a deck, its units, and what the command describes of the file."""
    name, options, length, force, tolerance = request.param
    deck = DECKS / f"{name}.bdf"
    found, _, report = described(deck, tmp_path_factory.mktemp("frames"), options, codes=(0, 2))
    root = int(re.search(r"^O: GRID (\d+)", report, re.MULTILINE)[1])
    return Frame(read(deck), points=2), found, root, (length, force, tolerance)


def test_masses_in_frames_within_frames_have_their_centre_and_inertia(framed):
    frame, found, root, (length, force, _) = framed
    mass, centre, inertia = frame.mass_properties()
    assert found["mass"] == pytest.approx(mass * force / length, rel=2e-12)
    arm = TO_BODY @ (centre - frame.place[root]) * length
    assert np.array(found["centre_of_mass"]) == pytest.approx(arm, abs=1e-11 * np.linalg.norm(arm))
    theirs = TO_BODY @ inertia @ TO_BODY * force * length
    ours = np.array(found["inertia"]["about_centre_of_mass"])
    assert ours == pytest.approx(theirs, abs=1e-11 * np.abs(theirs).max())


def test_offsets_and_orientations_in_frames_swing_as_their_frame(framed):
    frame, found, root, (_, _, tolerance) = framed
    ours = np.array(sorted(mode["angular_frequency"] for mode in found["modes"]))
    assert len(ours) == 12
    assert ours / frame.frequencies(root)[:12] == pytest.approx(1, abs=tolerance)
