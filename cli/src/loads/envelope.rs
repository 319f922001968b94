//! The most and the least of each load at each cut, with what the others were then.

use flexible_aircraft::equations::SectionLoads;
use flexible_aircraft::flight::Simulation;
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

/// Those of all cuts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Envelopes(Vec<Option<Envelope>>);

/// What a flight has carried.
#[derive(Clone, Debug)]
pub struct Carried {
    case: usize,
    /// Peak of the flight's gust, m/s of true airspeed; 0 where there is none.
    pub peak: f64,
    envelopes: Envelopes,
    /// Torsion and bending from moment to moment, N·m, at each of the first cuts.
    paths: Vec<Vec<(f64, f64)>>,
}

impl Envelopes {
    /// Of all flights together.
    pub fn of_all(flights: &[Carried]) -> Self {
        let mut all = Envelopes::default();
        for Carried { envelopes: Envelopes(of_flight), .. } in flights {
            all.0.resize(of_flight.len(), None);
            for (envelope, other) in all.0.iter_mut().zip(of_flight) {
                match (envelope.as_mut(), other) {
                    (Some(envelope), Some(other)) => {
                        other.most.iter().chain(&other.least).for_each(|extreme| envelope.take(extreme));
                    }
                    (None, other) => envelope.clone_from(other),
                    (Some(_), None) => {}
                }
            }
        }
        all
    }

    /// Of a cut, if anything has been flown.
    pub fn of(&self, cut: usize) -> Option<&Envelope> {
        self.0.get(cut)?.as_ref()
    }
}

impl Carried {
    /// A flight with so many cuts that has not begun; of so many of the first the paths are kept.
    pub fn begin(case: usize, cuts: usize, with_paths: usize) -> Self {
        let (envelopes, paths) = (Envelopes(vec![None; cuts]), vec![Vec::new(); with_paths]);
        Carried { case, peak: 0.0, envelopes, paths }
    }

    /// Looks at a flight at a moment, s.
    pub fn look(&mut self, time: f64, flight: &mut Simulation) {
        let outputs = &flight.instant_with_loads().outputs;
        self.peak = outputs.gust_peak_velocity;
        if let Some(loads) = outputs.loads.known() {
            self.take(time, loads);
        }
    }

    /// Takes what the loads of all cuts are then.
    fn take(&mut self, time: f64, loads: &[SectionLoads]) {
        for (envelope, loads) in self.envelopes.0.iter_mut().zip(loads) {
            let loads = LoadComponent::ALL.map(|component| component.of(loads));
            let now = Extreme { case: self.case, time, loads };
            match envelope {
                Some(envelope) => envelope.take(&now),
                None => {
                    let all = [now; COMPONENTS];
                    *envelope = Some(Envelope { start: now.loads, most: all, least: all });
                }
            }
        }
        for (path, loads) in self.paths.iter_mut().zip(loads) {
            path.push((loads.torsion, loads.bending));
        }
    }

    /// Which of the flights it is.
    pub fn case(&self) -> usize {
        self.case
    }

    /// Torsion and bending at a cut all through the flight, N·m.
    pub fn path(&self, cut: usize) -> &[(f64, f64)] {
        &self.paths[cut]
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
