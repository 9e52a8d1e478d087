# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, the C++ source of shippedCatalogueText(), from the catalogues in FOLDER. An entry is a
# literal of its own: compilers need not take one of more than 65,536 characters.
set(SOURCE "// Generated from resources/catalogue.\n#include \"core/catalogue/catalogue.h\"\n\n")
string(APPEND SOURCE "#include <initializer_list>\n#include <string>\n\nnamespace sparkout {\n\n")
string(APPEND SOURCE "namespace {\n\nstd::string joined(std::initializer_list<const char*> parts) {\n")
string(APPEND SOURCE "    std::string all;\n    for (const char* part : parts) {\n        all += part;\n    }\n")
string(APPEND SOURCE "    return all;\n}\n\n} // namespace\n\n")
string(APPEND SOURCE "std::string_view shippedCatalogueText(std::string_view kind) {\n")
foreach(KIND machines materials wheels)
    file(READ ${FOLDER}/${KIND}.json CONTENT)
    string(REPLACE "\n    {" ")catalogue\",\nR\"catalogue(\n    {" CONTENT "${CONTENT}")
    string(APPEND SOURCE "    if (kind == \"${KIND}\") {\n        static const std::string text = joined({R\"catalogue(${CONTENT})catalogue\"});\n        return text;\n    }\n")
endforeach()
string(APPEND SOURCE "    return {};\n}\n\n} // namespace sparkout\n")
file(WRITE ${OUTPUT} "${SOURCE}")
