//! What the tests measured, for people: each test writes down its cases in a record, checks them, and compares
//! the record with its file in `records/`; `VERIFICATION.md` is all records in the order of [`CLAIMS`].
//!
//! With the environment variable `UPDATE_GOLDEN=1` the tests rewrite their files instead of failing on them;
//! a second run then rewrites `VERIFICATION.md` from all of them.

use std::fs;
use std::path::{Path, PathBuf};

/// A claim of `VERIFICATION.md`: its heading, the test file in this directory, the records in order.
type Claim = (&'static str, &'static str, &'static [&'static str]);

/// All claims in the order of `VERIFICATION.md`.
const CLAIMS: &[Claim] = &[
    (
        "Beam element",
        "beam",
        &["beam-static", "beam-uniform-load", "beam-frequencies", "beam-orientation", "beam-rigid-body"],
    ),
    ("Frames closed by joints", "joints", &["joints"]),
    (
        "Sections with coupling",
        "coupled_sections",
        &[
            "bend-twist-static",
            "coupled-section-static",
            "axes-apart-static",
            "turned-section",
            "offset-beam",
            "bend-twist-frequencies",
            "tension-axis-arc",
        ],
    ),
    ("Strain energy of coupled sections", "coupled_energy", &["coupled-energy", "redescribed-section"]),
    ("A wing that washes out", "coupled_wing", &["wash-out"]),
    ("One wing described twice", "described_twice", &["described-twice", "turned-flight"]),
    ("Elastic hinges", "hinges", &["hinge-static", "hinge-frequencies", "hinge-far"]),
    ("Section loads at hinges", "hinge_loads", &["hinge-loads"]),
    ("Modal integrals", "modal_integrals", &["modal-integrals", "mass-matrix"]),
    ("Equations of motion", "equations_of_motion", &["equations-of-motion"]),
    ("Strain energy", "strain_energy", &["strain-energy", "strain-energy-by-element", "string"]),
    ("Geometric stiffening", "spin_up", &["spin-up", "spin-up-taut", "spinning"]),
    ("Large deflections of beams", "elastica", &["elastica", "half-circle", "bend"]),
    ("A turning beam that keeps its length", "turning_beam", &["spin-up-geometrically-exact"]),
    ("Geometrically exact kinematics", "exact_kinematics", &["exact-kinematics", "exact-mass", "exact-rows"]),
    (
        "Small motions of the geometrically exact level",
        "small_motions",
        &["undeformed-mass", "unloaded-jacobian"],
    ),
    ("Unsteady aerodynamics", "inflow", &["theodorsen", "wagner", "garrick", "flap"]),
    ("Loads of strips", "strip_loads", &["strip-loads", "flow-rates"]),
    ("Leading-edge suction", "suction", &["steady-drag", "camber-thrust", "adverse-yaw", "steady-power"]),
    ("Clamped frequencies and mass of the jet", "frequencies", &["frequencies"]),
    ("Trim", "trim", &["trim"]),
    (
        "Trim with wings bent by nearly half of their span",
        "geometrically_exact",
        &["trim-geometrically-exact", "trim-levels"],
    ),
    ("Trims of manoeuvres", "manoeuvres", &["trim-manoeuvres", "section-loads-manoeuvres"]),
    ("Load modes", "load_modes", &["load-modes", "load-modes-trim", "load-modes-few"]),
    ("Flutter with load modes", "load_modes_flutter", &["load-modes-flutter"]),
    ("Eigenvalues", "eigenvalues", &["eigenvalues", "eigenvalues-geometrically-exact"]),
    (
        "Linear models",
        "linear_model",
        &["linear-model-gains", "linear-model-eigenvalues", "linear-model-steps"],
    ),
    ("Modes in flight and flying qualities", "flight_modes", &["flight-modes", "flying-qualities"]),
    (
        "Frozen gusts in linear models",
        "harmonic_gusts",
        &["harmonic-gusts", "harmonic-gusts-single", "continuous-turbulence"],
    ),
    (
        "Static margin",
        "static_margin",
        &["static-margin", "static-margin-inflow", "static-margin-half", "neutral-point"],
    ),
    ("Conservation in vacuum", "conservation", &["conservation-kept", "conservation-lost"]),
    ("What turns in engines", "rotors", &["gyrostat", "whirl", "rotors-conservation"]),
    ("Energy balance in air", "energy_balance", &["energy-balance"]),
    ("Phugoid and short period", "rigid_modes", &["rigid-modes"]),
    ("A held section in a gust", "sears", &["sears", "kussner"]),
    ("Gusts that penetrate", "gusts", &["gust", "gust-weak", "gust-other", "gust-constant", "gust-half"]),
    ("A gust where O is", "gust_field", &["gust-field"]),
    (
        "Section loads",
        "section_loads",
        &["section-loads", "section-loads-gust", "section-loads-equilibrium", "section-loads-half"],
    ),
    (
        "Section loads summed plainly",
        "section_loads_summed",
        &["section-loads-summed", "section-loads-hinged"],
    ),
    ("Sensors on the structure", "sensors", &["sensors"]),
    ("Actuators and engines", "actuators", &["actuators"]),
    ("Fidelity levels", "fidelity_levels", &["rigid-limit", "damping"]),
    ("Invariance of the flight", "flight", &["mirror", "steadiness", "heading"]),
    ("Symmetric motion", "symmetry", &["half"]),
    ("Flutter", "flutter", &["flutter-section", "flutter-wings"]),
    ("Dead forces", "point_loads", &["dead-force"]),
    ("A loaded wing", "loaded_wing", &["flutter-loaded", "weightless-rod"]),
    ("Wind tunnel", "wind_tunnel", &["divergence"]),
    ("Measured sections", "measured_sections", &["divergence-moment-slope"]),
    (
        "Very flexible wings",
        "flexible_wings",
        &["patils-wing", "very-flexible-wing", "very-flexible-wing-flutter", "pazy"],
    ),
    ("Standard and other atmospheres", "atmosphere", &["warm-day", "stratosphere"]),
    ("High altitude, long endurance", "high_altitude", &["flying-wing", "high-altitude"]),
];

/// The cases of one test.
pub struct Record {
    name: &'static str,
    text: String,
    failures: Vec<String>,
}

impl Record {
    /// A record with the heading that says what is compared, and where the reference values come from.
    pub fn new(name: &'static str, heading: &str, source: &str) -> Self {
        let text = format!(
            "### {heading}\n\nSource: {source}\n\n| case | reference | tolerance | measured | deviation |\n\
             | --- | --- | --- | --- | --- |\n"
        );
        Record { name, text, failures: Vec::new() }
    }

    /// A value with a tolerance relative to its reference.
    pub fn relative(&mut self, case: &str, reference: f64, tolerance: f64, measured: f64) {
        let deviation = measured / reference - 1.0;
        let cells = [
            digits(reference, 5),
            format!("{} rel.", plain(tolerance)),
            digits(measured, 5),
            small(deviation),
        ];
        self.add(case, &cells, deviation.abs() <= tolerance);
    }

    /// A value with an absolute tolerance.
    pub fn absolute(&mut self, case: &str, reference: f64, tolerance: f64, measured: f64) {
        let deviation = measured - reference;
        let cells = [digits(reference, 5), plain(tolerance), digits(measured, 5), small(deviation)];
        self.add(case, &cells, deviation.abs() <= tolerance);
    }

    /// A truncation error, which should be as small as stated and shows two digits.
    pub fn error(&mut self, case: &str, bound: f64, measured: f64) {
        let cells = ["0".to_owned(), plain(bound), format!("{measured:.1e}"), String::new()];
        self.add(case, &cells, measured.abs() <= bound);
    }

    /// A rounding error: whatever is below the bound looks the same on every machine.
    pub fn rounding(&mut self, case: &str, bound: f64, measured: f64) {
        // What the record does not show is printed, so that a bound can be judged by what is found.
        println!("{case}: {measured:.1e} of {}", plain(bound));
        let shown =
            if measured.abs() <= bound { format!("< {}", plain(bound)) } else { format!("{measured:e}") };
        self.add(case, &["0".to_owned(), plain(bound), shown, String::new()], measured.abs() <= bound);
    }

    /// A value that must reach a bound.
    pub fn at_least(&mut self, case: &str, bound: f64, measured: f64) {
        let cells = [format!("≥ {}", digits(bound, 3)), String::new(), digits(measured, 3), String::new()];
        self.add(case, &cells, measured >= bound);
    }

    /// A value that must stay below a bound.
    pub fn at_most(&mut self, case: &str, bound: f64, measured: f64) {
        let cells = [format!("≤ {}", digits(bound, 3)), String::new(), digits(measured, 3), String::new()];
        self.add(case, &cells, measured <= bound);
    }

    /// A paragraph under the table.
    pub fn remark(&mut self, text: &str) {
        self.text.push_str(&format!("\n{text}\n"));
    }

    fn add(&mut self, case: &str, cells: &[String; 4], holds: bool) {
        let row = format!("| {case} | {} |\n", cells.join(" | "));
        if !holds {
            self.failures.push(row.clone());
        }
        self.text.push_str(&row);
    }

    /// Fails on every case that does not hold, and when the file does not say what was measured.
    pub fn finish(self) {
        println!("{}", self.text);
        assert!(self.failures.is_empty(), "these do not hold:\n{}", self.failures.concat());
        let listed = CLAIMS.iter().any(|(_, _, records)| records.contains(&self.name));
        assert!(listed, "{} is missing in CLAIMS", self.name);
        compare(&record_path(self.name), &self.text);
    }
}

#[test]
fn verification_md_says_what_the_tests_measured() {
    let mut page = String::from(
        "# What is verified, against what, how closely\n\n\
         Written by the tests in [`tests/verification`](tests/verification), one file per claim; a test fails when this\n\
         page or a measured value changes. `UPDATE_GOLDEN=1 cargo nextest run --release verification`, run twice, rewrites it.\n\
         *Deviation* is relative where the tolerance is; *< x* stands for anything at rounding level. [theory: air-loads.lift] cites a\n\
         label of [`docs/theory`](docs/theory/README.md).\n",
    );
    for (heading, file, records) in CLAIMS {
        page.push_str(&format!("\n## {heading}\n\n[`{file}.rs`](tests/verification/{file}.rs)\n"));
        for record in *records {
            let path = record_path(record);
            let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            page.push_str(&format!("\n{text}"));
        }
    }
    compare(&Path::new(env!("CARGO_MANIFEST_DIR")).join("VERIFICATION.md"), &page);
}

#[test]
fn every_record_belongs_to_a_claim() {
    for entry in fs::read_dir(record_path("x").parent().unwrap()).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let listed = CLAIMS.iter().any(|(_, _, records)| records.contains(&name.as_str()));
        assert!(listed, "{} belongs to no claim", path.display());
    }
}

fn record_path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/verification/records/{name}.md"))
}

/// Fails when a file does not hold the text, or writes it.
fn compare(path: &Path, text: &str) {
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(path, text).unwrap();
    }
    let found = fs::read_to_string(path).unwrap_or_default();
    assert!(found == text, "{} is stale; UPDATE_GOLDEN=1 rewrites it. It should be:\n{text}", path.display());
}

/// A number with so many significant digits.
fn digits(value: f64, count: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = libm::floor(libm::log10(value.abs())) as i32;
    if (-3..6).contains(&magnitude) {
        let decimals = (count as i32 - 1 - magnitude).max(0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.*e}", count - 1)
    }
}

/// A tolerance: one or two digits.
fn plain(value: f64) -> String {
    format!("{value:.1e}").replace(".0e", "e")
}

/// A deviation with two digits; what may be rounding is not shown.
fn small(deviation: f64) -> String {
    if deviation.abs() < 1e-9 { "< 1e-9".to_owned() } else { format!("{deviation:+.1e}") }
}
