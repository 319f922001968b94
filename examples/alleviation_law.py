"""The law of the gust-load alleviation, in Python alone: for the FMU of `gust_load_alleviation.py` and for loops of one's own.

aileron_symmetric = −gain · roll-off(low-pass(high-pass(a))), limited; a is the mean upward reading of the two tips.
The high-pass takes gravity and slow manoeuvres off, the low-pass makes of accelerations something like velocities, which
damp, and the roll-off leaves alone what an actuator of 40 rad/s would answer too late: a mode of the wing at 9 Hz.

All filters are of first order, by Euler's backward rule, and begin in the steady state. SI units and radians.
"""

from dataclasses import dataclass


@dataclass
class AlleviationLaw:
    gain: float = 0.025
    high_pass_time: float = 2.0
    low_pass_time: float = 0.5
    roll_off_time: float = 0.05
    limit: float = 0.35

    def __post_init__(self):
        self.steady = None
        self.slow = 0.0
        self.smooth = 0.0

    def ailerons(self, force_right, force_left, step_size):
        """Deflection of both ailerons together, from the specific forces of the tips along z (down)."""
        upward = -0.5 * (force_right + force_left)
        if self.steady is None:
            self.steady = upward
        self.steady += step_size / (self.high_pass_time + step_size) * (upward - self.steady)
        fast = upward - self.steady
        self.slow += step_size / (self.low_pass_time + step_size) * (fast - self.slow)
        self.smooth += step_size / (self.roll_off_time + step_size) * (self.slow - self.smooth)
        return min(max(-self.gain * self.smooth, -self.limit), self.limit)
