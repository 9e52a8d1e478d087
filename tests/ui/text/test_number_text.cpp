// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "ui/text/number_text.h"

#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include "tests/registry.h"

#include <bit>
#include <cmath>
#include <random>

namespace sparkout::test_number_text {

const QList<QLocale> locales{QLocale(QLocale::English, QLocale::UnitedStates),
                             QLocale(QLocale::Russian, QLocale::Russia),
                             QLocale(QLocale::German, QLocale::Germany)};

class TestNumberText : public QObject {
    Q_OBJECT

private slots:
    void anyDoubleReadsBackTheSameInEitherSeparatorAndEveryLocale() {
        std::mt19937_64 random(20240601);
        for (int i = 0; i < 20'000; ++i) {
            const auto value = std::bit_cast<double>(random());
            if (!std::isfinite(value)) {
                continue;
            }
            const QString point = QString::fromStdString(numberText(value));
            QString comma = point;
            comma.replace(u'.', u',');
            QCOMPARE(parseNumber(point).value(), value);
            QCOMPARE(parseNumber(comma).value(), value);
            for (const QLocale& locale : locales) {
                QCOMPARE(parseNumber(showNumber(value, locale)).value(), value);
            }
        }
    }

    void aPrintedNumberHasAMinusAndTheLocalesSign() {
        const QLocale before;
        QLocale::setDefault(locales[1]);
        const QString printed = printedNumber(-12.5);
        QLocale::setDefault(before);
        QCOMPARE(printed, QStringLiteral("−12,5"));
        QCOMPARE(parseNumber(printed).value(), -12.5);
    }

    void whatIsReadHasAPowerOfTen_data() {
        addColumns<double, QString>("value", "text");
        const auto row = [](double value, const QString& text) {
            addRow(qPrintable(text), value, text);
        };
        row(0, QStringLiteral("0"));
        row(1e-4, QStringLiteral("0,0001"));
        row(1e-15, QStringLiteral("10⁻¹⁵"));
        row(-1e-15, QStringLiteral("−10⁻¹⁵"));
        row(1.5e-8, QStringLiteral("1,5·10⁻⁸"));
        row(-2e20, QStringLiteral("−2·10²⁰"));
        row(1.1e-9, QStringLiteral("1,1·10⁻⁹"));
        row(11e-9, QStringLiteral("1,1·10⁻⁸"));
    }
    void whatIsReadHasAPowerOfTen() {
        QFETCH(double, value);
        QFETCH(QString, text);
        const QLocale before;
        QLocale::setDefault(locales[1]);
        const QString printed = printedNumber(value), brief = printedNumber(value, 6);
        const QString allowed = rangeShown({1e-15, 1}, "");
        QLocale::setDefault(before);
        QCOMPARE(printed, text);
        QCOMPARE(brief, text);
        QCOMPARE(parseNumber(text).value(), value);
        QVERIFY2(allowed.contains(QStringLiteral("10⁻¹⁵")), qPrintable(allowed));
    }

    void aFewDigitsOfAnyNumberAreReadAtAGlance() {
        const QLocale before;
        QLocale::setDefault(locales[0]);
        const QStringList texts{Names::significant(1e-15), Names::significant(-1.23456e-10, 3),
                                Names::significant(1.5e-6, 3), Names::significant(0),
                                Names::significant(2.5e20, 2)};
        ConstraintResult even;
        even.kind = ConstraintKind::burn;
        even.limit = 0.3;
        even.margin = 0.1 + 0.2 - 0.3; // what rounding leaves, 5.6e-17
        const QString margin = Names::margin(even);
        QLocale::setDefault(before);
        QCOMPARE(texts, QStringList({QStringLiteral("10⁻¹⁵"), QStringLiteral("−1.23·10⁻¹⁰"),
                                     QStringLiteral("0.00000150"), QStringLiteral("0.00"),
                                     QStringLiteral("2.5·10²⁰")}));
        QVERIFY2(!margin.contains(u'·') && !margin.contains(QStringLiteral("10")),
                 qPrintable(margin));
    }

    void aLowerBoundAndTheMarginBesideItSaySo() {
        const QLocale before;
        QLocale::setDefault(locales[0]);
        ConstraintResult round = held(ConstraintKind::roundness, Side::atMost, 6, 0.54, 6);
        round.knowsMachine = false;
        const QStringList bounds{Names::value(round), Names::margin(round)};
        round.value = 0.001;
        const QStringList none{Names::value(round), Names::margin(round)};
        QLocale::setDefault(before);
        QCOMPARE(bounds, QStringList({QStringLiteral("≥ 0.54"), QStringLiteral("≤ 5.46")}));
        QCOMPARE(none, QStringList({QStringLiteral("–"), QStringLiteral("–")}));
    }

    void sizesOfFilesAreInThousands() {
        const QLocale before;
        QLocale::setDefault(QLocale::c());
        QCOMPARE(sizeText(0), QStringLiteral("0 kB"));
        QCOMPARE(sizeText(1), QStringLiteral("1 kB")); // there is something
        QCOMPARE(sizeText(9600), QStringLiteral("10 kB"));
        QCOMPARE(sizeText(2'460'000), QStringLiteral("2.5 MB"));
        QCOMPARE(sizeText(73'000'000'000), QStringLiteral("73.0 GB"));
        QLocale::setDefault(before);
    }

    void whatIsNoPowerIsNoNumber() {
        for (const QString& text : {QStringLiteral("10⁻"), QStringLiteral("·10⁻⁵"),
                                    QStringLiteral("2 10⁻⁵"), QStringLiteral("⁵")}) {
            QVERIFY2(!parseNumber(text), qPrintable(text));
        }
    }

    void smallNumbersAreShownInPlainDecimals_data() {
        addColumns<double, QString>("value", "text");
        const auto row = [](double value, const char* text) { addRow(text, value, text); };
        row(0, "0");
        row(1e-4, "0.0001");
        row(1e-7, "0.0000001");
        row(-1.25e-5, "-0.0000125");
        row(1.5e-8, "1.5e-8");
        row(1e-15, "1e-15");
        row(1e5, "100000");
        row(50'000'000, "50000000");
        row(1e20, "1e20");
        row(0.1, "0.1");
    }
    void smallNumbersAreShownInPlainDecimals() {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(showNumber(value, locales[0]), text);
        QCOMPARE(showNumber(value, locales[1]), QString(text).replace(u'.', u','));
    }

    void messagesShowPlainDecimalsToo() {
        QLocale::setDefault(locales[0]);
        const Issue issue{IssueCode::unusual,
                          Severity::warning,
                          {},
                          Amount{2e-7, "mm/N"},
                          Bounds{{1e-6, 1e-3}, "mm/N"}};
        QCOMPARE(issueText(issue),
                 QStringLiteral("0.0000002 mm/N is unusual; usual: 0.000001…0.001 mm/N"));
    }

    void messagesShowAMinusAndKeepHyphens() {
        QLocale::setDefault(locales[0]);
        const Issue issue{IssueCode::unusual,
                          Severity::warning,
                          {},
                          Amount{-9000, "mm"},
                          Bounds{{-5000, -0.5}, "mm"}};
        QCOMPARE(issueText(issue), QStringLiteral("−9000 mm is unusual; usual: −5000…−0.5 mm"));
        const Issue tiny{IssueCode::unusual,
                         Severity::warning,
                         {},
                         Amount{-2e-7, "mm"},
                         Bounds{{.low = -1, .lowOpen = true}, "mm"}};
        QCOMPARE(issueText(tiny), QStringLiteral("−0.0000002 mm is unusual; usual: > −1 mm"));
        const Issue quoted{IssueCode::unusual,
                           Severity::warning,
                           {},
                           Quoted{"\"a -5\""},
                           Keys{{"F-80", "2026-11"}}};
        QCOMPARE(issueText(quoted), QStringLiteral("\"a -5\" is unusual; usual: F-80, 2026-11"));
    }

    void whatPeopleTypeIsRead_data() {
        addColumns<QString, double>("text", "value");
        const auto row = [](const char16_t* text, double value) {
            const QString shown = QString::fromUtf16(text);
            addRow(shown.toUtf8().constData(), shown, value);
        };
        row(u"0.005", 0.005);
        row(u"0,005", 0.005);
        row(u"1e-3", 0.001);
        row(u"1E-3", 0.001);
        row(u"1е-3", 0.001); // Cyrillic е
        row(u"  30 ", 30);
        row(u"\u00a030\t", 30);
        row(u"-16", -16);
        row(u"\u221216", -16);
        row(u"+0,5", 0.5);
        row(u".5", 0.5);
        row(u"5,", 5);
    }

    void whatPeopleTypeIsRead() {
        QFETCH(QString, text);
        QFETCH(double, value);
        const auto read = parseNumber(text);
        QVERIFY(read.has_value());
        QCOMPARE(*read, value);
    }

    void whatIsNoNumberIsRefused_data() {
        QTest::addColumn<QString>("text");
        for (const char* text : {"", " ", "abc", "1 000", "1,234.5", "1.234,5", "1..2", "--1",
                                 "+-1", "1e", "e5", "0x10", "nan", "inf", "1e999", "5 mm", "½"}) {
            addRow(*text ? text : "empty", text);
        }
    }

    void whatIsNoNumberIsRefused() {
        QFETCH(QString, text);
        QVERIFY(!parseNumber(text).has_value());
    }

    void aStepChangesTheLastDigitByOne_data() {
        addColumns<QString, int, bool, QString>("before", "steps", "zeroAllowed", "after");
        const auto row = [](const char* before, int steps, bool zero, const char* after) {
            QTest::addRow("%s by %d", before, steps)
                << QString::fromUtf8(before) << steps << zero << QString::fromUtf8(after);
        };
        row("0.005", 1, true, "0.006");
        row("0,110", 1, true, "0,111");
        row("30", -1, true, "29");
        row("0.99", 1, true, "1.00");
        row("1.2e-4", 1, true, "1.3e-4");
        row("-16", 1, true, "-15");
        row("-0.1", 1, true, "0.0");
        row("0.1", -1, true, "0.0");
        row("0.0", -1, true, "-0.1");
        row("0.01", -1, false, "0.009");
        row("abc", 1, true, "abc");
    }

    void aStepChangesTheLastDigitByOne() {
        QFETCH(QString, before);
        QFETCH(int, steps);
        QFETCH(bool, zeroAllowed);
        QFETCH(QString, after);
        QCOMPARE(stepNumber(before, steps, zeroAllowed), after);
    }
};

} // namespace sparkout::test_number_text

SPARKOUT_TEST(test_number_text, TestNumberText)
#include "test_number_text.moc"
