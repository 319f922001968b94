"""A vertical gust of the shape 1 − cos: the velocity of the air mass goes up to its peak and back to zero.

The values published at the end of a communication step are those of the end. Beside the velocity stands its rate: between
communication points the aircraft lets the wind change by it, and the air that is accelerated with the wing acts by it.
"""

from math import cos, pi, sin

from fmu_with_units import FmuWithUnits


class VerticalGust(FmuWithUnits):
    description = "Vertical gust of the shape 1 - cos"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.wind_down = 0.0
        self.wind_rate_down = 0.0
        self.start_time = 1.0
        self.duration = 1.0
        self.peak = -10.0
        self.output("wind_down", "m/s", "Velocity of the air mass, downwards")
        self.output("wind_rate_down", "m/s2", "Its rate of change")
        self.parameter("start_time", "s", "When the gust begins")
        self.parameter("duration", "s", "How long it lasts; at 127 m/s, 1 s is a wavelength of 127 m")
        self.parameter("peak", "m/s", "Largest velocity, downwards: negative is an upward gust")

    def do_step(self, current_time, step_size):
        phase = (current_time + step_size - self.start_time) / self.duration
        angle = 2.0 * pi * phase
        is_blowing = 0.0 < phase < 1.0
        self.wind_down = 0.5 * self.peak * (1.0 - cos(angle)) if is_blowing else 0.0
        self.wind_rate_down = self.peak * pi / self.duration * sin(angle) if is_blowing else 0.0
        return True
