# Read by every script here. CMake gives: $SOURCE and $BUILD of contdyn, $LIBRARY and $ARCHIVE that it built, $CONFIG,
# $VERSION, $ABI_VERSION (that of the SONAME), $LIBDIR, $WORK (a folder of the tests' own), $CMAKE, $CC, $CXX, $NM, $READELF.
set -euo pipefail
export LC_ALL=C
unset DESTDIR

here=$SOURCE/tests/install
prefix=$WORK/moved
expected="contdyn $VERSION: rope down to 0.000000 -1.000000, curtain down to -1.000000"

fail() {
    printf '%s: %s\n' "$(basename "$0" .sh)" "$*" >&2
    exit 1
}

needs() {
    "$READELF" -dW "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'
}

# Silent when all goes well, or else all that was said.
quietly() {
    local said
    said=$("$@" 2>&1) || { printf '%s\n' "$said"; return 1; }
}

# configures FOLDER ARGUMENT...: cmake with the compilers and the build type that contdyn was built with.
configures() {
    local out=$1
    shift
    rm -rf "$out"
    quietly "$CMAKE" -B "$out" -DCMAKE_BUILD_TYPE="$CONFIG" -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" "$@"
}

builds() { # builds FOLDER ARGUMENT...
    quietly "$CMAKE" --build "$1" --parallel 2 "${@:2}"
}

# runs shared|static PROGRAM: fails unless it prints what it should and is linked as it should be.
runs() {
    local said
    said=$("$2") || fail "$2 exits with $?"
    [ "$said" = "$expected" ] || fail "$2 prints '$said', not '$expected'"
    case $1 in
    shared) needs "$2" | grep -qx "libcontdyn.so.$ABI_VERSION" || fail "$2 does not need the shared library" ;;
    static) ! needs "$2" | grep -q contdyn || fail "$2 needs the shared library" ;;
    esac
    echo "$2 ($1): $said"
}
