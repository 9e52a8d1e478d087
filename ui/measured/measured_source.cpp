// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/measured_source.h"

#include "core/sha256.h"

#include <QByteArrayView>
#include <QStringDecoder>

#include <array>
#include <utility>

namespace sparkout {

namespace {

/// The letters of Windows-1251 from 0x80 on, below the alphabet.
constexpr std::array<char16_t, 64> upper1251{
    u'Ђ', u'Ѓ', u'‚', u'ѓ', u'„', u'…', u'†', u'‡', u'€', u'‰', u'Љ', u'‹', u'Њ', u'Ќ', u'Ћ', u'Џ',
    u'ђ', u'‘', u'’', u'“', u'”', u'•', u'–', u'—', u'?', u'™', u'љ', u'›', u'њ', u'ќ', u'ћ', u'џ',
    u' ', u'Ў', u'ў', u'Ј', u'¤', u'Ґ', u'¦', u'§', u'Ё', u'©', u'Є', u'«', u'¬', u'-', u'®', u'Ї',
    u'°', u'±', u'І', u'і', u'ґ', u'µ', u'¶', u'·', u'ё', u'№', u'є', u'»', u'ј', u'Ѕ', u'ѕ', u'ї'};

QString from1251(const std::string& bytes) {
    constexpr unsigned firstUpper = 0x80, firstLetter = 0xC0;
    QString text(static_cast<qsizetype>(bytes.size()), Qt::Uninitialized);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        const char16_t letter = byte < firstUpper ? static_cast<char16_t>(byte)
                                : byte < firstLetter
                                    ? upper1251.at(byte - firstUpper)
                                    : static_cast<char16_t>(u'А' + byte - firstLetter);
        text[static_cast<qsizetype>(i)] = QChar(letter);
    }
    return text;
}

} // namespace

MeasuredSource measuredSource(const QString& name, std::string bytes) {
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    const auto encoding = QStringConverter::encodingForData(view);
    QStringDecoder utf8(QStringConverter::Utf8, QStringConverter::Flag::Stateless);
    QString text = utf8(view);
    const bool isOther = encoding && *encoding != QStringConverter::Utf8;
    if (!isOther && !utf8.hasError()) {
        return {name, std::move(bytes), {}};
    }
    if (isOther) {
        QStringDecoder decoder(*encoding);
        text = decoder(view);
    } else {
        text = from1251(bytes);
    }
    return {name, text.toStdString(), sha256(bytes)};
}

} // namespace sparkout
