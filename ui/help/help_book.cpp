// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_book.h"

#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QByteArray>
#include <QCollator>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QRegularExpression>
#include <libstemmer.h>

#include <algorithm>
#include <array>

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

namespace {

struct HelpEntry {
    const char* id; ///< also the name of the file
    const char* group;
};

constexpr const char* gettingStarted = QT_TRANSLATE_NOOP("Help", "Getting started");
constexpr const char* inputPages = QT_TRANSLATE_NOOP("Help", "Inputs");
constexpr const char* viewPages = QT_TRANSLATE_NOOP("Help", "Views and results");
constexpr const char* modelPages = QT_TRANSLATE_NOOP("Help", "The model");
constexpr const char* workPages = QT_TRANSLATE_NOOP("Help", "Working with the program");

constexpr std::array helpContents{
    HelpEntry{"start", gettingStarted},
    HelpEntry{"editing", gettingStarted},
    HelpEntry{"news", gettingStarted},
    HelpEntry{"inputs-part", inputPages},
    HelpEntry{"inputs-material", inputPages},
    HelpEntry{"inputs-wheel", inputPages},
    HelpEntry{"inputs-machine", inputPages},
    HelpEntry{"inputs-gauge", inputPages},
    HelpEntry{"inputs-cycle", inputPages},
    HelpEntry{"stages", inputPages},
    HelpEntry{"inputs-batch", inputPages},
    HelpEntry{"inputs-search", inputPages},
    HelpEntry{"inputs-file", inputPages},
    HelpEntry{"surfaces", inputPages},
    HelpEntry{"verdict", viewPages},
    HelpEntry{"overview", viewPages},
    HelpEntry{"feeds", viewPages},
    HelpEntry{"profiles", viewPages},
    HelpEntry{"constraints", viewPages},
    HelpEntry{"compliance", viewPages},
    HelpEntry{"layers", viewPages},
    HelpEntry{"batch", viewPages},
    HelpEntry{"sweep", viewPages},
    HelpEntry{"optimise", viewPages},
    HelpEntry{"compare", viewPages},
    HelpEntry{"measured", viewPages},
    HelpEntry{"calibration", viewPages}, // from measurements
    HelpEntry{"playback", viewPages},
    HelpEntry{"step", viewPages},
    HelpEntry{"messages", viewPages},
    HelpEntry{"plots", viewPages},
    HelpEntry{"model", modelPages},
    HelpEntry{"waves", modelPages},
    HelpEntry{"limits", modelPages},
    HelpEntry{"validation", modelPages}, // written by tests/validation/validation.py
    HelpEntry{"glossary", modelPages},
    HelpEntry{"sources", modelPages},
    HelpEntry{"lessons", workPages},
    HelpEntry{"shortcuts", workPages},
    HelpEntry{"files", workPages},
    HelpEntry{"reports", workPages},
    HelpEntry{"packs", workPages},
    HelpEntry{"look", workPages},
    HelpEntry{"cli", workPages},
};

constexpr std::array formPages{Page::part,    Page::material, Page::wheel,
                               Page::machine, Page::gauge,    Page::cycle,
                               Page::batch,   Page::search,   Page::none};

QString writtenPage(const QString& id) {
    const QString language =
        QLocale().language() == QLocale::Russian ? QStringLiteral("ru") : QStringLiteral("en");
    QFile file(QStringLiteral(":/help/%1/%2.html").arg(language, id));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString sourcesHtml() {
    QString html = QStringLiteral("<table>");
    for (const auto& [key, text] : sourceTexts()) {
        html += QStringLiteral("<tr><td><a name=\"%1\"></a><code>%1</code></td><td>%2</td></tr>")
                    .arg(key, text.toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

/// The generated part of a page.
QString madePart(const QString& id, const QString& shortcuts) {
    for (const Page page : formPages) {
        if (id == fieldPageId(page)) {
            return fieldsHtml(page);
        }
    }
    return id == u"shortcuts"  ? shortcuts
           : id == u"sources"  ? sourcesHtml()
           : id == u"glossary" ? glossaryHtml()
                               : QString();
}

QString plainOf(QString html) {
    static const QRegularExpression tags(QStringLiteral("<[^>]*>"));
    html.replace(tags, QStringLiteral(" ")).replace(QStringLiteral("&nbsp;"), QStringLiteral(" "));
    html.replace(QStringLiteral("&lt;"), QStringLiteral("<"))
        .replace(QStringLiteral("&gt;"), QStringLiteral(">"))
        .replace(QStringLiteral("&quot;"), QStringLiteral("\""))
        .replace(QStringLiteral("&amp;"), QStringLiteral("&"));
    return html.simplified();
}

const QRegularExpression& headingPattern() {
    static const QRegularExpression pattern(
        QStringLiteral("<h([1-3])(?: id=\"([^\"]*)\")?>(.*?)</h\\1>"),
        QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

std::vector<HelpSection> sectionsOf(const QString& html) {
    std::vector<HelpSection> sections;
    qsizetype end = 0; // end of the last heading
    const auto finish = [&](qsizetype next) {
        if (!sections.empty()) {
            sections.back().text = plainOf(html.mid(end, next - end));
        }
    };
    for (auto it = headingPattern().globalMatch(html); it.hasNext();) {
        const auto found = it.next();
        finish(found.capturedStart());
        end = found.capturedEnd();
        sections.push_back({found.captured(2), plainOf(found.captured(3)), {}});
    }
    finish(html.size());
    return sections;
}

HelpPage pageOf(const HelpEntry& entry, const QString& shortcuts) {
    HelpPage page;
    page.id = QString::fromLatin1(entry.id);
    page.group = QCoreApplication::translate("Help", entry.group);
    page.html = writtenPage(page.id) + madePart(page.id, shortcuts);
    page.sections = sectionsOf(page.html);
    page.title = page.sections.empty() ? page.id : page.sections.front().title;
    page.html.replace(headingPattern(), QStringLiteral("<h\\1><a name=\"\\2\"></a>\\3</h\\1>"));
    return page;
}

} // namespace

HelpBook::HelpBook(const QString& shortcuts) {
    for (const HelpEntry& entry : helpContents) {
        m_pages.push_back(pageOf(entry, shortcuts));
    }
}

const HelpPage* HelpBook::find(const QString& id) const {
    const auto found = std::ranges::find(m_pages, id, &HelpPage::id);
    return found == m_pages.end() ? nullptr : &*found;
}

QString HelpBook::Hit::topic() const {
    return section->anchor.isEmpty() ? page->id : page->id + u'#' + section->anchor;
}

std::vector<HelpBook::Hit> HelpBook::search(const QString& words) const {
    const HelpWords wanted(words);
    std::vector<Hit> inTitle;
    std::vector<Hit> inText;
    for (const HelpPage& page : m_pages) {
        for (const HelpSection& section : page.sections) {
            if (wanted.isEmpty()) {
                continue;
            }
            if (wanted.areIn(section.title)) {
                inTitle.push_back({&page, &section});
            } else if (wanted.areIn(section.title + u' ' + section.text)) {
                inText.push_back({&page, &section});
            }
        }
    }
    inTitle.insert(inTitle.end(), inText.begin(), inText.end());
    return inTitle;
}

} // namespace sparkout
