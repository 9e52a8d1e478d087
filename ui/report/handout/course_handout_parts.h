// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/formula_writer.h"
#include "ui/report/handout/course_handout.h"
#include "ui/report/handout/exercises.h"

#include <QCoreApplication>
#include <QStringList>

/// The parts of the course hand-out.
namespace sparkout::report {

/// Gathers the keys of core/SOURCES.md that are cited, in their order.
class Citations {
public:
    QString cite(const QString& key); ///< "[MODEL-3]"
    [[nodiscard]] const QStringList& keys() const { return m_keys; }

private:
    QStringList m_keys;
};

/// The formulas of a step, and the symbols that stand in them.
struct StepBlocks {
    std::vector<Block> blocks;
    std::set<QString> symbols;
};

class CourseHandout {
    Q_DECLARE_TR_FUNCTIONS(CourseHandout)
public:
    static Facts header(const Project& project, const QString& file, const QDate& date);
    static QString task(const Outcome& outcome);
    /// Those that stand in the formulas, and what the step's feed and stock come from.
    static Table inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                        const std::set<QString>& symbols, Citations& citations);
    static Facts stepFacts(const Outcome& outcome, const HandoutStep& step);
    /// Force law, balance and limits of the step.
    static StepBlocks stepFormulas(const Outcome& outcome, const HandoutStep& step,
                                   Citations& citations);
    static Table limits(const Outcome& outcome, const HandoutStep& step);
    static std::vector<Block> figures(const OutcomePtr& outcome,
                                      const std::optional<HandoutStep>& step,
                                      const std::set<HandoutView>& views,
                                      const std::function<void()>& breathe);
    static std::vector<Block> questions(const std::vector<Exercise>& exercises);
    static std::vector<Block> answers(const std::vector<Exercise>& exercises, Operation operation);
    static Table sources(const Citations& citations);
};

} // namespace sparkout::report
