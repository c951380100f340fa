# SPDX-License-Identifier: BSD-3-Clause
# The installed tree: bin/octet, lib/liboctet_*.a, include/octet/<room>/*.h, libexec/octet/octet-reader,
# share/octet/python, share/octet/freecad, a package for find_package(octet), and what capi/ installs.
include(CMakePackageConfigHelpers)

# octet::octet is the whole library under one name.
add_library(octet_whole INTERFACE)
add_library(octet::octet ALIAS octet_whole)
set_target_properties(octet_whole PROPERTIES EXPORT_NAME octet)
get_property(rooms GLOBAL PROPERTY OCTET_ROOMS)
target_link_libraries(octet_whole INTERFACE ${rooms})

# Whoever uses it has the program that reads where a process with threads cannot (ReadOptions::reader_program).
add_dependencies(octet_whole octet_reader)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/octet)
set(installed)
foreach(room IN LISTS rooms)
  get_target_property(room_dir ${room} SOURCE_DIR)
  get_target_property(headers ${room} OCTET_ROOM_HEADERS)
  foreach(header IN LISTS headers)
    file(RELATIVE_PATH shown ${PROJECT_SOURCE_DIR} ${room_dir}/${header})
    get_filename_component(folder ${shown} DIRECTORY)
    install(FILES ${room_dir}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/octet/${folder}
            COMPONENT library)
    list(APPEND installed ${shown})
  endforeach()
endforeach()
# For the ctest `installed_headers`.
list(JOIN installed "\n" installed)
file(WRITE ${PROJECT_BINARY_DIR}/installed_headers.txt "${installed}\n")
install(TARGETS ${rooms} octet_whole EXPORT octetTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        COMPONENT library)
install(TARGETS octet_reader RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/octet COMPONENT program)
install(EXPORT octetTargets NAMESPACE octet:: DESTINATION ${package_dir} COMPONENT library)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/octetConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/octetConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/octetConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/octetConfig.cmake ${PROJECT_BINARY_DIR}/octetConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT library)
if(NOT OCTET_PROGRAM)
  return()
endif()
install(TARGETS octet RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# The manual page says what --help does.
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/octet.1
  COMMAND ${CMAKE_COMMAND} -D OCTET=$<TARGET_FILE:octet> -D VERSION=${PROJECT_VERSION}
          -D PAGE=${PROJECT_BINARY_DIR}/octet.1 -P ${PROJECT_SOURCE_DIR}/cmake/ManPage.cmake
  DEPENDS octet ${PROJECT_SOURCE_DIR}/cmake/ManPage.cmake VERBATIM)
add_custom_target(octet_man_page ALL DEPENDS ${PROJECT_BINARY_DIR}/octet.1)
install(FILES ${PROJECT_BINARY_DIR}/octet.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/app/completion.bash RENAME octet
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# The Python package, for PYTHONPATH, and the plug-in for FreeCAD, to be linked into its folder Mod, which uses it.
# It looks for the program in ../../../bin from its folder.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/plugins/python ${PROJECT_SOURCE_DIR}/plugins/freecad
        DESTINATION ${CMAKE_INSTALL_DATADIR}/octet COMPONENT program PATTERN __pycache__ EXCLUDE)
