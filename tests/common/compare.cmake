# Fails unless `program` prints what is in the file `kept`.
execute_process(COMMAND ${program} OUTPUT_VARIABLE printed RESULT_VARIABLE result)
file(READ ${kept} expected)
if(NOT result EQUAL 0 OR NOT printed STREQUAL expected)
  message(FATAL_ERROR "${program} ends with ${result} and prints other than ${kept}:\n${printed}")
endif()
