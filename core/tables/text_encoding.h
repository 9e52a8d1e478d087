// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sparkout {

/// The encoding of a text file.
enum class TextEncoding { utf8, utf16le, utf16be, utf32le, utf32be, windows1251, windows1252 };

/// The encoding of a text: by its byte order mark, else by evidence. A text that is valid UTF-8
/// without control characters is UTF-8; one whose pairs of bytes are letters, digits and signs of
/// European tables is UTF-16; otherwise, high letters next to Latin ones mean Windows-1252, all
/// others Windows-1251.
[[nodiscard]] TextEncoding encodingOf(std::string_view bytes);

/// The text in valid UTF-8, without a byte order mark. Invalid bytes become U+FFFD.
[[nodiscard]] std::string decodedText(std::string_view bytes, TextEncoding encoding);

/// Whether all of it is valid UTF-8.
[[nodiscard]] bool isUtf8(std::string_view bytes);

} // namespace sparkout
