#!/usr/bin/env bash
# Builds the Python package `flexair` as wheels, with the shared libraries of several platforms inside.
#
#   bash packaging/build-wheels.sh [--if-possible] [PLATFORM ...]
#
# The PLATFORMs are those whose libraries come with the package, chosen as in build-platforms.sh: linux64 always, all that
# can be built unless some are named. There is a wheel for linux64 (manylinux2014: glibc 2.17 and newer), and one for win64
# where its library is built; each is for every Python from 3.11 on. They go to target/wheels.
#
# Needs what build-platforms.sh does, and installs maturin from PyPI.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh
wheels=$CARGO_TARGET_DIR/wheels
data=python/package/flexair/flexair-data

# Builds the wheel of a platform with what was compiled for its library.
build_wheel() (
    use_toolchain "$1"
    case $1 in
        linux64) target=(--target x86_64-unknown-linux-gnu --zig --compatibility manylinux2014) ;;
        win64) target=(--target x86_64-pc-windows-gnu --interpreter python3.11) ;;
    esac
    "$venv/bin/maturin" build "${target[@]}" "${std[@]}" --locked --release --manifest-path python/Cargo.toml \
        --target-dir "$work/$1" --out "$wheels"
)

choose_platforms "$@"
prepare_zig
"$venv/bin/pip" install --quiet --disable-pip-version-check --requirement packaging/wheel-requirements.txt
build_libraries

say "gathering libraries, licences and aircraft"
rm -rf "$data" "$wheels"
# Away again at the end: what lies there counts as installed.
trap 'rm -rf "$data"' EXIT
cargo build --locked --release --quiet --workspace --example data_folder
"$CARGO_TARGET_DIR/release/examples/data_folder" "$data" flexair-python "${libraries[@]}" >&2

for platform in linux64 win64; do
    if [[ " ${platforms[*]} " == *" $platform "* ]]; then
        say "building the wheel for $platform"
        if ! build_wheel "$platform" >"$work/wheel-$platform.log" 2>&1; then
            cat "$work/wheel-$platform.log" >&2
            say "the wheel for $platform does not build"
            exit 1
        fi
    fi
done
ls "$wheels"/*.whl
