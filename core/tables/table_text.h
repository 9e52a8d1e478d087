// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/text_encoding.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace sparkout {

/// The text of a table, whatever encoding its file is in: all readers of tables take one.
class TableText {
public:
    TableText() = default;
    // A text is one, too: what is pasted, and the texts of tests.
    TableText(std::string bytes); // NOLINT(google-explicit-constructor)
    TableText(std::string_view bytes) : TableText(std::string(bytes)) {} // NOLINT
    TableText(const char* bytes) : TableText(std::string(bytes)) {}      // NOLINT

    /// Valid UTF-8 without a byte order mark.
    [[nodiscard]] std::string_view utf8() const { return std::string_view(m_text).substr(m_begin); }
    [[nodiscard]] TextEncoding encoding() const { return m_encoding; }
    [[nodiscard]] std::size_t bytes() const { return m_bytes; } ///< of the file
    /// Of the bytes of the file.
    [[nodiscard]] std::string sha256() const;
    [[nodiscard]] bool isBlank() const;

private:
    std::string m_text;
    std::size_t m_begin = 0;
    std::size_t m_bytes = 0;
    TextEncoding m_encoding = TextEncoding::utf8;
    std::string m_digest; ///< of the bytes, where the text has others
};

} // namespace sparkout
