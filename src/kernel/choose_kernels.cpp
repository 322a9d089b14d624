// Which kernels the processor can run. Asked by hand: the compiler's own __builtin_cpu_supports brings a static
// constructor with it.
#include "kernel/kernels.hh"

#if CD_WITH_AVX2 || CD_WITH_AVX512
#include <cpuid.h>
#endif

namespace cd {

#if CD_WITH_AVX2 || CD_WITH_AVX512
namespace {

struct Processor {
    bool avx2 = false, avx512 = false;

    Processor() {
        unsigned a, b, c, d;
        constexpr unsigned kOsSavesRegisters = 1u << 27, kAvx = 1u << 28;
        if (!__get_cpuid(1, &a, &b, &c, &d) || (c & kOsSavesRegisters) == 0 || (c & kAvx) == 0) return;
        unsigned saved, unused; // XCR0: which registers the system saves
        __asm__("xgetbv" : "=a"(saved), "=d"(unused) : "c"(0));
        if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return;
        avx2 = (saved & 0x06) == 0x06 && (b & 1u << 5) != 0;
        avx512 = avx2 && (saved & 0xe6) == 0xe6 && (b & 1u << 16) != 0 && (b & 1u << 17) != 0; // F and DQ
    }
};

} // namespace
#endif

// Asked once a thread: a virtual machine answers each of the processor's questions in microseconds.
uint32_t runnable_kernels() {
    constexpr uint32_t plain = 1u << CD_KERNELS_PLAIN;
#if CD_WITH_AVX2 || CD_WITH_AVX512
    static thread_local uint32_t sets = 0;
    if (sets != 0) return sets;
    const Processor processor;
    sets = plain;
    if (CD_WITH_AVX2 && processor.avx2) sets |= 1u << CD_KERNELS_AVX2;
    if (CD_WITH_AVX512 && processor.avx512) sets |= 1u << CD_KERNELS_AVX512;
    return sets;
#else
    return plain;
#endif
}

cd_kernels fastest_kernels() {
    cd_kernels set = CD_KERNELS_PLAIN;
    for (uint32_t faster = runnable_kernels() >> 1; faster > 0; faster >>= 1) ++set;
    return set;
}

} // namespace cd
