# SPDX-License-Identifier: GPL-3.0-or-later
# sparkout_moc(target header…): Qt's meta-object code of the headers that have any, compiled as one
# source. AUTOMOC takes ten times as long, for moc then reads every header that a header includes.
function(sparkout_moc TARGET)
    set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_moc)
    set(TEXT "")
    foreach(HEADER ${ARGN})
        file(RELATIVE_PATH NAME ${CMAKE_CURRENT_SOURCE_DIR} ${HEADER})
        string(MAKE_C_IDENTIFIER ${NAME} IDENTIFIER)
        set(MOC ${FOLDER}/${IDENTIFIER}.cpp)
        add_custom_command(OUTPUT ${MOC} COMMAND Qt6::moc --no-notes ${HEADER} -o ${MOC}
            DEPENDS ${HEADER} COMMENT "Meta-object code of ${NAME}" VERBATIM)
        list(APPEND MOCS ${MOC})
        string(APPEND TEXT "#include \"${MOC}\"\n")
    endforeach()
    file(MAKE_DIRECTORY ${FOLDER})
    set(ALL ${FOLDER}/${TARGET}_moc.cpp)
    file(CONFIGURE OUTPUT ${ALL} CONTENT "${TEXT}" @ONLY)
    set_source_files_properties(${ALL} PROPERTIES OBJECT_DEPENDS "${MOCS}" SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${TARGET} PRIVATE ${ALL})
endfunction()
