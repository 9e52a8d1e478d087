// SPDX-License-Identifier: GPL-3.0-or-later
// What can have left the waves counted on a part: by the speeds, known frequencies and the work;
// and the counts of another speed, by which the causes are told apart.
#include "core/study/wave_causes.h"

#include "core/project/machine.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <cmath>
#include <numbers>

namespace sparkout::test_wave_causes {

/// A wheel of so many revolutions a minute over a work of so many.
Project turning(double wheel_rpm, double work_rpm) {
    Project project = fixtures::plunge();
    project.machine->work_speed_rpm = work_rpm;
    project.machine->wheel_speed_m_s =
        std::numbers::pi * project.wheel->diameter_mm * wheel_rpm / 60'000;
    return project;
}

const WaveCause* causeOf(const std::vector<WaveCause>& causes, WaveSource source) {
    const auto found = std::ranges::find(causes, source, &WaveCause::source);
    return found == causes.end() ? nullptr : &*found;
}

class TestWaveCauses : public QObject {
    Q_OBJECT

private slots:
    // Some 70 waves at 40 rev/min of the work: the wheel turns 2800 times a minute.
    void theCountOfALetterIsThatOfTheWheel() {
        const std::vector<WaveCause> causes = waveCauses(turning(2800, 40), {70, {25, 100}});
        const WaveCause* const wheel = causeOf(causes, WaveSource::wheel);
        QVERIFY(wheel && wheel == causes.data());
        QCOMPARE(wheel->lobes, 1);
        QCOMPARE(wheel->turns, 1);
        QVERIFY(std::abs(wheel->waves - 70) < 1e-9);
        // 25 Hz leaves 37.5 a turn, 75 in two; 100 Hz 150: neither is 70.
        QVERIFY(!causeOf(causes, WaveSource::frequency));
        QVERIFY(causes.back().source == WaveSource::work);
    }

    void theTestTellsTheCausesApart() {
        for (const int count : {8, 33, 70, 400}) {
            const double counted = count;
            const Project project = turning(counted * 60, 60);
            const WaveTest test = waveTest(project, count);
            const std::vector<WaveCause> causes = waveCauses(project, {count, {counted}});
            const WaveCause* const wheel = causeOf(causes, WaveSource::wheel);
            const WaveCause* const other = causeOf(causes, WaveSource::frequency);
            QVERIFY(wheel && other);
            // Of the work the count stays; of time it falls with a faster work, by whole waves.
            const double fewer = counted - std::max(2.0, std::ceil(0.03 * counted));
            QCOMPARE(causes.back().atOtherWork, counted);
            QVERIFY(std::abs(wheel->atOtherWork - fewer) < 1e-9);
            QVERIFY(std::abs(fewer * test.workSpeed_rpm - counted * 60) < 1e-6);
            QCOMPARE(wheel->atOtherWork, other->atOtherWork);
            // The wheel's alone moves with the wheel.
            QCOMPARE(other->atOtherWheel, other->waves);
            QVERIFY(std::abs(wheel->atOtherWheel - fewer) < 1e-9);
        }
    }

    void lobesTurnsAndTheWheelHead() {
        Project project = turning(1200, 100); // 12 a turn
        QCOMPARE(causeOf(waveCauses(project, {36, {}}), WaveSource::wheel)->lobes, 3);
        project = turning(1250, 100); // 12.5 a turn: 25 in two
        const std::vector<WaveCause> causes = waveCauses(project, {25, {}});
        QCOMPARE(causeOf(causes, WaveSource::wheel)->turns
                     * causeOf(causes, WaveSource::wheel)->lobes,
                 2);
        QVERIFY(!causeOf(causes, WaveSource::wheelHead));
        // At 35 a turn two turns leave 35, not 70: that takes two waves around the wheel.
        const auto wholes = waveCauses(turning(1400, 40), {70, {}});
        QCOMPARE(wholes.size(), 2U);
        QCOMPARE(wholes.front().lobes, 2);
        QCOMPARE(wholes.front().turns, 1);
        project.machine->wheel_head_frequency_hz = 200; // 120 a turn
        QVERIFY(causeOf(waveCauses(project, {120, {}}), WaveSource::wheelHead));
    }

    void aCountIsRightToThreePerCentAndToOneWave() {
        QVERIFY(isCounted(10, 11) && !isCounted(10, 11.01));
        QVERIFY(isCounted(200, 206) && !isCounted(200, 206.1));
    }
};

} // namespace sparkout::test_wave_causes

SPARKOUT_TEST(test_wave_causes, TestWaveCauses)
#include "test_wave_causes.moc"
