# SPDX-License-Identifier: GPL-3.0-or-later
# What programs for Windows take along: the manifest, which makes letters of any language those of
# files and long paths usable, a version, and an icon where SPARKOUT_ICON names a file (.ico).
enable_language(RC)
# Qt is built without zstd, which that of this machine has.
set(CMAKE_AUTORCC_OPTIONS --no-zstd)
set(SPARKOUT_ICON "" CACHE FILEPATH "Icon of the window's program, an .ico file")

function(sparkout_windows_program TARGET DESCRIPTION)
    set(ICON_LINE "")
    if(SPARKOUT_ICON)
        set(ICON_LINE "1 ICON \"${SPARKOUT_ICON}\"")
    endif()
    set(MANIFEST ${PROJECT_SOURCE_DIR}/packaging/windows/program.manifest)
    string(REPLACE "." "," COMMA_VERSION ${PROJECT_VERSION})
    configure_file(${PROJECT_SOURCE_DIR}/packaging/windows/program.rc.in
        ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.rc @ONLY)
    target_sources(${TARGET} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.rc)
    # The run-time libraries of the compiler are inside.
    target_link_options(${TARGET} PRIVATE -static)
endfunction()
