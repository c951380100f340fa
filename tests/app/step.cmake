# SPDX-License-Identifier: BSD-3-Clause
# step(COMMAND ...) runs it, and ends the script with what it printed where it fails.
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${result}\n${output}")
  endif()
endfunction()
