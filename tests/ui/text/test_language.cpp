// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// A sign of per cent stays on the line of its number, in both languages.
#include "tests/registry.h"
#include "ui/text/language.h"
#include "ui/text/limit_names.h"

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

namespace sparkout::test_language {

const QRegularExpression parted(QStringLiteral("[\\d}] %(?![0-9A-Za-z])"));

/// The texts with a percent sign as the sources have them, with their contexts.
std::vector<std::pair<QByteArray, QByteArray>> textsWithPercents() {
    QFile file(QStringLiteral(SPARKOUT_SOURCE_DIR "/translations/sparkout_ru.ts"));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    std::vector<std::pair<QByteArray, QByteArray>> texts;
    QByteArray context;
    for (QXmlStreamReader xml(&file); !xml.atEnd(); xml.readNext()) {
        if (xml.isStartElement() && xml.name() == u"name") {
            context = xml.readElementText().toUtf8();
        } else if (xml.isStartElement() && xml.name() == u"source") {
            const QString text = xml.readElementText();
            if (text.contains(parted)) {
                texts.emplace_back(context, text.toUtf8());
            }
        }
    }
    return texts;
}

class TestLanguage : public QObject {
    Q_OBJECT

private slots:
    void noTextPartsANumberFromItsPercentSign() {
        const auto texts = textsWithPercents();
        QVERIFY(texts.size() > 20);
        Language language;
        for (const char* code : {"en", "ru"}) {
            language.apply(QString::fromLatin1(code));
            for (const auto& [context, text] : texts) {
                const QString shown =
                    QCoreApplication::translate(context.constData(), text.constData(), nullptr, 5);
                QVERIFY2(!shown.contains(parted), text.constData());
            }
            QVERIFY(LimitNames::percent(0.42).endsWith(QStringLiteral("42\u00a0%")));
            QVERIFY(LimitNames::percent(1.0002).contains(
                QRegularExpression(QStringLiteral("100[.,]1"))));
        }
    }

    void otherTextsStayAsTheyAre() {
        Language language;
        language.apply(QStringLiteral("en"));
        const auto shown = [](const char* text) {
            return QCoreApplication::translate("None", text);
        };
        QCOMPARE(shown("%1 %2, %3 %n"), QStringLiteral("%1 %2, %3 %n"));
        QCOMPARE(shown("Share, %"), QStringLiteral("Share, %"));
        QCOMPARE(shown("%1 % (95 %)"), QStringLiteral("%1\u00a0% (95\u00a0%)"));
        QCOMPARE(shown("{bad} (≤ {high} %)"), QStringLiteral("{bad} (≤ {high}\u00a0%)"));
    }
};

} // namespace sparkout::test_language

SPARKOUT_TEST(test_language, TestLanguage)
#include "test_language.moc"
