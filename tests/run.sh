#!/usr/bin/env bash
# All tests: Rust, the packaged FMU through FMPy, the FMU for several platforms. Needs Rust, a C compiler and
# Python 3.11 or newer.
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

# The environment is made anew when the pinned versions change.
venv=$target/venv
if ! cmp --silent tests/fmpy/requirements.txt "$venv/requirements.txt"; then
    rm -rf "$venv"
    python3 -m venv "$venv"
    "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement tests/fmpy/requirements.txt
    cp tests/fmpy/requirements.txt "$venv/requirements.txt"
fi
FMU=$target/fmu/FlexibleAircraft.fmu "$venv/bin/python" -m pytest tests/fmpy

bash tests/platforms/run.sh
