// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_words.h"

#include <libstemmer.h>

#include <QByteArray>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace sparkout {

namespace {

QRegularExpressionMatchIterator wordsOf(const QString& text) {
    static const QRegularExpression word(QStringLiteral("\\w+"),
                                         QRegularExpression::UseUnicodePropertiesOption);
    return word.globalMatch(text);
}

QString folded(const QString& word) {
    return word.toCaseFolded().replace(u'ё', u'е');
}

} // namespace

HelpWords::HelpWords(const QString& wanted)
    : m_stemmer(
        sb_stemmer_new(QLocale().language() == QLocale::Russian ? "russian" : "english", nullptr),
        sb_stemmer_delete) {
    for (auto it = wordsOf(wanted); it.hasNext();) {
        const QString word = folded(it.next().captured());
        m_wanted.push_back({word, stemOf(word)});
    }
}

QString HelpWords::stemOf(const QString& folded) const {
    const QByteArray utf8 = folded.toUtf8();
    const auto* const stem =
        m_stemmer
            ? sb_stemmer_stem(m_stemmer.get(), reinterpret_cast<const sb_symbol*>(utf8.constData()),
                              static_cast<int>(utf8.size()))
            : nullptr;
    return stem ? QString::fromUtf8(reinterpret_cast<const char*>(stem),
                                    sb_stemmer_length(m_stemmer.get()))
                : folded; // out of memory
}

bool HelpWords::Wanted::is(const QString& found, const HelpWords& words) const {
    constexpr int least = 3; // least letters of a distinctive stem: that of «ось» is «о»
    return found.startsWith(word)
           || (stem.size() >= least && found.front() == stem.front()
               && words.stemOf(found) == stem);
}

bool HelpWords::areIn(const QString& text) const {
    std::vector<bool> in(m_wanted.size());
    for (auto it = wordsOf(text); it.hasNext();) {
        const QString found = folded(it.next().captured());
        for (std::size_t i = 0; i < m_wanted.size(); ++i) {
            in[i] = in[i] || m_wanted[i].is(found, *this);
        }
    }
    return std::ranges::all_of(in, [](bool each) { return each; });
}

std::vector<HelpWords::Place> HelpWords::placesIn(const QString& text) const {
    std::vector<Place> places;
    for (auto it = wordsOf(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        const QString found = folded(match.captured());
        if (std::ranges::any_of(m_wanted, [&](const Wanted& w) { return w.is(found, *this); })) {
            places.push_back({match.capturedStart(), match.capturedLength()});
        }
    }
    return places;
}

} // namespace sparkout
