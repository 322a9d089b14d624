# Fails unless `program` prints what is in the file `kept`.
execute_process(COMMAND ${emulator} ${program} OUTPUT_VARIABLE printed RESULT_VARIABLE result)
string(REPLACE "\r\n" "\n" printed "${printed}") # how Windows ends lines
file(READ ${kept} expected)
if(NOT result EQUAL 0 OR NOT printed STREQUAL expected)
  message(FATAL_ERROR "${program} ends with ${result} and prints other than ${kept}:\n${printed}")
endif()
