# SPDX-License-Identifier: BSD-3-Clause
# Configures tests/app/host, which has Octet within it, without what only the program and the tests need.
#   cmake -D WORK=<folder> -D SOURCE=<host> -D OCTET=<source tree> -D COMPILER=<c++> -P host.cmake
file(REMOVE_RECURSE ${WORK})
include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)
step(${CMAKE_COMMAND} -E env --unset=CMAKE_BUILD_TYPE
     ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G Ninja -D OCTET=${OCTET} -D CMAKE_CXX_COMPILER=${COMPILER}
     -D CMAKE_INSTALL_INCLUDEDIR=headers -D CMAKE_DISABLE_FIND_PACKAGE_CLI11=ON
     -D CMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON)
file(STRINGS ${WORK}/definitions.txt lines REGEX "OCTET_INSTALLED_READER=\"${WORK}/octet/app/octet-reader\"")
if(NOT lines)
  message(FATAL_ERROR "the host is not told where octet-reader is built")
endif()
file(GLOB_RECURSE exported ${WORK}/octet/CMakeFiles/Export/*octetTargets.cmake)
file(STRINGS "${exported}" lines REGEX "INTERFACE_INCLUDE_DIRECTORIES .*_IMPORT_PREFIX}/headers/octet")
if(NOT lines)
  message(FATAL_ERROR "${exported}: headers are not looked for where CMAKE_INSTALL_INCLUDEDIR puts them")
endif()
file(STRINGS "${exported}" lines REGEX "OCTET_INSTALLED_READER=.*_IMPORT_PREFIX}/libexec/octet/octet-reader")
if(NOT lines)
  message(FATAL_ERROR "${exported}: users are not told where octet-reader is")
endif()
