# 64-bit Windows: by Clang with the headers and libraries of MinGW-w64's GCC.
include(${CMAKE_CURRENT_LIST_DIR}/x86_64-w64-mingw32.cmake)
set(gcc ${CMAKE_CXX_COMPILER})
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET x86_64-w64-mingw32)
set(CMAKE_CXX_COMPILER_TARGET x86_64-w64-mingw32)

# Debian keeps them where Clang does not look.
execute_process(COMMAND ${gcc} -print-libgcc-file-name OUTPUT_VARIABLE folder ERROR_QUIET
  OUTPUT_STRIP_TRAILING_WHITESPACE)
get_filename_component(folder "${folder}" DIRECTORY)
set(CMAKE_C_FLAGS_INIT -B${folder})
set(CMAKE_CXX_FLAGS_INIT
  "-B${folder} -isystem ${folder}/include/c++ -isystem ${folder}/include/c++/x86_64-w64-mingw32")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${folder}")
set(CMAKE_SHARED_LINKER_FLAGS_INIT -L${folder})
