#!/usr/bin/env bash
# All tests: Rust, then the packaged FMU through FMPy, alone and coupled with control laws. Needs Rust, a C compiler and Python 3.11 or newer.
#
# Everything is built in release mode: the FMU needs that anyway, and nothing is compiled twice.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
target=${CARGO_TARGET_DIR:-target}

if cargo nextest --version >/dev/null 2>&1; then
    cargo nextest run --workspace --release --no-fail-fast
else
    cargo test --workspace --lib --bins --tests --release --no-fail-fast
fi
cargo test --workspace --doc --release

cargo run --release --quiet -- package --no-check --output "$target/fmu/FlexibleAircraft.fmu"

# environment NAME REQUIREMENTS…: a Python environment, made anew when the pinned versions change.
environment() {
    local venv=$target/$1
    shift
    if ! cat "$@" | cmp --silent - "$venv/requirements.txt"; then
        rm -rf "$venv"
        python3 -m venv "$venv"
        "$venv/bin/pip" install --quiet --disable-pip-version-check "${@/#/--requirement=}"
        cat "$@" >"$venv/requirements.txt"
    fi
}

export FMU=$target/fmu/FlexibleAircraft.fmu
environment venv tests/fmpy/requirements.txt
"$target/venv/bin/python" -m pytest tests/fmpy

environment venv-coupling examples/requirements.txt tests/coupling/requirements.txt
FLEXAIR=$target/release/flexair "$target/venv-coupling/bin/python" -m pytest tests/coupling
