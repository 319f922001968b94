"""Gust-load alleviation: accelerometers at both wing tips move both ailerons together against what they feel.

aileron_symmetric = −gain · roll-off(low-pass(high-pass(a))), limited; a is the mean upward reading of the two tips.
The high-pass takes gravity and slow manoeuvres off, the low-pass makes of accelerations something like velocities, which
damp, and the roll-off leaves alone what an actuator of 40 rad/s would answer too late: a mode of the wing at 9 Hz.

A sampled law: it reads its inputs at the beginning of a communication step and publishes the ailerons at the end, so
that the aircraft flies with them one step later. All filters are of first order, by Euler's backward rule. Gain and
time constants are for steps of 10 ms.
"""

from fmu_with_units import FmuWithUnits


class GustLoadAlleviation(FmuWithUnits):
    description = "Gust-load alleviation from the accelerations of the wing tips, a sampled control law"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.force_right = 0.0
        self.force_left = 0.0
        self.aileron_symmetric = 0.0
        self.engage_time = 0.5
        self.gain = 0.025
        self.high_pass_time = 2.0
        self.low_pass_time = 0.5
        self.roll_off_time = 0.05
        self.limit = 0.35
        self.input("force_right", "m/s2", "Specific force at the right wing tip, along z (down)")
        self.input("force_left", "m/s2", "Specific force at the left wing tip, along z (down)")
        self.output("aileron_symmetric", "rad", "Deflection of both ailerons together, positive trailing edges down")
        self.parameter("engage_time", "s", "From here on the law acts; the filters begin in the steady state")
        self.parameter("gain", "rad.s2/m", "Aileron per filtered upward acceleration")
        self.parameter("high_pass_time", "s", "Time constant of the high-pass")
        self.parameter("low_pass_time", "s", "Time constant of the low-pass")
        self.parameter("roll_off_time", "s", "Time constant of the roll-off")
        self.parameter("limit", "rad", "Largest deflection, either way")
        self.steady = None
        self.slow = 0.0
        self.smooth = 0.0

    def do_step(self, current_time, step_size):
        # Half a step early, so that rounded times make no difference.
        if current_time + 0.5 * step_size < self.engage_time:
            return True
        upward = -0.5 * (self.force_right + self.force_left)
        if self.steady is None:
            self.steady = upward
        self.steady += step_size / (self.high_pass_time + step_size) * (upward - self.steady)
        fast = upward - self.steady
        self.slow += step_size / (self.low_pass_time + step_size) * (fast - self.slow)
        self.smooth += step_size / (self.roll_off_time + step_size) * (self.slow - self.smooth)
        self.aileron_symmetric = min(max(-self.gain * self.smooth, -self.limit), self.limit)
        return True
