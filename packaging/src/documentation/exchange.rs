//! What a page says of the states of an FMU for model exchange.

use std::mem::{Discriminant, discriminant};

use flexible_aircraft::flight::ContinuousState;
use flexible_aircraft::variables::ArchiveTable;
use quick_xml::escape::escape;

/// States of one sort that stand side by side.
struct Run<'a> {
    sort: Discriminant<ContinuousState>,
    /// From 1.
    first: usize,
    last: usize,
    from: &'a str,
    to: &'a str,
}

/// A section; nothing where the importer integrates no states.
pub(super) fn states(table: &ArchiveTable) -> String {
    let count = table.states().len();
    if count == 0 {
        return String::new();
    }
    let rows: String = runs(table).iter().map(row).collect();
    format!(
        "<h3 id=\"states\">States</h3>\n<p>This FMU is for model exchange: the importer integrates its {count} states, and has the \
         rate of each as <code>der(…)</code>. They begin at the trim. <code>attitude.yaw</code> is a state and goes on beyond half a \
         turn: it is not wrapped to ±π, as it is in the FMU for co-simulation.</p>\n\
         <table>\n<tr><th>places</th><th>states</th></tr>\n{rows}</table>\n\
         <p>The states of a strip's inflow stand side by side: real ones, then real and imaginary part of each complex one. Modes and \
         inflow that do not take part rest at 0; actuators and engines that do not lag stand still, and move nothing.</p>\n\
         <p>The motion is stiff: rates to 1600&nbsp;1/s. Explicit methods need steps below 1.7&nbsp;ms (RK4: 1&nbsp;ms; \
         Dormand–Prince finds them by itself and was 20 times as fast as CVode), implicit ones pay for a Jacobian of {count} columns. \
         For flying take the co-simulation FMU, for linearising this one.</p>\n\
         <p>What is not continuous belongs to co-simulation: limits of actuators and engines (<code>rate_limit</code>, \
         <code>minimum</code>, <code>maximum</code>), sampled sensors (<code>sensor.enabled</code>) and <code>tolerance</code>, which \
         is no parameter here. <code>inflow_states</code> is 0 or what the aircraft file says.</p>\n"
    )
}

fn runs(table: &ArchiveTable) -> Vec<Run<'_>> {
    let mut runs: Vec<Run<'_>> = Vec::new();
    for (place, (state, reference)) in (1..).zip(table.states()) {
        let name = table.get(*reference).map_or("", |row| row.name.as_str());
        // Angle and rate of an actuator take turns.
        let sort = match state {
            ContinuousState::SurfaceRate(control) => discriminant(&ContinuousState::SurfaceAngle(*control)),
            state => discriminant(state),
        };
        match runs.last_mut() {
            Some(run) if run.sort == sort => (run.last, run.to) = (place, name),
            _ => runs.push(Run { sort, first: place, last: place, from: name, to: name }),
        }
    }
    runs
}

fn row(Run { first, last, from, to, .. }: &Run<'_>) -> String {
    let (from, to) = (escape(*from), escape(*to));
    if first == last {
        return format!("<tr><td>{first}</td><td><code>{from}</code></td></tr>\n");
    }
    format!("<tr><td>{first}–{last}</td><td><code>{from}</code> to <code>{to}</code></td></tr>\n")
}
