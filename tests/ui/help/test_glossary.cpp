// SPDX-License-Identifier: GPL-3.0-or-later
// The glossary against the translations and the help: one name for one thing.
#include "ui/help/glossary.h"

#include "tests/registry.h"
#include "ui/text/language.h"

#include <QCollator>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>

namespace sparkout::test_glossary {

struct Message {
    QString source, translation;
};

QString read(const QString& path) {
    QFile file(QStringLiteral(SPARKOUT_SOURCE_DIR "/") + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Of the Russian translations; paths and quoted commands are no words.
std::vector<Message> messages() {
    static const QRegularExpression noWords(QStringLiteral("`[^`]*`|/[a-z_/0-9]+|&"));
    std::vector<Message> found;
    QXmlStreamReader xml(read(QStringLiteral("translations/sparkout_ru.ts")));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == u"source") {
            found.push_back({xml.readElementText().remove(noWords), {}});
        } else if (xml.name() == u"translation") {
            found.back().translation =
                xml.readElementText(QXmlStreamReader::IncludeChildElements).remove(noWords);
        }
    }
    return found;
}

bool hasOneOf(const QString& text, const QStringList& words) {
    return std::ranges::any_of(
        words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

class TestGlossary : public QObject {
    Q_OBJECT

private slots:
    void everyTermIsComplete() {
        const std::vector<Term> terms = glossary();
        QVERIFY(terms.size() > 40);
        for (const Term& term : terms) {
            for (const QString& text :
                 {term.english, term.russian, term.englishMeaning, term.russianMeaning}) {
                QVERIFY2(!text.isEmpty(), qPrintable(term.english));
            }
        }
        QVERIFY(std::ranges::is_sorted(terms, {}, [](const Term& t) { return t.english; }));
    }

    void translationsUseTheTerm() {
        const std::vector<Message> all = messages();
        QVERIFY(all.size() > 1000);
        QStringList others;
        for (const Term& term : glossary()) {
            const QRegularExpression word(
                QStringLiteral("\\b%1s?\\b").arg(QRegularExpression::escape(term.english)),
                QRegularExpression::CaseInsensitiveOption);
            int uses = 0;
            for (const Message& message : all) {
                if (!term.stems.isEmpty() && message.source.contains(word)) {
                    ++uses;
                    if (!hasOneOf(message.translation, term.stems)) {
                        others << term.english + QStringLiteral(": ") + message.source
                                      + QStringLiteral(" → ") + message.translation;
                    }
                }
            }
            QVERIFY2(uses > 0 || term.stems.isEmpty(), qPrintable(term.english));
        }
        QVERIFY2(others.isEmpty(), qPrintable(others.join(u'\n')));
    }

    void wordsThatAreNotUsedStandNowhere() {
        QStringList texts;
        for (const Message& message : messages()) {
            texts << message.translation;
        }
        const QString folder = QStringLiteral("resources/help/ru/");
        const QStringList pages = QDir(QStringLiteral(SPARKOUT_SOURCE_DIR "/") + folder)
                                      .entryList({QStringLiteral("*.html")});
        QVERIFY(pages.size() > 20);
        for (const QString& page : pages) {
            texts << read(folder + page);
        }
        int words = 0;
        for (const Term& term : glossary()) {
            for (const QString& word : term.banned) {
                ++words;
                for (const QString& text : texts) {
                    QVERIFY2(!text.contains(word, Qt::CaseInsensitive), qPrintable(text));
                }
            }
        }
        QVERIFY(words > 5);
    }

    void thePageHasEveryTermInTheOrderOfItsLanguage() {
        const auto places = [](const char* language, const QStringList& terms) {
            Language spoken;
            spoken.apply(QString::fromLatin1(language));
            const QString page = glossaryHtml();
            QList<qsizetype> found;
            for (const QString& term : terms) {
                found << page.indexOf(QStringLiteral("<b>%1</b>").arg(term));
            }
            return found;
        };
        QStringList english, russian;
        for (const Term& term : glossary()) {
            english << term.english;
            russian << term.russian;
        }
        std::ranges::sort(
            russian, [order = QCollator(QLocale(QLocale::Russian))](
                         const QString& a, const QString& b) { return order.compare(a, b) < 0; });
        for (const QList<qsizetype>& found : {places("en", english), places("ru", russian)}) {
            QVERIFY(found.front() > 0);
            QVERIFY(std::ranges::is_sorted(found));
        }
    }
};

} // namespace sparkout::test_glossary

SPARKOUT_TEST(test_glossary, TestGlossary)
#include "test_glossary.moc"
