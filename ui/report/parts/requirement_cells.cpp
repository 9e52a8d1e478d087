// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/requirement_cells.h"

#include "core/quality/light.h"
#include "core/quality/roughness.h"
#include "ui/charts/verdict_table.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/names.h"

namespace sparkout::report {

RequirementCells::RequirementCells(const ConstraintResult& constraint) : m_constraint(constraint) {}

QString RequirementCells::value() const {
    return Names::value(m_constraint);
}

QString RequirementCells::margin() const {
    return m_constraint.mostValue ? cell({}) : Names::margin(m_constraint);
}

QString RequirementCells::verdict() const {
    return isOpen(m_constraint) ? tr("not calibrated") : lightName(m_constraint);
}

QString RequirementCells::roughnessHead(const Project& project) {
    return isRoughnessCalibrated(project) ? tr("Ra, µm") : tr("Ra, µm, not calibrated");
}

} // namespace sparkout::report
