#!/usr/bin/env bash
# Builds fmi-sim, an importer from crates.io that test_rust_importers.py then flies. It takes minutes; CI does not.
#
# Its C bindings are generated with libclang, which comes from PyPI; the compiler's own headers are GCC's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=${CARGO_TARGET_DIR:-target}
folder=$target/masters/fmi-sim-0.7.0

python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check libclang==18.1.1
LIBCLANG_PATH=$(echo "$PWD/$folder"/venv/lib/python3*/site-packages/clang/native)
export LIBCLANG_PATH
export BINDGEN_EXTRA_CLANG_ARGS="-I$(cc -print-file-name=include)"
cargo install fmi-sim --version 0.7.0 --root "$folder" --target-dir "$folder/target"
