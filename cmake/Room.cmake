# SPDX-License-Identifier: BSD-3-Clause
# What most files include, parsed once: that was the greater part of the time that a file took. Headers from outside of the
# project alone, and types made of what is in them; with -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON each file must name what it needs.
set(OCTET_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional> <set> <span>
                  <string> <string_view> <utility> <vector> <Eigen/Core> <Eigen/Geometry> <fmt/format.h>
                  <oneapi/tbb/parallel_for.h> ${CMAKE_CURRENT_LIST_DIR}/common_types.h)
set(OCTET_OCCT_HEADERS <BRepAdaptor_Curve.hxx> <BRepAdaptor_Surface.hxx> <BRep_Builder.hxx> <BRep_Tool.hxx> <BRepTools.hxx>
                       <Geom2d_Curve.hxx> <Geom_Curve.hxx> <Geom_Surface.hxx> <TopExp.hxx> <TopExp_Explorer.hxx>
                       <TopTools_IndexedDataMapOfShapeListOfShape.hxx> <TopTools_IndexedMapOfShape.hxx> <TopoDS.hxx>)
set(OCTET_OCCT_TEST_HEADERS <BRepAlgoAPI_Cut.hxx> <BRepBuilderAPI_MakeEdge.hxx> <BRepBuilderAPI_MakeFace.hxx>
                            <BRepBuilderAPI_MakeWire.hxx> <BRepPrimAPI_MakeBox.hxx> <BRepPrimAPI_MakeCylinder.hxx>
                            <BRepPrimAPI_MakeSphere.hxx>)

# Definitions that all rooms have, so that they can share what is parsed.
set(OCTET_DEFINITIONS $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>
                      $<TARGET_PROPERTY:TBB::tbb,INTERFACE_COMPILE_DEFINITIONS>)

# parse_once(t first HEADERS...): t has them parsed once; as `first` has them where that was given the same.
function(parse_once target first)
  get_property(parsed GLOBAL PROPERTY OCTET_PARSED_BY_${first})
  if(parsed STREQUAL "${ARGN}")
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY OCTET_PARSED_BY_${target} "${ARGN}")
  endif()
endfunction()

# compile_together(t): eight files of t are one for the compiler (OCTET_UNITY). So a helper's name is its own in the
# room, and not that of a function in a header.
function(compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${OCTET_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  # gcc warns of classes whose members are of types of one file, but in the file that is compiled.
  target_compile_options(${target} PRIVATE $<$<AND:$<BOOL:${OCTET_UNITY}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
endfunction()

# room(NAME n SOURCES ... HEADERS ... DEPENDS ... PARSED_ONCE ...): one library target octet_<n>, alias octet::<n>.
function(room)
  cmake_parse_arguments(ROOM "" "NAME" "SOURCES;HEADERS;DEPENDS;PARSED_ONCE" ${ARGN})
  add_library(octet_${ROOM_NAME} STATIC ${ROOM_SOURCES} ${ROOM_HEADERS})
  add_library(octet::${ROOM_NAME} ALIAS octet_${ROOM_NAME})
  target_include_directories(octet_${ROOM_NAME} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/octet>)
  target_compile_features(octet_${ROOM_NAME} PUBLIC cxx_std_20)
  # No contraction: the same sources give the same bits with every compiler.
  target_compile_options(octet_${ROOM_NAME} PRIVATE -Wall -Wextra -Wpedantic -ffp-contract=off)
  target_link_libraries(octet_${ROOM_NAME} PUBLIC ${ROOM_DEPENDS})
  target_compile_definitions(octet_${ROOM_NAME} PRIVATE ${OCTET_DEFINITIONS})
  parse_once(octet_${ROOM_NAME} octet_base ${OCTET_HEADERS} ${ROOM_PARSED_ONCE})
  compile_together(octet_${ROOM_NAME})
  set_property(GLOBAL APPEND PROPERTY OCTET_ROOMS octet_${ROOM_NAME})
  set_property(TARGET octet_${ROOM_NAME} PROPERTY OCTET_ROOM_HEADERS ${ROOM_HEADERS})
  set_property(TARGET octet_${ROOM_NAME} PROPERTY EXPORT_NAME ${ROOM_NAME})
endfunction()

# room_test(NAME n SOURCES ... DEPENDS ... PARSED_ONCE ...): one GoogleTest program tests_<n>; ctest sees each TEST.
function(room_test)
  cmake_parse_arguments(TEST "" "NAME" "SOURCES;DEPENDS;PARSED_ONCE" ${ARGN})
  add_executable(tests_${TEST_NAME} ${TEST_SOURCES})
  target_include_directories(tests_${TEST_NAME} PRIVATE ${PROJECT_SOURCE_DIR})
  # -O1: two thirds of the compiler's time; what takes the tests' own is mostly in the rooms.
  target_compile_options(tests_${TEST_NAME} PRIVATE -Wall -Wextra -ffp-contract=off $<$<CONFIG:Release>:-O1>)
  target_link_libraries(tests_${TEST_NAME} PRIVATE ${TEST_DEPENDS} GTest::gtest GTest::gtest_main)
  target_compile_definitions(tests_${TEST_NAME} PRIVATE ${OCTET_DEFINITIONS})
  parse_once(tests_${TEST_NAME} tests_base ${OCTET_HEADERS} <gtest/gtest.h> ${TEST_PARSED_ONCE})
  gtest_discover_tests(tests_${TEST_NAME} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${TEST_NAME})
endfunction()
