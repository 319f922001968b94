//! Where the program is at home: in a checkout, where cargo builds what changed, or installed with a data folder, where
//! neither sources nor cargo are.

use std::path::{Path, PathBuf};

use flexible_aircraft::variables::probably_meant;
use flexible_aircraft_packaging::{Installation, Licences};

use crate::workspace;

/// How the data folder is called that lies beside an installed program.
const DATA: &str = "flexair-data";

/// Where outputs go outside of a checkout, in the working directory, a folder for each command.
const OUTPUTS: &str = "flexair-out";

/// Where they go in a checkout.
const TARGET: &str = "target";

/// Where the program is at home.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Home {
    /// In a checkout of flexible-aircraft, this folder.
    Checkout(PathBuf),
    /// Apart from its sources.
    Installed(Installation),
}

/// A name that no aircraft has.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "here is no such file, and no aircraft of this name comes with flexair{}; {instead}",
    meant(meant_name)
)]
pub struct NoSuchAircraft {
    meant_name: Option<String>,
    instead: String,
}

fn meant(name: &Option<String>) -> String {
    name.as_ref().map_or(String::new(), |name| format!(", did you mean `{name}`?"))
}

impl Home {
    /// That of the program that runs.
    pub fn of_program() -> Self {
        let program = std::env::current_exe().unwrap_or_default();
        Home::with_data(program.parent().unwrap_or(Path::new(".")).join(DATA))
    }

    /// Installed with this data folder, if it is there; otherwise the checkout in which the program was built, if that is.
    pub fn with_data(data: PathBuf) -> Self {
        let cli = Path::new(env!("CARGO_MANIFEST_DIR"));
        let checkout = cli.parent().unwrap_or(cli);
        if !data.is_dir() && checkout.join("Cargo.toml").is_file() {
            Home::Checkout(checkout.to_owned())
        } else {
            Home::Installed(Installation::at(data))
        }
    }

    /// The folder of the aircraft files that come with the program.
    pub fn aircraft_folder(&self) -> PathBuf {
        match self {
            Home::Checkout(root) => root.join("aircraft"),
            Home::Installed(installation) => installation.aircraft(),
        }
    }

    /// The names of these aircraft, in alphabetical order.
    pub fn aircraft_names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.aircraft_folder()).into_iter().flatten().flatten();
        let files =
            entries.map(|entry| entry.path()).filter(|path| path.extension() == Some("toml".as_ref()));
        let mut names: Vec<String> =
            files.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
        names.sort();
        names
    }

    /// The file of one of them.
    pub fn aircraft_file(&self, name: &str) -> PathBuf {
        self.aircraft_folder().join(name).with_extension("toml")
    }

    /// The aircraft file that is meant by a path: one that comes with the program where the path is its name, otherwise the
    /// path itself.
    ///
    /// # Errors
    /// When the path is a name, and nothing has it.
    pub fn aircraft(&self, given: PathBuf) -> Result<PathBuf, NoSuchAircraft> {
        let name = given.to_str().filter(|name| !name.contains(['/', '\\', '.']) && !name.is_empty());
        let Some(name) = name else { return Ok(given) };
        let names = self.aircraft_names();
        if names.iter().any(|known| known == name) {
            return Ok(self.aircraft_file(name));
        }
        if given.exists() {
            return Ok(given);
        }
        let meant_name = probably_meant(name, names.iter().map(String::as_str)).map(str::to_owned);
        let instead = match names.as_slice() {
            [] => format!("none is in {}", self.aircraft_folder().display()),
            names => format!("there are {}", names.join(", ")),
        };
        Err(NoSuchAircraft { meant_name, instead })
    }

    /// A file of the user's own in the working directory whose name would be taken for that of an aircraft that comes with the program, and
    /// that aircraft's file.
    pub fn namesake(&self, given: &Path) -> Option<[PathBuf; 2]> {
        let own = given.with_extension("toml");
        let found = self.aircraft(given.to_owned()).ok()?;
        let is_another = own.is_file() && !same_file::is_same_file(&own, &found).unwrap_or(true);
        is_another.then_some([own, found])
    }

    /// Where a command's output goes that goes to a place in a checkout unless the user names another.
    pub fn output(&self, command: &str, in_checkout: &Path) -> PathBuf {
        let is_fmu = in_checkout == workspace::fmu();
        match (self, in_checkout.strip_prefix(TARGET)) {
            (Home::Checkout(root), Ok(_)) if is_fmu => root.join(in_checkout),
            (Home::Installed(_), Ok(_)) if is_fmu => in_checkout.file_name().unwrap_or_default().into(),
            (Home::Installed(_), Ok(inside)) => {
                // Folders are called after what they hold there, and after the command here.
                Path::new(OUTPUTS).join(command).join(inside.components().skip(1).collect::<PathBuf>())
            }
            _ => in_checkout.to_owned(),
        }
    }

    /// Where the licences of what is linked come from.
    pub fn licences(&self) -> Licences {
        match self {
            Home::Checkout(root) => Licences::Workspace(root.clone()),
            Home::Installed(installation) => installation.licences(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn installed(folder: &Path) -> Home {
        let aircraft = folder.join(DATA).join("aircraft");
        std::fs::create_dir_all(&aircraft).unwrap();
        for name in ["glider.toml", "biplane.toml", "README.md"] {
            std::fs::write(aircraft.join(name), "").unwrap();
        }
        Home::with_data(folder.join(DATA))
    }

    #[test]
    fn outputs_go_to_the_working_directory_outside_of_a_checkout() {
        let folder = tempfile::tempdir().unwrap();
        let (home, checkout) = (installed(folder.path()), Home::Checkout("/flexible-aircraft".into()));
        for (command, in_checkout, elsewhere) in [
            ("package", "/flexible-aircraft/target/fmu/FlexibleAircraft.fmu", "FlexibleAircraft.fmu"),
            ("reproduce", "target/reproduction", "flexair-out/reproduce"),
            ("bench", "target/performance/PERFORMANCE.md", "flexair-out/bench/PERFORMANCE.md"),
            ("merge", "FlexibleAircraft.fmu", "FlexibleAircraft.fmu"),
            ("simulate", "-", "-"),
        ] {
            let default =
                Path::new(in_checkout).strip_prefix("/flexible-aircraft/").unwrap_or(Path::new(in_checkout));
            assert_eq!(checkout.output(command, default), Path::new(in_checkout));
            assert_eq!(home.output(command, default), Path::new(elsewhere));
        }
    }

    #[test]
    fn a_name_is_an_aircraft_that_comes_with_the_program_and_anything_else_a_path() {
        let folder = tempfile::tempdir().unwrap();
        let home = installed(folder.path());
        assert_eq!(home.aircraft_names(), ["biplane", "glider"]);
        let glider = folder.path().join("flexair-data/aircraft/glider.toml");
        assert_eq!(home.aircraft("glider".into()), Ok(glider));
        for path in ["glider.toml", "./glider", "no/such", ""] {
            assert_eq!(home.aircraft(path.into()), Ok(path.into()));
        }
        let mistake = home.aircraft("glidre".into()).unwrap_err().to_string();
        assert_eq!(
            mistake,
            "here is no such file, and no aircraft of this name comes with flexair, did you mean `glider`?; there are biplane, glider"
        );
    }

    #[test]
    fn without_a_data_folder_the_checkout_is_home() {
        let folder = tempfile::tempdir().unwrap();
        let home = Home::with_data(folder.path().join(DATA));
        let Home::Checkout(root) = &home else { panic!("{home:?}") };
        assert!(root.join("cli/src/home.rs").is_file());
        assert!(home.aircraft_names().contains(&"goland-wing".to_owned()));
    }
}
