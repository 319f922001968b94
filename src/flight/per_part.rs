//! Settings that each control or engine of an aircraft has of its own.

/// One for each part, numbered as in the model; those of which nothing was said have the usual one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PerPart<T> {
    /// Ends with one that is not the usual one, so that equal settings are equal lists.
    said: Vec<T>,
}

impl<T: Copy + Default + PartialEq> PerPart<T> {
    /// That of a part.
    pub fn get(&self, part: usize) -> T {
        self.said.get(part).copied().unwrap_or_default()
    }

    /// Sets that of a part.
    pub fn set(&mut self, part: usize, setting: T) {
        if part >= self.said.len() {
            self.said.resize(part + 1, T::default());
        }
        self.said[part] = setting;
        while self.said.last().is_some_and(|last| *last == T::default()) {
            self.said.pop();
        }
    }

    /// Those of the first parts, to the last of which anything was said.
    pub fn said(&self) -> &[T] {
        &self.said
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_set_to_the_usual_again_was_never_said() {
        let mut settings = PerPart::default();
        assert_eq!(settings.get(3), 0);
        settings.set(3, 7);
        settings.set(1, 2);
        assert_eq!((settings.said(), settings.get(9)), (&[0, 2, 0, 7][..], 0));
        settings.set(3, 0);
        assert_eq!(settings.said(), [0, 2]);
        settings.set(1, 0);
        assert_eq!(settings, PerPart::default());
    }
}
