#!/usr/bin/env bash
# Builds the shared library for several platforms and packages them into one FMU.
#
#   bash packaging/build-platforms.sh [--if-possible] [PLATFORM ...] [-- OPTION ...]
#
# linux64 is always built. Further PLATFORMs are win64, aarch64-linux and darwin64; without any, all are built if
# possible: where the tools are missing and cannot be installed, the platform is left out, loudly. The OPTIONs go to
# `flexair package`, such as `--aircraft my.toml --output my.fmu`; the FMU is target/platforms/FlexibleAircraft.fmu
# otherwise.
#
# Needs Rust and Python 3.11 or newer, and installs zig, the linker, from PyPI. The further platforms also need the
# source of Rust's standard library: that of the toolchain in use (`rustup component add rust-src`), or that of
# Debian's packages, which are installed when this runs as root. win64 needs mingw. The same toolchains give the same
# bytes wherever this runs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh

wanted=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    wanted+=("$1")
    shift
done
if [ $# -gt 0 ]; then shift; fi # the `--`

choose_platforms "${wanted[@]}"
prepare_zig
build_libraries
cargo run --locked --release --quiet -- package --output "$work" \
    "${libraries[@]/#/--binary=}" "$@"
