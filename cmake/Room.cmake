# SPDX-License-Identifier: BSD-3-Clause
# room(NAME n SOURCES ... HEADERS ... DEPENDS ...): one library target octet_<n>, alias octet::<n>.
function(room)
  cmake_parse_arguments(ROOM "" "NAME" "SOURCES;HEADERS;DEPENDS" ${ARGN})
  add_library(octet_${ROOM_NAME} STATIC ${ROOM_SOURCES} ${ROOM_HEADERS})
  add_library(octet::${ROOM_NAME} ALIAS octet_${ROOM_NAME})
  target_include_directories(octet_${ROOM_NAME} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/octet>)
  target_compile_features(octet_${ROOM_NAME} PUBLIC cxx_std_20)
  # No contraction: the same sources give the same bits with every compiler.
  target_compile_options(octet_${ROOM_NAME} PRIVATE -Wall -Wextra -Wpedantic -ffp-contract=off)
  target_link_libraries(octet_${ROOM_NAME} PUBLIC ${ROOM_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY OCTET_ROOMS octet_${ROOM_NAME})
  set_property(TARGET octet_${ROOM_NAME} PROPERTY OCTET_ROOM_HEADERS ${ROOM_HEADERS})
  set_property(TARGET octet_${ROOM_NAME} PROPERTY EXPORT_NAME ${ROOM_NAME})
endfunction()

# room_test(NAME n SOURCES ... DEPENDS ...): one GoogleTest program tests_<n>; ctest sees each TEST.
function(room_test)
  cmake_parse_arguments(TEST "" "NAME" "SOURCES;DEPENDS" ${ARGN})
  add_executable(tests_${TEST_NAME} ${TEST_SOURCES})
  target_include_directories(tests_${TEST_NAME} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(tests_${TEST_NAME} PRIVATE -Wall -Wextra -ffp-contract=off)
  target_link_libraries(tests_${TEST_NAME} PRIVATE ${TEST_DEPENDS} GTest::gtest GTest::gtest_main)
  gtest_discover_tests(tests_${TEST_NAME} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${TEST_NAME})
endfunction()
