"""Flies the two systems of the README in libcosim, with their control law and without, and draws them.

    python examples/closed_loop.py [FOLDER]

FOLDER, target/coupled unless another is named, has hold.ssp and alleviation.ssp; the picture goes there too.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from libcosimpy.CosimEnums import CosimVariableType
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
from libcosimpy.CosimObserver import CosimObserver

STEP = 0.01  # s
STOP_TIME = 15.0  # s

PANELS = {
    "hold": {
        "aircraft.attitude.pitch": ("pitch angle (°)", np.degrees),
        "aircraft.load_factor.z": ("load factor (1)", np.asarray),
        "aircraft.surface.elevator": ("elevator (°)", np.degrees),
    },
    "alleviation": {
        "aircraft.deflection.wing_tip_right.up": ("wing tip up (m)", np.asarray),
        "aircraft.station.wing_tip_right.specific_force.z": ("tip, specific force z (m/s²)", np.asarray),
        "aircraft.surface.aileron_symmetric": ("ailerons, both (°)", np.degrees),
    },
}
TITLES = {
    "hold": "Pitch-attitude hold, upward gust of 10 m/s for 4 s",
    "alleviation": "Gust-load alleviation, built-in gust of 10 m/s, 127 m long",
}


def fly(system, names, closed):
    """Histories of some variables by name, and `time`; the law of an open loop never engages.

    The system is an .ssp file, or the folder of an OspSystemStructure.xml.
    """
    read = CosimExecution.from_osp_config_file if system.is_dir() else CosimExecution.from_ssp_file
    execution = read(str(system))
    index = {
        f"{name}.{variable.name.decode()}": (slave, variable.reference)
        for name in ("aircraft", "law")
        for slave in [execution.slave_index_from_instance_name(name)]
        for variable in execution.slave_variables(slave)
    }
    if not closed:
        execution.real_initial_value(*index["law.engage_time"], 1e9)
    observer = CosimObserver.create_time_series(buffer_size=10_000)
    execution.add_observer(observer)
    for name in names:
        observer.start_time_series(*index[name], CosimVariableType.REAL)
    # Times are in nanoseconds. One step more, since the observer's last sample is the one before the end.
    execution.simulate_until(round((STOP_TIME + STEP) * 1e9))
    history = {}
    for name in names:
        times, _, values = observer.time_series_real_samples(*index[name], from_step=0, sample_count=10_000)
        history |= {"time": np.array(times) * 1e-9, name: np.array(values)}
    return history


def main(folder):
    log_output_level(CosimLogLevel.ERROR)
    figure, grid = plt.subplots(3, 2, sharex=True, figsize=(11, 7), layout="constrained")
    for column, (system, panels) in zip(grid.T, PANELS.items()):
        for closed in (False, True):
            history = fly(folder / f"{system}.ssp", panels, closed)
            for axis, (name, (label, convert)) in zip(column, panels.items()):
                label_of_loop, style = ("closed loop", "-") if closed else ("open loop", "--")
                axis.plot(history["time"], convert(history[name]), style, label=label_of_loop)
                axis.set_ylabel(label)
                axis.grid(alpha=0.3)
        column[0].set_title(TITLES[system], fontsize="medium", loc="left")
        column[-1].set_xlabel("time (s)")
    # One legend for all: the lines mean the same everywhere.
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    picture = folder / "closed-loop.png"
    figure.savefig(picture, dpi=100)
    print(picture)


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "target/coupled"))
