// SPDX-License-Identifier: GPL-3.0-or-later
// Readers of numbers, fed with the farthest of them: a table is refused by line and column, or its
// values are finite and in range, and what is worked out of them is finite, too.
#include "core/file/blanks_csv.h"
#include "core/measured/measured_table.h"
#include "core/measured/number_table.h"
#include "core/surface/roundness_readings.h"
#include "tests/registry.h"

#include <cmath>
#include <random>

namespace sparkout::test_extreme_numbers {

/// Texts that are numbers somewhere, and usual ones among them.
class Numbers {
public:
    explicit Numbers(unsigned seed) : m_random(seed) {}

    std::string usual(double about, double scatter) {
        return std::to_string(about
                              + std::uniform_real_distribution<>(-scatter, scatter)(m_random));
    }
    /// Every `rarity`-th is extreme.
    std::string mixed(double about, double scatter, int rarity) {
        static const std::vector<std::string> extreme{
            "1e308",    "-1e308", "1.7976931348623157e308",
            "1e309",    "-1e400", "5e-324",
            "2.3e-308", "1e-400", "nan",
            "NaN",      "-nan",   "inf",
            "-inf",     "INF",    "infinity",
            "0",        "-0",     "1e154",
            "1e-154",   "1e16",   "99999999999999999999",
            "0x1p10",   "1,5",    "1e",
            "--1",      "+-1",    "",
            "1e5",      "-1e-300"};
        if (std::uniform_int_distribution<>(0, rarity - 1)(m_random) != 0) {
            return usual(about, scatter);
        }
        return extreme[std::uniform_int_distribution<std::size_t>(0, extreme.size() - 1)(m_random)];
    }

private:
    std::mt19937 m_random;
};

bool areFinite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

class TestExtremeNumbers : public QObject {
    Q_OBJECT

private slots:
    void radiusBeyondAnyPartIsRefusedByLineAndColumn_data() {
        QTest::addColumn<QByteArray>("radius");
        for (const char* radius : {"1.7e308", "1e308", "-1e308", "5e-324", "0", "1501", "0.04"}) {
            QTest::newRow(radius) << QByteArray(radius);
        }
    }
    void radiusBeyondAnyPartIsRefusedByLineAndColumn() {
        QFETCH(QByteArray, radius);
        std::string text;
        for (int k = 0; k < 72; ++k) {
            text +=
                std::to_string(5 * k) + ';' + (k == 59 ? radius.toStdString() : "15.001") + '\n';
        }
        const ClosedProfile read = readClosedProfile(text, 15);
        QCOMPARE(read.faults.size(), std::size_t{1});
        QCOMPARE(read.faults[0].line, std::size_t{60});
        QCOMPARE(read.faults[0].column, std::size_t{2});
        QVERIFY(read.faults[0].issue.code == IssueCode::outOfRange);
        QVERIFY(read.radii_mm.empty());
    }

    void profilesAreRefusedOrHaveFiniteReadings() {
        Numbers numbers(11);
        int taken = 0;
        for (int i = 0; i < 120; ++i) {
            std::string text;
            for (int k = 0; k < 36; ++k) {
                text += numbers.usual(10 * k, 1e-3) + ';' + numbers.mixed(15, 0.01, 150) + '\n';
            }
            const ClosedProfile read = readClosedProfile(text, 15);
            QVERIFY(!read.faults.empty() || areFinite(read.radii_mm));
            if (!read.faults.empty()) {
                continue;
            }
            ++taken;
            for (const RoundnessReading& reading : roundnessReadings(read.radii_mm)) {
                for (const std::optional<RoundnessZone>& zone :
                     {std::optional(reading.minimumZone), std::optional(reading.leastSquares),
                      std::optional(reading.inscribed), std::optional(reading.circumscribed)}) {
                    QVERIFY(!zone || std::isfinite(zone->deviation()));
                }
            }
        }
        QVERIFY2(taken > 30 && taken < 120, qPrintable(QString::number(taken)));
    }

    void stiffnessReadingsAreRefusedOrInRange() {
        Numbers numbers(12);
        for (int i = 0; i < 500; ++i) {
            std::string text = "place, mm;load, N;deflection, µm\n";
            for (int k = 0; k < 6; ++k) {
                text += numbers.mixed(50, 40, 20) + ';' + numbers.mixed(200, 50, 20) + ';'
                        + numbers.mixed(4, 2, 20) + '\n';
            }
            for (const StiffnessReading& reading : readStiffnessTable(text).readings) {
                QVERIFY(limits::readingPlace_mm.contains(reading.position_mm));
                QVERIFY(limits::readingLoad_n.contains(reading.load_n));
                QVERIFY(limits::readingDeflection_um.contains(reading.deflection_um));
            }
        }
    }

    void measuredValuesAreRefusedOrInRange() {
        Numbers numbers(13);
        for (int i = 0; i < 500; ++i) {
            std::string parts = "Part;Zone;Diameter, mm;Deviation, mm;Roundness, µm\n";
            std::string traces = "t, min;Size, µm;P, W\n", keys;
            for (int k = 0; k < 8; ++k) {
                parts += numbers.mixed(k, 0, 20) + ";1;" + numbers.mixed(30, 0.01, 20) + ';'
                         + numbers.mixed(0, 0.01, 20) + ';' + numbers.mixed(2, 1, 20) + '\n';
                traces += numbers.mixed(k, 0, 20) + ';' + numbers.mixed(400, 9, 20) + ';'
                          + numbers.mixed(900, 9, 20) + '\n';
                keys += numbers.mixed(k, 0, 20) + "|power [W]|" + numbers.mixed(900, 9, 20) + '\n';
            }
            for (const std::string& text : {parts, traces, keys}) {
                const ReadMeasured read =
                    readMeasured(text, proposeTable(text),
                                 {.source = {}, .nominalDiameter_mm = 30, .currentFactor_kw_a = 0});
                for (const MeasuredPart& part : read.data.parts) {
                    for (const double diameter : part.diameters_mm) {
                        QVERIFY(boundsOf(ColumnQuantity::diameter).range.contains(diameter));
                    }
                    QVERIFY(std::isfinite(part.roundness_um.value_or(0)));
                }
                for (const MeasuredTrace& trace : read.data.traces) {
                    QVERIFY(areFinite(trace.time_s.values()) && areFinite(trace.values.values()));
                    QVERIFY(std::ranges::is_sorted(trace.time_s.values()));
                }
            }
        }
    }

    void blanksAreRefusedOrFinite() {
        Numbers numbers(14);
        for (int i = 0; i < 500; ++i) {
            std::string text = "no;stock_mm;dullness\n";
            for (int k = 0; k < 6; ++k) {
                text += std::to_string(k) + ';' + numbers.mixed(0.15, 0.01, 20) + ';'
                        + numbers.mixed(0.02, 0.01, 20) + '\n';
            }
            const auto read = readMeasuredBlanks(text);
            if (const auto* columns = std::get_if<std::vector<MeasuredColumn>>(&read)) {
                for (const MeasuredColumn& column : *columns) {
                    QVERIFY(areFinite(column.values));
                }
            }
        }
    }
};

} // namespace sparkout::test_extreme_numbers

SPARKOUT_TEST(test_extreme_numbers, TestExtremeNumbers)
#include "test_extreme_numbers.moc"
