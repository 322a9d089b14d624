# probe_toolchain(FILE RESULT): whether what a toolchain file names compiles a program, and runs it.
function(probe_toolchain file result)
  set(probe ${CMAKE_BINARY_DIR}/CMakeFiles/probe_toolchain)
  file(WRITE ${probe}.c
    "#include <math.h>\n#ifdef __cplusplus\n#include <utility>\n#endif\nint main(void) { return 0; }\n")
  include(${file}) # what it sets stays inside this function
  set(target)
  if(CMAKE_C_COMPILER_TARGET)
    set(target --target=${CMAKE_C_COMPILER_TARGET})
  endif()
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS_INIT}")
  separate_arguments(link_flags UNIX_COMMAND "${CMAKE_C_FLAGS_INIT} ${CMAKE_EXE_LINKER_FLAGS_INIT}")
  set(run_probe ${CMAKE_CROSSCOMPILING_EMULATOR} ${probe}.exe)
  if(CMAKE_SYSTEM_NAME STREQUAL "Windows") # Wine sets up a system first
    set(run_probe wine --version)
  endif()
  set(${result} ON PARENT_SCOPE)
  foreach(command IN ITEMS "${CMAKE_CXX_COMPILER};${target};${flags};-c;-x;c++;${probe}.c;-o;${probe}.o"
      "${CMAKE_C_COMPILER};${target};${link_flags};${probe}.c;-lm;-o;${probe}.exe" "${run_probe}")
    execute_process(COMMAND ${command} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(failed)
      set(${result} OFF PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()
