//! The page that shows it all.

use super::Reproduction;
use super::plots::Plot;

pub fn html(_: &Reproduction) -> String {
    String::new()
}
pub fn count<'a>(plots: impl Iterator<Item = &'a Plot>) -> String {
    plots
        .map(|p| {
            format!(
                "5.{} {} {:?} {:?} {}\n",
                p.figure.number,
                p.figure.quantity.label(),
                p.figure.window,
                p.fit.as_ref().map(|f| (f.ours.min, f.ours.max)),
                p.fit.as_ref().map_or(String::new(), |f| f.verdict.to_string())
            )
        })
        .collect()
}
