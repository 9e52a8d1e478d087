// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "ui/form/number_field.h"

#include "core/project/validate.h"
#include "ui/text/number_text.h"

#include "tests/registry.h"

#include <QApplication>
#include <QClipboard>
#include <QSignalSpy>
#include <QToolTip>

#include <random>

namespace sparkout::test_number_field {

NumberSpec spec(Range hard = {}) {
    NumberSpec made;
    made.hard = hard;
    made.unit = "mm";
    return made;
}

void typeOver(NumberField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    QTest::keyClicks(&field, text);
}

class TestNumberField : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void typedNumbersAreTakenAsTypedInEveryLocale_data() {
        addColumns<QLocale, QString, double>("locale", "text", "value");
        const QList<QLocale> locales{QLocale(QStringLiteral("en_US")),
                                     QLocale(QStringLiteral("ru_RU")),
                                     QLocale(QStringLiteral("de_DE"))};
        for (const QLocale& locale : locales) {
            for (const auto& [text, value] : {std::pair{"0.005", 0.005},
                                              {"0,005", 0.005},
                                              {"1e-3", 0.001},
                                              {"-0.25", -0.25},
                                              {"1800", 1800.0}}) {
                QTest::addRow("%s %s", qPrintable(locale.name()), text)
                    << locale << QString::fromUtf8(text) << value;
            }
        }
    }

    void typedNumbersAreTakenAsTypedInEveryLocale() {
        QFETCH(QLocale, locale);
        QFETCH(QString, text);
        QFETCH(double, value);
        QLocale::setDefault(locale);
        NumberField field(spec());
        field.reset(7);
        typeOver(field, text);
        QCOMPARE(field.text(), text);
        QCOMPARE(field.value().value(), value);
        QVERIFY(!field.refused());
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(parseNumber(field.text()).value(), value);
        QCOMPARE(field.text(), showNumber(value, locale));
    }

    void anyShownNumberReadsBackTheSame() {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> exponent(-12, 12);
        for (const char* name : {"en_US", "ru_RU", "de_DE"}) {
            QLocale::setDefault(QLocale(QString::fromUtf8(name)));
            NumberField field(spec());
            for (int i = 0; i < 500; ++i) {
                const double value = std::pow(10.0, exponent(random));
                field.reset(value);
                QVERIFY(!field.text().contains(QLocale().groupSeparator()));
                QCOMPARE(parseNumber(field.text()).value(), value);
            }
        }
    }

    void aPastedNumberIsTaken() {
        NumberField field(spec());
        field.reset(1);
        QApplication::clipboard()->setText(QStringLiteral(" \u22120,125\n"));
        field.selectAll();
        QTest::keySequence(&field, QKeySequence::Paste);
        QCOMPARE(field.value().value(), -0.125);
    }

    void theBeginningOfARefusedNumberIsNeverKept() {
        NumberField field(spec());
        field.reset(0.004);
        typeOver(field, QStringLiteral("0.9"));
        QCOMPARE(field.value().value(), 0.9);
        QTest::keyClicks(&field, QStringLiteral("x"));
        QVERIFY(field.refused());
        QCOMPARE(field.value().value(), 0.004);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.value().value(), 0.004);
        QTest::keyClick(&field, Qt::Key_Escape);
        QVERIFY(!field.refused());
        QCOMPARE(field.text(), showNumber(0.004, QLocale()));
    }

    void escapeGoesBackToTheValueBeforeTheEdit() {
        NumberField field(spec());
        field.reset(-16);
        typeOver(field, QStringLiteral("-2"));
        QCOMPARE(field.value().value(), -2.0);
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.value().value(), -16.0);
    }

    void garbageStaysVisibleAndNeverChangesTheValue_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"abc", "1.2.3", "1,234.5", "1 000", "12 mm", "--5", "", "2000", "0"}) {
            QTest::newRow(*text ? text : "empty") << QString::fromUtf8(text);
        }
    }

    void garbageStaysVisibleAndNeverChangesTheValue() {
        QFETCH(QString, text);
        NumberField field(spec({0, 1000, true}));
        field.reset(30);
        QApplication::clipboard()->setText(text);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        field.selectAll();
        if (text.isEmpty()) {
            QTest::keyClick(&field, Qt::Key_Delete);
        } else {
            QTest::keySequence(&field, QKeySequence::Paste);
        }
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.text(), text);
        QCOMPARE(field.value().value(), 30.0);
        QCOMPARE(edited.count(), 0);
        QVERIFY(field.refused());
        QCOMPARE(field.remark().mark, Mark::error);
        QVERIFY(!field.remark().reason.isEmpty());
        QCOMPARE(field.accessibleDescription(), field.remark().reason);
        field.setValue(30); // the model shows what it has: the refused text stays
        QCOMPARE(field.text(), text);
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.text(), QStringLiteral("30"));
        QVERIFY(!field.refused());
    }

    void aRefusalIsShownOnlyAfterAPauseInTyping() {
        NumberField field(spec({0, 5, true}));
        field.reset(1);
        typeOver(field, QStringLiteral("0"));
        QVERIFY(field.refused());
        QCOMPARE(field.remark().mark, Mark::none);
        QTRY_COMPARE(field.remark().mark, Mark::error);
    }

    void aValueTheOthersDoNotGoWithWaitsForAPause() {
        NumberField field(spec({0, 1000}));
        field.reset(40);
        field.setFits([](std::optional<double> value) { return value && *value >= 10; });
        QSignalSpy edited(&field, &NumberField::valueEdited);
        typeOver(field, QStringLiteral("5"));
        QCOMPARE(field.value().value(), 40.0);
        QTest::keyClicks(&field, QStringLiteral("0"));
        QCOMPARE(field.value().value(), 50.0);
        QCOMPARE(edited.count(), 1);
        typeOver(field, QStringLiteral("7"));
        QVERIFY(!field.refused());
        QTRY_COMPARE(field.value().value(), 7.0); // it is what was meant
        QCOMPARE(field.text(), QStringLiteral("7"));
    }

    void leavingTheFieldTakesAValueThatWaits() {
        NumberField field(spec({0, 1000}));
        field.reset(40);
        field.setFits([](std::optional<double> value) { return value && *value >= 10; });
        typeOver(field, QStringLiteral("5"));
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.text(), QStringLiteral("40"));
        typeOver(field, QStringLiteral("5"));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.value().value(), 5.0);
    }

    void anotherValueOfTheModelReplacesARefusedText() {
        NumberField field(spec());
        field.reset(1);
        typeOver(field, QStringLiteral("abc"));
        field.setValue(2);
        QCOMPARE(field.text(), QStringLiteral("2"));
        QVERIFY(!field.refused());
    }

    void anEmptyOptionalFieldMeansNotGiven() {
        NumberSpec optional = spec();
        optional.optional = true;
        optional.nullMeaning = "not required";
        NumberField field(optional);
        field.reset(4);
        field.selectAll();
        QTest::keyClick(&field, Qt::Key_Delete);
        QVERIFY(!field.value().has_value());
        QVERIFY(!field.refused());
        QCOMPARE(field.placeholderText(), QStringLiteral("not required"));
    }

    void aWholeNumberFieldRefusesFractions() {
        NumberSpec whole = spec();
        whole.integer = true;
        NumberField field(whole);
        field.reset(36);
        typeOver(field, QStringLiteral("36.5"));
        QVERIFY(field.refused());
        QCOMPARE(field.value().value(), 36.0);
    }

    void arrowKeysStepTheLastDigitWithinTheRange() {
        NumberField field(spec({0, 0.012, true}));
        field.reset(0.011);
        QTest::keyClick(&field, Qt::Key_Up);
        QTest::keyClick(&field, Qt::Key_Up); // 0.013 is out of range
        QCOMPARE(field.value().value(), 0.012);
        QCOMPARE(field.text(), QStringLiteral("0.012"));
        field.reset(0.001);
        QTest::keyClick(&field, Qt::Key_Down);
        QCOMPARE(field.value().value(), 0.0009);
    }

    void arrowKeysGoByTheStepsThatAreGiven() {
        QLocale::setDefault(QLocale(QLocale::Russian, QLocale::Russia));
        NumberSpec onDiameter = spec({0, 5});
        onDiameter.scale.factor = 2;
        NumberField field(onDiameter);
        field.setSteps([](double value, int steps) -> std::optional<double> {
            return value < 1 ? std::optional(value + steps * 0.0005) : std::nullopt;
        });
        field.reset(0.1);
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.value().value(), 0.1005);
        QCOMPARE(field.text(), QStringLiteral("0,201"));
        QTest::keyClick(&field, Qt::Key_Down);
        QCOMPARE(field.text(), QStringLiteral("0,2"));
        field.reset(2); // where none are given
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.text(), QStringLiteral("5"));
    }

    void anUnusualValueIsTakenAndMarked() {
        NumberSpec soft = spec({0, 1000});
        soft.soft = {3, 500};
        NumberField field(soft);
        field.reset(30);
        typeOver(field, QStringLiteral("900"));
        QCOMPARE(field.value().value(), 900.0);
        QCOMPARE(field.remark().mark, Mark::none); // it may become another
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.remark().mark, Mark::warning);
    }

    void arithmeticIsShownBelowAndTakenByEnter() {
        QLocale::setDefault(QLocale(QLocale::Russian, QLocale::Russia));
        NumberField field(spec({0, 100, true}));
        field.show();
        QApplication::setActiveWindow(&field);
        field.reset(7);
        QSignalSpy edited(&field, &NumberField::valueEdited);
        typeOver(field, QStringLiteral("(30-29,6)/2"));
        QCOMPARE(field.value().value(), 7.0); // a result waits
        QCOMPARE(QToolTip::text(), QStringLiteral("= 0,2\u00a0mm"));
        QVERIFY(field.accessibleDescription().contains(QStringLiteral("= 0,2")));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.text(), QStringLiteral("0,2"));
        QCOMPARE(field.value().value(), 0.2);
        QVERIFY(!edited.isEmpty());
        QVERIFY(!field.accessibleDescription().contains(u'='));
    }

    void arithmeticIsTakenAfterAPauseAndStaysAsTyped() {
        NumberField field(spec());
        field.reset(7);
        typeOver(field, QStringLiteral("12+0.3"));
        QTRY_COMPARE(field.value().value(), 12.3);
        QCOMPARE(field.text(), QStringLiteral("12+0.3"));
        field.setValue(12.3); // as the document does
        QCOMPARE(field.text(), QStringLiteral("12+0.3"));
        QTest::keyClicks(&field, QStringLiteral("*2"));
        QCOMPARE(field.value().value(), 7.0);
        QTest::keyClick(&field, Qt::Key_Tab);
        field.clearFocus();
        QTRY_COMPARE(field.value().value(), 12.6);
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(field.text(), QStringLiteral("12.7"));
    }

    void arithmeticThatFailsIsNamedAndKept() {
        NumberField field(spec({0, 1, true}));
        field.reset(0.5);
        typeOver(field, QStringLiteral("1/0"));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.refusal(), QStringLiteral("division by zero"));
        QCOMPARE(field.text(), QStringLiteral("1/0"));
        QCOMPARE(field.value().value(), 0.5);
        typeOver(field, QStringLiteral("1+1"));
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(field.refusal().startsWith(QStringLiteral("out of range")));
        QCOMPARE(field.value().value(), 0.5);
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.text(), QStringLiteral("0.5"));
    }
};

} // namespace sparkout::test_number_field

SPARKOUT_TEST(test_number_field, TestNumberField)
#include "test_number_field.moc"
