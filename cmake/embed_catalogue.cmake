# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, the C++ source of shippedCatalogueText(), from the catalogues in FOLDER.
set(SOURCE "// Generated from resources/catalogue.\n#include \"core/catalogue/shipped_catalogue.h\"\n\nnamespace sparkout {\n\n")
string(APPEND SOURCE "std::string_view shippedCatalogueText(std::string_view kind) {\n")
foreach(KIND machines materials wheels)
    file(READ ${FOLDER}/${KIND}.json CONTENT)
    string(APPEND SOURCE "    if (kind == \"${KIND}\") {\n        return R\"catalogue(${CONTENT})catalogue\";\n    }\n")
endforeach()
string(APPEND SOURCE "    return {};\n}\n\n} // namespace sparkout\n")
file(WRITE ${OUTPUT} "${SOURCE}")
