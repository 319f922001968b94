#!/usr/bin/env bash
# All tests: Rust, then the packaged FMU through FMPy, through every importer that a registry has, and coupled with control
# laws, then what `flexair view` writes, files and pages in Chromium, and Nastran decks beside pyNastran. With platforms in PLATFORMS (win64, aarch64-linux) their
# libraries are built and flown too, with WHEEL=1, or platforms in WHEEL, the Python package is built, installed and tested, with SLOW=1
# the tests in Rust that take a minute and more are run too, and more pages: that is slow, and rarely breaks. Needs Rust, a C compiler and
# Python 3.11 or newer.
#
# What the tests in Rust are made of is compiled with the release's optimisations but linked quickly (profile `checked`); the FMU and the
# command, which the tests in Python fly, are those of a release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
target=${CARGO_TARGET_DIR:-target}

# One archive for each version of FMI and each kind.
package() {
    cargo run --release --quiet -- package --no-check --fmi 2 --fmi 3 --kind co-simulation --kind model-exchange --output "$target/fmu"
}

# An environment with the packages of a file; it is made anew when the pinned versions change.
environment() {
    local requirements=$1 venv=$target/venv-$2
    cmp --silent "$requirements" "$venv/requirements.txt" && return
    rm -rf "$venv"
    python3 -m venv "$venv"
    "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement "$requirements"
    cp "$requirements" "$venv/requirements.txt"
}
environments() {
    for tests in fmpy masters coupling view nastran; do
        environment tests/$tests/requirements.txt $tests
    done
    # An importer whose packages conflict with those of the others.
    environment tests/masters/requirements-gemseo.txt gemseo
}

# Linking and downloading leave cores idle: these are made beside the tests in Rust, and say something if they fail.
mkdir -p "$target"
(set -e; package) >"$target/package.log" 2>&1 &
package=$!
(set -e; environments) >"$target/environments.log" 2>&1 &
environments=$!
trap 'jobs -p | xargs --no-run-if-empty kill 2>/dev/null' EXIT
is_made() {
    wait "$1" || { cat "$2" >&2; return 1; }
}

if cargo nextest --version >/dev/null 2>&1; then
    cargo nextest run --workspace --cargo-profile checked --no-fail-fast ${SLOW:+--run-ignored all}
else
    cargo test --workspace --lib --bins --tests --profile checked --no-fail-fast ${SLOW:+-- --include-ignored}
fi
cargo test --workspace --doc --profile checked
# With the packages that the tests above had, so that nothing is compiled anew.
cargo build --workspace --examples --profile checked

is_made $package "$target/package.log"
is_made $environments "$target/environments.log"
export GEMSEO_PYTHON=$target/venv-gemseo/bin/python
export FMU=$target/fmu/FlexibleAircraft.fmu FLEXAIR=$target/release/flexair EXAMPLES=$target/checked/examples
for tests in fmpy masters coupling view nastran; do
    # A file of tests stays with one process: its tests share what is costly to make.
    "$target/venv-$tests/bin/python" -m pytest -rs --numprocesses auto --dist loadfile tests/$tests
done

bash tests/view/run.sh

[ -n "${SLOW:-}" ] || echo 'tests/run.sh: tests in Rust that take a minute and more, and some pages, are left out; SLOW=1 runs them too'

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
