"""Flies the FMU with what Python brings along, no FMI tool, no package: an elevator pulse, printed every half second.

    python3 examples/fly_without_master.py target/fmu/FlexibleAircraft.fmu
"""

import sys
import tempfile
import zipfile
from ctypes import CDLL, byref, c_char_p, c_double, c_size_t, c_uint, c_void_p
from pathlib import Path
from xml.etree import ElementTree

PLATFORMS = {"linux": ("linux64", ".so"), "win32": ("win64", ".dll"), "darwin": ("darwin64", ".dylib")}
WATCHED = "attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up"
CO_SIMULATION, WARNING, STEP = 1, 1, 0.01  # of fmi2Type, of fmi2Status; s


def fly(folder):
    description = ElementTree.parse(folder / "modelDescription.xml").getroot()
    variables = {variable.get("name"): variable for variable in description.iter("ScalarVariable")}
    for name in ("elevator", *WATCHED):
        if name not in variables:
            sys.exit(f"{sys.argv[1]} has no variable {name}: this flight is one of the generic business jet")
    platform, suffix = PLATFORMS[sys.platform]
    library = CDLL(str(folder / "binaries" / platform / f"FlexibleAircraft{suffix}"))
    library.fmi2Instantiate.restype = c_void_p
    guid, resources = description.get("guid").encode(), (folder / "resources").as_uri().encode()
    callbacks = (c_void_p * 5)()  # fmi2CallbackFunctions: every member may be NULL
    jet = library.fmi2Instantiate(b"jet", CO_SIMULATION, c_char_p(guid), c_char_p(resources), callbacks, 0, 0)
    if jet is None:
        raise RuntimeError("fmi2Instantiate failed; a logger among the callbacks would say why")

    def call(function, *arguments):
        if library[function](c_void_p(jet), *arguments) > WARNING:
            raise RuntimeError(f"{function} failed")

    def real(function, name, value=0.0):
        """Gets or sets a variable: its value."""
        reference, number = c_uint(int(variables[name].get("valueReference"))), c_double(value)
        call(function, byref(reference), c_size_t(1), byref(number))
        return number.value

    call("fmi2SetupExperiment", 0, c_double(0.0), c_double(0.0), 0, c_double(0.0))
    call("fmi2EnterInitializationMode")
    call("fmi2ExitInitializationMode")
    for step in range(400):
        real("fmi2SetReal", "elevator", -0.02 if step < 150 else 0.0)  # rad about the trim, nose-up
        call("fmi2DoStep", c_double(STEP * step), c_double(STEP), 1)
        if step % 50 == 49:
            pitch, load_factor, wing_tip = (real("fmi2GetReal", name) for name in WATCHED)
            print(f"{STEP * (step + 1):.1f} s  pitch {pitch:+.6f} rad  load factor {load_factor:.6f}  "
                  f"wing tip {wing_tip:.6f} m up")
    library.fmi2FreeInstance(c_void_p(jet))


if __name__ == "__main__":
    if len(sys.argv) != 2 or not zipfile.is_zipfile(sys.argv[1]):
        sys.exit("usage: fly_without_master.py FMU, the jet's as flexair package writes it")
    # Windows cannot delete a library that is in use.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as unpacked:
        zipfile.ZipFile(sys.argv[1]).extractall(unpacked)
        fly(Path(unpacked))
