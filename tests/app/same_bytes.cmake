# SPDX-License-Identifier: BSD-3-Clause
# Builds the program with another compiler and compares the bytes of the meshes that both programs write: of second
# order, whose corners are the mesh of first order. Each file is compiled by itself (no OCTET_UNITY), which tells
# whether it includes what it needs.
#   cmake -D SOURCE=<root> -D BUILD=<folder> -D COMPILER=<c++> -D PROGRAM=<octet> -P same_bytes.cmake
if(NOT COMPILER)
  message(FATAL_ERROR "clang++ was not found when the build was configured: install clang (scripts/install-packages "
                      "test does) and configure again; without it nothing says that both compilers agree")
endif()
include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja -D CMAKE_BUILD_TYPE=Release
     -D CMAKE_CXX_COMPILER=${COMPILER} -D OCTET_TESTS=OFF -D OCTET_UNITY=OFF)
step(${CMAKE_COMMAND} --build ${BUILD} --target octet)

file(GLOB parts ${SOURCE}/models/*.step)
if(NOT parts)
  message(FATAL_ERROR "no part in ${SOURCE}/models")
endif()
foreach(part IN LISTS parts)
  get_filename_component(name ${part} NAME_WE)
  set(ours ${BUILD}/${name}-ours.msh)
  set(theirs ${BUILD}/${name}-theirs.msh)
  file(REMOVE ${ours} ${theirs})
  execute_process(COMMAND ${PROGRAM} mesh ${part} -o ${ours} --order 2 --quiet RESULT_VARIABLE code_ours ERROR_VARIABLE text)
  execute_process(COMMAND ${BUILD}/app/octet mesh ${part} -o ${theirs} --order 2 --quiet RESULT_VARIABLE code_theirs
                  ERROR_VARIABLE text)
  if(NOT code_ours EQUAL code_theirs)
    message(FATAL_ERROR "${name}: exit codes ${code_ours} and ${code_theirs}: ${text}")
  endif()
  if(NOT EXISTS ${ours})  # parts that are refused (models/ holds some) are refused by both
    message(STATUS "${name}: both refuse it: ${text}")
    continue()
  endif()
  file(SHA256 ${ours} hash_ours)
  file(SHA256 ${theirs} hash_theirs)
  if(NOT hash_ours STREQUAL hash_theirs)
    message(FATAL_ERROR "${name}: the two compilers' programs write different bytes: ${ours} ${theirs}")
  endif()
  message(STATUS "${name}: same bytes (${hash_ours})")
endforeach()
