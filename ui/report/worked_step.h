// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/course_handout.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>
#include <QSet>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace sparkout::report {

/// Gathers the keys of core/SOURCES.md that are cited, in their order.
class Citations {
    Q_DECLARE_TR_FUNCTIONS(Citations)
public:
    QString cite(const QString& key);  ///< "[MODEL-3]"
    [[nodiscard]] Table table() const; ///< the keys with their sources

private:
    QStringList m_keys;
};

/// The formulas of a step, and their symbols.
struct StepBlocks {
    std::vector<Block> blocks;
    std::set<QString> symbols;
};

/// The step that the hand-out works out: its place, its formulas and its limits.
class WorkedStep {
    Q_DECLARE_TR_FUNCTIONS(WorkedStep)
public:
    /// The parts that a worksheet leaves out: the results, and the numbers of these symbols.
    using Hidden = std::optional<QSet<QString>>;

    static Facts facts(const Outcome& outcome, const HandoutStep& step, bool results = true);
    /// Force law, balance and limits of the step. With `hidden` its results and the numbers of
    /// those symbols are left out.
    static StepBlocks formulas(const Outcome& outcome, const HandoutStep& step,
                               Citations& citations, const Hidden& hidden = {});
    static Table limits(const Outcome& outcome, const HandoutStep& step, bool results = true);
};

/// The task of the hand-out, and the inputs for it.
class HandoutTask {
    Q_DECLARE_TR_FUNCTIONS(HandoutTask)
public:
    static Facts header(const Project& project, const QString& file, const QDate& date);
    static QString task(const Outcome& outcome); ///< with the cycle time
    static QString part(const Project& project); ///< the ground part
    /// The inputs in the formulas, and those behind the step's feed and stock.
    static Table inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                        const std::set<QString>& symbols, Citations& citations,
                        const std::function<bool(std::string_view path)>& hides = {});
};

} // namespace sparkout::report
