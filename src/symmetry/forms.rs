//! The two forms in which an aircraft flies: as the whole, or as its half while motion is its own mirror image.
//!
//! [theory: symmetry.half]

/// The form in which a state stands for the aircraft; [`Plants`](super::Plants) give those that it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Form {
    is_half: bool,
}

/// One thing for each form that an aircraft has.
#[derive(Clone, Debug)]
pub struct Forms<T> {
    whole: T,
    half: Option<T>,
}

impl Form {
    pub(super) const WHOLE: Form = Form { is_half: false };
    pub(super) const HALF: Form = Form { is_half: true };

    /// Whether it is the form of symmetric motion.
    pub fn is_symmetric(self) -> bool {
        self.is_half
    }
}

impl<T> Forms<T> {
    pub(super) fn new(whole: T, half: Option<T>) -> Self {
        Forms { whole, half }
    }

    /// That of a form; an aircraft without it has one form only.
    pub fn of(&self, form: Form) -> &T {
        match &self.half {
            Some(half) if form.is_half => half,
            _ => &self.whole,
        }
    }

    /// That of a form, to be changed.
    pub fn of_mut(&mut self, form: Form) -> &mut T {
        match &mut self.half {
            Some(half) if form.is_half => half,
            _ => &mut self.whole,
        }
    }

    /// Something else for each form.
    pub fn map<'a, U>(&'a self, mut make: impl FnMut(&'a T) -> U) -> Forms<U> {
        Forms { whole: make(&self.whole), half: self.half.as_ref().map(make) }
    }

    /// Something else for each form, of this and of what belongs to the same forms.
    pub(super) fn zip_map<'a, O, U>(
        &'a self,
        other: &'a Forms<O>,
        mut make: impl FnMut(&'a T, &'a O) -> U,
    ) -> Forms<U> {
        let whole = make(&self.whole, &other.whole);
        let half = self.half.as_ref().zip(other.half.as_ref()).map(|(one, other)| make(one, other));
        Forms { whole, half }
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        std::iter::once(&self.whole).chain(&self.half)
    }

    /// That of the whole aircraft.
    pub fn whole(&self) -> &T {
        &self.whole
    }

    pub(super) fn half(&self) -> Option<&T> {
        self.half.as_ref()
    }
}
