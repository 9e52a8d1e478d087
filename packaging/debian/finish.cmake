# SPDX-License-Identifier: GPL-3.0-or-later
# Run by CPack on what is staged, before it is packed: what Debian wants of every package (copyright,
# changelog, compressed manual pages, no sections that nobody needs), and one time for all files.
set(NAME_program sparkout)
set(NAME_library libsparkout-dev)
set(NAME_python python3-sparkout)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
    set(WHEN $ENV{SOURCE_DATE_EPOCH})
else()
    string(TIMESTAMP WHEN "%s" UTC)
endif()

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(COMPONENT IN LISTS CPACK_COMPONENTS_ALL)
    set(PACKAGE ${NAME_${COMPONENT}})
    set(ROOT ${CPACK_TEMPORARY_DIRECTORY}/${COMPONENT})
    set(DOC ${ROOT}/usr/share/doc/${PACKAGE})
    file(MAKE_DIRECTORY ${DOC})
    configure_file(${CPACK_SPARKOUT_SOURCE}/packaging/debian/copyright ${DOC}/copyright COPYONLY)
    execute_process(COMMAND date -R -u -d @${WHEN} OUTPUT_VARIABLE DATE COMMAND_ERROR_IS_FATAL ANY
        OUTPUT_STRIP_TRAILING_WHITESPACE)
    file(WRITE ${DOC}/changelog "${PACKAGE} (${CPACK_PACKAGE_VERSION}) stable; urgency=medium

  * Release ${CPACK_PACKAGE_VERSION}; NEWS.gz says what has changed.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${DATE}\n")
    configure_file(${CPACK_SPARKOUT_SOURCE}/CHANGELOG.md ${DOC}/NEWS COPYONLY)
    file(GLOB_RECURSE PAGES ${ROOT}/usr/share/man/*.1)
    run(gzip -9 -n -f ${DOC}/changelog ${DOC}/NEWS ${PAGES})
    file(GLOB_RECURSE ARCHIVES ${ROOT}/usr/lib/*.a)
    foreach(ARCHIVE IN LISTS ARCHIVES)
        run(strip --strip-debug --remove-section=.comment --remove-section=.note
            --enable-deterministic-archives ${ARCHIVE})
    endforeach()
    file(GLOB_RECURSE PROGRAMS ${ROOT}/usr/bin/* ${ROOT}/usr/lib/*.so)
    foreach(PROGRAM IN LISTS PROGRAMS)
        run(strip --remove-section=.comment --remove-section=.note ${PROGRAM})
    endforeach()
    run(chmod -R u=rwX,go=rX ${ROOT}/usr)
    file(GLOB_RECURSE MODULES ${ROOT}/usr/lib/*.so)
    if(MODULES)
        run(chmod 644 ${MODULES})
    endif()
    run(find ${ROOT} -exec touch --no-dereference --date=@${WHEN} {} +)
endforeach()
