// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/estimate_names.h"

#include "core/measured/calibrated_inputs.h"
#include "core/quality/requirement.h"
#include "ui/text/texts.h"

#include <QStringList>

namespace sparkout {

QString EstimateNames::inputs(const Project& project, ConstraintKind kind) {
    QStringList names;
    for (const Field* field : estimatesBehind(project, kind)) {
        if (!isCalibrated(project, *field)) {
            names += inputText(field->label).toLower();
        }
    }
    return names.join(u", ");
}

QString EstimateNames::behind(const Project& project, ConstraintKind kind) {
    const QString names = inputs(project, kind);
    return names.isEmpty() ? QString() : tr("Rests on estimates, to be calibrated: %1.").arg(names);
}

} // namespace sparkout
