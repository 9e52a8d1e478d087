// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"
#include "core/lesson/goal_check.h"
#include "core/study/outcome.h"
#include "ui/report/course/paper_writer.h"
#include "ui/report/course/student_view.h"
#include "ui/report/handout/handout_view.h"

#include <QCoreApplication>
#include <QString>

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sparkout::report {

/// The results of a work, step by step: every number is computed by the engine from what was handed
/// in.
class StepResults {
    Q_DECLARE_TR_FUNCTIONS(StepResults)
public:
    StepResults(const Work& work, const StudentView& view, const std::set<HandoutView>& figures,
                const std::function<void()>& breathe);

    /// Writes the answers to a step and their results, in tables and figures.
    void write(PaperWriter& paper, std::size_t step);
    /// All predictions beside the engine's values; no rows if there are none.
    [[nodiscard]] Table predictions() const;
    /// The differences between the given project and the kept runs. No rows without runs.
    [[nodiscard]] Table keptRuns() const;
    [[nodiscard]] const GoalResult& result(std::size_t step) const { return m_results[step]; }

private:
    struct Run {
        OutcomePtr outcome;
        std::map<QString, int> figures; ///< numbers of figures by their contents
    };
    [[nodiscard]] const Project& given(std::size_t step) const;
    /// The run for a step; null if it was not possible.
    Run* runOf(std::size_t step);
    [[nodiscard]] Table changes(std::size_t step, const Project& set) const;
    void writeSetting(PaperWriter& paper, std::size_t step, Run& run) const;
    void writePrediction(PaperWriter& paper, std::size_t step) const;
    void writeCurve(PaperWriter& paper, std::size_t step) const;
    void writeOrder(PaperWriter& paper, std::size_t step) const;
    void writeChoice(PaperWriter& paper, std::size_t step) const;
    void writeFigures(PaperWriter& paper, std::size_t step, Run& run) const;

    const Work& m_work;
    const StudentView& m_view;
    const std::set<HandoutView>& m_figures;
    const std::function<void()>& m_breathe;
    std::vector<StepRecord> m_records;
    std::vector<GoalResult> m_results;
    std::vector<Setup> m_given;        ///< initial set-up of each step
    std::map<std::string, Run> m_runs; ///< by the text of the set-up and the surface
};

} // namespace sparkout::report
