// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Units of inputs as the window shows them.
#include "core/catalogue/catalogue.h"
#include "core/project/project.h"
#include "tests/registry.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QRegularExpression>
#include <QSet>

namespace sparkout::test_unit_text {

void addUnits(const StructInfo& table, QSet<QByteArray>& units) {
    for (const Field& field : table.fields) {
        units += field.unit;
        if (field.nested) {
            addUnits(*field.nested, units);
        }
    }
    units.remove({});
}

class TestUnitText : public QObject {
    Q_OBJECT

private slots:
    void everyUnitOfAnInputIsRussianInARussianWindow() {
        QSet<QByteArray> units;
        addUnits(tableOf<Project>(), units);
        addUnits(tableOf<ThermalData>(), units);
        QVERIFY(units.size() > 15);
        Language language;
        language.apply(QStringLiteral("ru"));
        // The same letters in both languages: degrees Celsius, Rockwell's scale C.
        static const QRegularExpression international(QStringLiteral("°C|HRC"));
        static const QRegularExpression latin(QStringLiteral("[A-Za-z]"));
        for (const QByteArray& unit : units) {
            QString shown = unitText(unit.constData());
            QVERIFY2(!shown.remove(international).contains(latin), unit.constData());
        }
        language.apply(QStringLiteral("en"));
        QCOMPARE(unitText("kg/m³"), QStringLiteral("kg/m³"));
    }

    void timesAreInSecondsWhereTheLongestIsBelowTwoMinutes() {
        Language language;
        language.apply(QStringLiteral("ru"));
        QCOMPARE(TimeUnit(119.9).titled(QStringLiteral("Время")), QStringLiteral("Время, с"));
        QCOMPARE(TimeUnit(120).titled(QStringLiteral("Время")), QStringLiteral("Время, мин"));
        language.apply(QStringLiteral("en"));
        QCOMPARE(TimeUnit(119.9).text(), QStringLiteral("s"));
        QCOMPARE(TimeUnit(119.9).of(90), 90.0);
        QCOMPARE(TimeUnit(120).of(90), 1.5);
    }
};

} // namespace sparkout::test_unit_text

SPARKOUT_TEST(test_unit_text, TestUnitText)
#include "test_unit_text.moc"
