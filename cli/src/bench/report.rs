//! What was measured, as a page and a plot.

use flexible_aircraft::structure::ReducedModel;

use super::equations::{EquationCosts, RightHandSide};
use super::options::Optional;
use super::scaling::{Point, Scaling};
use super::standard_flight::{Accuracy, Latency, StandardFlight};
use crate::chart::{Axis, Chart, Curve, Mark, Window};

/// All measurements of one run.
pub struct Report<'a> {
    pub model: &'a ReducedModel,
    /// That moves.
    pub control: &'a str,
    pub flight: StandardFlight,
    /// The same with gusts, turbulence or an actuator.
    pub options: Vec<Optional>,
    pub equations: EquationCosts,
    pub scaling: Scaling,
}

impl Report<'_> {
    /// A few lines for the terminal.
    pub fn summary(&self) -> String {
        let row = |level: &str, accuracy: &Accuracy| {
            let Accuracy { tolerance, time_per_second, errors: [pitch, tip, load] } = accuracy;
            let times = 1.0 / time_per_second;
            format!(
                "{level}tolerance {tolerance:.0e}: {times:.0} times real time; errors of pitch {pitch:.1e}, wing tip {tip:.1e}, load factor {load:.1e}\n"
            )
        };
        let rows = self.flight.accuracies.iter().map(|accuracy| row("", accuracy));
        let bending = row("geometrically exact, ", &self.flight.geometrically_exact);
        let EquationCosts { half, whole, plain_time_per_second, .. } = &self.equations;
        rows.collect::<String>()
            + &bending
            + &format!(
                "right-hand side {:.2} µs, of the whole aircraft {:.2} µs; plain method {:.1} times real time",
                1e6 * half.time,
                1e6 * whole.time,
                1.0 / plain_time_per_second
            )
    }

    /// `PERFORMANCE.md`.
    pub fn markdown(&self) -> String {
        let StandardFlight { accuracies, geometrically_exact, latencies, instantiation, trim, same_bits } =
            &self.flight;
        let options: String = self
            .options
            .iter()
            .map(|option| accuracy_row(&format!("{}, ", option.name), &option.accuracy))
            .collect();
        let accuracies: String = accuracies.iter().map(|accuracy| accuracy_row("", accuracy)).collect();
        let latencies: String = latencies.iter().map(latency_row).collect();
        let same = if *same_bits { "the same bits" } else { "**different bits**" };
        let memory = self
            .scaling
            .memory
            .map_or("not told by this system".to_owned(), |bytes| format!("{:.2} MB", bytes as f64 / 1e6));
        format!(
            "# How fast it flies\n\n\
             Written by `flexair bench`; processor times of one core of {machine}, the least of several runs.\n\n\
             ## The standard flight\n\n\
             {name}, nominal stiffness, {level} model, 12 modes of both families, 5 inflow states a strip, 127 m/s, {control} 2-3-1-1, 15 s,\n\
             communication step 10 ms, through the C interface of the packaged FMU, from the end of the initialisation on. Errors are the\n\
             largest of the flight in parts of the quantity's peak, against a flight with the relative tolerance 1e-12, whose steps are\n\
             hundreds of times shorter. The flight is symmetric: half the aircraft flies for the whole. Everything that acts on one side\n\
             alone costs what the columns for the whole aircraft of the last tables say. The row *geometrically exact* is the same flight at that\n\
             level, against one of its own.\n\n\
             | tolerance | CPU s per s | times real time | error of pitch | of wing tip | of load factor |\n\
             | --- | --- | --- | --- | --- | --- |\n{accuracies}\
             {bending}\
             | plain method | {plain:.4} | {plain_times:.1} | | | |\n\n\
             The *plain method* is the classical Runge–Kutta method in steps of 1 ms, all strips one at a time, kept in the benchmark so that\n\
             gains stay visible. One step of 10 ms and ten of 1 ms give {same}.\n\n\
             With gusts, turbulence or an actuator the same flight costs more and is less smooth; errors are against a flight with the tolerance\n\
             1e-9. The gust is met after 1 s, turbulence from the beginning on.\n\n\
             | flown with, tolerance | CPU s per s | times real time | error of pitch | of wing tip | of load factor |\n\
             | --- | --- | --- | --- | --- | --- |\n{options}\n\
             | communication step | half of the steps within | 99 % | 99.9 % | all | longest step of a single flight |\n\
             | --- | --- | --- | --- | --- | --- |\n{latencies}\n\
             Latencies are wall clock, with the {control} moving every 10 ms; of each step the least of five flights, all of which compute the\n\
             same. The last column has what else the machine did in it. `fmi2Instantiate` takes {instantiation:.2} ms, initialisation with the trim \
             {trim:.2} ms; a simulation holds {memory}.\n\n\
             {right}\
             ## What it costs\n\n\
             ![Cost of the right-hand side over modes, strips and inflow states](docs/performance.svg)\n\n{scaling}",
            machine = machine(),
            name = self.model.name,
            level = self.model.fidelity.in_words(),
            bending = accuracy_row("geometrically exact, ", geometrically_exact),
            control = self.control,
            plain = self.equations.plain_time_per_second,
            plain_times = 1.0 / self.equations.plain_time_per_second,
            instantiation = 1e3 * instantiation,
            trim = 1e3 * trim,
            right = self.right_hand_side(),
            scaling = self.scaling_tables(),
        )
    }

    fn right_hand_side(&self) -> String {
        let EquationCosts { half, whole, most_multiplications, .. } = &self.equations;
        let row = |name: &str, costs: &RightHandSide| {
            let RightHandSide { time, narrow_time, multiplications } = costs;
            let rate = *multiplications as f64 / time;
            format!(
                "| {name} | {:.2} | {:.2} | {multiplications} | {:.1} | {:.0} % |\n",
                1e6 * time,
                1e6 * narrow_time,
                1e-9 * rate,
                100.0 * rate / most_multiplications,
            )
        };
        let strips = self.model.strips.len();
        format!(
            "## The right-hand side\n\n\
             Multiplications of numbers in registers are counted by running the same formulas with an arithmetic that counts (`src/math/arithmetic.rs`);\n\
             there are about as many additions.\n\
             This machine does at most {:.1} a nanosecond, each with an addition. One strip at a time gives the same bits.\n\n\
             | of | µs | one strip at a time, µs | multiplications | a nanosecond | of what is possible |\n\
             | --- | --- | --- | --- | --- | --- |\n{}{}\n\
             That is {:.0} ns for each of the {strips} strips in symmetric flight, {:.0} ns otherwise.\n\n",
            1e-9 * most_multiplications,
            row("half the aircraft (the standard flight)", half),
            row("the whole aircraft", whole),
            1e9 * half.time / strips as f64,
            1e9 * whole.time / strips as f64,
        )
    }

    fn scaling_tables(&self) -> String {
        let Scaling { modes, strips, inflow_states, fidelity, geometrically_exact: bending, .. } =
            &self.scaling;
        let groups: [(&str, &[Point]); 7] = [
            ("modes (the rest standard)", modes),
            ("strips (each cut into parts)", strips),
            ("inflow states", inflow_states),
            ("fidelity level", fidelity),
            ("geometrically exact: modes", &bending.modes),
            ("geometrically exact: strips (each cut into parts)", &bending.strips),
            (
                "geometrically exact: sections (the same strips, bays of masses cut into parts)",
                &bending.sections,
            ),
        ];
        let table = |(title, points): (&str, &[Point])| {
            let rows: String = points.iter().map(scaling_row).collect();
            format!(
                "| {title} | right-hand side, µs, half | whole | CPU ms per s of flight, library, half | whole |\n\
                 | --- | --- | --- | --- | --- |\n{rows}\n"
            )
        };
        groups.into_iter().map(table).collect()
    }

    /// The right-hand side over the sizes, each relative to the standard aircraft's.
    pub fn chart(&self) -> Chart {
        let Scaling { modes, strips, inflow_states, .. } = &self.scaling;
        let all = self.model.strips.len();
        let curve = |label: String, points: &[Point], standard: usize| Curve {
            label,
            points: points
                .iter()
                .map(|point| (point.size as f64 / standard as f64, 1e6 * point.half.right_hand_side))
                .collect(),
        };
        let curves = vec![
            curve("modes (1 is 12)".to_owned(), modes, 12),
            curve(format!("strips (1 is {all})"), strips, all),
            curve("inflow states a strip (1 is 5)".to_owned(), inflow_states, 5),
        ];
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let most = points().fold(0.0_f64, |most, point| most.max(point.1));
        Chart {
            title: "Time of one right-hand side in symmetric flight".to_owned(),
            x: Axis::new("size, in parts of the standard aircraft's (1)", Window::new(0.0, 4.2)),
            y: Axis::new("processor time (µs)", Window::new(0.0, 1.1 * most)),
            curves,
            marks: vec![Mark::Vertical(1.0, String::new())],
            frame: None,
        }
    }
}

fn accuracy_row(level: &str, accuracy: &Accuracy) -> String {
    let Accuracy { tolerance, time_per_second, errors: [pitch, tip, load] } = accuracy;
    let times = 1.0 / time_per_second;
    format!(
        "| {level}{tolerance:.0e} | {time_per_second:.5} | {times:.0} | {pitch:.1e} | {tip:.1e} | {load:.1e} |\n"
    )
}

fn latency_row(latency: &Latency) -> String {
    let cells: String = latency.quantiles.iter().map(|time| format!(" {:.1} µs |", 1e6 * time)).collect();
    format!("| {:.0} ms |{cells} {:.1} µs |\n", 1e3 * latency.step, 1e6 * latency.longest)
}

fn scaling_row(point: &Point) -> String {
    let Point { label, half, whole, .. } = point;
    let (rates, flights) = (
        [half, whole].map(|costs| 1e6 * costs.right_hand_side),
        [half, whole].map(|costs| 1e3 * costs.time_per_second),
    );
    format!("| {label} | {:.2} | {:.2} | {:.2} | {:.2} |\n", rates[0], rates[1], flights[0], flights[1])
}

/// The processor, as Linux names it.
fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let value = |key: &str| {
        let line = text.lines().find(|line| line.starts_with(key))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    let vectors =
        if value("flags").is_some_and(|flags| flags.contains("avx512f")) { " with AVX-512" } else { "" };
    let name = value("model name").unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    match value("cpu MHz") {
        Some(clock) => format!("{name}{vectors}, {clock} MHz"),
        None => format!("{name}{vectors}"),
    }
}
