// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include "core/printable.h"

namespace sparkout::cli {

namespace {

void put(std::FILE* stream, std::string_view bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), stream);
}

} // namespace

void printText(std::FILE* stream, std::string_view text) {
    put(stream, printableLines(text));
}

void printOverLine(std::FILE* terminal, std::string_view text) {
    put(terminal, "\r\x1b[K" + printable(text));
}

} // namespace sparkout::cli
