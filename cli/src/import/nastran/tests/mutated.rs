//! Decks with random mistakes: refused with words, or an aircraft; never a panic, and never for long.

use std::time::{Duration, Instant};

use super::*;

/// SplitMix64 [Steele, Lea, Flood 2014]: the same mutants in every run.
struct Random(u64);

impl Random {
    fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % below as u64) as usize
    }
}

/// What numbers and words are replaced by.
const WORDS: [&str; 16] = [
    "",
    "0",
    "-1",
    "1",
    "2",
    "3",
    "999999999",
    "9223372036854775807",
    "0.",
    "-1.5",
    "1.+300",
    "1.-300",
    "THRU",
    "YES",
    "BOX",
    "GGO",
];

/// The example, with all of its files in one.
fn transport() -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/nastran");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let bulk = ["fuselage.bdf", "wing.bdf", "tails.bdf", "aero.bdf"].map(read).concat();
    let begin = read("transport.bdf");
    let own: String = begin
        .lines()
        .filter(|line| !line.starts_with("INCLUDE") && *line != "ENDDATA")
        .map(|line| format!("{line}\n"))
        .collect();
    own + &bulk
}

#[test]
fn random_mistakes_are_refused_or_imported() {
    let mut random = Random(20_240_117);
    let decks = [transport(), cards::stick_text(), wrapped(&panels::wing_text())];
    let begin = Instant::now();
    let mut imported = 0;
    for round in 0..1500 {
        let mut lines: Vec<String> = decks[round % decks.len()].lines().map(str::to_owned).collect();
        for _ in 0..1 + random.next(3) {
            let line = random.next(lines.len());
            match random.next(6) {
                0 => drop(lines.remove(line)),
                1 => {
                    let other = lines[random.next(lines.len())].clone();
                    lines.insert(line, other);
                }
                2 => {
                    let other = random.next(lines.len());
                    lines.swap(line, other);
                }
                3 => {
                    let letter = random.next(lines[line].len().max(1));
                    if lines[line].is_char_boundary(letter) {
                        let inserted =
                            ['0', '9', '.', '-', '+', ',', '*', ' ', 'E', '\t', '$', 'ü'][random.next(12)];
                        lines[line].insert(letter, inserted);
                    }
                }
                _ => {
                    let mut fields: Vec<String> = if lines[line].contains(',') {
                        lines[line].split(',').map(str::to_owned).collect()
                    } else {
                        lines[line].split_whitespace().map(str::to_owned).collect()
                    };
                    if !fields.is_empty() {
                        let field = random.next(fields.len());
                        fields[field] = WORDS[random.next(WORDS.len())].to_owned();
                        lines[line] = fields.join(",");
                    }
                }
            }
            if lines.is_empty() {
                break;
            }
        }
        match of_text(&lines.join("\n")) {
            Ok(found) => {
                imported += 1;
                assert!(found.text().starts_with("# Written by"));
            }
            // What the library refuses names a file that nobody has.
            Err(error @ super::super::Error::NotRead(_)) => panic!("{error}\n{}", lines.join("\n")),
            Err(error) => assert!(!error.to_string().is_empty(), "{}", lines.join("\n")),
        }
    }
    assert!((200..1400).contains(&imported), "{imported}");
    assert!(begin.elapsed() < Duration::from_secs(120));
}
