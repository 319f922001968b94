# What the scripts share that build the shared library for several platforms: sourced from the root of the workspace.
#
# linux64 is always built. For the others the source of Rust's standard library is needed: that of the toolchain in use
# (`rustup component add rust-src`), or that of Debian's packages, which are installed when this runs as root. win64 needs
# mingw. zig, the linker, is installed from PyPI. The same toolchains give the same bytes wherever this runs.

export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
work=$CARGO_TARGET_DIR/platforms
venv=$work/venv
mkdir -p "$work"

say() { printf '%s: %s\n' "$(basename "$0" .sh)" "$*" >&2; }

# Whether Debian packages are there, now or after installing them; never at the price of removing others.
debian() {
    local status
    status=$(dpkg-query --show --showformat '${db:Status-Status}\n' "$@" 2>/dev/null) || true
    [ "$(grep -cx installed <<<"$status")" = $# ] && return
    [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null || return
    apt-get update -qq >&2 &&
        DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-remove --no-install-recommends "$@" >/dev/null
}

# Chooses a cargo and a rustc that can build the standard library.
choose_toolchain_with_std_source() {
    if [ -d "$(rustc --print sysroot)/lib/rustlib/src/rust/library" ]; then
        cargo=$(command -v cargo) rustc=$(command -v rustc)
    elif debian rustc-web cargo-web rust-web-src; then
        cargo=/usr/bin/cargo rustc=/usr/bin/rustc
    else
        return 1
    fi
}

# Whether a platform other than linux64 can be built here.
prepare() {
    case $1 in
        win64)
            choose_toolchain_with_std_source &&
                { command -v x86_64-w64-mingw32-gcc >/dev/null || debian gcc-mingw-w64-x86-64; }
            ;;
        *) choose_toolchain_with_std_source ;;
    esac
}

# Sets the environment in which things are built for a platform, and options of cargo, `std`: in a subshell.
use_toolchain() {
    export PATH=$venv/bin:$PATH RUSTFLAGS="--remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo"
    std=()
    if [ "$1" != linux64 ]; then
        export RUSTC_BOOTSTRAP=1 CARGO=$cargo RUSTC=$rustc
        std=(-Z build-std=std,panic_unwind)
    fi
    if [ "$1" = win64 ]; then
        RUSTFLAGS+=" -C link-arg=-Wl,--no-insert-timestamp"
    fi
}

# Builds the library of a platform into $work/<platform>.
build() (
    use_toolchain "$1"
    case $1 in
        linux64) compile=(cargo-zigbuild zigbuild --target x86_64-unknown-linux-gnu.2.17) ;;
        win64) compile=("$CARGO" build --target x86_64-pc-windows-gnu) ;;
        aarch64-linux) compile=(cargo-zigbuild zigbuild --target aarch64-unknown-linux-gnu.2.17) ;;
        darwin64)
            # Stripped by the linker, which signs what it writes: changed later, it would not load. zig knows no list
            # of exported symbols for macOS: what C shall not see is hidden.
            export CARGO_PROFILE_RELEASE_STRIP=none MACOSX_DEPLOYMENT_TARGET=11.0
            RUSTFLAGS+=" -Z default-visibility=hidden"
            RUSTFLAGS+=" -C link-arg=-s -C link-arg=-Wl,-install_name,@rpath/FlexibleAircraft.dylib"
            compile=(cargo-zigbuild zigbuild --target universal2-apple-darwin)
            ;;
    esac
    "${compile[@]}" "${std[@]}" --locked --release --package flexible-aircraft --lib --target-dir "$work/$1"
)

built_library() {
    case $1 in
        linux64) echo "$work/$1/x86_64-unknown-linux-gnu/release/libflexible_aircraft.so" ;;
        win64) echo "$work/$1/x86_64-pc-windows-gnu/release/flexible_aircraft.dll" ;;
        aarch64-linux) echo "$work/$1/aarch64-unknown-linux-gnu/release/libflexible_aircraft.so" ;;
        darwin64) echo "$work/$1/universal2-apple-darwin/release/libflexible_aircraft.dylib" ;;
    esac
}

# Chooses platforms: linux64, and of those given the ones that can be built here. With `--if-possible` among them, or
# without any, for all then, those are left out that cannot; otherwise that is an error.
choose_platforms() {
    local if_possible= wanted=() word platform
    for word in "$@"; do
        case $word in
            --if-possible) if_possible=yes ;;
            linux64 | win64 | aarch64-linux | darwin64) wanted+=("$word") ;;
            *)
                say "found $word, allowed are --if-possible, linux64, win64, aarch64-linux and darwin64"
                exit 2
                ;;
        esac
    done
    if [ ${#wanted[@]} = 0 ]; then
        if_possible=yes wanted=(win64 aarch64-linux darwin64)
    fi
    platforms=(linux64)
    for platform in "${wanted[@]}"; do
        if [[ " ${platforms[*]} " == *" $platform "* ]]; then
            continue
        elif prepare "$platform"; then
            platforms+=("$platform")
        else
            say "LEFT OUT: $platform, for want of the source of Rust's standard library or of a linker"
            [ -n "$if_possible" ] || exit 1
        fi
    done
}

# Makes the Python environment with zig.
prepare_zig() {
    if ! cmp --silent packaging/zig-requirements.txt "$venv/zig-requirements.txt"; then
        rm -rf "$venv"
        python3 -m venv "$venv"
        "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement packaging/zig-requirements.txt
        cp packaging/zig-requirements.txt "$venv/zig-requirements.txt"
    fi
}

# Builds the libraries of the chosen platforms; `libraries` are then PLATFORM=FILE.
build_libraries() {
    local builds=() index platform
    # Side by side: much of a build has nothing to do for a second processor.
    say "building ${platforms[*]}"
    for platform in "${platforms[@]}"; do
        build "$platform" >"$work/$platform.log" 2>&1 &
        builds+=($!)
    done
    libraries=()
    for index in "${!platforms[@]}"; do
        platform=${platforms[index]}
        if ! wait "${builds[index]}"; then
            cat "$work/$platform.log" >&2
            say "$platform does not build"
            exit 1
        fi
        libraries+=("$platform=$(built_library "$platform")")
    done
}
