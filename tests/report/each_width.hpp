// Compiles a function for each width of vectors, as the library's kernels are; the best is taken when the program
// starts.
#ifndef REPORT_EACH_WIDTH_HPP
#define REPORT_EACH_WIDTH_HPP

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define REPORT_EACH_WIDTH __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define REPORT_EACH_WIDTH
#endif

#endif
