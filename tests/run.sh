#!/usr/bin/env bash
# All tests: Rust, then the packaged FMU through FMPy, through every importer that a registry has, and coupled with control
# laws, then what `flexair view` writes, files and pages in Chromium. With platforms in PLATFORMS (win64, aarch64-linux) their
# libraries are built and flown too, with WHEEL=1, or platforms in WHEEL, the Python package is built, installed and tested: that is
# slow, and rarely breaks. Needs Rust, a C compiler and Python 3.11 or newer.
#
# What the tests in Rust are made of is compiled with the release's optimisations but linked quickly (profile `checked`); the FMU and the
# command, which the tests in Python fly, are those of a release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
target=${CARGO_TARGET_DIR:-target}

if cargo nextest --version >/dev/null 2>&1; then
    cargo nextest run --workspace --cargo-profile checked --no-fail-fast
else
    cargo test --workspace --lib --bins --tests --profile checked --no-fail-fast
fi
cargo test --workspace --doc --profile checked
# With the packages that the tests above had, so that nothing is compiled anew.
cargo build --workspace --examples --profile checked

# One archive for each version of FMI and each kind.
cargo run --release --quiet -- package --no-check --fmi 2 --fmi 3 --kind co-simulation --kind model-exchange --output "$target/fmu"

# An environment with the packages of a file; it is made anew when the pinned versions change.
python_of() {
    local requirements=$1 venv=$target/venv-$2
    if ! cmp --silent "$requirements" "$venv/requirements.txt"; then
        rm -rf "$venv"
        python3 -m venv "$venv"
        "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement "$requirements"
        cp "$requirements" "$venv/requirements.txt"
    fi
    echo "$venv/bin/python"
}
# An importer whose packages conflict with those of the others.
GEMSEO_PYTHON=$(python_of tests/masters/requirements-gemseo.txt gemseo)
export GEMSEO_PYTHON
export FMU=$target/fmu/FlexibleAircraft.fmu FLEXAIR=$target/release/flexair EXAMPLES=$target/checked/examples
for tests in fmpy masters coupling view; do
    python=$(python_of tests/$tests/requirements.txt $tests)
    "$python" -m pytest -rs tests/$tests
done

bash tests/view/run.sh

if [ -n "${PLATFORMS:-}" ]; then
    bash tests/platforms/run.sh
else
    echo 'tests/run.sh: the libraries of other platforms are left out; PLATFORMS="win64 aarch64-linux" flies them too'
fi

if [ -n "${WHEEL:-}" ]; then
    bash tests/wheel/run.sh
else
    echo 'tests/run.sh: the Python package is left out; WHEEL=1 builds, installs and tests it'
fi
