// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_model.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/kit/metrics.h"
#include "ui/part/status_text.h"
#include "ui/session/surface_edits.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>

#include <utility>

namespace sparkout {

namespace {

constexpr int timeDigits = 3; ///< after the point: the times stand below each other

QString shownMinutes(double time_s) {
    return Names::fixed(time_s / units::secondsPerMinute, timeDigits);
}

} // namespace

void PartModel::setPart(SetupState state, std::vector<SurfaceStatus> statuses) {
    const bool sameRows = state.surfaces.size() == m_state.surfaces.size();
    if (!sameRows) {
        beginResetModel();
    }
    m_state = std::move(state);
    m_statuses = std::move(statuses);
    sameRows ? cellsChanged() : endResetModel();
}

void PartModel::setStudy(int id, const SurfaceStudyPtr& study) {
    (study->kind == SurfaceStudy::Kind::search ? m_searches : m_batches)[id] = study;
    cellsChanged();
}

void PartModel::forgetStudies() {
    m_searches.clear();
    m_batches.clear();
    cellsChanged();
}

int PartModel::rowsShown() const {
    return static_cast<int>(m_state.surfaces.size());
}

QString PartModel::searchText(const SurfaceStudy& study) const {
    if (!study.isSetUp) {
        return tr("not set up");
    }
    if (!study.search || !study.search->ran()) {
        return tr("refused");
    }
    const FoundCycle* best = study.search->best();
    return best ? shownMinutes(best->time_s) : tr("none feasible");
}

QString PartModel::batchText(const SurfaceStudy& study) const {
    if (!study.isSetUp) {
        return tr("not set up");
    }
    if (!study.issues.empty() || !study.batch || !study.batch->ran()) {
        return tr("refused");
    }
    const BatchSummary& summary = study.batch->summary;
    return tr("%1 of %2 bad").arg(summary.bad.count).arg(summary.parts);
}

QString PartModel::text(std::size_t row, int column) const {
    const SurfaceState& of = *m_state.surfaces[row];
    const SurfaceStatus& status = m_statuses[row];
    switch (column) {
    case surface:
        return QStringLiteral("%1. %2").arg(row + 1).arg(
            printableText(SurfaceEdits::nameOf(m_state, row)));
    case diameter: return printedNumber(of.project.part->diameter_mm);
    case time: return status.ran() ? shownMinutes(status.time_s) : QString();
    case verdict: return statusText(status);
    case margin: return worstText(status);
    case search: {
        const auto found = m_searches.find(of.id);
        return found == m_searches.end() ? QString() : searchText(*found->second);
    }
    case batch: {
        const auto found = m_batches.find(of.id);
        return found == m_batches.end() ? QString() : batchText(*found->second);
    }
    default: return {};
    }
}

QVariant PartModel::cell(int row, int column, int role) const {
    const auto of = static_cast<std::size_t>(row);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole: return text(of, column);
    case Qt::TextAlignmentRole:
        return aligned(column == diameter || column == time || column == search || column == batch);
    case Qt::DecorationRole:
        return column == verdict
                   ? statusPixmap(m_statuses[of], metrics::iconSmall, qGuiApp->devicePixelRatio())
                   : QVariant();
    default: return {};
    }
}

QVariant PartModel::head(int column, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(column == diameter || column == time || column == search || column == batch);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case surface: return tr("Surface");
    case diameter: return tr("⌀, mm");
    case time: return tr("Cycle, min");
    case verdict: return tr("Verdict");
    case margin: return tr("Minimum margin");
    case search: return tr("Found, min");
    case batch: return tr("Batch");
    default: return {};
    }
}

QString PartModel::asTsv() const {
    QStringList lines;
    for (int row = -1; row < rowsShown(); ++row) {
        QStringList cells;
        for (int column = 0; column < columnCount_; ++column) {
            cells += row < 0 ? head(column, Qt::DisplayRole).toString()
                             : text(static_cast<std::size_t>(row), column);
        }
        lines += cells.join(u'\t');
    }
    return lines.join(u'\n');
}

} // namespace sparkout
