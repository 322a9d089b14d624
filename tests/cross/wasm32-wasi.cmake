# WebAssembly with 128-bit lanes and a system interface (WASI): by clang, lld and Debian's wasi-libc, libc++-dev-wasm32
# (headers only) and libclang-rt-dev-wasm32; what is built runs under node. Without -msimd128 lanes are single numbers:
# the same bits.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_C_FLAGS_INIT -msimd128)
set(CMAKE_CXX_FLAGS_INIT -msimd128)
set(CMAKE_EXE_LINKER_FLAGS_INIT -O0) # or clang has Binaryen's wasm-opt, where that is, go over it, which refuses SIMD128
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY) # programs in C++ would need a C++ library; contdyn does not
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-warnings ${CMAKE_CURRENT_LIST_DIR}/wasi.mjs)
