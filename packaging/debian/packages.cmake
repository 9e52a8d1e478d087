# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages, by CPack: sparkout (component program), libsparkout-dev (library) and
# python3-sparkout (python, where the module is built). packaging/release makes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sparkout)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR Sparkout)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program library)
if(TARGET sparkout_python)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish.cmake)
set(CPACK_SPARKOUT_SOURCE ${PROJECT_SOURCE_DIR})

set(SPARKOUT_MAINTAINER
    "Sparkout maintainers <maintainers@users.noreply.h-seed-4eb8bf60.example>" CACHE STRING
    "Who answers for the packages: name and address")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${SPARKOUT_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${SPARKOUT_HOMEPAGE})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip) # quick: packaging/release packs them anew, in a fixed order
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sparkout)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Loaded at run time, so that no tool finds them: Qt's SVG plug-in and Russian, the fonts of window and
# cards.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
    "libqt6svg6, qt6-svg-plugins | libqt6svg6 (<< 6.6)" # apart since Debian 13
    "qt6-translations-l10n, fonts-dejavu-core, fonts-dejavu-extra, hicolor-icon-theme")
string(REPLACE ";" ", " CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "qt6-wayland, shared-mime-info")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "workbench for cylindrical grinding cycles
Sparkout computes cylindrical grinding cycles on CNC machines pass by pass
and compares the ground part with its drawing. The machine, the shaft and
the centres yield, so the wheel removes less than it is fed; the blank is out
of round; the gauge watches one section only.
.
Traverse and plunge grinding, external and internal, of one or several
surfaces; batches with scatter and capability, sweeps, the quickest cycle of a
grid with its proof, measured parts beside the prediction, operation cards and
reports. In English and Russian, with a window and on the command line.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libsparkout-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libnlopt-dev")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "engine of a workbench for grinding cycles (library)
Sparkout computes cylindrical grinding cycles on CNC machines pass by pass
and compares the ground part with its drawing.
.
Static libraries, headers and the CMake package of its engine in C++20, which
needs no Qt: reading projects, simulating cycles and batches, searching for
the quickest cycle.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-sparkout)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(TARGET sparkout_python)
    get_target_property(MINOR sparkout_python PYTHON_MINOR)
    math(EXPR NEXT "${MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3 (>= 3.${MINOR}~), python3 (<< 3.${NEXT}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "engine of a workbench for grinding cycles (Python 3 module)
Sparkout computes cylindrical grinding cycles on CNC machines pass by pass
and compares the ground part with its drawing.
.
The module gives its engine to Python, with type hints: projects, cycles,
batches, sweeps and searches, profiles as NumPy arrays.")
include(CPack)
