// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Every variant is valid, not solved as given and solved by the best of its grid; the same seed
// gives the same; what cannot be met ends and says why.
#include "core/lesson/goal_check.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"
#include "core/project/validate.h"
#include "core/search/optimise.h"
#include "core/setup/setup_file.h"
#include "core/statistics/philox.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

#include <set>

namespace sparkout::test_make_variants {

using nlohmann::json;

Answer answerWith(const Setup& setup) {
    Answer answer;
    answer.setup.text = writeSetup(setup);
    return answer;
}

long long refusedBy(const MadeVariants& made, VariantFault fault) {
    return made.refused[static_cast<std::size_t>(fault)];
}

class TestMakeVariants : public QObject {
    Q_OBJECT

private slots:
    void everyVariantIsSolvableAndUnsolved_data() {
        QTest::addColumn<QString>("file");
        for (const auto& file : samples::lessonFiles()) {
            addRow(file.filename().string().c_str(), QString::fromStdString(file.string()));
        }
    }
    void everyVariantIsSolvableAndUnsolved() {
        QFETCH(QString, file);
        const Lesson lesson = readLesson(samples::readText(file.toStdString())).lesson.value();
        const auto count = static_cast<std::size_t>(samples::sized(6, 2, 60));
        RunningTimer timer;
        const MadeVariants made = makeVariants(lesson, count, 2026);
        qInfo("%zu variants in %lld tries and %.1f s", made.variants.size(), made.tries,
              double(timer.elapsed()) / 1000);
        QCOMPARE(made.variants.size(), count);
        std::set<VariantLevels> seen;
        for (const MadeVariant& variant : made.variants) {
            QVERIFY(seen.insert(variant.levels).second);
            checkOne(lesson, made, variant);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }

    void theBestIsThatOfEveryCycleOfTheGrid() {
        const Lesson lesson = samples::lesson();
        const MadeVariants made = makeVariants(lesson, 3, 7);
        QCOMPARE(made.variants.size(), std::size_t{3});
        for (const MadeVariant& variant : made.variants) {
            const Lesson given = withVariant(lesson, variant.levels, {});
            SearchOptions options;
            options.method = SearchMethod::full;
            const SearchSummary full = optimise(given.base.surfaces.front().project, options);
            QCOMPARE(full.best->time_s / 60, variant.best->time_min);
        }
    }

    void theSameSeedGivesTheSame() {
        const Lesson lesson = samples::lesson();
        const auto levels = [&](std::size_t count, std::uint32_t seed) {
            std::vector<VariantLevels> all;
            for (const MadeVariant& variant : makeVariants(lesson, count, seed).variants) {
                all.push_back(variant.levels);
            }
            return all;
        };
        const auto some = levels(6, 11);
        QVERIFY(some == levels(6, 11));
        QVERIFY(some != levels(6, 12));
        const auto more = levels(9, 11); // a larger group begins with the same
        QVERIFY(std::equal(some.begin(), some.end(), more.begin()));
    }

    /// The draws are those of the generator, which has published vectors of its own: on any
    /// machine.
    void theDrawsAreThese() {
        Lesson lesson = samples::lesson();
        lesson.variants->difficulty = {0, 100'000, 1000};
        lesson.steps.resize(3); // nothing is searched
        const MadeVariants made = makeVariants(lesson, 4, 1);
        QCOMPARE(made.tries, 4LL);
        const VariantLevels counts = levelCounts(lesson);
        QVERIFY((counts == VariantLevels{9, 9, 8, 4}));
        for (std::size_t i = 0; i < made.variants.size(); ++i) {
            for (std::size_t k = 0; k < counts.size(); ++k) {
                const std::uint64_t bits =
                    randomBits(1, RandomStream::variant, i, static_cast<std::uint32_t>(k));
                QCOMPARE(made.variants[i].levels[k],
                         static_cast<std::size_t>((bits >> 32) * counts[k] >> 32));
            }
        }
    }

    void impossibleDemandsSayWhatRefusedThem_data() {
        addColumns<QString, QString, int>("pointer", "value", "fault");
        const auto row = [](const char* name, const char* pointer, const char* value,
                            VariantFault fault) {
            addRow(name, pointer, value, static_cast<int>(fault));
        };
        row("best too slow", "/variants/difficulty", R"({"most_time_percent": 100})",
            VariantFault::tooSlow);
        row("best too quick", "/variants/difficulty", R"({"least_time_percent": 100})",
            VariantFault::tooQuick);
        row("margin", "/variants/difficulty",
            R"({"least_time_percent": 0, "most_time_percent": 9999, "margin_within_percent": 0})",
            VariantFault::otherMargin);
        row("alike", "/variants/inputs", R"([{"path": "/wheel/dullness", "list": [0.02, 0.021]}])",
            VariantFault::alike);
        row("invalid", "/variants/inputs", R"([{"path": "/wheel/width_mm", "list": [2000, 2001]}])",
            VariantFault::invalid);
        row("solved as given", "/steps/6/goal/time/within_percent_of_best", "900",
            VariantFault::solved);
        row("nothing is free", "/steps/6/inputs", "[]", VariantFault::notFree);
        row("no figure", "/steps/1/goal/prediction/figure/count", "5000", VariantFault::noFigure);
        row("figure below its bound", "/variants/figures",
            R"([{"figure": {"name": "diameter_spread_um"}, "least": 500}])",
            VariantFault::otherFigure);
        row("figure above its bound", "/variants/figures",
            R"([{"figure": {"name": "diameter_spread_um"}, "step": 3, "most": 0.1}])",
            VariantFault::otherFigure);
        row("no figure to bound", "/variants/figures",
            R"([{"figure": {"name": "lag_um", "place": "nz", "count": 5000}, "most": 1}])",
            VariantFault::noFigure);
        row("figure out of reach", "/steps/5/goal/figure/value", "500", VariantFault::unattained);
        row("no answer", "/variants/inputs",
            R"([{"path": "/part/tolerance/radial_runout_um", "list": [1e-6, 2e-6]}])",
            VariantFault::noAnswer);
    }
    void impossibleDemandsSayWhatRefusedThem() {
        QFETCH(QString, pointer);
        QFETCH(QString, value);
        QFETCH(int, fault);
        json file = samples::lessonJsonOf();
        if (pointer == u"/variants/inputs") { // of these alone
            file["variants"]["difficulty"] = {{"least_time_percent", 0},
                                              {"most_time_percent", 9999},
                                              {"margin_within_percent", 1000}};
        }
        file[json::json_pointer(pointer.toStdString())] = json::parse(value.toStdString());
        if (pointer != u"/variants/inputs") {
            file["variants"]["inputs"] = {
                {{"path", "/wheel/dullness"}, {"list", {0.03, 0.036, 0.012, 0.01}}}};
        }
        const MadeVariants made = makeVariants(samples::lessonOf(file), 6, 3);
        QVERIFY(made.variants.size() < 6);
        QCOMPARE(made.tries, mostTries(6));
        QVERIFY2(refusedBy(made, static_cast<VariantFault>(fault)) > 0, refusedText(made).c_str());
        long long all = static_cast<long long>(made.variants.size());
        for (const long long count : made.refused) {
            all += count;
        }
        QCOMPARE(all, made.tries);
    }

    void aLessonThatCannotBeSearchedSaysSo() {
        json file = samples::lessonJsonOf();
        file["project"].erase("optimisation");
        QVERIFY(makeVariants(samples::lessonOf(file), 2, 1).fault == LessonFault::noGrid);
        file = samples::lessonJsonOf();
        file["project"]["part"]["tolerance"]["radial_runout_um"] = 1e-6;
        QVERIFY(makeVariants(samples::lessonOf(file), 2, 1).fault == LessonFault::noReference);
    }

    void withoutVariantsAllHaveTheSame() {
        json file = samples::lessonJsonOf();
        file.erase("variants");
        const Lesson lesson = samples::lessonOf(file);
        const MadeVariants made = makeVariants(lesson, 3, 1);
        QCOMPARE(made.variants.size(), std::size_t{3});
        QVERIFY(made.variants[0].levels.empty());
        QCOMPARE(made.variants[2].best->time_min, made.reference->time_min);
    }

    void aStopEndsIt() {
        const StoppedSource stop;
        const MadeVariants made = makeVariants(samples::lesson(), 5, 1, stop.get_token());
        QVERIFY(made.isStopped);
        QVERIFY(made.variants.empty());
    }

    void timesAllowedAreRoundedUp() {
        QCOMPARE(timeAllowed_min(2, 20), 2.4);
        QCOMPARE(timeAllowed_min(2.0001, 20), 2.401);
        QCOMPARE(timeAllowed_min(2, 0), 2.0);
    }

private:
    static std::string refusedText(const MadeVariants& made) {
        std::string text;
        for (const long long count : made.refused) {
            text += std::to_string(count) + ' ';
        }
        return text;
    }

    static void checkOne(const Lesson& lesson, const MadeVariants& made,
                         const MadeVariant& variant) {
        const auto best_min = variant.best ? std::optional(variant.best->time_min) : std::nullopt;
        const Lesson given = withVariant(lesson, variant.levels, best_min);
        for (std::size_t i = 0; i < given.steps.size(); ++i) {
            const Setup setup = setupOf(given, i);
            for (const GroundSurface& surface : setup.surfaces) {
                QVERIFY(!hasErrors(validate(surface.project)));
            }
            const Goal& goal = given.steps[i].goal;
            if (isMetBySetting(goal.kind())) {
                QVERIFY(!checkStep(given, i, answerWith(setup)).passed());
            }
            if (goal.time || goal.requirements) {
                Setup solved = setup;
                solved.surfaces.front().project = samples::solving(variant.best->project, goal);
                QVERIFY(checkStep(given, i, answerWith(solved)).passed());
            }
        }
        if (best_min) {
            const Difficulty& bounds = lesson.variants->difficulty;
            const double share = 100 * *best_min / made.reference->time_min;
            QVERIFY(share >= bounds.least_time_percent - 1e-6
                    && share <= bounds.most_time_percent + 1e-6);
            QVERIFY(std::abs(variant.best->margin_percent - made.reference->margin_percent)
                    <= bounds.margin_within_percent + 1e-6);
        }
    }
};

} // namespace sparkout::test_make_variants

SPARKOUT_TEST(test_make_variants, TestMakeVariants)
#include "test_make_variants.moc"
