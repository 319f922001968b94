"""Gust-load alleviation: accelerometers at both wing tips move both ailerons together against what they feel.

The law itself is in `alleviation_law.py`.

A sampled law: it reads its inputs at the beginning of a communication step and publishes the ailerons at the end, so
that the aircraft flies with them one step later. Gain and time constants are for steps of 10 ms.
"""

from alleviation_law import AlleviationLaw
from fmu_with_units import FmuWithUnits


class GustLoadAlleviation(FmuWithUnits):
    description = "Gust-load alleviation from the accelerations of the wing tips, a sampled control law"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.force_right = 0.0
        self.force_left = 0.0
        self.aileron_symmetric = 0.0
        self.engage_time = 0.5
        start = AlleviationLaw()
        self.gain = start.gain
        self.high_pass_time = start.high_pass_time
        self.low_pass_time = start.low_pass_time
        self.roll_off_time = start.roll_off_time
        self.limit = start.limit
        self.input("force_right", "m/s2", "Specific force at the right wing tip, along z (down)")
        self.input("force_left", "m/s2", "Specific force at the left wing tip, along z (down)")
        self.output("aileron_symmetric", "rad", "Deflection of both ailerons together, positive trailing edges down")
        self.parameter("engage_time", "s", "From here on the law acts; the filters begin in the steady state")
        self.parameter("gain", "rad.s2/m", "Aileron per filtered upward acceleration")
        self.parameter("high_pass_time", "s", "Time constant of the high-pass")
        self.parameter("low_pass_time", "s", "Time constant of the low-pass")
        self.parameter("roll_off_time", "s", "Time constant of the roll-off")
        self.parameter("limit", "rad", "Largest deflection, either way")
        self.law = None

    def do_step(self, current_time, step_size):
        # Half a step early, so that rounded times make no difference.
        if current_time + 0.5 * step_size < self.engage_time:
            return True
        if self.law is None:
            self.law = AlleviationLaw(self.gain, self.high_pass_time, self.low_pass_time, self.roll_off_time, self.limit)
        self.aileron_symmetric = self.law.ailerons(self.force_right, self.force_left, step_size)
        return True
