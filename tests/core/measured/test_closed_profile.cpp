// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles of roundness machines as tables: both dialects, radii and deviations, angles that are
// not even, faults by line and column.
#include "core/measured/number_table.h"

#include "tests/check_line.h"
#include "tests/registry.h"

#include <cmath>
#include <numbers>
#include <string>

namespace sparkout::test_closed_profile {

/// Angle and value a line, of `value` at so many angles.
template <class Value>
std::string table(const char* headings, int points, const Value& value) {
    std::string text = headings;
    for (int k = 0; k < points; ++k) {
        text += std::to_string(360.0 * k / points) + ';' + std::to_string(value(k)) + '\n';
    }
    return text;
}

bool hasFault(const ClosedProfile& read, std::size_t line, std::size_t column, IssueCode code) {
    return read.radii_mm.empty() && read.faults.size() == 1 && read.faults[0].line == line
           && read.faults[0].column == column && read.faults[0].issue.code == code;
}

class TestClosedProfile : public QObject {
    Q_OBJECT

private slots:
    void radiiAsTheyStand() {
        const auto radius = [](int k) { return 15 + 0.001 * (k % 5); };
        const ClosedProfile read = readClosedProfile(table("", 40, radius), 15);
        QVERIFY(read.faults.empty());
        QCOMPARE(read.rows, std::size_t{40});
        for (int k = 0; k < 40; ++k) {
            QVERIFY(std::abs(read.radii_mm[std::size_t(k)] - radius(k)) < 1e-6);
        }
    }

    void deviationsInMicrometresAreFromTheNominalRadius() {
        std::string text = "Угол, °;Отклонение, мкм\n";
        for (int k = 0; k < 12; ++k) {
            text += std::to_string(30 * k) + ';' + (k % 2 ? "-1,5" : "2,5") + '\n';
        }
        const ClosedProfile read = readClosedProfile(text, 20);
        QVERIFY(read.faults.empty());
        QCOMPARE(read.radii_mm.size(), std::size_t{12});
        QVERIFY(std::abs(read.radii_mm[0] - 20.0025) < 1e-12);
        QVERIFY(std::abs(read.radii_mm[1] - 19.9985) < 1e-12);
    }

    /// Steps that grow and shrink round the part: straight lines between the points.
    void anglesThatAreNotEven() {
        std::string text;
        constexpr int points = 720;
        for (int k = 0; k < points; ++k) {
            const double u = 2 * std::numbers::pi * k / points;
            const double phi = u + 0.1 * std::sin(u);
            text += std::to_string(phi * 180 / std::numbers::pi) + '\t'
                    + std::to_string(15 + 0.01 * std::cos(2 * phi)) + '\n';
        }
        const ClosedProfile read = readClosedProfile(text, 15);
        QVERIFY(read.faults.empty());
        for (int k = 0; k < points; ++k) {
            const double phi = 2 * std::numbers::pi * k / points;
            QVERIFY(std::abs(read.radii_mm[std::size_t(k)] - 15 - 0.01 * std::cos(2 * phi)) < 3e-6);
        }
    }

    void theFirstPointMayStandAgainAtTheEnd() {
        std::string text;
        for (int k = 0; k <= 10; ++k) {
            text += std::to_string(36 * k) + ";15\n";
        }
        QCOMPARE(readClosedProfile(text, 15).radii_mm.size(), std::size_t{10});
    }

    void faultsAreNamedByLineAndColumn() {
        const auto round = [](int) { return 15.0; };
        const std::string good = table("angle;radius\n", 12, round);
        QVERIFY(hasFault(readClosedProfile(good + "350;abc\n", 15), 14, 2, IssueCode::wrongType));
        QVERIFY(hasFault(readClosedProfile(good + "1;15\n", 15), 14, 1, IssueCode::outOfRange));
        QVERIFY(hasFault(readClosedProfile(good + "400;15\n", 15), 14, 1, IssueCode::outOfRange));
        QVERIFY(hasFault(readClosedProfile(good + "350;-15\n", 15), 14, 2, IssueCode::outOfRange));
        QVERIFY(hasFault(readClosedProfile(good + "350\n", 15), 14, 0, IssueCode::wrongCount));
        QVERIFY(hasFault(readClosedProfile(table("", 5, round), 15), 0, 0, IssueCode::wrongCount));
        QVERIFY(hasFault(readClosedProfile("", 15), 0, 0, IssueCode::wrongCount));
    }
};

} // namespace sparkout::test_closed_profile

SPARKOUT_TEST(test_closed_profile, TestClosedProfile)
#include "test_closed_profile.moc"
