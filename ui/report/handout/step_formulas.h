// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/simulation/trajectory.h"
#include "ui/report/format/formula_writer.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/citations.h"

#include <QCoreApplication>

#include <optional>
#include <set>

namespace sparkout::report {

/// The formulas of a step, and their symbols.
struct StepBlocks {
    std::vector<Block> blocks;
    std::set<QString> symbols;
};

/// The formulas of one step, each sheet with its sources and the symbols not yet explained.
class StepFormulas {
    Q_DECLARE_TR_FUNCTIONS(StepFormulas)
public:
    StepFormulas(const Project& project, const Place& at, Citations& citations,
                 std::optional<LeftOut> leftOut = {});
    void add(const FormulaSheet& sheet);
    void say(const QString& text) { m_blocks.emplace_back(Paragraph{text}); }
    void add(Block block) { m_blocks.push_back(std::move(block)); }
    [[nodiscard]] StepBlocks take() { return {std::move(m_blocks), std::move(m_symbols)}; }

private:
    void explain(const FormulaSheet& sheet);

    Place m_at;
    Citations& m_citations;
    FormulaWriter m_writer;
    std::set<QString> m_explained; ///< inputs, and symbols with their meanings
    std::set<QString> m_symbols;   ///< already explained symbols
    std::vector<Block> m_blocks;
};

} // namespace sparkout::report
