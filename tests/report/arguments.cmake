# cmake -DPROGRAM=... -DFOLDER=... -P arguments.cmake: --csv writes no page; arguments that mean nothing are refused.

file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${PROGRAM} --only chain --csv --out ${FOLDER}
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(NOT status EQUAL 0 OR EXISTS ${FOLDER}/index.html OR NOT EXISTS ${FOLDER}/chain_growth.csv OR
    EXISTS ${FOLDER}/membrane_growth.csv)
  message(FATAL_ERROR "--csv: status ${status}, or a page was written, or a CSV file is missing or too many")
endif()

foreach(arguments IN ITEMS "--only;nothing" "--only;chain,nothing" "--only;membrane," "--only" "--out" "--fast" "chain")
  execute_process(COMMAND ${PROGRAM} ${arguments} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT status EQUAL 2 OR NOT said MATCHES "usage:")
    message(FATAL_ERROR "${arguments}: status ${status}, said ${said}")
  endif()
endforeach()
