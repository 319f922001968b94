//! `flexair flutter` as a process: interrupted, and with nobody who reads what it says.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

fn flutter(aircraft: &str, points: &str, output: &Path) -> Command {
    let file: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft").join(aircraft);
    let mut command = Command::new(env!("CARGO_BIN_EXE_flexair"));
    command
        .arg("flutter")
        .arg(file)
        .args(["--from", "20", "--to", "80", "--points", points, "--output"])
        .arg(output);
    command
}

#[cfg(unix)]
#[test]
fn a_long_analysis_stops_at_ctrl_c_at_once_and_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("flutter");
    let mut process = flutter("goland-wing.toml", "100000", &output).stdout(Stdio::null()).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(500));
    assert!(process.try_wait().unwrap().is_none(), "a hundred thousand airspeeds take longer");
    let interrupted = Command::new("kill").args(["-INT", &process.id().to_string()]).status().unwrap();
    assert!(interrupted.success());
    let asked = Instant::now();
    assert!(!process.wait().unwrap().success());
    assert!(asked.elapsed() < Duration::from_secs(2), "{:?}", asked.elapsed());
    assert!(!output.exists());
}

#[test]
fn closed_output_is_no_panic_and_the_files_are_there() {
    let folder = tempfile::tempdir().unwrap();
    let mut process = flutter("typical-section.toml", "3", folder.path())
        .args(["--modes", "2"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(process.stdout.take());
    let ended = process.wait_with_output().unwrap();
    let complaint = String::from_utf8(ended.stderr).unwrap();
    assert!(!complaint.contains("panicked"), "{complaint}");
    assert!(folder.path().join("typical-section-roots.csv").exists());
}
