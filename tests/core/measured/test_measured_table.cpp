// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of measurements: dialects, headings and units of both languages, faults by line and
// column, what is kept of long traces.
#include "core/measured/measured_table.h"
#include "core/sha256.h"
#include "tests/check_line.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <cmath>
#include <string>

namespace sparkout::test_measured_table {

ReadMeasured readAs(std::string_view text, const MeasuredContext& context = {}) {
    return readMeasured(text, proposeTable(text), context);
}

bool hasFault(const ReadMeasured& read, std::size_t line, std::size_t column, IssueCode code) {
    return std::ranges::any_of(read.faults, [&](const CellFault& fault) {
        return fault.line == line && fault.column == column && fault.issue.code == code;
    });
}

QString placesOf(const ReadMeasured& read) {
    QString text;
    for (const CellFault& fault : read.faults) {
        text += QStringLiteral("%1:%2 code %3; ")
                    .arg(fault.line)
                    .arg(fault.column)
                    .arg(static_cast<int>(fault.issue.code));
    }
    return text;
}

class TestMeasuredTable : public QObject {
    Q_OBJECT

private slots:
    void dialects_data() {
        addColumns<QByteArray, char, char>("text", "delimiter", "decimal");
        addRow("comma, point", QByteArray("t,d\n0.1,29.9\n0.2,29.8\n"), ',', '.');
        addRow("comma, whole numbers", QByteArray("t,d\n1,30\n2,31\n"), ',', '.');
        addRow("semicolon, comma", QByteArray("t, s;d, mm\n0,1;29,9\n0,2;29,8\n"), ';', ',');
        addRow("semicolon, point", QByteArray("t;d\n0.1;29.9\n"), ';', '.');
        addRow("tab, comma", QByteArray("t, s\td, mm\n0,1\t29,9\n"), '\t', ',');
        addRow("tab, point", QByteArray("t, s\td, mm\n0.1\t29.9\n"), '\t', '.');
        addRow("quoted decimal commas",
               QByteArray("\"t, s\",\"d, mm\"\n\"0,1\",\"29,9\"\n\"0,2\",\"29,8\"\n"), ',', ',');
        addRow("one column", QByteArray("Диаметр, мм\n29,991\n29,993\n"), ';', ',');
        addRow("key and value", QByteArray("0.1|power|3.2\n0.2|power|3.3\n"), '|', '.');
    }
    void dialects() {
        QFETCH(QByteArray, text);
        QFETCH(char, delimiter);
        QFETCH(char, decimal);
        const TableDialect dialect = dialectOf(text.toStdString());
        QCOMPARE(dialect.delimiter, delimiter);
        QCOMPARE(dialect.decimal, decimal);
    }

    void headings_data() {
        addColumns<QByteArray, int, int, int>("heading", "quantity", "unit", "place");
        const auto row = [](const char* heading, ColumnQuantity quantity, ColumnUnit unit,
                            int place = -1) {
            addRow(heading, QByteArray(heading), static_cast<int>(quantity), static_cast<int>(unit),
                   place);
        };
        row("Diameter, mm", ColumnQuantity::diameter, ColumnUnit::mm);
        row("Диаметр, мм", ColumnQuantity::diameter, ColumnUnit::mm);
        row("ДИАМЕТР [мкм]", ColumnQuantity::diameter, ColumnUnit::um);
        row("D2, mm", ColumnQuantity::diameter, ColumnUnit::mm);
        row("d РЗ1, мм", ColumnQuantity::diameter, ColumnUnit::mm, 0);
        row("Diameter RZ2 [mm]", ColumnQuantity::diameter, ColumnUnit::mm, 2);
        row("Отклонение диаметра, мкм", ColumnQuantity::diameter_deviation, ColumnUnit::um);
        row("t, s", ColumnQuantity::time, ColumnUnit::s);
        row("Время, мин", ColumnQuantity::time, ColumnUnit::min);
        row("time [ms]", ColumnQuantity::time, ColumnUnit::ms);
        row("P [kW]", ColumnQuantity::wheel_power, ColumnUnit::kw);
        row("P, N", ColumnQuantity::normal_force, ColumnUnit::n);
        row("Мощность, Вт", ColumnQuantity::wheel_power, ColumnUnit::w);
        row("Ток шпинделя, А", ColumnQuantity::spindle_current, ColumnUnit::a);
        row("Py (кН)", ColumnQuantity::normal_force, ColumnUnit::kn);
        row("Биение", ColumnQuantity::radial_runout, ColumnUnit::um);
        row("Ra, µm", ColumnQuantity::roughness_ra, ColumnUnit::um);
        row("№ детали", ColumnQuantity::part, ColumnUnit::none);
        row("Зона", ColumnQuantity::place, ColumnUnit::none);
        row("Diameter, inch", ColumnQuantity::ignored, ColumnUnit::none);
        row("Diameter [inch]", ColumnQuantity::diameter, ColumnUnit::unknown);
        row("Temperature, °C", ColumnQuantity::ignored, ColumnUnit::none);
        row("", ColumnQuantity::ignored, ColumnUnit::none);
    }
    void headings() {
        QFETCH(QByteArray, heading);
        QFETCH(int, quantity);
        QFETCH(int, unit);
        QFETCH(int, place);
        const ColumnMatch match = matchHeading(heading.toStdString());
        QCOMPARE(static_cast<int>(match.quantity), quantity);
        QCOMPARE(static_cast<int>(match.unit), unit);
        QCOMPARE(match.place.value_or(-1), place);
        QCOMPARE(match.heading, heading.toStdString());
    }

    void partsOfARussianTable() {
        const ReadMeasured read = readAs("Деталь;Зона;Диаметр, мм;D2, мм;Биение, мкм;Ra, мкм\r\n"
                                         "17;РЗ1;29,991;29,993;3,1;0,62\r\n"
                                         "17;НЗ;29,985;;2,0;\r\n"
                                         "\r\n"
                                         "18;РЗ2;29,99;29,99;−0;0,7\r\n");
        QVERIFY2(read.faults.empty(), qPrintable(placesOf(read)));
        const std::vector<MeasuredPart>& parts = read.data.parts;
        QCOMPARE(parts.size(), std::size_t{3});
        QCOMPARE(read.rows, std::size_t{3});
        QCOMPARE(parts[0].part, std::string("17"));
        QCOMPARE(parts[0].place, 0);
        QCOMPARE(parts[0].diameters_mm, (std::vector<double>{29.991, 29.993}));
        QCOMPARE(parts[0].radial_runout_um, std::optional(3.1));
        QCOMPARE(parts[0].roughness_ra_um, std::optional(0.62));
        QCOMPARE(parts[1].place, 1);
        QCOMPARE(parts[1].diameters_mm, (std::vector<double>{29.985}));
        QVERIFY(!parts[1].roughness_ra_um);
        QCOMPARE(parts[2].place, 2);
    }

    /// The same values in the other dialect and other units.
    void aPastedEnglishTableIsTheSame() {
        const ReadMeasured one = readAs("Part\tSection\tDiameter [mm]\tRoundness [µm]\n"
                                        "a\t1\t29.991\t1.5\nb\t2\t29.99\t2\n");
        const ReadMeasured other = readAs("Part;Section;Diameter [µm];Roundness [mm]\n"
                                          "a;1;29991;0.0015\nb;2;29990;0.002\n");
        QVERIFY2(one.faults.empty() && other.faults.empty(), qPrintable(placesOf(other)));
        QCOMPARE(one.data.parts.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(one.data.parts[i].place, static_cast<int>(i)); // counted from 1
            QCOMPARE(other.data.parts[i].place, static_cast<int>(i));
            QVERIFY(
                std::abs(one.data.parts[i].diameters_mm[0] - other.data.parts[i].diameters_mm[0])
                < 1e-12);
            QVERIFY(std::abs(*one.data.parts[i].roundness_um - *other.data.parts[i].roundness_um)
                    < 1e-12);
        }
    }

    void zonesBesideEachOtherAreRowsOfTheirOwn() {
        const ReadMeasured read = readAs(
            "Part,Deviation RZ1 [µm],Deviation NZ [µm],Runout NZ [µm]\n1,-4.5,-6,2\n2,-5,-7,3\n",
            {.source = {}, .nominalDiameter_mm = 30, .currentFactor_kw_a = 0});
        QVERIFY2(read.faults.empty(), qPrintable(placesOf(read)));
        QCOMPARE(read.data.parts.size(), std::size_t{4});
        QCOMPARE(read.data.parts[0].diameters_mm.front(), 30 - 0.0045);
        QCOMPARE(read.data.parts[1].place, 1);
        QCOMPARE(read.data.parts[1].radial_runout_um, std::optional(2.0));
    }

    void tracesWithTheirUnits() {
        const std::string text = "t, ms;Размер, мкм;P [W];I, A;F [kN]\n"
                                 "0;110,5;1500;2;0,05\n10;100;1600;;0,06\n20;;1700;3;0,07\n";
        const ReadMeasured read = readAs(
            text, {.source = "trace.csv", .nominalDiameter_mm = 0, .currentFactor_kw_a = 0.5});
        QVERIFY2(read.faults.empty(), qPrintable(placesOf(read)));
        QCOMPARE(read.data.traces.size(), std::size_t{4});
        const MeasuredTrace& size = read.data.traces[0];
        QVERIFY(size.quantity == TraceQuantity::gauge_size);
        QCOMPARE(size.time_s.values(), (std::vector<double>{0, 0.01}));
        QCOMPARE(size.values[0], 110.5 * 1e-3);
        QCOMPARE(size.source, std::string("trace.csv"));
        QCOMPARE(size.source_sha256, sha256(text));
        QCOMPARE(size.source_samples, 2);
        const MeasuredTrace& power = read.data.traces[1];
        QVERIFY(power.quantity == TraceQuantity::wheel_power);
        QCOMPARE(power.values[2], 1700 * 1e-3);
        const MeasuredTrace& current = read.data.traces[2];
        QVERIFY(current.quantity == TraceQuantity::spindle_current);
        QCOMPARE(current.factor_kw_per_a, std::optional(0.5));
        QCOMPARE(current.time_s.values(), (std::vector<double>{0, 0.02}));
        QVERIFY(read.data.traces[3].quantity == TraceQuantity::normal_force);
        QCOMPARE(read.data.traces[3].values[0], 0.05 * 1e3);
    }

    void keyAndValueLines() {
        const ReadMeasured read = readAs("2026-03-04T10:59:59.50Z|power [W]|1200|size [mm]|0.25\n"
                                         "2026-03-04T11:00:00.25Z|power [W]|1250\n"
                                         "2026-03-04T11:00:01Z|spindle_mode|AUTO|power [W]|"
                                         "UNAVAILABLE|size [mm]|0.2\n");
        QVERIFY2(read.faults.empty(), qPrintable(placesOf(read)));
        QCOMPARE(read.data.traces.size(), std::size_t{2});
        QCOMPARE(read.data.traces[0].time_s.values(), (std::vector<double>{0, 0.75}));
        QCOMPARE(read.data.traces[0].values.values(), (std::vector<double>{1.2, 1.25}));
        QCOMPARE(read.data.traces[1].time_s.values(), (std::vector<double>{0, 1.5}));
        const ReadMeasured seconds = readAs("0.5|power|3\n1.5|power|four\n1.0|power|3\n2|power\n");
        QVERIFY(hasFault(seconds, 2, 3, IssueCode::wrongType));
        QVERIFY(hasFault(seconds, 3, 1, IssueCode::outOfRange));
        QVERIFY(hasFault(seconds, 4, 0, IssueCode::wrongCount));
    }

    void faultsSayWhere_data() {
        addColumns<QByteArray, int, int, int>("text", "line", "column", "code");
        const auto row = [](const char* name, const char* text, int line, int column,
                            IssueCode code) {
            addRow(name, QByteArray(text), line, column, static_cast<int>(code));
        };
        row("nothing", " \n", 0, 0, IssueCode::empty);
        row("headings alone", "Part,Diameter [mm]\n", 0, 0, IssueCode::empty);
        row("no number", "Part,Diameter [mm]\n1,29.9\n2,abc\n", 3, 2, IssueCode::wrongType);
        row("two marks", "Part;Diameter [mm]\n1;29,9\n2;1.029,9\n", 3, 2, IssueCode::wrongType);
        row("the other decimal mark", "t;d [mm]\n0,1;29,9\n0,2;29.9\n", 3, 2, IssueCode::wrongType);
        row("out of range", "Part,Diameter [mm]\n1,-5\n", 2, 2, IssueCode::outOfRange);
        row("time goes back", "t,P [kW]\n1,2\n0.5,2\n", 3, 1, IssueCode::outOfRange);
        row("too many cells", "Part,Diameter [mm]\n1,29.9,7\n", 2, 3, IssueCode::wrongCount);
        row("inches", "Part,Diameter [inch]\n1,1.2\n", 1, 2, IssueCode::notOneOf);
        row("nothing known", "a,b\n1,2\n", 1, 0, IssueCode::missingKey);
        row("a trace without a time", "P [kW]\n1\n", 1, 0, IssueCode::missingKey);
        row("half a section", "Part,Section,d [mm]\n1,1.5,30\n", 2, 2, IssueCode::wrongType);
        row("no such section", "Part,Section,d [mm]\n1,900,30\n", 2, 2, IssueCode::outOfRange);
        row("infinite", "Part,d [mm]\n1,inf\n", 2, 2, IssueCode::wrongType);
    }
    void faultsSayWhere() {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        QFETCH(int, column);
        QFETCH(int, code);
        const ReadMeasured read = readAs(text.toStdString());
        QVERIFY2(hasFault(read, static_cast<std::size_t>(line), static_cast<std::size_t>(column),
                          static_cast<IssueCode>(code)),
                 qPrintable(placesOf(read)));
    }

    void hostileTextIsNoHarm() {
        std::string bytes = "d [mm],\"";
        for (int i = 0; i < 3000; ++i) {
            bytes += static_cast<char>(i * 37 % 251);
        }
        (void)readAs(bytes);
        std::string many = "d [mm]\n";
        for (int i = 0; i < 10'000; ++i) {
            many += "x\n";
        }
        QCOMPARE(readAs(many).faults.size(), limits::issues);
        QVERIFY(hasFault(readAs("Part;d [mm]\n1;\xD0\n"), 2, 2, IssueCode::wrongType));
    }

    /// Published digests [FIPS180-4].
    void digests() {
        QCOMPARE(sha256("abc"),
                 std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61"
                             "f20015ad"));
        QCOMPARE(sha256(""),
                 std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b78"
                             "52b855"));
        QCOMPARE(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
                 std::string("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"));
        QCOMPARE(sha256(std::string(1'000'000, 'a')),
                 std::string("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"));
    }

    void thinningTakesMeans() {
        constexpr std::size_t count = 100'003, most = 1000;
        std::vector<double> times, values;
        for (std::size_t i = 0; i < count; ++i) {
            times.push_back(static_cast<double>(i) / 100);
            values.push_back(5 + times.back() / 8 + (i % 2 == 0 ? 1 : -1)); // a ramp under noise
        }
        const auto [keptTimes, kept] = thinOut(times, values, most);
        QCOMPARE(kept.size(), most);
        QCOMPARE(kept.size(), keptTimes.size());
        QVERIFY(std::ranges::is_sorted(keptTimes));
        // The mean of a ramp is the ramp at the mean time; of the noise a hundredth is left.
        for (std::size_t i = 0; i < most; ++i) {
            QVERIFY(std::abs(kept[i] - 5 - keptTimes[i] / 8) < 0.0101);
        }
        QCOMPARE(thinOut(times, values, count).second, values);
    }

    void aMillionSamplesInTwoSeconds() {
        std::string text = "t, s;Мощность, кВт\n";
        constexpr int samples = 1'000'000;
        for (int i = 0; i < samples; ++i) {
            text += std::to_string(i / 1000) + ',' + std::to_string(1000 + i % 1000).substr(1) + ';'
                    + std::to_string(2 + i % 7) + ",12345\n";
        }
        RunningTimer timer;
        const ReadMeasured read = readAs(text);
        const double seconds = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
        QVERIFY2(read.faults.empty(), qPrintable(placesOf(read)));
        QCOMPARE(read.data.traces.front().source_samples, samples);
        QVERIFY(read.data.traces.front().values.size() <= limits::traceSamples);
        constexpr double target_s = 2;
        qInfo("a million samples read in %.2f s, %s", seconds, beside(seconds, target_s));
        QVERIFY2(seconds < 4 * target_s, qPrintable(QString::number(seconds)));
    }
};

} // namespace sparkout::test_measured_table

SPARKOUT_TEST(test_measured_table, TestMeasuredTable)
#include "test_measured_table.moc"
