# cmake -DSOURCE=... -DFOLDER=... -DOUT=... -DCOMPILER=... -DC_COMPILER=... -DSTRIP=... -DGENERATOR=... -DFLAGS=... -P
# sizes.cmake: builds the shared library with each part left out, and writes how large each file is, stripped.

cmake_minimum_required(VERSION 3.20)

set(variants
  "everything|"
  "without chain|CHAIN"
  "without ropes|ROPE"
  "without membrane|MEMBRANE"
  "without water|WATER"
  "without float32|FLOAT32"
  "without float64|FLOAT64"
  "without AVX-512|AVX512"
  "without AVX2 and AVX-512|AVX2+AVX512"
  "chain alone|MEMBRANE+WATER"
  "membrane alone|CHAIN+WATER"
  "water alone|CHAIN+MEMBRANE"
  "chain alone in float32 with plain kernels|MEMBRANE+WATER+FLOAT64+AVX2+AVX512"
  "chain alone in float32 with plain kernels and no ropes|MEMBRANE+WATER+FLOAT64+AVX2+AVX512+ROPE")

set(table "variant,bytes\n")
foreach(variant IN LISTS variants)
  string(REGEX REPLACE "\\|.*" "" name "${variant}")
  string(REGEX REPLACE ".*\\|" "" parts "${variant}")
  string(REPLACE "+" ";" parts "${parts}")
  string(MAKE_C_IDENTIFIER "${name}" folder)
  set(folder ${FOLDER}/${folder})
  set(options)
  foreach(part IN LISTS parts)
    list(APPEND options -DCONTDYN_${part}=OFF)
  endforeach()
  foreach(command IN ITEMS configure build)
    if(command STREQUAL "configure")
      set(line ${CMAKE_COMMAND} -S ${SOURCE} -B ${folder} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
        -DCONTDYN_TESTS=OFF -DCONTDYN_REPORT=OFF ${options})
    else()
      set(line ${CMAKE_COMMAND} --build ${folder} --target contdyn --parallel)
    endif()
    execute_process(COMMAND ${line} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT status EQUAL 0)
      message(FATAL_ERROR "${name}: ${said}")
    endif()
  endforeach()
  file(GLOB built ${folder}/src/libcontdyn.so.*.*.*)
  list(GET built 0 library)
  execute_process(COMMAND ${STRIP} -o ${folder}/stripped.so ${library} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name}: cannot strip ${library}")
  endif()
  file(SIZE ${folder}/stripped.so bytes)
  string(APPEND table "${name},${bytes}\n")
  message(STATUS "${name}: ${bytes} bytes")
endforeach()
file(WRITE ${OUT} "${table}")
