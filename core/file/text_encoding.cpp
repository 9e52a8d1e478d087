// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/text_encoding.h"

#include "core/printable.h"
#include "core/sha256.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

constexpr char32_t noCharacter = 0xFFFD;
constexpr unsigned firstHigh = 0x80; ///< first byte outside ASCII

/// 0x80…0xBF of Windows-1251; А…я follow.
constexpr std::u16string_view upper1251 = u"ЂЃ‚ѓ„…†‡€‰Љ‹ЊЌЋЏ"
                                          u"ђ‘’“”•–—\uFFFD™љ›њќћџ"
                                          u"\u00A0ЎўЈ¤Ґ¦§Ё©Є«¬\u00AD®Ї"
                                          u"°±Ііґµ¶·ё№є»јЅѕї";
/// 0x80…0x9F of Windows-1252; the rest is Latin-1.
constexpr std::u16string_view upper1252 = u"€\uFFFD‚ƒ„…†‡ˆ‰Š‹Œ\uFFFDŽ\uFFFD"
                                          u"\uFFFD‘’“”•–—˜™š›œ\uFFFDžŸ";
static_assert(upper1251.size() == 0x40 && upper1252.size() == 0x20);

struct ByteOrderMark {
    std::string_view bytes;
    TextEncoding encoding;
};

/// The longer first: that of UTF-32 begins with that of UTF-16.
constexpr std::array byteOrderMarks{
    ByteOrderMark{std::string_view("\xEF\xBB\xBF"), TextEncoding::utf8},
    ByteOrderMark{std::string_view("\xFF\xFE\0\0", 4), TextEncoding::utf32le},
    ByteOrderMark{std::string_view("\0\0\xFE\xFF", 4), TextEncoding::utf32be},
    ByteOrderMark{std::string_view("\xFF\xFE"), TextEncoding::utf16le},
    ByteOrderMark{std::string_view("\xFE\xFF"), TextEncoding::utf16be}};

unsigned byteAt(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

/// A number of several bytes, little or big endian.
char32_t unitAt(std::string_view bytes, std::size_t from, std::size_t size, bool isLittle) {
    char32_t unit = 0;
    for (std::size_t i = 0; i < size; ++i) {
        unit = unit << 8U | byteAt(bytes, from + (isLittle ? size - 1 - i : i));
    }
    return unit;
}

void append(std::string& text, char32_t code) {
    const auto byte = [&text](char32_t value) { text += static_cast<char>(value); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0U | code >> 6U);
        byte(0x80U | (code & 0x3FU));
    } else if (code < 0x10000) {
        byte(0xE0U | code >> 12U);
        byte(0x80U | (code >> 6U & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    } else {
        byte(0xF0U | code >> 18U);
        byte(0x80U | (code >> 12U & 0x3FU));
        byte(0x80U | (code >> 6U & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    }
}

/// The bytes from here on that are ASCII.
std::size_t asciiBytes(std::string_view bytes) {
    const auto end = std::find_if(bytes.begin(), bytes.end(), [](char c) {
        return static_cast<unsigned char>(c) >= firstHigh;
    });
    return static_cast<std::size_t>(end - bytes.begin());
}

std::string fromUtf8(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size());
    while (!bytes.empty()) {
        const std::size_t size = std::max(asciiBytes(bytes), characterBytes(bytes));
        if (size == 0) {
            append(text, noCharacter);
        }
        text += bytes.substr(0, size);
        bytes.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return text;
}

std::string fromUtf16(std::string_view bytes, bool isLittle) {
    std::string text;
    text.reserve(bytes.size());
    std::size_t i = 0;
    while (i + 2 <= bytes.size()) {
        char32_t unit = unitAt(bytes, i, 2, isLittle);
        i += 2;
        const bool isHigh = unit >= 0xD800 && unit < 0xDC00;
        const char32_t low = isHigh && i + 2 <= bytes.size() ? unitAt(bytes, i, 2, isLittle) : 0;
        if (low >= 0xDC00 && low < 0xE000) {
            unit = 0x10000 + ((unit - 0xD800) << 10U) + (low - 0xDC00);
            i += 2;
        } else if (unit >= 0xD800 && unit < 0xE000) {
            unit = noCharacter;
        }
        append(text, unit);
    }
    if (i < bytes.size()) {
        append(text, noCharacter);
    }
    return text;
}

std::string fromUtf32(std::string_view bytes, bool isLittle) {
    std::string text;
    std::size_t i = 0;
    for (; i + 4 <= bytes.size(); i += 4) {
        const char32_t code = unitAt(bytes, i, 4, isLittle);
        const bool isOne = code < 0x110000 && (code < 0xD800 || code >= 0xE000);
        append(text, isOne ? code : noCharacter);
    }
    if (i < bytes.size()) {
        append(text, noCharacter);
    }
    return text;
}

std::string fromWindows(std::string_view bytes, bool isCyrillic) {
    constexpr unsigned firstLetter1251 = firstHigh + upper1251.size();
    constexpr unsigned firstOfLatin1 = firstHigh + upper1252.size();
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const unsigned byte = byteAt(bytes, i);
        if (byte < firstHigh) {
            append(text, byte);
        } else if (isCyrillic) {
            append(text, byte < firstLetter1251 ? upper1251[byte - firstHigh]
                                                : U'А' + (byte - firstLetter1251));
        } else {
            append(text, byte < firstOfLatin1 ? upper1252[byte - firstHigh] : byte);
        }
    }
    return text;
}

/// A character used in tables of measurements and of names.
bool isOfTables(char32_t c) {
    struct Block {
        char32_t first, last;
    };
    constexpr std::array blocks{Block{0x20, 0x7E},     Block{0xA0, 0x24F},    // Latin
                                Block{0x370, 0x52F},                          // Greek, Cyrillic
                                Block{0x2010, 0x2044}, Block{0x2070, 0x20BF}, // signs
                                Block{0x2100, 0x2300}};                       // №, −, ⌀
    return c == '\t' || c == '\n' || c == '\r'
           || std::any_of(blocks.begin(), blocks.end(),
                          [c](const Block& b) { return c >= b.first && c <= b.last; });
}

/// UTF-16 without a mark, if nearly all of the text's beginning then consists of such characters.
std::optional<TextEncoding> utf16ByEvidence(std::string_view bytes) {
    constexpr std::size_t looked = 1U << 16U; // bytes
    const std::size_t units = std::min(bytes.size(), looked) / 2;
    for (const bool isLittle : {true, false}) {
        std::size_t ofTables = 0;
        for (std::size_t i = 0; i < units; ++i) {
            ofTables += isOfTables(unitAt(bytes, 2 * i, 2, isLittle)) ? 1 : 0;
        }
        if (units > 0 && 10 * ofTables >= 9 * units) {
            return isLittle ? TextEncoding::utf16le : TextEncoding::utf16be;
        }
    }
    return std::nullopt;
}

bool hasControls(std::string_view bytes) {
    constexpr std::string_view ofTexts = "\t\n\v\f\r\x1A"; // 0x1a ends files of DOS
    return std::any_of(bytes.begin(), bytes.end(), [&](char c) {
        return static_cast<unsigned char>(c) < 0x20 && ofTexts.find(c) == ofTexts.npos;
    });
}

/// Whether it is UTF-8 except for a few bytes.
bool isDamagedUtf8(std::string_view bytes) {
    constexpr std::size_t few = 3; // ratio of valid characters
    std::size_t valid = 0, others = 0;
    while (!bytes.empty()) {
        bytes.remove_prefix(asciiBytes(bytes));
        if (!bytes.empty()) {
            const std::size_t size = characterBytes(bytes);
            (size > 0 ? valid : others) += 1;
            bytes.remove_prefix(std::max<std::size_t>(size, 1));
        }
    }
    return valid > few * others;
}

/// Whether most high letters are in words with Latin ones, as in "Prüfer".
bool isWestern(std::string_view bytes) {
    std::size_t beside = 0, apart = 0, highOfWord = 0, latinOfWord = 0;
    const auto endWord = [&] {
        (latinOfWord > 0 ? beside : apart) += highOfWord;
        highOfWord = latinOfWord = 0;
    };
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const unsigned byte = byteAt(bytes, i);
        constexpr unsigned yoCapital = 0xA8, yo = 0xB8, firstLetter = 0xC0;
        if (byte >= firstLetter || byte == yoCapital || byte == yo) {
            ++highOfWord;
        } else if ((byte | 0x20U) >= 'a' && (byte | 0x20U) <= 'z') {
            ++latinOfWord;
        } else {
            endWord();
        }
    }
    endWord();
    return beside > apart;
}

} // namespace

bool isUtf8(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t size = std::max(asciiBytes(bytes), characterBytes(bytes));
        if (size == 0) {
            return false;
        }
        bytes.remove_prefix(size);
    }
    return true;
}

TextEncoding encodingOf(std::string_view bytes) {
    for (const ByteOrderMark& mark : byteOrderMarks) {
        if (bytes.starts_with(mark.bytes)) {
            return mark.encoding;
        }
    }
    const bool isValid = isUtf8(bytes);
    if (isValid && !hasControls(bytes)) {
        return TextEncoding::utf8;
    }
    if (const auto utf16 = utf16ByEvidence(bytes)) {
        return *utf16;
    }
    return isValid || isDamagedUtf8(bytes) ? TextEncoding::utf8
           : isWestern(bytes)              ? TextEncoding::windows1252
                                           : TextEncoding::windows1251;
}

std::string decodedText(std::string_view bytes, TextEncoding encoding) {
    for (const ByteOrderMark& mark : byteOrderMarks) {
        if (mark.encoding == encoding && bytes.starts_with(mark.bytes)) {
            bytes.remove_prefix(mark.bytes.size());
            break;
        }
    }
    switch (encoding) {
    case TextEncoding::utf16le: return fromUtf16(bytes, true);
    case TextEncoding::utf16be: return fromUtf16(bytes, false);
    case TextEncoding::utf32le: return fromUtf32(bytes, true);
    case TextEncoding::utf32be: return fromUtf32(bytes, false);
    case TextEncoding::windows1251: return fromWindows(bytes, true);
    case TextEncoding::windows1252: return fromWindows(bytes, false);
    case TextEncoding::utf8: break;
    }
    return fromUtf8(bytes);
}

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
