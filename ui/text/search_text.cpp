// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/search_text.h"

#include <QStringList>

#include <algorithm>

namespace sparkout {

QString searchForm(const QString& text) {
    static const QString cyrillic = QStringLiteral("авекмнорстухё×,");
    static const QString latin = QStringLiteral("abekmhopctyxex.");
    QString form = text.toLower();
    for (QChar& letter : form) {
        if (const qsizetype at = cyrillic.indexOf(letter); at >= 0) {
            letter = latin[at];
        }
    }
    return form;
}

QString inLatinLetters(const QString& text) {
    static const QString cyrillic = QStringLiteral("абвгдеёжзийклмнопрстуфхцчшщъыьэюя");
    static const QStringList latin =
        QStringLiteral("a b v g d e e zh z i y k l m n o p r s t u f kh ts ch sh shch _ y _ e yu "
                       "ya")
            .split(u' ');
    QString result;
    for (const QChar letter : text) {
        const qsizetype at = cyrillic.indexOf(letter.toLower());
        QString sound = at < 0 ? QString(letter) : latin[at];
        if (at >= 0 && letter.isUpper()) {
            sound[0] = sound[0].toUpper();
        }
        result += sound.remove(u'_');
    }
    return result;
}

bool matchesQuery(const QString& searchFormOfText, const QString& query) {
    const QStringList words = searchForm(query).split(u' ', Qt::SkipEmptyParts);
    return std::all_of(words.begin(), words.end(), [&searchFormOfText](const QString& word) {
        return searchFormOfText.contains(word);
    });
}

} // namespace sparkout
