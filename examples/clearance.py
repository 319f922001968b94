"""Clears a control law: gust-load alleviation in closed loop at 1000 points of fuel, stiffness, altitude and speed, on Dask.

    pip install fmpy distributed pyarrow matplotlib
    python examples/clearance.py --flexair target/release/flexair --output target/clearance.parquet

An FMU for each mass, since masses are no parameters: `mass_case` changes the text of the aircraft file. The other three
are parameters. At each point the jet meets 1-cosine gusts of CS-25 from below, of the lengths of GRADIENTS, without the law
and with it; its row keeps the worst root bending of the wing and the worst load factor. What has no trim, or one that nobody
could fly, is a row that says why. A picture beside the table has a map, envelopes and the ten worst points.

Points, workers that die and other clusters are as in `dask_sweep.py`, the law as in `gust_load_alleviation.py`: sampled every
10 ms and one step late, behind an actuator. On another cluster the workers need FMPy, and find the FMUs under the same paths.
"""

import argparse
import re
import shutil
import subprocess
import sys
import tomllib
from itertools import product
from pathlib import Path
from random import Random

import alleviation_law
import dask_sweep
from alleviation_law import AlleviationLaw
from dask_sweep import STEP, STEPS, history, instance, sweep, unpacked, write
from fmpy.fmi1 import FMICallException

ENGAGED = 50  # steps: from here on the law acts
AIRCRAFT = Path(__file__).parents[1] / "aircraft/generic-business-jet.toml"
FUEL = [0.1, 0.4, 0.7, 1.0]  # of what is in the aircraft file
GRID = {
    "stiffness_scale": [0.6, 0.8, 1.0, 1.2, 1.4],
    "altitude": [0.0, 3000.0, 6000.0, 9000.0, 12000.0],  # m
    "airspeed": [100.0 + 10.0 * number for number in range(10)],  # m/s
}
GRADIENTS = [15.0, 30.0, 60.0, 106.68]  # m
GUST = {"gust.shape": 2, "gust.criterion": 2}  # one_minus_cosine; CS-25, up to the cruising speed
ACTUATOR = {"actuator.aileron_symmetric.frequency": 40.0, "actuator.aileron_symmetric.rate_limit": 0.7}
READ = ["station.wing_tip_right.specific_force.z", "station.wing_tip_left.specific_force.z"]
BENDING, LOAD_FACTOR = KEPT = ["loads.wing_root_right.bending", "load_factor.z"]
LOOPS = ["open", "closed"]
COLUMNS = ["point", "fuel", *GRID, "status", "message", "bending.trim"]
COLUMNS += [f"{name}.{loop}" for name in ("bending", "gradient", "load_factor") for loop in LOOPS]


def all_points():
    """Every point of the grid, shuffled, always alike: the first so many say something of all."""
    grid = list(product(FUEL, *GRID.values()))
    places = sorted(range(len(grid)), key=lambda place: Random(place).random())
    return [{"point": number} | dict(zip(["fuel", *GRID], grid[place])) for number, place in enumerate(places)]


def mass_case(text, factor):
    """An aircraft file with a factor on each `total_kg` in a line that ends in `# fuel`; all else stays, comments too."""
    line = re.compile(r"^(?P<before>.*\btotal_kg\s*=\s*)(?P<mass>[-+.\deE]+)(?P<after>.*#\s*fuel\s*)$", re.MULTILINE)
    multiplied = lambda found: f"{found['before']}{factor * float(found['mass'])!r}{found['after']}"
    changed, count = line.subn(multiplied, text)
    if count == 0:
        sys.exit("the aircraft file has no line with `total_kg` that ends in `# fuel`")
    tomllib.loads(changed)  # still TOML
    return changed


def case(folder, fuel):
    """Where the FMU of a mass case is."""
    return Path(folder) / f"fuel-{round(100 * fuel):03}.fmu"


def package(folder, aircraft, program):
    """An FMU for each mass case, unless it is there and of the same aircraft file."""
    text = aircraft.read_text(encoding="utf-8")
    folder.mkdir(parents=True, exist_ok=True)
    for fuel in FUEL:
        fmu, changed = case(folder, fuel), mass_case(text, fuel)
        source = fmu.with_suffix(".toml")
        if fmu.is_file() and source.is_file() and source.read_text(encoding="utf-8") == changed:
            continue
        fmu.unlink(missing_ok=True)
        source.write_text(changed, encoding="utf-8")
        print(f"packaging {fmu}", flush=True)
        write_fmu(source.resolve(), fmu.resolve(), program)


def write_fmu(aircraft, fmu, program):
    """By the Python package `flexair` where it is installed and no command is named, otherwise by the command."""
    if program is None:
        try:
            import flexair
        except ImportError:
            program = shutil.which("flexair") or sys.exit("there is no flexair: name the command with --flexair")
        else:
            flexair.package(aircraft, output=fmu, check=False)
            return
    command = [program, "package", "--no-check", "--aircraft", aircraft, "--output", fmu]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


class NoTrim(Exception):
    """A trim that is not there, or that nobody could fly."""


def flight(fmu, point, gradient, law, said):
    """Histories of KEPT in one gust; `law` is None for the open loop, `said` takes what the FMU says."""
    reals = {name: point[name] for name in GRID} | {"gust.gradient": gradient} | ACTUATOR
    ailerons = 0.0
    with instance(*unpacked(fmu), point, said) as (aircraft, number):
        kept, read = ([number[name] for name in names] for names in (KEPT, READ))

        def act(step):
            nonlocal ailerons
            if law is not None and step >= ENGAGED:
                aircraft.setReal([number["aileron_symmetric"]], [ailerons])
                ailerons = law.ailerons(*aircraft.getReal(read), STEP)

        aircraft.setupExperiment(startTime=0.0)
        aircraft.setInteger([number[name] for name in GUST], list(GUST.values()))
        aircraft.setReal([number[name] for name in reals], list(reals.values()))
        try:
            aircraft.enterInitializationMode()
            aircraft.exitInitializationMode()
        except FMICallException as error:
            raise NoTrim from error
        if said:
            raise NoTrim
        return dict(zip(KEPT, history(aircraft, kept, act)))


def fly(point, folder):
    """The row of a point: the worst of all gusts, without the law and with it."""
    fmu, said = str(case(folder, point["fuel"])), []
    row = {**point, "status": "ok", "message": ""}
    worst = dict.fromkeys([f"{name}.{loop}" for name in ("bending", "load_factor") for loop in LOOPS], float("-inf"))
    where = {}
    for gradient, loop in product(GRADIENTS, LOOPS):
        law = AlleviationLaw() if loop == "closed" else None
        try:
            flown = flight(fmu, point, gradient, law, said)
        except NoTrim:
            return row | {"status": "no_trim", "message": " ".join(said)}
        except FMICallException as error:
            reason = " ".join(said) or str(error)
            return row | {"status": "left_validity", "message": f"{loop} loop, gradient of {gradient} m: {reason}"}
        row["bending.trim"] = flown[BENDING][0]
        if max(flown[BENDING]) > worst[f"bending.{loop}"]:
            worst[f"bending.{loop}"], where[f"gradient.{loop}"] = max(flown[BENDING]), gradient
        worst[f"load_factor.{loop}"] = max(worst[f"load_factor.{loop}"], *flown[LOAD_FACTOR])
    return row | worst | where


def ranked(table):
    """The points with most bending in closed loop, the worst first."""
    return sorted((row for row in table if row["status"] == "ok"), key=lambda row: -row["bending.closed"])


def share(row):
    """Of what the gust adds to the bending of the trim, how much the law takes off."""
    return (row["bending.open"] - row["bending.closed"]) / (row["bending.open"] - row["bending.trim"])


def said_of(row):
    return (
        f"{row['airspeed']:.0f} m/s, {row['altitude'] / 1000:g} km, "
        f"stiffness × {row['stiffness_scale']:g}, fuel {100 * row['fuel']:.0f} %"
    )


def draw(table, picture):
    """A map of what the law takes off at least, envelopes of the bending over speed, and the ten worst points."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": 14, "lines.linewidth": 2.5})
    sizes = {"height_ratios": [1.15, 1, 1.35]}
    figure, (of_share, of_speed, of_worst) = plt.subplots(3, figsize=(8, 12), gridspec_kw=sizes, layout="constrained")
    flown = ranked(table)
    draw_map(of_share, flown)
    draw_envelopes(of_speed, flown)
    draw_worst(of_worst, flown[:10])
    figure.savefig(picture, dpi=100)
    plt.close(figure)


def draw_map(axis, flown):
    """At least: with any stiffness and fuel."""
    import numpy as np

    speeds, altitudes = GRID["airspeed"], GRID["altitude"]
    least = np.full((len(altitudes), len(speeds)), np.nan)
    for row in flown:
        place = altitudes.index(row["altitude"]), speeds.index(row["airspeed"])
        least[place] = np.fmin(least[place], 100 * share(row))
    axis.imshow(least, origin="lower", aspect="auto", cmap="YlGn", vmin=min(0, np.nanmin(least, initial=0)))
    middle = 0.6 * np.nanmax(least, initial=0)
    for (row, column), value in np.ndenumerate(least):
        text = "–" if np.isnan(value) else f"{value:.0f}"
        axis.text(column, row, text, ha="center", va="center", color="white" if value > middle else "black")
    axis.set_xticks(range(len(speeds)), [f"{speed:.0f}" for speed in speeds])
    axis.set_yticks(range(len(altitudes)), [f"{altitude / 1000:g}" for altitude in altitudes])
    axis.set_xlabel("true airspeed (m/s)")
    axis.set_ylabel("altitude (km)")
    axis.set_title("taken off the gust's bending, at least (%); –: no trim", fontsize="medium", loc="left")


def draw_envelopes(axis, flown):
    speeds = sorted({row["airspeed"] for row in flown})
    for name, label, colour in [
        ("bending.open", "gusts, without the law", "tab:orange"),
        ("bending.closed", "gusts, with it", "tab:blue"),
        ("bending.trim", "trim", "tab:gray"),
    ]:
        largest = [max(row[name] for row in flown if row["airspeed"] == speed) for speed in speeds]
        axis.plot(speeds, [bending / 1e6 for bending in largest], "o-", color=colour, label=label)
    axis.set_xlabel("true airspeed (m/s)")
    axis.set_ylabel("root bending (MN m)")
    axis.set_title("largest at any altitude, stiffness and fuel", fontsize="medium", loc="left")
    axis.set_ylim(bottom=0)
    axis.legend(fontsize="small", loc="lower right", ncols=3, columnspacing=1, handlelength=1.2)
    axis.grid(alpha=0.3)


def draw_worst(axis, worst):
    places = range(len(worst))
    axis.barh(places, [row["bending.open"] / 1e6 for row in worst], color="tab:orange", label="without the law")
    axis.barh(places, [row["bending.closed"] / 1e6 for row in worst], height=0.55, color="tab:blue", label="with it")
    for place, row in zip(places, worst):
        axis.text(0.02, place, said_of(row), transform=axis.get_yaxis_transform(), va="center", color="white", fontsize=12)
    axis.set_yticks(places, [place + 1 for place in places])
    axis.invert_yaxis()
    axis.set_xlabel("root bending (MN m)")
    axis.set_title("the ten worst points", fontsize="medium", loc="left")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    total = len(all_points())
    parser.add_argument("--aircraft", type=Path, default=AIRCRAFT, metavar="FILE", help="the jet's, or one much like it")
    parser.add_argument("--flexair", metavar="PROGRAM", help="the command, where the Python package is not to be asked")
    kept = "where FMUs are kept for the next run; another version of flexair wants another"
    parser.add_argument("--fmu", type=Path, default=Path("target/clearance"), metavar="FOLDER", help=kept)
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster, as tcp://host:8786")
    parser.add_argument("--points", type=int, default=total, metavar="N", help=f"how many of {total}")
    parser.add_argument("--output", type=Path, default=Path("target/clearance.parquet"), help="the table, .csv or .parquet")
    options = parser.parse_args()
    if not 1 <= options.points <= total:
        parser.error(f"--points: found {options.points}, allowed is 1 to {total}")
    return options


def main():
    options = arguments()
    package(options.fmu, options.aircraft, options.flexair)
    points = all_points()[: options.points]
    folder = str(options.fmu.resolve())
    table = sweep(fly, points, options.scheduler, (alleviation_law, dask_sweep), folder=folder)
    write(table, COLUMNS, options.output)
    worst = ranked(table)[:10]
    for place, row in enumerate(worst, 1):
        print(
            f"{place}. {said_of(row)}: {row['bending.open'] / 1e6:.3f} MN m without the law, "
            f"{row['bending.closed'] / 1e6:.3f} with it, load factor {row['load_factor.closed']:.2f}"
        )
    picture = options.output.with_suffix(".png")
    if worst:
        draw(table, picture)
        print(picture)


if __name__ == "__main__":
    main()
