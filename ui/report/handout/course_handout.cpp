// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/course_handout.h"

#include "ui/report/handout/course_handout_parts.h"
#include "ui/report/parts/cycle_card_parts.h"
#include "ui/report/parts/part_sketch.h"
#include "ui/report/parts/report_values.h"
#include "ui/views/verdict/verdict_text.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace sparkout::report {

namespace {

constexpr std::array viewRows{
    HandoutViewRow{HandoutView::feeds, "feeds",
                   QT_TRANSLATE_NOOP("HandoutView", "Feeds around the step, with E1…E5")},
    HandoutViewRow{HandoutView::cycle, "cycle",
                   QT_TRANSLATE_NOOP("HandoutView", "Feeds over the whole cycle")},
    HandoutViewRow{HandoutView::profiles, "profiles",
                   QT_TRANSLATE_NOOP("HandoutView", "Zone profiles at the end")},
    HandoutViewRow{HandoutView::limits, "limits",
                   QT_TRANSLATE_NOOP("HandoutView", "Actual feed under its limits")},
};

/// The blocks of the hand-out, section by section.
class HandoutBlocks {
public:
    explicit HandoutBlocks(std::vector<Block>& blocks) : m_blocks(blocks) {}
    void heading(const QString& text) { m_blocks.emplace_back(Heading{text}); }
    void add(Block block) { m_blocks.push_back(std::move(block)); }
    void add(std::vector<Block> blocks) { std::ranges::move(blocks, std::back_inserter(m_blocks)); }

private:
    std::vector<Block>& m_blocks;
};

void addStep(HandoutBlocks& blocks, const Outcome& outcome, const std::optional<HandoutStep>& step,
             const std::vector<Block>& formulas) {
    blocks.heading(CourseHandout::tr("The step worked out"));
    if (!step) {
        blocks.add(Paragraph{CourseHandout::tr(
            "The cycle is too long to be recorded, so no step of it can be worked out.")});
        return;
    }
    blocks.add(CourseHandout::stepFacts(outcome, *step));
    blocks.add(Paragraph{CourseHandout::tr(
        "Every formula stands in symbols, then with its numbers, then with its result. Numbers are "
        "put in with as many digits as the printed result needs.")});
    blocks.add(formulas);
}

} // namespace

std::span<const HandoutViewRow> handoutViews() {
    return viewRows;
}

std::optional<std::set<HandoutView>> readHandoutViews(const QString& text) {
    std::set<HandoutView> views;
    for (const QString& word : text.split(u',', Qt::SkipEmptyParts)) {
        const auto row = std::ranges::find_if(viewRows, [&](const HandoutViewRow& r) {
            return word.trimmed() == QLatin1StringView(r.key);
        });
        if (row == viewRows.end()) {
            return {};
        }
        views.insert(row->view);
    }
    return views;
}

QString handoutViewText(const std::set<HandoutView>& views) {
    QStringList keys;
    for (const HandoutViewRow& row : viewRows) {
        if (views.contains(row.view)) {
            keys << QString::fromLatin1(row.key);
        }
    }
    return keys.join(u',');
}

Report courseHandout(const OutcomePtr& outcome, const QString& file, const QDate& date,
                     const HandoutOptions& options, const std::function<void()>& breathe) {
    const Project& project = outcome->result.project;
    Report report = begunReport(CourseHandout::tr("Course hand-out"), project, file, date);
    std::optional<HandoutStep> step = findStep(outcome->trajectory, options.step);
    if (!step) {
        step = findStep(outcome->trajectory); // roughing was over before it began
    }
    const std::vector<Exercise> exercises = makeExercises(*outcome, step, breathe);
    HandoutBlocks blocks(report.blocks);
    blocks.add(CourseHandout::header(project, file, date));
    blocks.heading(CourseHandout::tr("The task"));
    blocks.add(Paragraph{CourseHandout::task(*outcome)});
    blocks.add(partSketch(outcome));
    blocks.heading(CourseHandout::tr("Stages of the cycle"));
    blocks.add(CycleCard::stages(*outcome));
    blocks.heading(CourseHandout::tr("Inputs of the formulas"));
    Citations citations;
    const StepBlocks worked =
        step ? CourseHandout::stepFormulas(*outcome, *step, citations) : StepBlocks();
    blocks.add(CourseHandout::inputs(*outcome, step, worked.symbols, citations));
    addStep(blocks, *outcome, step, worked.blocks);
    if (auto figures = CourseHandout::figures(outcome, step, options.views, breathe);
        !figures.empty()) {
        blocks.heading(CourseHandout::tr("Figures"));
        blocks.add(std::move(figures));
    }
    if (!exercises.empty()) {
        blocks.heading(CourseHandout::tr("Questions"));
        blocks.add(CourseHandout::questions(exercises));
    }
    blocks.heading(CourseHandout::tr("Sources"));
    blocks.add(CourseHandout::sources(citations));
    if (options.answers && !exercises.empty()) {
        blocks.add(PageBreak{});
        blocks.heading(CourseHandout::tr("Answers"));
        blocks.add(CourseHandout::answers(exercises, project.operation));
    }
    return report;
}

} // namespace sparkout::report
