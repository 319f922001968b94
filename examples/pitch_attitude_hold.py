"""Pitch-attitude hold: keeps the pitch angle that the aircraft has when the hold engages.

elevator = pitch_gain (θ − θ₀) + integral_gain ∫ (θ − θ₀) dt + rate_gain q, limited; a positive elevator is nose-down.

A sampled law: it reads its inputs at the beginning of a communication step and publishes the elevator at the end,
so that the aircraft flies with it one step later. The integral is a sum of rectangles. Gains are for steps of 10 ms.
"""

from fmu_with_units import FmuWithUnits


class PitchAttitudeHold(FmuWithUnits):
    description = "Pitch-attitude hold, a sampled control law"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.pitch = 0.0
        self.pitch_rate = 0.0
        self.elevator = 0.0
        self.engage_time = 0.5
        self.pitch_gain = 4.0
        self.integral_gain = 0.4
        self.rate_gain = 2.0
        self.limit = 0.2
        self.input("pitch", "rad", "Pitch angle")
        self.input("pitch_rate", "rad/s", "Pitch rate, body axes")
        self.output("elevator", "rad", "Elevator about its trim, positive nose-down")
        self.parameter("engage_time", "s", "From here on the law acts; the pitch angle then is what it holds")
        self.parameter("pitch_gain", "1", "Elevator per deviation of the pitch angle")
        self.parameter("integral_gain", "1/s", "Elevator per time integral of the deviation")
        self.parameter("rate_gain", "s", "Elevator per pitch rate")
        self.parameter("limit", "rad", "Largest elevator, either way")
        self.reference = None
        self.integral = 0.0

    def do_step(self, current_time, step_size):
        # Half a step early, so that rounded times make no difference.
        if current_time + 0.5 * step_size < self.engage_time:
            return True
        if self.reference is None:
            self.reference = self.pitch
        deviation = self.pitch - self.reference
        self.integral += deviation * step_size
        wanted = (
            self.pitch_gain * deviation + self.integral_gain * self.integral + self.rate_gain * self.pitch_rate
        )
        self.elevator = min(max(wanted, -self.limit), self.limit)
        return True
