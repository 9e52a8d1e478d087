# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, the C++ source of examples(), from the project files in FOLDER.
file(GLOB FILES ${FOLDER}/*.sparkout ${FOLDER}/setups/*.sparkout)
list(SORT FILES)
set(SOURCE "// Generated from resources/examples.\n#include \"app/examples.h\"\n\nnamespace sparkout {\n\n")
string(APPEND SOURCE "const std::vector<Example>& examples() {\n    static const std::vector<Example> all{\n")
foreach(FILE ${FILES})
    get_filename_component(NAME ${FILE} NAME)
    file(READ ${FILE} CONTENT)
    string(APPEND SOURCE "        {\"${NAME}\", R\"project(${CONTENT})project\"},\n")
endforeach()
string(APPEND SOURCE "    };\n    return all;\n}\n\n} // namespace sparkout\n")
file(WRITE ${OUTPUT} "${SOURCE}")
