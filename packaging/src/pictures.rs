//! The pictures of an FMU, where each version of FMI has importers look for them.

use flexible_aircraft::aircraft::Aircraft;
use flexible_aircraft::fmi::Version;

use crate::archive::Entry;
use crate::plan_view::{self, PictureError};

/// The icon that importing tools show.
const ICON: &[u8] = include_bytes!("../../modelDescription/model.png");

/// Where FMI 3.0 says that there is an icon: all of the usual square, and no terminals.
const ICON_ALONE: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiTerminalsAndIcons fmiVersion="3.0">
  <GraphicalRepresentation>
    <CoordinateSystem x1="-100" y1="-100" x2="100" y2="100" suggestedScalingFactorTo_mm="0.1"/>
    <Icon x1="-100" y1="-100" x2="100" y2="100"/>
  </GraphicalRepresentation>
</fmiTerminalsAndIcons>
"#;

/// Those of an aircraft.
///
/// # Errors
/// When it cannot be drawn.
pub(crate) fn entries(version: Version, aircraft: &Aircraft) -> Result<Vec<Entry>, PictureError> {
    Ok(match version {
        Version::V2 => vec![Entry::new("model.png", ICON)],
        Version::V3 => vec![
            Entry::new("terminalsAndIcons/icon.png", ICON),
            Entry::new("terminalsAndIcons/terminalsAndIcons.xml", ICON_ALONE),
            Entry::new("documentation/diagram.png", plan_view::png(aircraft)?),
        ],
    })
}
