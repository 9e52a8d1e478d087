// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "ui/table/profile_csv.h"

#include "tests/registry.h"

namespace sparkout::test_profile_csv {

using Values = std::vector<double>;

/// What is wrong with a text; fails the test when nothing is.
ProfileCsvFault faultOf(const char* text) {
    const auto read = readProfileCsv(text);
    const auto* fault = std::get_if<ProfileCsvFault>(&read);
    return fault ? *fault : ProfileCsvFault{ProfileCsvFault::What::count, -1, {}, -1};
}

class TestProfileCsv : public QObject {
    Q_OBJECT

private slots:
    void theValuesOfATableAreRead_data() {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const char* text) { addRow(name, QByteArray(text)); };
        row("points", "0\n-1.5\n-3\n-2.25\n");
        row("commas", "0\n-1,5\n-3\n-2,25");
        row("carriage returns", "0\r\n-1.5\r\n-3\r\n-2.25\r\n");
        row("blank lines and spaces", "\n 0\n\n -1.5 \n-3\n  \n-2.25\n\n");
        row("typographic minus", "0\n\u22121,5\n\u22123\n\u22122,25\n");
        row("byte order mark and header", "\xEF\xBB\xBFradius\n0\n-1.5\n-3\n-2.25\n");
        row("header with a comma", "Отклонение, мкм\n0\n-1,5\n-3\n-2,25\n");
        row("header in another encoding", "\xD0\xE0\xE4\n0\n-1,5\n-3\n-2,25\n");
        row("semicolons", "angle;radius\n0;0\n90;-1,5\n180;-3\n270;-2,25\n");
        row("semicolons and points", "0;0\n90;-1.5\n180;-3\n270;-2.25\n");
        row("tabs", "0\t0\n90\t-1,5\n180\t-3\n270\t-2,25\n");
        row("commas between columns", "angle,radius\n0,0\n90,-1.5\n180,-3\n270,-2.25\n");
        row("three columns", "n, angle, radius\n1, 0, 0\n2, 90, -1.5\n3, 180, -3\n4, 270, -2.25\n");
        row("quoted", "\"angle\",\"radius\"\n\"0\",\"0\"\n\"90\",\"-1,5\"\n\"180\",\"-3\"\n\"270\","
                      "\"-2,25\"\n");
    }
    void theValuesOfATableAreRead() {
        QFETCH(QByteArray, text);
        const auto read = readProfileCsv(text.toStdString());
        QVERIFY(std::holds_alternative<Values>(read));
        QCOMPARE(std::get<Values>(read), (Values{0, -1.5, -3, -2.25}));
    }

    void aColumnThatCountsIsNotTakenForWholeParts() {
        QCOMPARE(std::get<Values>(readProfileCsv("0,5\n1,7\n2,9\n3,8\n")), (Values{5, 7, 9, 8}));
        QCOMPARE(std::get<Values>(readProfileCsv("0,5\n1,7\n2,9\n1,8\n")),
                 (Values{0.5, 1.7, 2.9, 1.8}));
    }

    void aValueThatCannotBeReadIsNamedWithItsLine() {
        const auto fault = faultOf("radius\n\n0\n-1.5\nabc\n-2\n");
        QCOMPARE(fault.what, ProfileCsvFault::What::notANumber);
        QCOMPARE(fault.line, 5);
        QCOMPARE(fault.text, QStringLiteral("abc"));
        QVERIFY(profileCsvFaultText(fault).contains(QStringLiteral("5")));
        QVERIFY(profileCsvFaultText(fault).contains(QStringLiteral("abc")));
        QCOMPARE(faultOf("0\n-1,5\noops\n-2\n").text, QStringLiteral("oops"));
        QCOMPARE(faultOf("0\n-1,5\n-2,5x\n-2\n").text, QStringLiteral("-2,5x"));
        QCOMPARE(faultOf("1;0\n2;x\n").text, QStringLiteral("x"));
        QCOMPARE(faultOf("1;0\n2;\n").text, QStringLiteral("2;"));
        QCOMPARE(faultOf("0\nnan\n1\n2\n").line, 2);
        QCOMPARE(faultOf("12x\n0\n1\n2\n").line, 1); // no header: it begins with a digit
        QCOMPARE(faultOf("0,0.5\n1,0.7\n2,0.9\n3,-0,8\n").line, 4);
        QVERIFY(faultOf(QByteArray(5000, 'x').prepend("0\n").constData()).text.size() < 100);
    }

    void aValueOutOfRangeIsNamedWithItsLine() {
        const auto fault = faultOf("0\n-1\n20000\n0\n");
        QCOMPARE(fault.what, ProfileCsvFault::What::outOfRange);
        QCOMPARE(fault.line, 3);
        QCOMPARE(fault.text, QStringLiteral("20000"));
    }

    void theNumberOfValuesMustBeEvenAndWithinTheLimits_data() {
        addColumns<int, bool>("count", "taken");
        addRow("none", 0, false);
        addRow("too few", 2, false);
        addRow("fewest", 4, true);
        addRow("odd", 37, false);
        addRow("most", 3600, true);
        addRow("too many", 3602, false);
    }
    void theNumberOfValuesMustBeEvenAndWithinTheLimits() {
        QFETCH(int, count);
        QFETCH(bool, taken);
        const QByteArray text = QByteArray("-1.5\n").repeated(count);
        QCOMPARE(std::holds_alternative<Values>(readProfileCsv(text.toStdString())), taken);
        if (!taken) {
            const auto fault = faultOf(text.constData());
            QCOMPARE(fault.what, ProfileCsvFault::What::count);
            QCOMPARE(fault.count, count);
            QVERIFY(profileCsvFaultText(fault).contains(QStringLiteral("3600")));
        }
    }
};

} // namespace sparkout::test_profile_csv

SPARKOUT_TEST(test_profile_csv, TestProfileCsv)
#include "test_profile_csv.moc"
