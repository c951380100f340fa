# SPDX-License-Identifier: BSD-3-Clause
# Debian packages of the build, by `cpack` in its folder (scripts/package): `octet` (the program, the library for
# C, the Python package and the plug-in for FreeCAD, where Debian's Python and FreeCAD find them) and
# `liboctet-dev` (the library for find_package, and what linking that for C takes).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "The Octet developers")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL program links library)

set(CPACK_DEBIAN_OCTET_PACKAGE_NAME octet)
set(CPACK_DEBIAN_OCTET_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_OCTET_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_OCTET_PACKAGE_RECOMMENDS "python3-numpy, libhdf5-103-1")
set(CPACK_DEBIAN_OCTET_PACKAGE_SUGGESTS "freecad, python3-meshio")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME liboctet-dev)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "${PROJECT_DESCRIPTION} (library)")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
# As scripts/install-packages has them; octet, for it has octet-reader.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "octet (= ${PROJECT_VERSION}), libocct-data-exchange-dev, libocct-ocaf-dev, \
libocct-modeling-algorithms-dev, libfontconfig-dev, libeigen3-dev, libtbb-dev, libfmt-dev, zlib1g-dev")

# Only in packages: an installation elsewhere has nothing to say about /usr.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/links)
file(CREATE_LINK ../../../share/octet/python/octet ${PROJECT_BINARY_DIR}/links/octet SYMBOLIC)
file(CREATE_LINK ../../octet/freecad ${PROJECT_BINARY_DIR}/links/Octet SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/links/octet DESTINATION lib/python3/dist-packages
        COMPONENT links EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_BINARY_DIR}/links/Octet DESTINATION ${CMAKE_INSTALL_DATADIR}/freecad/Mod
        COMPONENT links EXCLUDE_FROM_ALL)

include(CPack)
cpack_add_component_group(octet)
cpack_add_component(program GROUP octet)
cpack_add_component(links GROUP octet)
cpack_add_component_group(library)
cpack_add_component(library GROUP library)
