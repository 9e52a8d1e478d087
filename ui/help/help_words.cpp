// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_words.h"

#include <libstemmer.h>

#include <QByteArray>
#include <QLocale>

#include <algorithm>
#include <memory>

namespace sparkout {

namespace {

using Stemmer = std::unique_ptr<sb_stemmer, decltype(&sb_stemmer_delete)>;

/// As much of the word as it has in common with its stem: a stem may end in other letters.
QString withoutEnding(const QString& word, sb_stemmer* stemmer) {
    const QByteArray utf8 = word.toUtf8();
    const auto* const stem =
        sb_stemmer_stem(stemmer, reinterpret_cast<const sb_symbol*>(utf8.constData()),
                        static_cast<int>(utf8.size()));
    if (!stem) {
        return word; // out of memory
    }
    const QString found =
        QString::fromUtf8(reinterpret_cast<const char*>(stem), sb_stemmer_length(stemmer));
    const auto parted = std::mismatch(word.begin(), word.end(), found.begin(), found.end());
    return word.left(parted.first - word.begin());
}

} // namespace

QString folded(QString text) {
    return text.toCaseFolded().replace(u'ё', u'е');
}

QStringList searchedWords(const QString& words) {
    const bool russian = QLocale().language() == QLocale::Russian;
    const Stemmer stemmer(sb_stemmer_new(russian ? "russian" : "english", nullptr),
                          sb_stemmer_delete);
    QStringList wanted = folded(words).split(u' ', Qt::SkipEmptyParts);
    for (QString& word : wanted) {
        word = withoutEnding(word, stemmer.get());
    }
    return wanted;
}

} // namespace sparkout
