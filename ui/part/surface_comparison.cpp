// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/surface_comparison.h"

#include "core/quality/requirement.h"
#include "core/units.h"
#include "ui/charts/light_icon.h"
#include "ui/kit/metrics.h"
#include "ui/session/surface_edits.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QGuiApplication>

#include <algorithm>
#include <set>
#include <utility>

namespace sparkout {

void SurfaceComparison::setPart(const SetupState& state, std::vector<SurfaceStatus> statuses) {
    beginResetModel();
    m_statuses = std::move(statuses);
    m_names.clear();
    std::set<ConstraintKind> kinds;
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        m_names +=
            QStringLiteral("%1. %2").arg(i + 1).arg(printableText(SurfaceEdits::nameOf(state, i)));
        for (const ConstraintResult& requirement : m_statuses[i].requirements) {
            kinds.insert(requirement.kind);
        }
    }
    m_kinds.assign(kinds.begin(), kinds.end());
    endResetModel();
}

int SurfaceComparison::rowsShown() const {
    return 1 + static_cast<int>(m_kinds.size());
}

int SurfaceComparison::columnsShown() const {
    return 1 + static_cast<int>(m_statuses.size());
}

/// Null: the row or column names something, or the surface has no such requirement.
const ConstraintResult* SurfaceComparison::at(int row, int column) const {
    if (row < 1 || column < 1) {
        return nullptr;
    }
    const auto& all = m_statuses[static_cast<std::size_t>(column) - 1].requirements;
    const auto found =
        std::ranges::find(all, m_kinds[static_cast<std::size_t>(row) - 1], &ConstraintResult::kind);
    return found == all.end() ? nullptr : &*found;
}

QString SurfaceComparison::text(int row, int column) const {
    if (column == 0 && row == 0) {
        return tr("Cycle time, min");
    }
    if (column == 0) {
        const ConstraintKind kind = m_kinds[static_cast<std::size_t>(row) - 1];
        const char* const unit = requirementOf(kind).unit;
        const bool isEstimate =
            kind == ConstraintKind::roughness
            && std::ranges::any_of(m_statuses, &SurfaceStatus::isRoughnessEstimate);
        const QString name = isEstimate ? tr("Ra, estimate") : Names::constraint(kind);
        return *unit ? tr("%1, %2").arg(name, unitText(unit)) : name;
    }
    const SurfaceStatus& status = m_statuses[static_cast<std::size_t>(column) - 1];
    if (row == 0) {
        constexpr int decimals = 3;
        return status.ran() ? Names::fixed(status.time_s / units::secondsPerMinute, decimals)
                            : QStringLiteral("—");
    }
    const ConstraintResult* requirement = at(row, column);
    return requirement ? QStringLiteral("%1 / %2").arg(Names::value(*requirement),
                                                       Names::limit(*requirement))
                       : QStringLiteral("—");
}

QVariant SurfaceComparison::cell(int row, int column, int role) const {
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole: return text(row, column);
    case Qt::TextAlignmentRole: return aligned(false); // beside its light
    case Qt::DecorationRole:
        if (const ConstraintResult* requirement = at(row, column)) {
            const SurfaceStatus& status = m_statuses[static_cast<std::size_t>(column) - 1];
            const bool isEstimate =
                requirement->kind == ConstraintKind::roughness && status.isRoughnessEstimate;
            // An estimate that holds is not shown as a value that is known to.
            const Light light = lightOf(*requirement);
            return lightPixmap(isEstimate ? std::max(light, Light::close) : light,
                               metrics::iconSmall, qGuiApp->devicePixelRatio(), false);
        }
        return {};
    default: return {};
    }
}

QVariant SurfaceComparison::head(int column, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(false);
    }
    return role != Qt::DisplayRole ? QVariant()
           : column == 0           ? tr("Value / limit")
                                   : QVariant(m_names.value(column - 1));
}

QString SurfaceComparison::asTsv() const {
    QStringList lines;
    for (int row = -1; row < rowsShown(); ++row) {
        QStringList cells;
        for (int column = 0; column < columnsShown(); ++column) {
            cells += row < 0 ? head(column, Qt::DisplayRole).toString() : text(row, column);
        }
        lines += cells.join(u'\t');
    }
    return lines.join(u'\n');
}

} // namespace sparkout
