# cmake -DSOURCE=... -DFOLDER=... -DOUT=... -DCOMPILER=... -DC_COMPILER=... -DSTRIP=... -DGENERATOR=... -DFLAGS=...
# [-DLAUNCHER=...] -P sizes.cmake: builds the shared library with each part left out, and writes how large each file is,
# stripped.
#
#   -DBUDGETS=ON                 builds those that have a budget and parts left out, and fails where a file is larger than
#                                its budget, or by a page or more smaller
#   -DBUDGETS=ON -DBUILT=FILE    likewise the whole library, which is not built: it is this file
#   -DSELFTEST=ON -DBUILT=FILE   fails unless a byte too many for the budget is refused, and a page too few

cmake_minimum_required(VERSION 3.20)

# Name, parts left out, and the budget in bytes: what GCC 12 makes for x86-64. Who needs more gives a reason with the new
# number; who needs less takes it down.
set(variants
  "everything||1480912"
  "without chain|CHAIN"
  "without ropes|ROPE"
  "without membrane|MEMBRANE"
  "without cloth|CLOTH"
  "without water|WATER"
  "without hulls|HULL"
  "without bend and rings|BEND"
  "without colliders|CONTACT"
  "without the coupled solver|COUPLED"
  "without advected momentum|ADVECTED"
  "without drawing|DRAW"
  "without sleep|SLEEP"
  "without saved states|SAVE"
  "without float32|FLOAT32"
  "without float64|FLOAT64"
  "without AVX-512|AVX512"
  "without AVX2 and AVX-512|AVX2+AVX512|809168"
  "chain alone|MEMBRANE+WATER"
  "membrane alone|CHAIN+WATER"
  "water alone|CHAIN+MEMBRANE"
  "chain alone in float32 with plain kernels|MEMBRANE+WATER+FLOAT64+AVX2+AVX512"
  "chain alone in float32 with plain kernels and no ropes|MEMBRANE+WATER+FLOAT64+AVX2+AVX512+ROPE|239816"
  "chain alone likewise and no bend, sleep and saved states|MEMBRANE+WATER+FLOAT64+AVX2+AVX512+ROPE+BEND+SLEEP+SAVE|145592")

cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
set(page 4096)

# Sets `bytes` to how large the file is, stripped.
function(measure name library folder)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${STRIP} -o ${folder}/stripped.so ${library} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name}: cannot strip ${library}")
  endif()
  file(SIZE ${folder}/stripped.so bytes)
  set(bytes ${bytes} PARENT_SCOPE)
  message(STATUS "${name}: ${bytes} bytes")
endfunction()

function(hold name bytes budget)
  math(EXPR least "${budget} - ${page} + 1")
  if(bytes GREATER budget)
    message(SEND_ERROR "${name}: ${bytes} bytes are over its budget of ${budget}")
  elseif(bytes LESS least)
    message(SEND_ERROR "${name}: a page or more below its budget of ${budget}: take that down to ${bytes}")
  endif()
endfunction()

if(SELFTEST)
  if(DEFINED BUDGET) # run by the loop below
    hold("the file" ${BYTES} ${BUDGET})
    return()
  endif()
  measure("the file" ${BUILT} ${FOLDER})
  foreach(case IN ITEMS "0|" "-1|over its budget" "4095|" "4096|a page or more below its budget")
    string(REGEX MATCH "^([^|]*)\\|([^|]*)" found "${case}")
    math(EXPR budget "${bytes} + ${CMAKE_MATCH_1}")
    set(reason "${CMAKE_MATCH_2}")
    execute_process(COMMAND ${CMAKE_COMMAND} -DSELFTEST=ON -DBYTES=${bytes} -DBUDGET=${budget} -P ${CMAKE_CURRENT_LIST_FILE}
      RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_QUIET)
    if(reason STREQUAL "" AND NOT status EQUAL 0)
      message(SEND_ERROR "refused under a budget of ${budget}: ${said}")
    elseif(NOT reason STREQUAL "" AND (status EQUAL 0 OR NOT said MATCHES "${reason}"))
      message(SEND_ERROR "accepted under a budget of ${budget}, or refused for another reason: ${said}")
    endif()
  endforeach()
  return()
endif()

set(table "variant,bytes\n")
foreach(variant IN LISTS variants)
  string(REGEX MATCH "^([^|]*)\\|([^|]*)\\|?([0-9]*)$" found "${variant}")
  set(name ${CMAKE_MATCH_1})
  string(REPLACE "+" ";" parts "${CMAKE_MATCH_2}")
  set(budget ${CMAKE_MATCH_3})
  string(MAKE_C_IDENTIFIER "${name}" folder)
  set(folder ${FOLDER}/${folder})
  if(BUDGETS AND (NOT budget OR (BUILT AND parts) OR NOT (BUILT OR parts)))
    continue()
  endif()
  if(BUILT)
    set(library ${BUILT})
  else()
    set(options)
    foreach(part IN LISTS parts)
      list(APPEND options -DCONTDYN_${part}=OFF)
    endforeach()
    foreach(command IN ITEMS configure build)
      if(command STREQUAL "configure")
        set(line ${CMAKE_COMMAND} -S ${SOURCE} -B ${folder} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
          -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
          -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCONTDYN_TESTS=OFF -DCONTDYN_REPORT=OFF ${options})
      else()
        set(line ${CMAKE_COMMAND} --build ${folder} --target contdyn --parallel ${cores})
      endif()
      execute_process(COMMAND ${line} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
      if(NOT status EQUAL 0)
        message(FATAL_ERROR "${name}: ${said}")
      endif()
    endforeach()
    file(GLOB built ${folder}/src/libcontdyn.so.*.*.*)
    list(GET built 0 library)
  endif()
  measure("${name}" ${library} ${folder})
  string(APPEND table "${name},${bytes}\n")
  if(BUDGETS)
    hold("${name}" ${bytes} ${budget})
  endif()
endforeach()
if(NOT BUDGETS)
  file(WRITE ${OUT} "${table}")
endif()
