// SPDX-License-Identifier: GPL-3.0-or-later
// A run judged by its batch and by measured parts, from one run of the batch.
#include "core/batch/batch_run.h"
#include "core/measured/adequacy.h"
#include "core/project/batch.h"
#include "core/study/whole_batch.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sparkout::test_batch_judgement {

Project exampleOf(const char* name) {
    return samples::projectIn("resources/examples/" + std::string(name) + ".sparkout");
}

/// The judgements, and the number of parts that were run for them.
struct Counted {
    BatchJudgement judged;
    std::int64_t parts = 0;
};

Counted countedBatch(const Project& project) {
    Counted counted;
    BatchOptions options;
    options.sink = [&counted](const PartRecord&) {
        ++counted.parts;
        return true;
    };
    counted.judged = judgeBatchOf(project, options);
    return counted;
}

bool isSame(const std::optional<Interval>& a, const std::optional<Interval>& b) {
    return a.has_value() == b.has_value() && (!a || (a->low == b->low && a->high == b->high));
}

class TestBatchJudgement : public QObject {
    Q_OBJECT

private slots:
    /// The same as by two batches: one of the project, one that predicts the measured parts.
    void oneRunJudgesBatchAndMeasuredParts() {
        for (const char* name : {"shaft-30h6-calibrated", "shaft-30h6-measured"}) {
            for (const bool hasLimits : {true, false}) { // else the prediction adds its own
                Project project = exampleOf(name);
                if (!hasLimits) {
                    project.part->tolerance.roundness_um.reset();
                    project.part->tolerance.roughness_ra_um.reset();
                }
                const Counted one = countedBatch(project);
                QVERIFY(one.judged.issues.empty());
                QCOMPARE(one.parts, std::int64_t{project.batch->parts});
                const BatchResult batch = runBatch(project);
                const JudgedBatch apart = judgeBatch(batch, summarise(batch));
                QVERIFY2(one.judged.batch, name);
                QCOMPARE(one.judged.batch->parts, apart.parts);
                QCOMPARE(one.judged.batch->bad, apart.bad);
                QCOMPARE(one.judged.batch->seed, apart.seed);
                QCOMPARE(one.judged.batch->isWhole, apart.isWhole);
                QVERIFY(isSame(one.judged.batch->interval, apart.interval));
                QVERIFY(isSame(one.judged.batch->lowPpk, apart.lowPpk));
                const std::optional<MeasuredBias> bias = greatestBias(
                    project, judgeAdequacy(project, runBatch(predictingProject(project))));
                QCOMPARE(one.judged.measured.has_value(), bias.has_value());
                QVERIFY(!bias
                        || (one.judged.measured->bias_um == bias->bias_um
                            && one.judged.measured->section == bias->section));
            }
        }
    }

    void measuredPartsThatAreMovedAreABias() {
        Project project = exampleOf("shaft-30h6-calibrated");
        constexpr double moved_um = 20;
        project.measured->summaries.front().mean_um += moved_um;
        const BatchJudgement judged = judgeBatchOf(project);
        QVERIFY(judged.measured && judged.measured->kind == ConstraintKind::diameterMin);
        QVERIFY(std::abs(judged.measured->bias_um - moved_um) < 2);
    }

    void withoutABatchMeasuredPartsAreJudged() {
        Project project = exampleOf("shaft-30h6-calibrated");
        project.measured->summaries.front().mean_um += 20;
        project.batch.reset();
        const BatchJudgement judged = judgeBatchOf(project);
        QVERIFY(!judged.batch && judged.measured);
        project.measured.reset();
        const Counted nothing = countedBatch(project);
        QVERIFY(nothing.parts == 0 && !nothing.judged.batch && !nothing.judged.measured);
    }

    void aBatchThatCannotBeRunSaysWhy() {
        Project project = exampleOf("shaft-30h6-factory");
        project.batch->factors.stock_mm = Factor{};
        project.batch->factors.stock_mm->uniform = std::vector<double>{-1, 5};
        const BatchJudgement judged = judgeBatchOf(project);
        QVERIFY(hasErrors(judged.issues) && !judged.batch && !judged.measured);
    }
};

} // namespace sparkout::test_batch_judgement

SPARKOUT_TEST(test_batch_judgement, TestBatchJudgement)
#include "test_batch_judgement.moc"
