// SPDX-License-Identifier: GPL-3.0-or-later
// The values that a setting can be given.
#include "core/study/remedy_setting.h"

#include "core/project/validate.h"
#include "tests/registry.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace sparkout::test_setting_scale {

const SettingScale scales[] = {SettingScale::digits(), SettingScale::steps(0.0005, 0.0005),
                               SettingScale::steps(0, 1), SettingScale::revolutions(180),
                               SettingScale::revolutions(10000)};

/// Digits between the first and the last that is not 0.
std::size_t significantDigits(double value) {
    std::string digits;
    for (const char c : numberText(value)) {
        if (c == 'e') {
            break;
        }
        if (c != '.' && (c != '0' || !digits.empty())) {
            digits += c;
        }
    }
    return digits.find_last_not_of('0') + 1;
}

class TestSettingScale : public QObject {
    Q_OBJECT

private slots:
    void valuesRiseFromPlaceToPlace() {
        for (const SettingScale& scale : scales) {
            for (std::int64_t place = 1; place < 2000; ++place) {
                QVERIFY(scale.at(place) > scale.at(place - 1));
            }
        }
    }

    void aValueIsBetweenThePlacesBelowAndAbove() {
        for (const SettingScale& scale : scales) {
            for (double value = 0.00123; value < 50; value *= 1.0317) {
                const std::int64_t below = scale.lastBelow(value), above = scale.firstAbove(value);
                QVERIFY(scale.at(below) < value && value < scale.at(above));
                QVERIFY(above - below == 1 || (above - below == 2 && scale.at(below + 1) == value));
                QCOMPARE(scale.firstFrom(value), below + 1);
                QCOMPARE(scale.lastUpTo(value), above - 1);
            }
            for (std::int64_t place = 1; place < 700; ++place) {
                const double value = scale.at(place);
                for (const double same : {value, std::nextafter(value, 0), value * (1 + 1e-12)}) {
                    QCOMPARE(scale.lastBelow(same), place - 1);
                    QCOMPARE(scale.firstAbove(same), place + 1);
                    QCOMPARE(scale.firstFrom(same), place);
                    QCOMPARE(scale.lastUpTo(same), place);
                }
            }
        }
    }

    void numbersHaveTwoDigitsOrThreeAndStepsOfATwentiethAtMost() {
        const SettingScale scale = SettingScale::digits();
        std::int64_t place = scale.firstFrom(1e-6);
        QCOMPARE(scale.at(place), 1e-6);
        for (; scale.at(place) < 1e5; ++place) {
            const double value = scale.at(place);
            const std::string text = numberText(value);
            const bool one = text[text.find_first_of("123456789")] == '1';
            QVERIFY2(significantDigits(value) <= (one ? 3U : 2U), text.c_str());
            QVERIFY(scale.at(place + 1) / value < 1.0501);
        }
    }

    void dwellsAreWholeRevolutions() {
        for (const double speed_rpm : {20.0, 180.0, 233.0, 1500.0}) {
            const SettingScale scale = SettingScale::revolutions(speed_rpm);
            for (std::int64_t turns = 0; turns < 60; ++turns) {
                QCOMPARE(std::llround(scale.at(turns) * speed_rpm / 60), (long long)turns);
            }
        }
    }
};

} // namespace sparkout::test_setting_scale

SPARKOUT_TEST(test_setting_scale, TestSettingScale)
#include "test_setting_scale.moc"
