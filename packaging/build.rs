//! Compiles the one C file of the calling side, see `src/log_line.c`.

fn main() {
    println!("cargo::rerun-if-changed=src/log_line.c");
    cc::Build::new().file("src/log_line.c").compile("flexible_aircraft_log_line");
}
