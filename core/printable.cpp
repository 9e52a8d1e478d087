// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/printable.h"

#include <cstdio>

namespace sparkout {

namespace {

std::string escape(const char* format, unsigned value) {
    char text[8];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string shown(std::string_view text, bool keepsLines) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = characterBytes(text);
        if (length == 0) {
            out += escape("\\x%02X", static_cast<unsigned char>(text.front()));
            text.remove_prefix(1);
            continue;
        }
        const std::string_view character = text.substr(0, length);
        const unsigned code = characterCode(character);
        if (steersTheDisplay(code) && !(keepsLines && code == '\n')) {
            out += escape("\\u%04X", code);
        } else {
            out += character;
        }
        text.remove_prefix(length);
    }
    return out;
}

} // namespace

std::string printable(std::string_view text) {
    return shown(text, false);
}

std::string printableLines(std::string_view text) {
    return shown(text, true);
}

std::size_t characterBytes(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t bytes = first < 0x80                     ? 1
                              : first >= 0xC2 && first < 0xE0  ? 2
                              : first >= 0xE0 && first < 0xF0  ? 3
                              : first >= 0xF0 && first <= 0xF4 ? 4
                                                               : 0;
    if (bytes > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    // Longer than need be, half of a pair of UTF-16, and beyond the last character.
    const bool wrong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F)
                       || (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F);
    return wrong ? 0 : bytes;
}

unsigned characterCode(std::string_view character) {
    unsigned code = static_cast<unsigned char>(character.front());
    if (character.size() > 1) {
        code &= 0x7FU >> character.size();
    }
    for (const char byte : character.substr(1)) {
        code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
    }
    return code;
}

bool steersTheDisplay(unsigned code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E
           || code == 0x200F || (code >= 0x2028 && code <= 0x202E)
           || (code >= 0x2066 && code <= 0x2069);
}

} // namespace sparkout
