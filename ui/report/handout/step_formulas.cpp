// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/step_formulas.h"

#include "core/project/leaves.h"
#include "ui/report/handout/formula_meanings.h"
#include "ui/text/field_text.h"
#include "ui/text/formula_text.h"

#include <algorithm>
#include <utility>

namespace sparkout::report {

StepFormulas::StepFormulas(const Project& project, const Place& at, Citations& citations,
                           std::optional<LeftOut> leftOut)
    : m_at(at), m_citations(citations), m_writer(std::move(leftOut)) {
    m_explained.insert(QStringLiteral("γ")); // among the inputs, too
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (*leaf.field->symbol && singleNumberIn(*leaf.field, leaf.owner)) {
            m_explained.insert(QString::fromUtf8(leaf.field->symbol));
        }
    }
}

void StepFormulas::add(const FormulaSheet& sheet) {
    m_blocks.emplace_back(Heading{QCoreApplication::translate("Formula", sheet.name)});
    QStringList sources;
    for (const FormulaSource& source : sourcesOf(sheet, m_at)) {
        const QString key = m_citations.cite(QString::fromLatin1(source.key));
        sources << (*source.equations ? tr("%1, eq. %2", "key of a source, its equation")
                                            .arg(key, QString::fromLatin1(source.equations))
                                      : key);
    }
    say(tr("Source: %1").arg(sources.join(QStringLiteral("; "))));
    for (Block& block : m_writer.write(sheet)) {
        m_blocks.push_back(std::move(block));
    }
    explain(sheet);
}

void StepFormulas::explain(const FormulaSheet& sheet) {
    Table table;
    table.head = {tr("Symbol"), tr("Meaning")};
    table.texts = {true, true};
    table.symbols = true;
    const auto explainTerm = [&](const FormulaTerm& term) {
        const QString symbol = QString::fromUtf8(term.symbol);
        if (!isConstant(term)) {
            m_symbols.insert(symbol);
        }
        const QString meaning = isConstant(term) ? QString() : symbolMeaning(sheet, term.symbol);
        if (!meaning.isEmpty() && !m_explained.contains(symbol)
            && m_explained.insert(symbol + u'=' + meaning).second) {
            table.rows.push_back({symbol, meaning});
        }
    };
    for (const FormulaStep& step : sheet.steps) {
        explainTerm(step.result);
        std::ranges::for_each(step.terms, explainTerm);
    }
    if (!table.rows.empty()) {
        m_blocks.emplace_back(std::move(table));
    }
}

} // namespace sparkout::report
