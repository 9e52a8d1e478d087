// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_text.h"

#include "core/sha256.h"

#include <utility>

namespace sparkout {

TableText::TableText(std::string bytes)
    : m_text(std::move(bytes)), m_bytes(m_text.size()), m_encoding(encodingOf(m_text)) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (m_encoding == TextEncoding::utf8 && isUtf8(m_text)) {
        m_begin = m_text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
        return;
    }
    m_digest = sparkout::sha256(m_text);
    m_text = decodedText(m_text, m_encoding);
}

std::string TableText::sha256() const {
    return m_digest.empty() ? sparkout::sha256(m_text) : m_digest;
}

bool TableText::isBlank() const {
    return utf8().find_first_not_of(" \t\r\n") == std::string_view::npos;
}

} // namespace sparkout
