#!/usr/bin/env bash
# selftest.sh CHECK: runs check_CHECK.sh on an example it must accept and on examples it must refuse, made on the spot.
. "$(dirname "$0")/common.sh"

here=$(cd "$(dirname "$0")" && pwd)
check=$here/check_$1.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

accepts() {
    "$check" "$@" || fail "$(basename "$check") $* refuses a good example"
    echo "accepted as it should be: $*"
}

# The reason must match $1, so that the check is seen to refuse for what is wrong.
refuses() {
    local reason=$1 said
    shift
    said=$("$check" "$@" 2>&1) && fail "$(basename "$check") $* accepts a bad example"
    grep -qE -e "$reason" <<<"$said" || fail "$(basename "$check") $* gives another reason than '$reason': $said"
    echo "refused as it should be: $(tail -n 1 <<<"$said")"
}

# library NAME FLAGS...: NAME.so, and archive NAME: NAME.a, from C or C++ text on standard input.
library() {
    local name=$1
    shift
    "$CC" -x "${language:-c}" -fPIC -fvisibility=hidden -O1 -c - -o "$name.o"
    "$CC" -shared "$name.o" -o "$name.so" "$@"
}
archive() {
    "$CC" -x "${language:-c}" -fPIC -fvisibility=hidden -O1 ${flags:-} -c - -o "$1.o"
    rm -f "$1.a"
    ar rc "$1.a" "$1.o"
}
header() {
    mkdir -p include
    cat >"include/$1"
}
API='__attribute__((visibility("default")))'

selftest_needed() {
    local shared='-Wl,--no-as-needed'
    library good $shared -lm <<<"$API double f(double x) { return x; }"
    accepts good.so
    library cxx $shared -lstdc++ <<<"$API int f(void) { return 1; }"
    refuses 'libstdc\+\+' cxx.so
    library unwinds $shared -lgcc_s <<<"$API int f(void) { return 1; }"
    refuses 'libgcc_s' unwinds.so
    echo 'int x;' >plain.c
    "$CC" -c plain.c -o plain.o
    refuses 'no shared library' plain.o
}

selftest_soname() {
    mkdir good bad
    library object <<<"$API int f(void) { return 1; }"
    "$CC" -shared -Wl,-soname,libcontdyn.so.1 object.o -o good/libcontdyn.so.1.2.3
    ln -s libcontdyn.so.1.2.3 good/libcontdyn.so.1
    ln -s libcontdyn.so.1 good/libcontdyn.so
    accepts good/libcontdyn.so 1.2.3
    refuses 'SONAME is' good/libcontdyn.so 2.0.0
    refuses 'no file' good/libcontdyn.so 1.2.4
    "$CC" -shared object.o -o bad/libcontdyn.so
    refuses 'SONAME is' bad/libcontdyn.so 1.2.3
    rm good/libcontdyn.so.1
    cp good/libcontdyn.so.1.2.3 good/libcontdyn.so.1
    refuses 'does not lead' good/libcontdyn.so.1.2.3 1.2.3
    "$CC" -shared -Wl,-soname,libcontdyn.so.1 -Wl,-z,execstack object.o -o good/libcontdyn.so.1.2.3
    ln -sf libcontdyn.so.1.2.3 good/libcontdyn.so.1
    refuses 'executable stack' good/libcontdyn.so 1.2.3
    mkdir early
    "$CC" -shared -Wl,-soname,libcontdyn.so.0.7 object.o -o early/libcontdyn.so.0.7.2
    ln -s libcontdyn.so.0.7.2 early/libcontdyn.so.0.7
    ln -s libcontdyn.so.0.7 early/libcontdyn.so
    accepts early/libcontdyn.so 0.7.2
    "$CC" -shared -Wl,-soname,libcontdyn.so.0 object.o -o early/libcontdyn.so.0.7.2
    refuses 'SONAME is' early/libcontdyn.so 0.7.2
}

selftest_exports() {
    header a.h <<EOT
#include <stddef.h>
typedef struct cd_table { void (*run)(void* cd_user, size_t n); } cd_table;
enum { CD_A = 1 };
/* cd_in_a_comment(); */
$API int cd_one(const cd_table* table,
    int more);
$API const char* cd_two(void);
EOT
    local one="$API int cd_one(const void* table, int more) { return more + !table; }"
    local two="$API const char* cd_two(void) { return \"\"; }"
    library good <<<"$one $two int cd_hidden(void) { return 1; }"
    accepts good.so include a.h
    library extra <<<"$one $two $API int cd_three(void) { return 3; }"
    refuses 'in no header' extra.so include a.h
    library data <<<"$one $two $API int cd_data = 3;"
    refuses 'no function' data.so include a.h
    library missing <<<"$one"
    refuses 'not exported' missing.so include a.h
    library hidden <<<"$one const char* cd_two(void) { return \"\"; }"
    refuses 'not exported' hidden.so include a.h
    header empty.h <<<'typedef int cd_int;'
    refuses 'found no function' good.so include empty.h
}

selftest_undefined() {
    language=c++
    archive good <<<'extern "C" void* malloc(unsigned long); namespace cd { void* f() { return malloc(1); } }'
    accepts good.a
    library good <<<'extern "C" void* malloc(unsigned long); extern "C" '"$API"' void* f() { return malloc(1); }'
    accepts good.so
    archive news <<<'int* f() { return new int; }'
    refuses '_Znw' news.a
    library news <<<"$API int* f() { return new int; }"
    refuses '_Znw' news.so
    archive static_object <<<'struct S { ~S(); }; S::~S() { *(volatile int*)this = 0; } S s;'
    refuses '__cxa_atexit' static_object.a
    archive guard <<<'int g(); int f() { static int x = g(); return x; }'
    refuses '__cxa_guard' guard.a
    archive throws <<<'int f() { throw 1; }'
    refuses '__cxa_throw' throws.a
    archive prints <<<'extern "C" int puts(const char*); int f() { return puts(""); }'
    refuses 'prints' prints.a
    archive aborts <<<'extern "C" void abort(); void f() { abort(); }'
    refuses 'aborts' aborts.a
    archive inexact <<<'extern "C" float powf(float, float); float f(float x) { return powf(x, x); }'
    refuses 'another libm' inexact.a
}

selftest_start_up() {
    archive good <<<'int f(void) { return 1; }'
    accepts good.a
    archive constructor <<<'int g(void); __attribute__((constructor)) void f(void) { g(); }'
    refuses 'init_array|ctors' constructor.a
    archive destructor <<<'int g(void); __attribute__((destructor)) void f(void) { g(); }'
    refuses 'fini_array|dtors' destructor.a
    archive early <<<'int g(void); __attribute__((constructor(200))) void f(void) { g(); }'
    refuses 'init_array|ctors' early.a
    language=c++ archive static_object <<<'extern "C" int g(); int x = g();'
    refuses 'init_array|ctors' static_object.a
    library good <<<"$API int f(void) { return 1; }"
    accepts good.so
    library constructor <<<'int g(void); __attribute__((constructor)) void f(void) { g(); }'
    refuses 'init_array|ctors' constructor.so
    ar rc empty.a
    refuses 'no code' empty.a
}

selftest_globals() {
    local message='namespace cd { static thread_local char message[9]; char* f() { return message; } }'
    echo 'cd::message 9' >allowed
    language=c++
    archive good <<<"$message"' extern const char* const names[]; const char* const names[] = { "a", "b" };'
    accepts good.a allowed
    archive data <<<"$message int x = 1;"
    refuses '\.data' data.a allowed
    archive bss <<<"$message int x;"
    refuses '\.bss' bss.a allowed
    archive local <<<"$message int f() { static int x; return ++x; }"
    refuses '\.bss' local.a allowed
    archive thread <<<"$message namespace cd { thread_local int depth; }"
    refuses 'cd::depth' thread.a allowed
    echo 'cd::message 8' >smaller
    refuses 'cd::message 9' good.a smaller
    language=c flags=-fcommon archive common <<<'int x; int f(void) { return x; }'
    refuses 'common' common.a allowed
}

selftest_fma() {
    library good <<<"$API double f(double a, double b, double c) { volatile double p = a * b; return p + c; }"
    accepts good.so
    case $("$CC" -dumpmachine) in
    x86_64*) flags=-mfma ;;
    aarch64* | powerpc64* | riscv64*) flags= ;;
    *) echo "SKIPPED: no fused multiply-add known for this machine"; exit 77 ;;
    esac
    # shellcheck disable=SC2086 # flags are words
    "$CC" -x c -shared -fPIC -O2 -ffp-contract=fast $flags - -o fused.so \
        <<<"$API double f(double a, double b, double c) { return a * b + c; }"
    refuses 'fused' fused.so
    archive data <<<'extern const int x[]; const int x[] = { 1 };'
    refuses 'no code' data.a
}

selftest_apart() {
    rope='int rope_length(void) { return 1; } int x_rope_make(void) { return rope_length(); }'
    pond='int x_pond_make(void) { return 2; }'
    "$CC" -x c -c -o rope.o - <<<"$rope"
    "$CC" -x c -c -o pond.o - <<<"$pond"
    ar rc good.a rope.o pond.o
    accepts good.a x rope pond
    archive bad <<<"$rope $pond"
    refuses 'rope alone has of a pond' bad.a x rope pond
    refuses 'no function of a boat' good.a x rope boat
}

selftest_layers() {
    mkdir -p src/{base,kernel,solve,model,api} # each example adds to the one before
    echo '#include "contdyn/base.h"' >src/base/status.hh
    printf '#include <math.h>\n#include "base/status.hh"\n#include "kernel/line.hh"\n' >src/kernel/line.cpp
    echo '#include "contdyn/chain.h"' >src/model/chain.hh
    accepts src
    echo '  # include "solve/line.hh"' >src/kernel/line.hh
    refuses 'kernel/line.hh:1' src
    rm src/kernel/line.hh
    echo '#include <model/chain.hh>' >src/base/memory.hh
    refuses 'base/memory.hh:1' src
    echo '#include "contdyn/chain.h"' >src/base/memory.hh
    refuses 'base/memory.hh:1' src
    echo '#include "status.hh"' >src/base/memory.hh
    refuses 'write the layer' src
    rm src/base/memory.hh
    mkdir src/extra
    echo '#include "base/status.hh"' >src/extra/x.hh
    refuses 'outside' src
    mkdir nothing
    refuses 'no sources' nothing
}

selftest_file_length() {
    mkdir src
    seq 500 >src/long.cpp
    accepts 500 src
    seq 501 >src/longer.cpp
    refuses 'longer.cpp' 500 src
    rm src/*
    refuses 'no file' 500 src
}

selftest_headers() {
    guarded() { { printf '#ifndef X_H\n#define X_H\n' && cat && printf '#endif\n'; } | header x.h; }
    guarded <<<'#include <stdint.h>
typedef int32_t cd_a;'
    accepts "$CC" include
    guarded <<<'typedef int32_t cd_a;'
    refuses 'int32_t' "$CC" include
    guarded <<<'#if CD_NOT_DEFINED
#endif'
    refuses 'CD_NOT_DEFINED' "$CC" include
    guarded <<<'int cd_f(int class);'
    refuses 'class' "$CC" include
    guarded <<<'#include <stdalign.h>
int cd_f();'
    refuses 'x.h' "$CC" include
    header x.h <<<'enum { CD_A = 1 };'
    refuses 'CD_A' "$CC" include
    rm include/x.h
    refuses 'no header' "$CC" include
    said=$("$check" no-such-compiler include) && fail 'passes without a compiler' || [ $? = 77 ]
    grep -q SKIPPED <<<"$said"
}

selftest_baseline() {
    command -v abidw >/dev/null || exit 77
    local good='#include <stddef.h>
        typedef struct cd_table { void (*run)(void* user, size_t n); int size; } cd_table;
        typedef int cd_a;
        enum { CD_A = 1, CD_B = 2 };
        CD_API int cd_one(const cd_table* table, cd_a a);
        CD_API double cd_two(void);'
    header a.h <<<"$good"
    "$check" --update baseline include a.h
    accepts baseline include a.h
    header a.h <<<"$good"$'\n CD_API int cd_three(void);'
    accepts baseline include a.h
    header a.h <<<"${good/CD_B = 2/CD_B = 2, CD_C = 3}"
    accepts baseline include a.h
    header a.h <<<"${good/CD_B = 2/CD_B = 3}"
    refuses CD_B baseline include a.h
    header a.h <<<"${good/CD_B = 2/CD_C = 2}"
    refuses CD_B baseline include a.h
    header a.h <<<"${good/cd_a a/long a}"
    refuses cd_one baseline include a.h
    header a.h <<<"${good/CD_API double cd_two(void);/}"
    refuses cd_two baseline include a.h
    header a.h <<<"${good/double cd_two/float cd_two}"
    refuses cd_two baseline include a.h
    header a.h <<<"${good/int size;/int size, more;}"
    refuses cd_table baseline include a.h
    header a.h <<<"${good/void\* user, size_t n/size_t n, void* user}"
    refuses cd_table baseline include a.h
}

selftest_equations() {
    mkdir src
    printf 'so that\n\n    a = b,    (1)\n    c = d (x)     (2)\n\nand (3)\n' >src/model.md
    echo '// a line (model.md, 1 and 2)' >src/line.hh
    accepts src
    echo '// (model.md, 2 to 3)' >src/other.cpp
    refuses 'other.cpp:1' src
    rm src/other.cpp
    echo '// a line (model.md, 1)' >src/line.hh
    refuses 'nothing cites .2.' src
    echo '// a line (model.md, 1 to 2)' >src/line.hh
    accepts src
    printf '\n    e = f     (4)\n' >>src/model.md
    refuses 'in turn: 1 2 4' src
    sed -i '/(4)/d' src/model.md
    echo '// none' >src/line.hh
    refuses 'cites' src
}

"selftest_$1"
