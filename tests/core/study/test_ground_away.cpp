// SPDX-License-Identifier: GPL-3.0-or-later
// Infeeds larger than the part: the run ends with a status of its own, and nothing that reads its
// radii is upset by them.
#include "core/quality/result_names.h"
#include "core/study/outcome.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_ground_away {

using nlohmann::json;

class TestGroundAway : public QObject {
    Q_OBJECT

private slots:
    /// A revolution in a minute at 99 mm/min, where the radius is 15 mm.
    void aPlungeThroughTheAxisSaysSo() {
        json file = samples::sample("smallest-plunge");
        file["machine"]["work_speed_rpm"] = 1;
        file["cycle"]["stages"][0]["radial_feed_mm_min"] = 99;
        const OutcomePtr outcome = outcomeOf(file);
        QCOMPARE(outcome->result.status, RunStatus::groundAway);
        QCOMPARE(std::string(statusKey(outcome->result.status)), std::string("ground_away"));
    }

    /// A stroke that crawls for hours while the wheel is fed: fits of the form find radii that no
    /// surface has.
    void aContinuousInfeedThroughTheAxisSaysSo() {
        json file = samples::sample("smallest-traverse");
        file["part"]["lower_deviation_um"] = -2000;
        file["part"]["tolerance"]["cylindricity_um"] = 5;
        file["gauge"]["delay_s"] = 22;
        file["cycle"]["stages"] = {
            {{"radial_feed_mm", 0.004}, {"axial_feed_mm_min", 1800}, {"stock_mm", 0.1}},
            {{"radial_feed_mm", 0.4},
             {"axial_feed_mm_min", 0.01},
             {"continuous_feed_mm_min", 7.4},
             {"stock_mm", 0.05}}};
        QCOMPARE(outcomeOf(file)->result.status, RunStatus::groundAway);
    }

    void aPartOfWhichSomethingIsLeftIsNotGroundAway() {
        json file = samples::sample("smallest-plunge");
        file["machine"]["work_speed_rpm"] = 1;
        file["cycle"]["stages"][0]["radial_feed_mm_min"] = 9;
        QCOMPARE(outcomeOf(file)->result.status, RunStatus::completed);
    }

private:
    static OutcomePtr outcomeOf(const json& file) {
        const ReadResult read = readProject(file.dump());
        return read.project ? evaluate(*read.project, {}) : nullptr;
    }
};

} // namespace sparkout::test_ground_away

SPARKOUT_TEST(test_ground_away, TestGroundAway)
#include "test_ground_away.moc"
