"""The Pazy wing against the published results of UM/NAST, with data that are not ours to ship.

    git clone https://github.com/UM-A2SRL/AePW3-LDWG target/AePW3-LDWG
    git -C target/AePW3-LDWG checkout 396710a
    cargo build --release -p flexair
    python3 tests/pazy/compare.py target/AePW3-LDWG --write

C. Riso, C. E. S. Cesnik, IFASD 2022 and AIAA SciTech Forum 2022: the beam model of the Technion Pazy wing with skin, its
lift slopes, and what their program found, as of commit 396710a. The data have no licence: nothing of them is kept here, the
aircraft file is made anew in a temporary folder. With `--write` the comparison becomes a record of VERIFICATION.md, which
UPDATE_GOLDEN=1 then copies there. Not part of CI.
"""

import argparse
import csv
import datetime
import re
import subprocess
import sys
import tempfile
import zipfile
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
RECORD = ROOT / "tests/verification/records/pazy.md"

BEAM = "00_Models/01_Pazy_Technion/02_Models_Beam"
COORDINATES = f"{BEAM}/01_Coordinates/coordinates.txt"
INERTIA = f"{BEAM}/02_Inertia_Distributions/inertia_skin1.xlsx"
STIFFNESS = f"{BEAM}/03_Stiffness_Distributions/stiffness_skin1.xlsx"
IFASD = "02_2022_IFASD_Riso_Cesnik"
LIFT_SLOPES = f"{IFASD}/01_Static_Aeroelastic/00_Aero_Coefficients/aero_coeff.txt"
STATIC = f"{IFASD}/01_Static_Aeroelastic/02_Sweeps/static_aeroelastic_aoa{{}}_UM_NAST_sweep_w_skin.txt"
ONSETS = f"{IFASD}/03_Flutter_Deformed/nonlinear_flutter_UM_NAST_onset_w_skin.txt"
BENDING = "01_2022_SciTech_Riso_Cesnik/03_Static_Bending/02_Sweeps/static_bending_UM_NAST_sweep_w_skin.txt"

MODES = 12
# The independent computation has two digits after the point, and does not say its inflow states.
SAME_EQUATIONS = 0.004
INFLOW_STATES = 8
# Chord, m; where the beam runs, as a fraction of it.
CHORD = 0.1
AXIS = 0.44
# What an independent computation with these equations found: tip up over airspeed (m/s), tip under a mass (kg), % of
# the span, or None where it did not look; onset of the hump over root incidence (degrees), m/s.
INDEPENDENT_TIPS = {
    5: {10: None, 20: 4.26, 30: 10.01, 40: 18.67, 50: 30.28, 60: 43.72},
    7: {10: None, 20: 5.92, 30: 13.78, 40: 25.10, 50: 38.83, 60: 52.57},
}
INDEPENDENT_BENDING = {1: -20.03, 2: -35.47, 3: -46.28}
INDEPENDENT_ONSETS = {3: 50.66, 5: 43.21, 7: 38.53}

SPREADSHEET = {"m": "http://schemas.openxmlformats.org/spreadsheetml/2006/main"}


def sheet(path):
    """The columns of the first sheet of a workbook by their headings."""
    with zipfile.ZipFile(path) as book:
        strings = ElementTree.fromstring(book.read("xl/sharedStrings.xml")).findall("m:si", SPREADSHEET)
        cells = ElementTree.fromstring(book.read("xl/worksheets/sheet1.xml"))
    rows = [[cell for cell in row if len(cell)] for row in cells.iterfind(".//m:row", SPREADSHEET)]
    values = [[cell.findtext("m:v", namespaces=SPREADSHEET) for cell in row] for row in rows]
    names = ["".join(strings[int(index)].itertext()) for index in values[0]]
    return {name: [float(row[place]) for row in values[1:]] for place, name in enumerate(names)}


def table(path, separator=None):
    """The numbers of a text file, a tuple for each line that has some."""
    lines = [line.split(separator) for line in path.read_text().splitlines() if line.strip()]
    return [tuple(float(cell) for cell in line) for line in lines if "x" not in line[0]]


def interpolate(pairs, at):
    """Linear between pairs in ascending order; where two have one place, the first counts."""
    for (low, before), (high, after) in pairwise(pairs):
        if low <= at <= high and low < high:
            return before + (after - before) * (at - low) / (high - low)
    raise ValueError(f"found {at}, allowed is {pairs[0][0]} to {pairs[-1][0]}")


class Wing:
    """The data, from which aircraft files are made."""

    def __init__(self, data):
        self.stations = [y for _, y, _ in table(data / COORDINATES, ",")]
        self.inertia = sheet(data / INERTIA)
        self.stiffness = sheet(data / STIFFNESS)
        self.lift_slopes = [(y, slope) for y, slope, _ in table(data / LIFT_SLOPES)]
        self.span = self.stations[-1]

    def aircraft(self, incidence=0.0, weight=False, tip_mass=0.0):
        """An aircraft file: root incidence in degrees, mass at the middle of the tip's chord in kg."""
        k = self.stiffness
        in_plane = [k44 - k14 * k14 / k11 for k11, k14, k44 in zip(k["K11"], k["K14"], k["K44"])]
        text = f"""
            format = 1
            name = "Pazy wing"
            gravity_m_s2 = {9.80665 if weight else 0}
            support = "clamped"
            mount_attitude_deg = [0, {incidence}, 0]
            mode_basis = "bending_torsion"
            model = "geometrically_exact"
            inflow_states = {INFLOW_STATES}
            density_kg_m3 = 1.225
            [[component]]
            name = "wing"
            attached_to = "origin"
            axis_m = {[[0, y, 0] for y in self.stations]}
            elements = {[1] * len(k["K11"])}
            y_axis = [1, 0, 0]
            chord_m = {CHORD}
            EA_N = {{ per_element = {k["K11"]} }}
            GJ_N_m2 = {{ per_element = {k["K22"]} }}
            EI_y_N_m2 = {{ per_element = {k["K33"]} }}
            EI_z_N_m2 = {{ per_element = {in_plane} }}
            [[station]]
            name = "tip"
            component = "wing"
            at = 1
        """
        return "\n".join([text, *self.surfaces(), *self.bays(), self.load(tip_mass)])

    def surfaces(self):
        """Two strips an element."""
        for root, tip in pairwise(self.stations):
            for inner, outer in pairwise([root, 0.5 * (root + tip), tip]):
                yield f"""
                    [[component.surface]]
                    from = {inner / self.span}
                    to = {outer / self.span}
                    elastic_axis = {AXIS}
                    lift_slope_per_rad = {interpolate(self.lift_slopes, 0.5 * (inner + outer))}
                    profile_drag = 0
                """

    def bays(self):
        """A mass at each node but the root, from axes with x aft and z up."""
        rows = [dict(zip(self.inertia, row)) for row in zip(*self.inertia.values())]
        for y, row in list(zip(self.stations, rows))[1:]:
            yield f"""
                [[component.point_masses]]
                at_m = {y}
                mass_kg = {row["mass"]}
                offset_m = [{-row["cgx"]}, {row["cgy"]}, {-row["cgz"]}]
                inertia_kg_m2 = [{row["Ixx"]}, {row["Iyy"]}, {row["Izz"]}]
            """

    def load(self, mass):
        if mass == 0.0:
            return ""
        return f"""
            [[component.point_masses]]
            at = 1
            mass_kg = {mass}
            offset_m = [{-(0.5 - AXIS) * CHORD}, 0, 0]
        """


class Program:
    """`flexair` in a temporary folder."""

    def __init__(self, flexair, folder):
        self.flexair, self.folder = flexair, Path(folder)
        (self.folder / "rest.csv").write_text("time\n0\n")

    def run(self, command, aircraft, *options):
        file = self.folder / "pazy.toml"
        file.write_text(aircraft)
        options = [*command, *(str(option) for option in options)]
        options = [str(file) if option == "AIRCRAFT" else option for option in options]
        result = subprocess.run([self.flexair, *options], cwd=self.folder, capture_output=True, text=True)
        if result.returncode:
            sys.exit(result.stderr)
        return result.stdout

    def tip(self, aircraft, airspeed):
        """How far the tip is up at rest, normal to the root's chord, m."""
        command = ["simulate", "rest.csv", "--aircraft", "AIRCRAFT", "--modes", str(MODES)]
        [row] = csv.DictReader(self.run(command, aircraft, "--set", f"airspeed={airspeed}").splitlines())
        return float(row["deflection.tip.up"])

    def onset(self, aircraft, around):
        """The lowest flutter speed, m/s, in a range about where it is expected."""
        command = ["flutter", "AIRCRAFT", "--modes", str(MODES), "--output", str(self.folder)]
        limits = ["--from", 0.8 * around, "--to", 1.1 * around, "--points", 7]
        report = self.run(command, aircraft, *limits)
        found = re.search(r"^ *([\d.]+) m/s  flutter ", report, re.MULTILINE)
        return float(found[1]) if found else sys.exit(f"no flutter:\n{report}")


@dataclass
class Row:
    """A number beside what others found: UM/NAST's is to be met within a share, or merely shown, the independent one within less."""

    case: str
    published: float
    independent: float | None
    found: float
    tolerance: float | None

    @property
    def deviation(self):
        return self.found / self.published - 1.0

    @property
    def holds(self):
        beside = self.independent is None or abs(self.found / self.independent - 1.0) <= SAME_EQUATIONS
        return beside and (self.tolerance is None or abs(self.deviation) <= self.tolerance)

    def cells(self):
        independent = "–" if self.independent is None else f"{self.independent:.2f}"
        numbers = f"{self.published:.2f} | {independent} | {self.found:.2f}"
        tolerance = "–" if self.tolerance is None else f"{100 * self.tolerance:g} %"
        return f"| {self.case} | {numbers} | {100 * self.deviation:+.2f} % | {tolerance} |"


def tips_in_flow(data, wing, program):
    for incidence, independent in INDEPENDENT_TIPS.items():
        published = dict(table(data / STATIC.format(incidence)))
        aircraft = wing.aircraft(incidence)
        for airspeed, expected in independent.items():
            tip = 100 * program.tip(aircraft, airspeed) / wing.span
            tolerance = None if expected is None else 0.02
            yield Row(f"{incidence}°, {airspeed} m/s: tip up, % of the span", published[airspeed], expected, tip, tolerance)


def tips_under_masses(data, wing, program):
    published = dict(table(data / BENDING))
    own = program.tip(wing.aircraft(weight=True), 0)
    for mass, expected in INDEPENDENT_BENDING.items():
        tip = program.tip(wing.aircraft(weight=True, tip_mass=mass), 0) - own
        case = f"{mass} kg at the tip, less own weight: tip up, % of the span"
        yield Row(case, published[mass], expected, 100 * tip / wing.span, 0.002)


def onsets(data, wing, program):
    published = {incidence: airspeed for airspeed, incidence in table(data / ONSETS)}
    for incidence, expected in INDEPENDENT_ONSETS.items():
        found = program.onset(wing.aircraft(incidence), published[incidence])
        yield Row(f"{incidence}°: flutter begins, m/s", published[incidence], expected, found, 0.01)


def record(rows):
    """For VERIFICATION.md."""
    day = datetime.date.today().isoformat()
    source = (
        "C. Riso, C. E. S. Cesnik, IFASD 2022 (flow, flutter) and AIAA SciTech Forum 2022 (masses), by UM/NAST with the beam\n"
        "model and the lift slopes of their repository [AePW3-LDWG](https://github.com/UM-A2SRL/AePW3-LDWG); an independent\n"
        f"computation of the equations of this program. Run on {day} by [`compare.py`](tests/pazy/compare.py), not in CI: the\n"
        "data have no licence, and nothing of them is kept here."
    )
    remark = (
        "At low speeds, where the wing is almost straight, ours bends 2 % more at both incidences: a difference of the air's\n"
        "loads on the straight wing. The bending by masses has no air in it."
    )
    head = "| case | UM/NAST | independent | measured | deviation | tolerance |\n| --- | --- | --- | --- | --- | --- |"
    lines = "\n".join(row.cells() for row in rows)
    title = f"### The Pazy wing with skin, without weight in the flow; {MODES} modes, N = {INFLOW_STATES}"
    return f"{title}\n\nSource: {source}\n\n{head}\n{lines}\n\n{remark}\n"


def main():
    parser = argparse.ArgumentParser(description="the Pazy wing against UM/NAST")
    parser.add_argument("data", type=Path, help="a copy of github.com/UM-A2SRL/AePW3-LDWG")
    parser.add_argument("--flexair", type=Path, default=ROOT / "target/release/flexair")
    parser.add_argument("--write", action="store_true", help=f"write {RECORD.relative_to(ROOT)}")
    options = parser.parse_args()
    wing = Wing(options.data)
    with tempfile.TemporaryDirectory() as folder:
        program = Program(options.flexair.resolve(), folder)
        rows = [row for rows in (tips_in_flow, tips_under_masses, onsets) for row in rows(options.data, wing, program)]
    text = record(rows)
    print(text)
    if options.write:
        RECORD.write_text(text)
    if not all(row.holds for row in rows):
        sys.exit("not all of these hold")


if __name__ == "__main__":
    main()
