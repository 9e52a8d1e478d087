// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/requirement_cells.h"

#include "core/quality/roughness.h"
#include "ui/charts/verdict_table.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/names.h"

namespace sparkout::report {

RequirementCells::RequirementCells(const Project& project, const ConstraintResult& constraint)
    : m_constraint(constraint)
    , m_isEstimate(constraint.kind == ConstraintKind::roughness
                   && !isRoughnessCalibrated(project)) {}

QString RequirementCells::value() const {
    return m_isEstimate && m_constraint.isWhole
               ? QStringLiteral("≈\u00a0") + Names::significant(m_constraint.value, 1)
               : Names::value(m_constraint);
}

QString RequirementCells::margin() const {
    return m_isEstimate ? cell({}) : Names::margin(m_constraint);
}

QString RequirementCells::verdict() const {
    // It comes out too small: what fails even so does fail.
    return m_isEstimate && m_constraint.holds ? tr("not calibrated") : lightName(m_constraint);
}

QString RequirementCells::roughnessHead(const Project& project) {
    return isRoughnessCalibrated(project) ? tr("Ra, µm") : tr("Ra, µm, not calibrated");
}

} // namespace sparkout::report
