"""What `flexair sweep` writes is what Arrow reads, and what the FMU flies through FMPy."""

import json

import numpy as np
from fmpy import simulate_fmu

SWEEP = """
seed = 3
samples = 4
[set]
"gust.start" = 0.5
[[vary]]
name = "airspeed"
values = [120, 500, 140]
[[vary]]
name = "gust.peak"
uniform = [5, 10]
[run]
kind = "gust"
duration = 2
[[keep]]
output = "load_factor.z"
reduce = ["max", "time_of_max"]
[[keep]]
output = "path.vertical_speed"
reduce = "end"
"""


def test_arrow_reads_columns_types_and_units(sweep):
    table = sweep(SWEEP)
    kept = ["load_factor.z.max", "load_factor.z.time_of_max", "path.vertical_speed.end"]
    assert table.column_names == ["point", "airspeed", "gust.peak", "status", "message", *kept]
    assert [str(kind) for kind in table.schema.types] == ["int64", "double", "double", "string", "string", *["double"] * 3]
    units = json.loads(table.schema.metadata[b"units"])
    assert units == dict(zip(["airspeed", "gust.peak", *kept], ["m/s", "m/s", "1", "s", "m/s"]))
    columns = table.to_pydict()
    assert columns["point"] == list(range(12))
    assert columns["airspeed"] == [120.0] * 4 + [500.0] * 4 + [140.0] * 4
    assert columns["status"] == ["ok"] * 4 + ["invalid"] * 4 + ["ok"] * 4
    for name in kept:
        assert [value is None for value in columns[name]] == [status != "ok" for status in columns["status"]]
    assert "allowed is 1 to 400 m/s" in columns["message"][5] and columns["message"][0] == ""
    assert len(set(columns["gust.peak"])) == 12 and all(5 <= peak < 10 for peak in columns["gust.peak"])


def test_a_point_is_what_fmpy_flies(sweep, aircraft):
    rows = sweep(SWEEP).to_pylist()
    for row in (rows[0], rows[11]):
        starts = {"airspeed": row["airspeed"], "gust.peak": row["gust.peak"], "gust.start": 0.5, "gust.shape": 2}
        outputs = ["load_factor.z", "path.vertical_speed"]
        flown = simulate_fmu(aircraft, stop_time=2.0, output_interval=0.01, start_values=starts, output=outputs)
        factor = flown["load_factor.z"]
        assert row["load_factor.z.max"] == factor.max() > 1.1
        assert abs(row["load_factor.z.time_of_max"] - flown["time"][np.argmax(factor)]) < 1e-9
        assert row["path.vertical_speed.end"] == flown["path.vertical_speed"][-1]
