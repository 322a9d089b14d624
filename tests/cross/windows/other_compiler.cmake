# What a game built by Microsoft's compiler needs of a DLL built by MinGW-w64: its headers compile, and a program links
# against the import library and runs. The compiler here is Clang with Microsoft's ABI and linker syntax, without their
# C library. Given: CLANG, LLD_LINK, KERNEL32, INCLUDE, IMPORT_LIBRARY, FOLDER (of the DLL), emulator, REFERENCE (the
# same program by MinGW-w64).

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "${line} ends with ${result}:\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

set(clang ${CLANG} --target=x86_64-pc-windows-msvc -ffreestanding -Wall -Wextra -Wundef -pedantic -Werror -I${INCLUDE})
file(GLOB headers ${INCLUDE}/contdyn/*.h)
foreach(header IN LISTS headers)
  foreach(language IN ITEMS c99 c17 c++17 c++20)
    string(REGEX REPLACE "[0-9]+" "" kind ${language})
    file(WRITE ${FOLDER}/header.${kind} "#include \"${header}\"\ntypedef int not_empty;\n")
    run(${clang} -std=${language} -x ${kind} -fsyntax-only ${FOLDER}/header.${kind})
  endforeach()
endforeach()

run(${clang} -std=c99 -c ${CMAKE_CURRENT_LIST_DIR}/game.c -o ${FOLDER}/game.obj)
run(${LLD_LINK} /nologo /entry:start /subsystem:console /nodefaultlib /out:${FOLDER}/game.exe
  ${FOLDER}/game.obj ${IMPORT_LIBRARY} ${KERNEL32})
run(${emulator} ${REFERENCE})
set(expected "${said}")
run(${emulator} ${FOLDER}/game.exe)
if(NOT said MATCHES "^[0-9a-f]+$" OR NOT said STREQUAL expected)
  message(FATAL_ERROR "it writes '${said}', and built by MinGW-w64 '${expected}'")
endif()
