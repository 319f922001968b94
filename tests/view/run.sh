#!/usr/bin/env bash
# The page of `flexair view` in headless Chromium: a made-up sample and pages that the command FLEXAIR writes. What is missing is
# installed: Chromium by apt, as root where there is apt, Node from PyPI into an environment under target/. Where that cannot be done it
# says so and tests nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
FLEXAIR=$(realpath "${FLEXAIR:-$target/release/flexair}")
export FLEXAIR

leave_out() {
    printf '\n*** tests/view/run.sh: SKIPPED, the page of flexair view is not tested: %s ***\n\n' "$1" >&2
    exit 0
}

install_chromium() {
    [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null || return 1
    local install=(env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends chromium)
    "${install[@]}" >/dev/null 2>&1 || { apt-get update >/dev/null && "${install[@]}" >/dev/null; }
}

has_node() {
    command -v npm >/dev/null &&
        node -e 'const [major, minor] = process.versions.node.split("."); process.exit(100 * major + +minor < 2011 ? 1 : 0)' 2>/dev/null
}

install_node() {
    [ -x "$target/venv-node/bin/node" ] || python3 -m venv "$target/venv-node" || return 1
    "$target/venv-node/bin/pip" install --quiet --disable-pip-version-check --requirement tests/view/requirements-node.txt
}

# Packages of web/, anew when their versions change.
install_packages() {
    cmp --silent package-lock.json node_modules/package-lock.json && return
    npm ci --silent --no-audit --no-fund && cp package-lock.json node_modules/
}

if ! { [ -n "${CHROMIUM:-}" ] || command -v chromium || command -v chromium-browser || command -v google-chrome; } >/dev/null; then
    install_chromium || leave_out 'there is no Chromium, and apt-get does not install it; CHROMIUM may name one'
fi
if ! has_node; then
    install_node || leave_out 'there is no Node 20.11 or newer, and pip does not install it'
    PATH=$target/venv-node/bin:$PATH
fi
cd web
install_packages || leave_out 'npm ci does not install the packages of web/'
npm test
