//! Whether connections fit the model descriptions of their components.

use flexible_aircraft::variables::nearest;

use super::component::Component;
use super::connection::Connection;
use super::endpoint::Endpoint;
use super::error::{ConnectionError, Misfit, SystemError};
use crate::model_description::Variable;

/// The connections, each with its output first.
pub(super) fn connections(
    components: &[Component],
    wanted: &[(Endpoint, Endpoint)],
) -> Result<Vec<Connection>, SystemError> {
    let (mut connections, mut misfits): (Vec<Connection>, _) = (Vec::new(), Vec::new());
    for (first, second) in wanted {
        let checked =
            connection(components, first, second).and_then(|new| match feeder(&connections, &new.input) {
                Some(by) => {
                    Err(ConnectionError::FedTwice { input: new.input.to_string(), by: by.to_string() })
                }
                None => Ok(new),
            });
        match checked {
            Ok(connection) => connections.push(connection),
            Err(error) => misfits.push(Misfit { given: format!("{first}={second}"), error }),
        }
    }
    if misfits.is_empty() { Ok(connections) } else { Err(SystemError::Misfits(misfits)) }
}

/// The output that feeds an input.
pub(super) fn feeder<'c>(connections: &'c [Connection], input: &Endpoint) -> Option<&'c Endpoint> {
    connections.iter().find(|connection| connection.input == *input).map(|connection| &connection.output)
}

fn connection(components: &[Component], a: &Endpoint, b: &Endpoint) -> Result<Connection, ConnectionError> {
    let (at_a, at_b) = (variable(components, a)?, variable(components, b)?);
    let (output, from, input, to) = match (at_a.causality.as_str(), at_b.causality.as_str()) {
        ("output", "input") => (a, at_a, b, at_b),
        ("input", "output") => (b, at_b, a, at_a),
        _ => {
            let (first, second) = (described(a, at_a), described(b, at_b));
            return Err(ConnectionError::Causality { first, second });
        }
    };
    for (end, variable) in [(output, from), (input, to)] {
        if let Some(dimensions) = component(components, end)?.description.dimensions(variable) {
            return Err(ConnectionError::Array { found: described(end, variable), dimensions });
        }
    }
    if !from.kind.holds_the_same_as(to.kind) {
        return Err(ConnectionError::types(from.kind, to.kind));
    }
    let without_unit = match (from.unit.as_str(), to.unit.as_str()) {
        ("", "") => None,
        ("", _) => Some(output.clone()),
        (_, "") => Some(input.clone()),
        (made, needed) => {
            let definition = |end, unit| component(components, end).map(|c| c.description.base_unit(unit));
            let (of_made, of_needed) = (definition(output, made)?, definition(input, needed)?);
            if made != needed && (of_made.is_none() || of_made != of_needed) {
                return Err(ConnectionError::Unit { output: made.to_owned(), input: needed.to_owned() });
            }
            None
        }
    };
    Ok(Connection { output: output.clone(), input: input.clone(), without_unit })
}

/// The component of an endpoint.
pub(super) fn component<'c>(
    components: &'c [Component],
    end: &Endpoint,
) -> Result<&'c Component, ConnectionError> {
    let found = components.iter().find(|component| component.name == end.component);
    found.ok_or_else(|| {
        let names: Vec<&str> = components.iter().map(|component| component.name.as_str()).collect();
        ConnectionError::UnknownComponent { found: end.component.clone(), allowed: names.join(", ") }
    })
}

/// The variable at an endpoint.
pub(super) fn variable<'c>(
    components: &'c [Component],
    end: &Endpoint,
) -> Result<&'c Variable, ConnectionError> {
    let component = component(components, end)?;
    component.description.variable(&end.variable).ok_or_else(|| {
        let names = component.description.variables.iter().map(|variable| variable.name.as_str());
        ConnectionError::UnknownVariable {
            component: component.name.clone(),
            found: end.variable.clone(),
            nearest: nearest(&end.variable, names),
        }
    })
}

/// An endpoint and what it is.
pub(super) fn described(end: &Endpoint, variable: &Variable) -> String {
    match variable.causality.as_str() {
        "" => format!("the local variable `{end}`"),
        causality => format!("the {causality} `{end}`"),
    }
}
