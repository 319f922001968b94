"""Many random gusts on a Dask cluster: the FMU through FMPy, a task for each point, a row for each in a table.

    pip install fmpy distributed
    python examples/dask_sweep.py --points 200 --output target/gusts.csv

flies on two processes of this machine, with --scheduler on the workers of another cluster, which find the FMU under the same
path and have FMPy. A point is a function of its number alone, so that the table is the same whatever worker flies it.

A flight that cannot be flown is a row that says why. A worker that dies takes with it what it was flying and what it had flown
and not yet handed over: both are flown again by others, in whatever order. A point that sees `allowed-failures` workers die
(of distributed.scheduler, 3 unless the scheduler says otherwise) is given up: its row says `worker_died`.
"""

import argparse
import csv
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path
from random import Random

from distributed import Client, KilledWorker, LocalCluster, as_completed, get_worker
from fmpy import extract, fmi2, read_model_description
from fmpy.fmi1 import FMICallException

STEP, STEPS = 0.01, 500  # s: the grid of the aircraft's own integrator, 5 s of it
KEPT = "load_factor.z", "deflection.wing_tip_right.up"
VARIED = "gust.gradient", "gust.peak"
COLUMNS = ["point", *VARIED, "status", "message", *(f"{name}.{reduced}" for name in KEPT for reduced in ("max", "min"))]


def point(number):
    """A gust of any length that CS-25 has and of up to 15 m/s, upwards or downwards."""
    random = Random(number)
    return {"point": number, "gust.gradient": random.uniform(9.144, 106.68), "gust.peak": random.uniform(-15.0, 15.0)}


def unpacked(fmu):
    """The FMU's folder and description, made once by each worker."""
    worker = get_worker()
    if not hasattr(worker, "unpacked_fmus"):
        worker.unpacked_fmus = {}
    if fmu not in worker.unpacked_fmus:
        # Among the worker's own files: it goes with them.
        folder = tempfile.mkdtemp(prefix="fmu-", dir=worker.local_directory)
        worker.unpacked_fmus[fmu] = extract(fmu, unzipdir=folder), read_model_description(fmu)
    return worker.unpacked_fmus[fmu]


def callbacks(said):
    """What the FMU calls; it has no words for success, so that what it says is why a flight failed or a trim is odd."""

    def hear(_component, _name, _status, _category, message):
        said.append(message.decode().replace("%%", "%"))  # as printf would print it

    log = fmi2.fmi2CallbackLoggerTYPE(hear)
    memory = {name: getattr(fmi2.defaultCallbacks, name) for name in ("allocateMemory", "freeMemory")}
    return fmi2.fmi2CallbackFunctions(logger=log, **memory)


@contextmanager
def instance(folder, description, point, said):
    """An FMU that is unpacked, instantiated for a point, and the references of its variables by name; `said` takes what it says."""
    aircraft = fmi2.FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName=f"point_{point['point']}",
    )
    aircraft.instantiate(callbacks=callbacks(said))
    try:
        yield aircraft, {variable.name: variable.valueReference for variable in description.modelVariables}
    finally:
        aircraft.freeInstance()


def history(aircraft, kept, act=lambda step: None):
    """Flies to the end, and has values of what is kept from the trim on; `act` is called before each step with its number."""
    values = [aircraft.getReal(kept)]
    for step in range(STEPS):
        act(step)
        aircraft.doStep(currentCommunicationPoint=STEP * step, communicationStepSize=STEP)
        values.append(aircraft.getReal(kept))
    aircraft.terminate()
    return list(zip(*values))


def fly(point, fmu):
    """The row of a point: a number, and values of parameters that are Real."""
    said, row = [], {**point, "status": "invalid"}
    varied = [name for name in point if name != "point"]
    with instance(*unpacked(fmu), point, said) as (aircraft, number):
        try:
            aircraft.setupExperiment(startTime=0.0)
            aircraft.setInteger([number["gust.shape"]], [2])  # one_minus_cosine
            aircraft.setReal([number[name] for name in varied], [point[name] for name in varied])
            row["status"] = "no_trim"
            aircraft.enterInitializationMode()
            aircraft.exitInitializationMode()
            row["status"] = "left_validity"
            histories = history(aircraft, [number[name] for name in KEPT])
            row["status"] = "ok"
            for name, values in zip(KEPT, histories):
                row |= {f"{name}.max": max(values), f"{name}.min": min(values)}
        except FMICallException as error:
            said = said or [str(error)]
    return row | {"message": " ".join(said)}


def rows(client, fly, points, **fixed):
    """The row that `fly` makes of each point and what is fixed, in the order in which they come."""
    # Not pure: the same point may be flown again.
    flights = client.map(fly, points, **fixed, pure=False)
    point_of = dict(zip((flight.key for flight in flights), points))
    for flight in as_completed(flights):
        try:
            yield flight.result()
        except KilledWorker as error:
            yield {**point_of[flight.key], "status": "worker_died", "message": str(error)}


def sweep(fly, points, scheduler=None, modules=(), **fixed):
    """The rows of all points in their order, said one by one: flown on two processes of this machine, or on the workers of a
    scheduler with an address. These get the modules that they do not have."""
    cluster = scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0")
    with Client(cluster) as client:
        for module in modules:
            client.upload_file(module.__file__)
        table = []
        for row in rows(client, fly, points, **fixed):
            table.append(row)
            print(f"{len(table)} of {len(points)}: point {row['point']} {row['status']}", flush=True)
    if not scheduler:
        cluster.close()
    return sorted(table, key=lambda row: row["point"])


def write(table, names, output):
    """Columns of these names: Parquet by the name of the file, or comma-separated values; empty where a flight failed."""
    output.parent.mkdir(parents=True, exist_ok=True)
    if output.suffix == ".parquet":
        import pyarrow
        import pyarrow.parquet

        columns = {name: [row.get(name) for row in table] for name in names}
        pyarrow.parquet.write_table(pyarrow.table(columns), output)
        return
    with output.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, names, restval="")
        writer.writeheader()
        writer.writerows(table)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fmu", type=Path, default=Path("target/fmu/FlexibleAircraft.fmu"), help="of the jet")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster, as tcp://host:8786")
    parser.add_argument("--points", type=int, default=200, metavar="N", help="how many gusts")
    parser.add_argument("--output", type=Path, default=Path("target/gusts.csv"), help="the table, .csv or .parquet")
    options = parser.parse_args()
    if not options.fmu.is_file():
        sys.exit(f"{options.fmu} does not exist: run `flexair package`")
    points = [point(number) for number in range(options.points)]
    table = sweep(fly, points, options.scheduler, fmu=str(options.fmu.resolve()))
    write(table, COLUMNS, options.output)


if __name__ == "__main__":
    main()
