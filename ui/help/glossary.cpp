// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/glossary.h"

#include <QCollator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>

namespace sparkout {

namespace {

QStringList listOf(const QJsonValue& value) {
    QStringList texts;
    for (const QJsonValue text : value.toArray()) {
        texts << text.toString();
    }
    return texts;
}

} // namespace

std::vector<Term> glossary() {
    QFile file(QStringLiteral(":/help/glossary.json"));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
    std::vector<Term> terms;
    for (const QJsonValue value : document.object().value(QLatin1StringView("terms")).toArray()) {
        const QJsonObject term = value.toObject();
        const auto text = [&term](const char* key) {
            return term.value(QLatin1StringView(key)).toString();
        };
        terms.push_back({text("en"), text("ru"), text("meaning_en"), text("meaning_ru"),
                         listOf(term.value(QLatin1StringView("stems"))),
                         listOf(term.value(QLatin1StringView("banned")))});
    }
    return terms;
}

QString glossaryHtml() {
    const bool russian = QLocale().language() == QLocale::Russian;
    std::vector<Term> terms = glossary();
    const QCollator order{QLocale()};
    std::ranges::sort(terms, [&](const Term& a, const Term& b) {
        return order.compare(russian ? a.russian : a.english, russian ? b.russian : b.english) < 0;
    });
    QString html = QStringLiteral("<table>");
    for (const Term& term : terms) {
        html += QStringLiteral("<tr><td><b>%1</b></td><td><i>%2</i></td><td>%3</td></tr>")
                    .arg((russian ? term.russian : term.english).toHtmlEscaped(),
                         (russian ? term.english : term.russian).toHtmlEscaped(),
                         (russian ? term.russianMeaning : term.englishMeaning).toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

} // namespace sparkout
