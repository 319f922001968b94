//! The table `[basis]`: what stands beside the natural modes.

use super::{assert_messages, edited};

const BEFORE: &str = "model = \"exact\"\n";

fn with_basis(table: &str) -> String {
    format!("{BEFORE}\n[basis]\n{table}\n")
}

#[test]
fn load_modes_are_there_where_the_file_asks_for_them_and_nowhere_else() {
    let asked = |edits: &[(&str, &str)]| edited(edits).unwrap().load_modes;
    assert!(!asked(&[]));
    for (table, expected) in [("load_modes = true", true), ("load_modes = false", false), ("", false)] {
        assert_eq!(asked(&[(BEFORE, &with_basis(table))]), expected, "{table}");
    }
}

#[test]
fn what_is_no_flag_and_what_no_basis_has_is_refused() {
    let refused = |text: &str, message: &str| assert_messages(&[(BEFORE, text)], &[message]);
    refused(
        &with_basis("load_modes = 1"),
        "small.toml:11:14: basis.load_modes: found 1; true or false is allowed",
    );
    refused(
        &with_basis("load_mode = true"),
        "small.toml:11:1: basis.load_mode: found the unknown field \"load_mode\"; allowed here: load_modes",
    );
    refused(&format!("{BEFORE}basis = true\n"), "small.toml:9:9: basis: found true; a table is allowed");
}
