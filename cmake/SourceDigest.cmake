# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFOLDER=… -DOUTPUT=… -P SourceDigest.cmake: writes a header with the digest of a folder's
# sources, whatever folder it stands in and whatever order they are found in.
file(GLOB_RECURSE files RELATIVE "${FOLDER}" "${FOLDER}/*.cpp" "${FOLDER}/*.h" "${FOLDER}/*.in")
list(FILTER files EXCLUDE REGEX "^workbook/") # these make no result
list(SORT files)
set(all "")
foreach(file IN LISTS files)
    file(SHA256 "${FOLDER}/${file}" digest)
    string(APPEND all "${file} ${digest}\n")
endforeach()
string(SHA256 digest "${all}")
string(SUBSTRING "${digest}" 0 16 digest)
set(text "#pragma once\n#define SPARKOUT_SOURCE_DIGEST \"${digest}\"\n")
if(EXISTS "${OUTPUT}")
    file(READ "${OUTPUT}" before)
endif()
if(NOT "${before}" STREQUAL "${text}") # an unchanged digest compiles nothing again
    file(WRITE "${OUTPUT}" "${text}")
endif()
