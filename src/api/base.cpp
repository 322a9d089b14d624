#include "contdyn/base.h"

#include "base/status.hh"
#include "kernel/kernels.hh"

#define CD_TEXT_(a) #a
#define CD_TEXT(a) CD_TEXT_(a)
#if defined(__clang__)
#define CD_COMPILER "Clang " CD_TEXT(__clang_major__) "." CD_TEXT(__clang_minor__)
#elif defined(__GNUC__)
#define CD_COMPILER "GCC " CD_TEXT(__GNUC__) "." CD_TEXT(__GNUC_MINOR__)
#else
#define CD_COMPILER "another compiler"
#endif
#if defined(__x86_64__)
#define CD_TARGET "x86-64"
#elif defined(__i386__)
#define CD_TARGET "i686"
#elif defined(__aarch64__)
#define CD_TARGET "AArch64"
#elif defined(__riscv)
#define CD_TARGET "RISC-V"
#elif defined(__s390x__)
#define CD_TARGET "s390x"
#elif defined(__wasm__)
#define CD_TARGET "WebAssembly"
#else
#define CD_TARGET "another target"
#endif
#if defined(__AVX512F__) // by the flags of whoever builds it
#define CD_PLAIN "AVX-512"
#elif defined(__AVX2__)
#define CD_PLAIN "AVX2"
#elif defined(__AVX__)
#define CD_PLAIN "AVX"
#elif defined(__SSE2__)
#define CD_PLAIN "SSE2"
#elif defined(__aarch64__)
#define CD_PLAIN "NEON"
#elif defined(__wasm_simd128__)
#define CD_PLAIN "SIMD128"
#else
#define CD_PLAIN "plain"
#endif

const char* cd_status_name(cd_status status) {
    switch (status) {
#define CD_NAME(code) \
    case code: return #code;
        CD_NAME(CD_OK)
        CD_NAME(CD_ERROR_NULL)
        CD_NAME(CD_ERROR_HANDLE)
        CD_NAME(CD_ERROR_VALUE)
        CD_NAME(CD_ERROR_ENUM)
        CD_NAME(CD_ERROR_RANGE)
        CD_NAME(CD_ERROR_SIZE)
        CD_NAME(CD_ERROR_MEMORY)
        CD_NAME(CD_ERROR_DISABLED)
        CD_NAME(CD_ERROR_UNSUPPORTED)
        CD_NAME(CD_ERROR_DIVERGED)
        CD_NAME(CD_ERROR_FORMAT)
        CD_NAME(CD_ERROR_MISMATCH)
        CD_NAME(CD_ERROR_TOLERANCE)
        CD_NAME(CD_ERROR_CALLBACK)
#undef CD_NAME
    default: return "CD_ERROR_UNKNOWN";
    }
}

const char* cd_error_message(void) { return cd::last_message(); }

uint32_t cd_runnable_kernels(void) { return cd::runnable_kernels(); }

const char* cd_kernels_name(cd_kernels kernels) {
    switch (kernels) {
    case CD_KERNELS_PLAIN: return CD_PLAIN;
    case CD_KERNELS_AVX2: return "AVX2";
    case CD_KERNELS_AVX512: return "AVX-512";
    default: return "unknown";
    }
}

uint32_t cd_version(void) { return CD_VERSION_MAJOR * 1000000u + CD_VERSION_MINOR * 1000u + CD_VERSION_PATCH; }

const char* cd_version_string(void) {
    return CD_TEXT(CD_VERSION_MAJOR) "." CD_TEXT(CD_VERSION_MINOR) "." CD_TEXT(CD_VERSION_PATCH);
}

const char* cd_build_info(void) {
    return CD_COMPILER ", " CD_TARGET
                       ", objects:"
#if CD_WITH_CHAIN
                       " chain"
#endif
#if CD_WITH_ROPE
                       " rope"
#endif
#if CD_WITH_MEMBRANE
                       " membrane"
#endif
#if CD_WITH_CLOTH
                       " cloth"
#endif
#if CD_WITH_WATER
                       " water"
#endif
#if CD_WITH_HULL
                       " hulls"
#endif
                       ", features:"
#if CD_WITH_BEND
                       " bend"
#endif
#if CD_WITH_CONTACT
                       " contact"
#endif
#if CD_WITH_COUPLED
                       " coupled"
#endif
#if CD_WITH_ADVECTED
                       " advected"
#endif
#if CD_WITH_DRAW
                       " draw"
#endif
#if CD_WITH_SLEEP
                       " sleep"
#endif
#if CD_WITH_SAVE
                       " save"
#endif
                       ", precisions:"
#if CD_WITH_FLOAT32
                       " float32"
#endif
#if CD_WITH_FLOAT64
                       " float64"
#endif
                       ", kernels: plain"
#if CD_WITH_AVX2
                       " avx2"
#endif
#if CD_WITH_AVX512
                       " avx512"
#endif
        ;
}
