//! Numbers as Nastran writes them: `1.5`, `1.5E+3`, `1.5D3`, and `1.5+3`, where the sign alone begins the exponent.

/// A real number; none where the text is something else, or not finite.
pub fn real(text: &str) -> Option<f64> {
    let mut plain = String::with_capacity(text.len() + 1);
    let mut has_exponent = false;
    for (place, letter) in text.char_indices() {
        match letter {
            '0'..='9' | '.' => plain.push(letter),
            'e' | 'E' | 'd' | 'D' if place > 0 && !has_exponent => {
                has_exponent = true;
                plain.push('e');
            }
            '+' | '-' => {
                let follows_exponent = plain.ends_with('e');
                if place > 0 && !follows_exponent {
                    if has_exponent {
                        return None;
                    }
                    has_exponent = true;
                    plain.push('e');
                }
                plain.push(letter);
            }
            _ => return None,
        }
    }
    plain.parse().ok().filter(|number: &f64| number.is_finite())
}

/// A whole number.
pub fn integer(text: &str) -> Option<i64> {
    text.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_need_no_letter() {
        let cases = [
            ("1.5", 1.5),
            ("-.5", -0.5),
            ("7.0E+7", 7e7),
            ("7.d-3", 7e-3),
            ("2.5+10", 2.5e10),
            ("-1.-3", -1e-3),
            ("+3.E2", 300.0),
            ("1+3", 1000.0),
            ("4", 4.0),
        ];
        for (text, number) in cases {
            assert_eq!(real(text), Some(number), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in
            ["", "-", "E5", "1.2.3", "1.E", "1.5+3-2", "1.E5+2", "THRU", "nan", "inf", "1.+999", "1 2"]
        {
            assert_eq!(real(text), None, "{text}");
        }
        assert_eq!(
            [integer("12"), integer("-3"), integer("1."), integer("")],
            [Some(12), Some(-3), None, None]
        );
    }
}
