// SPDX-License-Identifier: GPL-3.0-or-later
// The glossary against the translations and the help: one name for one thing.
#include "ui/help/help_book.h"

#include "tests/registry.h"
#include "ui/text/language.h"

#include <QCollator>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace sparkout::test_glossary {

struct Message {
    QString source, translation;
};

QString read(const QString& path) {
    QFile file(QStringLiteral(SPARKOUT_SOURCE_DIR "/") + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The Russian translations without mnemonics.
std::vector<Message> messages() {
    std::vector<Message> found;
    QXmlStreamReader xml(read(QStringLiteral("translations/sparkout_ru.ts")));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == u"source") {
            found.push_back({xml.readElementText().remove(u'&'), {}});
        } else if (xml.name() == u"translation") {
            found.back().translation =
                xml.readElementText(QXmlStreamReader::IncludeChildElements).remove(u'&');
        }
    }
    return found;
}

/// Paths and quoted commands are no words.
QString words(QString text) {
    static const QRegularExpression noWords(QStringLiteral("`[^`]*`|/[a-z_/0-9]+"));
    return text.remove(noWords);
}

/// The sources of the program and its files that have Russian texts beside the translations.
QStringList russianFiles() {
    QStringList files;
    for (const auto& [folder, pattern] :
         {std::pair{"resources/help/ru", "*.html"},
          std::pair{"resources/lessons", "*.sparkout-lesson"},
          std::pair{"resources/examples", "*.sparkout"}, std::pair{"resources/catalogue", "*.json"},
          std::pair{"app/manual", "*.cpp"}}) {
        const QDir root(QStringLiteral(SPARKOUT_SOURCE_DIR));
        QDirIterator each(root.filePath(QString::fromLatin1(folder)),
                          {QString::fromLatin1(pattern)}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (each.hasNext()) {
            files << root.relativeFilePath(each.next());
        }
    }
    return files;
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
                if (!term.stems.isEmpty() && words(message.source).contains(word)) {
                    ++uses;
                    if (!hasOneOf(words(message.translation), term.stems)) {
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
            texts << words(message.translation);
        }
        const QStringList files = russianFiles();
        QVERIFY(files.size() > 60);
        for (const QString& file : files) {
            texts << read(file);
        }
        int banned = 0;
        for (const Term& term : glossary()) {
            for (const QString& word : term.banned) {
                ++banned;
                for (const QString& text : texts) {
                    QVERIFY2(!text.contains(word, Qt::CaseInsensitive),
                             qPrintable(word + QStringLiteral(": ") + text));
                }
            }
        }
        QVERIFY(banned > 5);
    }

    void textHasOneTranslationUnlessTheGlossaryListsSeveral() {
        std::map<QString, QSet<QString>> found, listed;
        for (const Message& message : messages()) {
            found[message.source] << message.translation;
        }
        std::erase_if(found, [](const auto& each) { return each.second.size() == 1; });
        const QJsonDocument document =
            QJsonDocument::fromJson(read(QStringLiteral("resources/help/glossary.json")).toUtf8());
        for (const QJsonValue each : document[QLatin1StringView("doubles")].toArray()) {
            const QString source = each[QLatin1StringView("en")].toString();
            QVERIFY2(!each[QLatin1StringView("why")].toString().isEmpty(), qPrintable(source));
            for (const QJsonValue text : each[QLatin1StringView("ru")].toArray()) {
                listed[source] << text.toString();
            }
        }
        for (const auto& [source, texts] : found) {
            QVERIFY2(listed[source] == texts,
                     qPrintable(source + QStringLiteral(" → ")
                                + QStringList(texts.values()).join(QStringLiteral(" | "))));
        }
        QCOMPARE(listed.size(), found.size());
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
