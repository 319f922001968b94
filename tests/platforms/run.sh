#!/usr/bin/env bash
# Builds the FMU for several platforms, and checks and flies its libraries wherever that can be done here.
#
# linux64 always; of the platforms in PLATFORMS (default: win64 and aarch64-linux, which wine and qemu can run) those
# that can be built. As root on Debian, what is missing is installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
venv=${CARGO_TARGET_DIR:-$PWD/target}/platforms/venv

read -ra platforms <<<"${PLATFORMS:-win64 aarch64-linux}"
bash packaging/build-platforms.sh --if-possible linux64 "${platforms[@]}"

wanted=()
[ -x /usr/lib/wine/wine64 ] || command -v wine64 >/dev/null || wanted+=(wine64)
command -v qemu-aarch64 >/dev/null || command -v qemu-aarch64-static >/dev/null || wanted+=(qemu-user)
[ -d /usr/aarch64-linux-gnu/lib ] || wanted+=(libc6-arm64-cross)
if [ ${#wanted[@]} -gt 0 ] && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get update -qq &&
        DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-remove --no-install-recommends "${wanted[@]}" \
            >/dev/null || echo "tests/platforms: ${wanted[*]} cannot be installed" >&2
fi

if ! cmp --silent tests/platforms/requirements.txt "$venv/requirements.txt"; then
    "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement tests/platforms/requirements.txt
    cp tests/platforms/requirements.txt "$venv/requirements.txt"
fi
"$venv/bin/python" -m pytest -rs tests/platforms
