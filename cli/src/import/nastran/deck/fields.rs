//! One line of bulk data cut into its fields: free (commas), small (columns of 8) and large (columns of 16, with a star).

use std::ops::Range;

/// Bytes of a file: a field without its blanks. Empty where nothing stands.
pub type Span = Range<u32>;

/// Fields of data of a line that is not large.
pub const DATA: usize = 8;

/// Columns of a field, small and large.
const SMALL: usize = 8;
const LARGE: usize = 16;

/// Columns of a line that count.
const WIDTH: usize = 80;

/// A line of bulk data.
#[derive(Debug, PartialEq)]
pub struct Line {
    /// The name of a card or the mark of a continuation, without the star.
    pub head: Span,
    /// As many as the format has.
    pub data: Vec<Span>,
    /// What the line ends with to name its continuation.
    pub tail: Span,
    /// Whether the head has a star, behind the name of a card or before the mark of a continuation.
    pub is_large: bool,
}

/// Why a line is none.
#[derive(Debug, PartialEq)]
pub enum Unreadable {
    /// More between commas than a line has fields.
    TooMany { found: usize, allowed: usize },
    /// More bytes than any field needs.
    TooLong { found: usize, allowed: usize },
}

/// Bytes of a line without its comment: between commas numbers may be long, but not without end.
const LONGEST: usize = 1000;

/// Cuts a line, whose first byte is at some place of its file; without its comment, which `$` begins.
pub fn cut(line: &str, at: u32) -> Result<Line, Unreadable> {
    let line = line.split('$').next().unwrap_or_default().trim_end();
    if line.len() > LONGEST {
        return Err(Unreadable::TooLong { found: line.len(), allowed: LONGEST });
    }
    if line.contains(',') { free(line, at) } else { Ok(fixed(line, at)) }
}

fn free(line: &str, at: u32) -> Result<Line, Unreadable> {
    let mut begin = 0;
    let mut fields = Vec::with_capacity(10);
    for part in line.split(',') {
        fields.push(trimmed(line, begin..begin + part.len(), at));
        begin += part.len() + 1;
    }
    let head = fields.remove(0);
    let (head, is_large) = without_star(line, head, at);
    let most = if is_large { DATA / 2 } else { DATA };
    let tail = if fields.len() > most { fields.remove(most) } else { head.end..head.end };
    let has_more = fields.iter().skip(most).any(|field| !field.is_empty());
    if has_more {
        return Err(Unreadable::TooMany { found: fields.len() + 2, allowed: most + 2 });
    }
    fields.resize(most, tail.start..tail.start);
    Ok(Line { head, data: fields, tail, is_large })
}

fn fixed(line: &str, at: u32) -> Line {
    let places = columns(line);
    let between = |from: usize, to: usize| {
        let mut inside = places.iter().filter(|(column, _)| (from..to).contains(column));
        let first = inside.next().map(|(_, bytes)| bytes.clone());
        let last = inside.next_back().map(|(_, bytes)| bytes.end);
        let bytes = first.map_or(line.len()..line.len(), |first| first.start..last.unwrap_or(first.end));
        trimmed(line, bytes, at)
    };
    let head = between(0, SMALL);
    let (head, is_large) = without_star(line, head, at);
    let (count, width) = if is_large { (DATA / 2, LARGE) } else { (DATA, SMALL) };
    let data = (0..count).map(|field| between(SMALL + field * width, SMALL + (field + 1) * width)).collect();
    Line { head, data, tail: between(WIDTH - SMALL, WIDTH), is_large }
}

/// The columns in which the letters of a line stand, with their bytes; a tab leads to the next field.
fn columns(line: &str) -> Vec<(usize, Range<usize>)> {
    let mut column = 0;
    let mut places = Vec::with_capacity(line.len().min(WIDTH));
    for (byte, letter) in line.char_indices() {
        if column >= WIDTH {
            break;
        }
        if letter == '\t' {
            column += SMALL - column % SMALL;
        } else {
            places.push((column, byte..byte + letter.len_utf8()));
            column += 1;
        }
    }
    places
}

/// Without blanks at both ends.
fn trimmed(line: &str, bytes: Range<usize>, at: u32) -> Span {
    let part = &line[bytes.clone()];
    let begin = bytes.start + (part.len() - part.trim_start().len());
    let end = begin + part.trim().len();
    at + begin as u32..at + end as u32
}

fn text<'l>(line: &'l str, span: &Span, at: u32) -> &'l str {
    &line[(span.start - at) as usize..(span.end - at) as usize]
}

/// The head, and whether a star makes its line large: behind a name it goes, before the mark of a continuation it tells that it is one.
fn without_star(line: &str, head: Span, at: u32) -> (Span, bool) {
    let said = text(line, &head, at);
    let is_large = said.ends_with('*') || said.starts_with('*');
    let is_mark = said.starts_with('*');
    (head.start..head.end - u32::from(is_large && !is_mark), is_large)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(line: &str) -> (String, Vec<String>, String) {
        let cut = cut(line, 0).unwrap();
        let text = |span: &Span| line[span.start as usize..span.end as usize].to_owned();
        (text(&cut.head), cut.data.iter().map(text).collect(), text(&cut.tail))
    }

    #[test]
    fn the_three_formats_give_the_same_fields() {
        let small = texts("GRID          12       3     1.5    2.+1     -4.       5                +A1 $ x");
        assert_eq!(small.0, "GRID");
        assert_eq!(small.1, ["12", "3", "1.5", "2.+1", "-4.", "5", "", ""]);
        assert_eq!(small.2, "+A1");
        assert_eq!(texts("GRID, 12, 3, 1.5, 2.+1, -4., 5,,, +A1").1, small.1);
        assert_eq!(texts("GRID\t12\t3\t1.5\t2.+1\t-4.\t5").1, small.1);
        let large = "GRID*                 12               3             1.5            2.+1*G";
        assert_eq!(texts(large), ("GRID".into(), small.1[..4].to_vec(), "*G".into()));
        assert_eq!(texts("GRID*,12,3,1.5,2.+1").1, small.1[..4]);
    }

    #[test]
    fn too_many_commas_are_refused_and_letters_of_any_kind_are_columns() {
        assert_eq!(cut("A,1,2,3,4,5,6,7,8,+,10", 0), Err(Unreadable::TooMany { found: 11, allowed: 10 }));
        assert_eq!(texts("GRÏD          ü2").1[0], "ü2");
        assert_eq!(texts("+           1.0").0, "+");
        assert_eq!(texts("").1.len(), 8);
    }
}
