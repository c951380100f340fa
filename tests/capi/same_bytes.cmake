# SPDX-License-Identifier: BSD-3-Clause
# That the mesh which the test `capi` wrote is the program's to the byte, and that liboctet shows functions of
# its C interface alone.
execute_process(COMMAND ${OCTET} mesh ${MODELS}/bracket.step -o ${WORK}/program.msh --size 6 --order 2 --quiet
                        --group ends=Face1-2
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "octet failed")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/program.msh ${WORK}/library.msh
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the library's mesh is not the program's")
endif()
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
string(REGEX REPLACE "\n$" "" symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
list(LENGTH symbols count)
list(FILTER symbols EXCLUDE REGEX " octet_[a-z_]+$")
if(NOT result EQUAL 0 OR count LESS 10 OR symbols)
  message(FATAL_ERROR "${count} symbols, and besides those of C: ${symbols}")
endif()
