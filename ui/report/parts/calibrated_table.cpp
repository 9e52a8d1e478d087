// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/calibrated_table.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/measured.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/calibration_text.h"
#include "ui/text/texts.h"

namespace sparkout::report {

Table CalibratedTable::of(const Project& project) {
    Table table;
    table.head = {tr("Input"), tr("Value found"), tr("95 % interval"), tr("Unit"),
                  tr("Data"),  tr("n"),           tr("Date"),          tr("In use")};
    table.texts = {true, false, false, true, true, false, true, true};
    if (!project.measured) {
        return table;
    }
    for (const Calibration& record : project.measured->calibrations) {
        table.rows.push_back(
            {locationText(record.input), CalibrationText::number(record.value),
             cell(CalibrationText::interval(record)), cell(CalibrationText::unit(project, record)),
             cell(oneLine(record.data)), QString::number(record.count),
             cell(CalibrationText::date(record)),
             hasCalibratedValue(project, record) ? tr("yes") : tr("no, changed since")});
    }
    return table;
}

} // namespace sparkout::report
