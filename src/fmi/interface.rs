//! Which FMU an archive is: a version of FMI and a kind. One library serves all of them.

use std::fmt;

use crate::variables::Extent;

/// A version of FMI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Version {
    /// FMI 2.0.
    V2,
    /// FMI 3.0.
    V3,
}

/// Who integrates the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// The FMU.
    CoSimulation,
    /// The importer.
    ModelExchange,
}

/// A version and a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Interface {
    /// Of FMI.
    pub version: Version,
    /// Who integrates.
    pub kind: Kind,
}

impl Interface {
    /// FMI 2.0 for co-simulation, which most tools take.
    pub const USUAL: Interface = Interface { version: Version::V2, kind: Kind::CoSimulation };

    /// All of them.
    pub const ALL: [Interface; 4] = [
        Interface::USUAL,
        Interface { version: Version::V3, kind: Kind::CoSimulation },
        Interface { version: Version::V2, kind: Kind::ModelExchange },
        Interface { version: Version::V3, kind: Kind::ModelExchange },
    ];

    /// What an importer knows of the variables.
    pub fn extent(self) -> Extent {
        Extent { states: self.kind == Kind::ModelExchange, time: self.version == Version::V3 }
    }
}

impl Version {
    /// As the model description has it.
    pub fn number(self) -> &'static str {
        match self {
            Version::V2 => "2.0",
            Version::V3 => "3.0",
        }
    }
}

impl Kind {
    /// For people.
    pub fn name(self) -> &'static str {
        match self {
            Kind::CoSimulation => "co-simulation",
            Kind::ModelExchange => "model exchange",
        }
    }
}

impl fmt::Display for Interface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "FMI {} {}", self.version.number(), self.kind.name())
    }
}
