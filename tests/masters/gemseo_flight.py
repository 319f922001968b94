"""Flies one flight in GEMSEO-FMU, step by step, and writes all outputs: `gemseo_flight.py FMU FLIGHT.json HISTORY.json`.

GEMSEO-FMU pins an older FMPy than the other importers, so it has an environment of its own and this is a program.
The discipline is made as a user makes it: all inputs and the parameters of the flight are its inputs, and it writes
all of them before every step, parameters too.
"""

import json
import sys
from pathlib import Path

from gemseo_fmu.disciplines.fmu_discipline import FMUDiscipline
from numpy import array


def main(fmu, flight, history):
    flight = json.loads(Path(flight).read_text())
    time, inputs, parameters = flight["time"], flight["inputs"], flight["parameters"]
    discipline = FMUDiscipline(
        fmu,
        input_names=[*inputs, *parameters] or None,
        output_names=flight["outputs"],
        initial_time=time[0],
        final_time=time[-1],
        time_step=0.01,
        do_step=True,
        restart=False,
    )
    written = {name: array([value]) for name, value in parameters.items()}
    found = {name: [] for name in flight["outputs"]}
    for point in range(len(time) - 1):
        values = {name: array([column[point]]) for name, column in inputs.items()}
        result = discipline.execute({**written, **values})
        for name, column in found.items():
            column.append(float(result[name][0]))
    Path(history).write_text(json.dumps({"time": time[1:], **found}))


if __name__ == "__main__":
    main(*sys.argv[1:])
