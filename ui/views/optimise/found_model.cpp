// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/found_model.h"

#include "core/optimisation/limit.h"
#include "core/units.h"
#include "ui/views/optimise/optimise_text.h"

#include <QFont>
#include <QLocale>

#include <cmath>
#include <utility>

namespace sparkout {

void FoundModel::show(SearchOutcomePtr outcome, std::optional<double> before_s) {
    beginResetModel();
    m_outcome = std::move(outcome);
    m_before_s = before_s;
    endResetModel();
}

void FoundModel::setBefore(std::optional<double> before_s) {
    m_before_s = before_s;
    cellsChanged();
}

QString FoundModel::text(const FoundCycle& found, int column) const {
    switch (column) {
    case stages: return QLocale().toString(qulonglong(found.cycle.stages.size()));
    case time: return OptimiseText::minutes(found.time_s);
    case change:
        return m_before_s && *m_before_s > 0 ? OptimiseText::percent(found.time_s / *m_before_s - 1)
                                             : QStringLiteral("–");
    case gap: return gapOf(found) ? OptimiseText::percent(*gapOf(found)) : QStringLiteral("–");
    case margin: return OptimiseText::percent(found.leastRelativeMargin);
    case cycle: return OptimiseText::found(found, m_outcome->project);
    case parts: return found.held ? OptimiseText::parts(*found.held) : QStringLiteral("–");
    case cost: return found.cost ? OptimiseText::cost(*found.cost) : QStringLiteral("–");
    default: return {};
    }
}

std::optional<double> FoundModel::gapOf(const FoundCycle& found) const {
    return gapToLimit(found.time_s, m_outcome->limit.time_s);
}

QString FoundModel::kindOf(const FoundCycle& found) const {
    if (m_outcome->marginWithin_us && (found.isBest || found.isBestOfItsNumber)) {
        return found.isBest
                   ? tr("The farthest of the grid from its limits within the time given")
                   : tr("The farthest of its number of stages from its limits, within the time");
    }
    if (m_outcome->wear && m_outcome->objective() == SearchObjective::cost) {
        return found.isBest ? tr("The cheapest of the grid")
                            : tr("The cheapest of its number of stages");
    }
    if (m_outcome->wear) {
        return found.isBest ? tr("The one of the grid that keeps the wheel longest")
                            : tr("The one of its number of stages that keeps the wheel longest");
    }
    if (found.isBest) {
        return tr("The quickest of the grid");
    }
    if (found.isBestOfItsNumber) {
        return tr("The quickest of its number of stages");
    }
    switch (found.by) {
    case FoundBy::search: break;
    case FoundBy::margin: return tr("None is both quicker and farther from its limits");
    case FoundBy::refinement: return tr("Between the levels of the grid, not proved");
    }
    return tr("The best so far when it was found");
}

QVariant FoundModel::cell(int row, int column, int role) const {
    if (row >= rowsShown()) {
        return {};
    }
    const FoundCycle& found = m_outcome->found[static_cast<std::size_t>(row)];
    switch (role) {
    case Qt::DisplayRole: return text(found, column);
    case Qt::TextAlignmentRole: return aligned(column != cycle);
    case Qt::FontRole: {
        QFont font;
        font.setBold(found.isBestOfItsNumber);
        return font;
    }
    case Qt::ToolTipRole: {
        const QString what = kindOf(found);
        return what + u'\n' + text(found, cycle) + u'\n'
               + OptimiseText::cycleHint(m_outcome->project.operation);
    }
    default: return {};
    }
}

QVariant FoundModel::side(int row, int role) const {
    return role == Qt::DisplayRole ? QVariant(row + 1) : QVariant();
}

QVariant FoundModel::head(int column, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(column != cycle);
    }
    if (role == Qt::DisplayRole) {
        switch (column) {
        case stages: return tr("Stages");
        case time: return tr("Time, min");
        case change: return tr("Against yours, %");
        case gap: return tr("Gap, %");
        case margin: return tr("Margin, %");
        case parts: return tr("Parts");
        case cost: return tr("Cost");
        default: return tr("Cycle");
        }
    }
    if (role != Qt::ToolTipRole) {
        return {};
    }
    switch (column) {
    case stages: return tr("Number of stages");
    case time: return tr("Machining time");
    case change:
        return tr("Against the time of your cycle: the present one, or the one that a cycle found "
                  "took the place of");
    case gap: return tr("By how much a stepless cycle might at most be quicker");
    case margin: return tr("The minimum margin of all requirements, of its limit");
    case parts: return tr("Parts from one dressing to the next that it holds for");
    case cost: return tr("Cost of a part with its share of the dressing");
    default:
        return m_outcome ? OptimiseText::cycleHint(m_outcome->project.operation)
                         : tr("Feeds and stocks of the stages");
    }
}

CsvTable FoundModel::table() const {
    CsvTable table;
    table.header << tr("Stages") << tr("Time, min") << tr("Against yours, %") << tr("Gap, %")
                 << tr("Margin, %") << tr("Cycle");
    if (hasInterval()) {
        table.header << tr("Parts") << tr("Cost");
    }
    for (int row = 0; row < rowsShown(); ++row) {
        const FoundCycle& found = m_outcome->found[static_cast<std::size_t>(row)];
        CsvCell toBefore;
        if (m_before_s && *m_before_s > 0) {
            toBefore = 100 * (found.time_s / *m_before_s - 1);
        }
        table.rows.push_back(
            {double(found.cycle.stages.size()), found.time_s / units::secondsPerMinute, toBefore,
             gapOf(found) ? CsvCell(100 * *gapOf(found)) : CsvCell(),
             100 * found.leastRelativeMargin, OptimiseText::found(found, m_outcome->project)});
        if (hasInterval()) {
            table.rows.back().push_back(found.held ? CsvCell(double(found.held->parts))
                                                   : CsvCell());
            table.rows.back().push_back(found.cost ? CsvCell(*found.cost) : CsvCell());
        }
    }
    return table;
}

} // namespace sparkout
