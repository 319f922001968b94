//! What a page says of the interface of its FMU: how inputs are set, and how long parameters may be.

use flexible_aircraft::fmi::{Interface, Kind, Version};

/// Of co-simulation: who gives rates of inputs in FMI 2.0.
const RATES_OF_INPUTS: &str = "With <code>fmi2SetRealInputDerivatives</code>, order 1, an input changes at the
given rate, over as many steps as there are until its rate is given again or its value is set at a later communication point;
higher orders are left out with a warning. Few importers call it, and the wind must not jump: a gust without its rate
is 12 to 23&nbsp;% wrong in load factor. So <code>wind_rate_north</code>, <code>wind_rate_east</code> and
<code>wind_rate_down</code> are inputs. From the last setting of wind or rate on the wind changes at this rate (and the
derivative, if given), which is kept until it is set again; setting the rate alone starts from the wind that acts then.";

/// The same in FMI 3.0, which has no such function.
const RATES_OF_WIND: &str = "The wind must not jump: a gust without its rate is 12 to 23&nbsp;% wrong in load factor. So
<code>wind_rate_north</code>, <code>wind_rate_east</code> and <code>wind_rate_down</code> are inputs. From the last setting of
wind or rate on the wind changes at this rate, which is kept until it is set again; setting the rate alone starts from the wind
that acts then.";

/// Of model exchange.
const INPUTS_OF_EXCHANGE: &str = "<p>Inputs are what they are set to at each instant. <code>wind_rate_north</code>,
<code>wind_rate_east</code> and <code>wind_rate_down</code> act beside <code>wind_north</code>, <code>wind_east</code> and
<code>wind_down</code>: the apparent mass feels the rate of the wind, the wind itself is what is set, whatever its rate. Who sets a wind that
changes sets its rate too: without it a gust is 12 to 23&nbsp;% wrong in load factor.</p>
";

/// How inputs act, and what the tolerance and a bad trim do.
pub(super) fn how_to_use(Interface { version, kind }: Interface) -> String {
    let exit = match version {
        Version::V2 => "fmi2ExitInitializationMode",
        Version::V3 => "fmi3ExitInitializationMode",
    };
    let warning = match version {
        Version::V2 => "fmi2Warning",
        Version::V3 => "fmi3Warning",
    };
    let trim = format!(
        "A trim that nobody could fly stands: <code>{exit}</code> then answers\n<code>{warning}</code>, and the log names quantity, \
         value and limit."
    );
    let rates = match version {
        Version::V2 => RATES_OF_INPUTS,
        Version::V3 => RATES_OF_WIND,
    };
    match kind {
        Kind::CoSimulation => format!(
            "<p>Inputs act from the beginning of a communication step and are held until they are set again; 10&nbsp;ms is a good step \
             for flight control. {rates}</p>\n<p>Of the tolerance that an importer gives and the parameter \
             <code>tolerance</code> the tighter one counts, and is what the\nparameter reads in flight. {trim}</p>\n"
        ),
        Kind::ModelExchange => format!("{INPUTS_OF_EXCHANGE}<p>{trim}</p>\n"),
    }
}

/// When inputs and parameters may be set.
pub(super) fn when_set(kind: Kind) -> &'static str {
    match kind {
        Kind::CoSimulation => {
            "Inputs may be set at every communication point, parameters until initialisation ends."
        }
        Kind::ModelExchange => "Inputs may be set at every instant, parameters until initialisation ends.",
    }
}

/// What happens where the model does not hold any more.
pub(super) fn ending(kind: Kind) -> &'static str {
    match kind {
        Kind::CoSimulation => "A step ends with an error and a logged reason",
        Kind::ModelExchange => "An evaluation is discarded with a logged reason",
    }
}
