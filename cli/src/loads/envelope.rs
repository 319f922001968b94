//! The most and the least of each load at each cut, with what the others were then.

use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::variables::LoadComponent;

/// How many components loads have.
pub const COMPONENTS: usize = LoadComponent::ALL.len();

/// An extreme of a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Of which of the flights.
    pub case: usize,
    /// s.
    pub time: f64,
    /// All six components at that moment, N and N·m.
    pub loads: [f64; COMPONENTS],
}

/// Those of a cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// At the beginning of the first flight.
    pub start: [f64; COMPONENTS],
    /// Where each component is largest.
    pub most: [Extreme; COMPONENTS],
    /// Where each is least.
    pub least: [Extreme; COMPONENTS],
}

/// Those of all cuts, and of some the way from one extreme to the next.
#[derive(Clone, Debug, Default)]
pub struct Envelopes {
    of_cuts: Vec<Option<Envelope>>,
    /// Torsion and bending at each moment of the flights, N·m, of the first cuts.
    paths: Vec<Vec<(usize, (f64, f64))>>,
}

impl Envelopes {
    /// Of so many cuts, nothing flown; so many of the first have their paths kept.
    pub fn new(cuts: usize, with_paths: usize) -> Self {
        Envelopes { of_cuts: vec![None; cuts], paths: vec![Vec::new(); with_paths] }
    }

    /// Takes what the loads of all cuts are at a moment of a flight.
    pub fn take(&mut self, case: usize, time: f64, loads: &[SectionLoads]) {
        for (envelope, loads) in self.of_cuts.iter_mut().zip(loads) {
            let now = Extreme { case, time, loads: LoadComponent::ALL.map(|component| component.of(loads)) };
            match envelope {
                Some(envelope) => envelope.take(&now),
                None => {
                    let all = [now; COMPONENTS];
                    *envelope = Some(Envelope { start: now.loads, most: all, least: all });
                }
            }
        }
        for (path, loads) in self.paths.iter_mut().zip(loads) {
            path.push((case, (loads.torsion, loads.bending)));
        }
    }

    /// Of a cut, if anything has been flown.
    pub fn of(&self, cut: usize) -> Option<&Envelope> {
        self.of_cuts[cut].as_ref()
    }

    /// Torsion and bending at a cut all through a flight, N·m.
    pub fn path(&self, cut: usize, case: usize) -> Vec<(f64, f64)> {
        let of_case = self.paths[cut].iter().filter(|(of, _)| *of == case);
        of_case.map(|(_, point)| *point).collect()
    }
}

impl Envelope {
    fn take(&mut self, now: &Extreme) {
        for component in 0..COMPONENTS {
            if now.loads[component] > self.most[component].loads[component] {
                self.most[component] = *now;
            }
            if now.loads[component] < self.least[component].loads[component] {
                self.least[component] = *now;
            }
        }
    }
}
