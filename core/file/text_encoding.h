// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

/// The text of a table, in any file encoding: the input of all readers of tables.
class TableText {
public:
    TableText() = default;
    // Converts a text, such as a pasted one, and those of tests.
    TableText(std::string bytes); // NOLINT(google-explicit-constructor)
    TableText(std::string_view bytes) : TableText(std::string(bytes)) {} // NOLINT
    TableText(const char* bytes) : TableText(std::string(bytes)) {}      // NOLINT

    /// Valid UTF-8 without a byte order mark.
    [[nodiscard]] std::string_view utf8() const { return std::string_view(m_text).substr(m_begin); }
    [[nodiscard]] TextEncoding encoding() const { return m_encoding; }
    [[nodiscard]] std::size_t bytes() const { return m_bytes; } ///< of the file
    /// The hash of the file's bytes.
    [[nodiscard]] std::string sha256() const;
    [[nodiscard]] bool isBlank() const;

private:
    std::string m_text;
    std::size_t m_begin = 0;
    std::size_t m_bytes = 0;
    TextEncoding m_encoding = TextEncoding::utf8;
    std::string m_digest; ///< digest of the bytes, if they differ from the text
};

} // namespace sparkout
