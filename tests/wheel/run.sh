#!/usr/bin/env bash
# Builds the wheels with the libraries of the platforms in WHEEL (`1`: linux64 alone), installs that of linux64 into a fresh
# environment, and tests it there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=${CARGO_TARGET_DIR:-$PWD/target}

read -ra platforms <<<"${WHEEL/#1/linux64}"
bash packaging/build-wheels.sh --if-possible "${platforms[@]}"

# Where nothing of the checkout is.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check --requirement tests/wheel/requirements.txt \
    "$target"/wheels/flexair-*manylinux*.whl
cp tests/wheel/*.py "$folder"
mkdir "$folder/wheels"
cp "$target"/wheels/*.whl "$folder/wheels"

# In a namespace where an empty folder lies over the checkout, if the system lets us; in any case no program is found but those
# of the environment.
root=$PWD away=()
hide='mount -t tmpfs none "$0" && exec "$@"'
if unshare --mount --map-root-user sh -c "$hide" "$root" true 2>/dev/null; then
    away=(unshare --mount --map-root-user sh -c "$hide" "$root")
else
    echo 'tests/wheel: the checkout cannot be hidden here' >&2
fi
cd "$folder"
"${away[@]}" env --ignore-environment PATH="$folder/venv/bin" HOME="$folder" \
    "$folder/venv/bin/python" -m pytest -rs "$folder"
