//! How a quantity varies along a component: a number, or one of five forms.

use super::document::{self, Value};
use super::error::{Place, Problem, Report};
use super::format::{Allowed, Field, Table, law as fields};

/// A point of a component: the fraction s of its length and the element in which it lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisPoint {
    pub(super) s: f64,
    pub(super) element: usize,
}

#[derive(Clone, Debug)]
enum LawForm {
    Constant(f64),
    PerElement(Vec<f64>),
    /// Linear between the pairs, constant beyond the first and the last.
    Piecewise {
        at: Vec<f64>,
        values: Vec<f64>,
    },
    /// Coefficients of 1, s, s² …
    Polynomial(Vec<f64>),
    /// root · (c / c(0))^power.
    ChordPower {
        root: f64,
        power: f64,
    },
    /// factor · another law of the same component.
    Multiple {
        of: String,
        factor: f64,
    },
}

/// A law of the file, with what its values may be.
#[derive(Clone)]
pub(super) struct Law {
    form: LawForm,
    pub(super) place: Place,
    allowed: &'static Allowed,
}

/// What a law may be, by the fields of its forms.
fn forms_text(forms: &[&Table]) -> String {
    let form = |form: &&Table| format!("{{ {} }}", form.names());
    format!("a number or a table of one form ({})", forms.iter().map(form).collect::<Vec<_>>().join(", "))
}

impl Law {
    /// Reads a law whose values must be what its field allows.
    pub(super) fn read(value: &Value) -> Option<Law> {
        let (place, allowed) = (value.place.clone(), value.kind.allowed());
        if value.is_number() {
            return Some(Law { form: LawForm::Constant(value.number()?), place, allowed });
        }
        // The first field tells the forms apart.
        let forms = value.kind.forms();
        let Some(format) = forms.iter().find(|format| value.has_field(format.fields[0])) else {
            return value.wrong(&forms_text(forms));
        };
        let table = value.table_of(format)?;
        let number = |field| table.required(field).and_then(|v| v.number());
        let form = if value.has_field(&fields::PER_ELEMENT) {
            LawForm::PerElement(table.required(&fields::PER_ELEMENT)?.within(allowed).numbers()?)
        } else if value.has_field(&fields::AT) {
            read_piecewise(&table, allowed)?
        } else if value.has_field(&fields::TERMS) {
            LawForm::Polynomial(table.required(&fields::TERMS)?.numbers()?)
        } else if value.has_field(&fields::ROOT) {
            let root = table.required(&fields::ROOT).and_then(|v| v.within(allowed).number());
            let power = number(&fields::POWER);
            LawForm::ChordPower { root: root?, power: power? }
        } else {
            let of = table.required(&fields::MULTIPLE_OF).and_then(|v| v.text());
            let factor = number(&fields::FACTOR);
            LawForm::Multiple { of: of?, factor: factor? }
        };
        Some(Law { form, place, allowed })
    }
}

fn read_piecewise(table: &document::Table, allowed: &'static Allowed) -> Option<LawForm> {
    let at = table.required(&fields::AT).and_then(|v| v.numbers());
    let values = table.required(&fields::VALUES).and_then(|v| v.within(allowed).numbers());
    let (at, values) = (at?, values?);
    if at.len() != values.len() {
        let found = format!("found {} places and {} values", at.len(), values.len());
        table.report.add(Problem::WrongType, &table.place, found, "as many values as places are allowed");
        return None;
    }
    if at.windows(2).any(|pair| pair[1] <= pair[0]) {
        let found = format!("found the places {at:?}");
        table.report.add(
            Problem::OutOfRange,
            &table.place.within(fields::AT.name),
            found,
            "increasing places are allowed",
        );
        return None;
    }
    Some(LawForm::Piecewise { at, values })
}

fn piecewise(at: &[f64], values: &[f64], s: f64) -> f64 {
    let next = at.partition_point(|&place| place < s);
    if next == 0 {
        return values[0];
    }
    if next == at.len() {
        return values[next - 1];
    }
    let fraction = (s - at[next - 1]) / (at[next] - at[next - 1]);
    values[next - 1] + fraction * (values[next] - values[next - 1])
}

/// The laws of one component that others can refer to.
pub(super) struct Laws<'a> {
    pub(super) chord: Option<&'a Law>,
    /// By the name of the field.
    pub(super) named: &'a [(&'static str, Law)],
    /// Number of elements of the component.
    pub(super) elements: usize,
    pub(super) report: &'a Report<'a>,
}

impl Laws<'_> {
    /// The values of a law at some points, or a complaint at the first that is not allowed.
    pub(super) fn values(&self, law: &Law, points: &[AxisPoint]) -> Option<Vec<f64>> {
        let values = self.unchecked(law, points)?;
        for (value, point) in values.iter().zip(points) {
            let place = law.place.within(&format!("element[{}]", point.element + 1));
            if !law.allowed.check(*value, &place, self.report) {
                return None;
            }
        }
        Some(values)
    }

    /// The values of a law, or everywhere the number that holds where its field is left out.
    pub(super) fn values_or_usual(
        &self,
        law: Option<&Law>,
        field: &Field,
        points: &[AxisPoint],
    ) -> Option<Vec<f64>> {
        law.map_or_else(|| Some(vec![field.absent.number(); points.len()]), |law| self.values(law, points))
    }

    /// The chord at some points; complains at the `place` that needs it when the component has none.
    pub(super) fn chords(&self, points: &[AxisPoint], place: &Place) -> Option<Vec<f64>> {
        let Some(chord) = self.chord else {
            let found = "found a quantity in terms of the chord, and no chord_m";
            let allowed = "it is allowed in a component that has a law chord_m";
            self.report.add(Problem::MissingField, place, found, allowed);
            return None;
        };
        // Its forms are none that would ask for a chord.
        self.values(chord, points)
    }

    fn unchecked(&self, law: &Law, points: &[AxisPoint]) -> Option<Vec<f64>> {
        let each = |value: &dyn Fn(&AxisPoint) -> f64| Some(points.iter().map(value).collect());
        match &law.form {
            LawForm::Constant(value) => each(&|_| *value),
            LawForm::PerElement(values) if values.len() == self.elements => each(&|p| values[p.element]),
            LawForm::PerElement(values) => {
                let found = format!("found {} values", values.len());
                let allowed = format!("one for each of the {} elements is allowed", self.elements);
                self.report.add(
                    Problem::WrongType,
                    &law.place.within(fields::PER_ELEMENT.name),
                    found,
                    allowed,
                );
                None
            }
            LawForm::Piecewise { at, values } => each(&|p| piecewise(at, values, p.s)),
            LawForm::Polynomial(terms) => {
                each(&|p| terms.iter().rev().fold(0.0, |sum, term| sum * p.s + term))
            }
            LawForm::ChordPower { root, power } => {
                let root_chord = self.chords(&[AxisPoint { s: 0.0, element: 0 }], &law.place)?[0];
                let chords = self.chords(points, &law.place)?;
                Some(chords.iter().map(|chord| root * libm::pow(chord / root_chord, *power)).collect())
            }
            LawForm::Multiple { of, factor } => {
                let base = self.base(law, of)?;
                Some(self.unchecked(base, points)?.iter().map(|value| factor * value).collect())
            }
        }
    }

    /// The law that another is a multiple of.
    fn base(&self, law: &Law, of: &str) -> Option<&Law> {
        let base = self.named.iter().find(|(name, _)| *name == of).map(|(_, base)| base);
        match base {
            Some(base) if !matches!(base.form, LawForm::Multiple { .. }) => return Some(base),
            Some(_) => {
                let found = format!("found a multiple of \"{of}\", which is itself a multiple");
                let allowed = "a multiple of a law that stands for itself is allowed";
                self.report.add(
                    Problem::Contradiction,
                    &law.place.within(fields::MULTIPLE_OF.name),
                    found,
                    allowed,
                );
            }
            None => {
                let names: Vec<&str> = self.named.iter().map(|(name, _)| *name).collect();
                let found = format!("found \"{of}\", which is not a law here");
                let allowed = match names.as_slice() {
                    [] => "the stiffnesses of this component are no laws: another form is allowed".to_owned(),
                    names => format!("allowed: {}", names.join(", ")),
                };
                self.report.add(
                    Problem::UnknownName,
                    &law.place.within(fields::MULTIPLE_OF.name),
                    found,
                    allowed,
                );
            }
        }
        None
    }
}
