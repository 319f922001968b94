//! What becomes of the wake in a linear model, as the command line has it.

use std::fmt::{self, Display};
use std::str::FromStr;

use flexible_aircraft::Inflow;

/// What stands before the number of states.
const BALANCED: &str = "balanced:";

/// What becomes of the wake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wake {
    /// Its states are kept.
    Keep,
    /// There is none.
    Steady,
    /// The whole model is reduced to so many states.
    Balanced(usize),
}

impl Wake {
    /// With which states a model begins.
    pub fn states(self) -> Inflow {
        match self {
            Wake::Keep | Wake::Balanced(_) => Inflow::Kept,
            Wake::Steady => Inflow::Steady,
        }
    }
}

impl FromStr for Wake {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let number = text.strip_prefix(BALANCED).and_then(|number| number.parse().ok());
        match (text, number) {
            ("keep", _) => Ok(Wake::Keep),
            ("steady", _) => Ok(Wake::Steady),
            (_, Some(states)) => Ok(Wake::Balanced(states)),
            _ => Err(format!("allowed are keep, steady and {BALANCED}N, N a number of states")),
        }
    }
}

impl Display for Wake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Wake::Keep => f.write_str("keep"),
            Wake::Steady => f.write_str("steady"),
            Wake::Balanced(states) => write!(f, "{BALANCED}{states}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again_and_nothing_else() {
        for wake in [Wake::Keep, Wake::Steady, Wake::Balanced(36)] {
            assert_eq!(wake.to_string().parse(), Ok(wake));
        }
        for other in ["", "half", "balanced", "balanced:", "balanced:-4", "balanced:3.5", "keep:3"] {
            assert!(other.parse::<Wake>().unwrap_err().contains("keep, steady and balanced:N"), "{other}");
        }
    }
}
