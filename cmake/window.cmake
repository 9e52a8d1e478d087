# SPDX-License-Identifier: GPL-3.0-or-later
# What the window needs on top of the engine.
# Qt asks for them on behalf of programs that use its private parts: not found, nothing is missing.
set(XKB_FIND_QUIETLY TRUE)
set(WrapVulkanHeaders_FIND_QUIETLY TRUE)
find_package(Qt6 REQUIRED COMPONENTS Core Gui Widgets PrintSupport Charts LinguistTools)
# The moc of all targets, in a twentieth of its time.
get_target_property(SPARKOUT_MOC Qt6::moc LOCATION)
if(CMAKE_HOST_UNIX)
    set(MOC ${SPARKOUT_MOC})
    set(SOURCE_FOLDER ${PROJECT_SOURCE_DIR})
    set(BINARY_FOLDER ${PROJECT_BINARY_DIR})
    set(MACROS)
    if(WIN32)
        set(MACROS -DQ_OS_WIN)
    endif()
    foreach(NAME MOC SOURCE_FOLDER BINARY_FOLDER) # words of the shell, whatever a folder's name
        string(REPLACE "'" "'\\''" ${NAME} "${${NAME}}")
        set(${NAME} "'${${NAME}}'")
    endforeach()
    set(SPARKOUT_MOC ${PROJECT_BINARY_DIR}/generated/moc_own_headers.sh)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/moc_own_headers.sh.in ${SPARKOUT_MOC} @ONLY
        USE_SOURCE_PERMISSIONS)
endif()
find_package(QCustomPlotQt6 REQUIRED)
find_package(qpdf REQUIRED)
find_library(STEMMER_LIBRARY stemmer REQUIRED)
find_path(STEMMER_INCLUDE_FOLDER libstemmer.h REQUIRED)
