//! Lines of TOML with comments for people.

/// Longest line of a comment by itself.
const WIDTH: usize = 118;

/// A line with a comment behind it, which begins at a column or where the line ends.
pub fn beside(text: &str, comment: &str, column: usize) -> String {
    if comment.is_empty() { format!("{text}\n") } else { format!("{text:<column$} # {comment}\n") }
}

/// Lines of a comment; none of none.
pub fn comment(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let place = lines.len() - 1;
        if lines[place].len() + word.len() + 3 > WIDTH {
            lines.push(format!(" {word}"));
        } else {
            lines[place] += &format!(" {word}");
        }
    }
    lines.iter().filter(|line| !line.is_empty()).map(|line| format!("#{line}\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_behind_a_value_or_in_lines_of_their_own() {
        assert_eq!(beside("a = 1", "m", 8), "a = 1    # m\n");
        assert_eq!(beside("a = 1", "", 8), "a = 1\n");
        assert_eq!(comment(""), "");
        let lines = comment(&"word ".repeat(40));
        assert!(
            lines.lines().count() == 2
                && lines.lines().all(|line| line.len() <= WIDTH && line.starts_with("# word"))
        );
    }
}
