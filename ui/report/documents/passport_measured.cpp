// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport_measured.h"

#include "core/identification/hold_out.h"
#include "core/project/project.h"
#include "ui/measured/measured_boxes.h"
#include "ui/measured/measured_text.h"
#include "ui/report/documents/passport_figures.h"

#include <utility>

namespace sparkout::report {

bool PassportMeasured::applies(const Project& project) {
    return !statisticsOfMeasured(project).empty();
}

Table PassportMeasured::table(const Project& project, const std::vector<AdequacyRow>& rows) {
    const ValueTable shown = adequacyTable(project, rows);
    Table table;
    for (const ValueHead& column : shown.columns) {
        table.head << column.text;
        table.texts.push_back(column.isText);
    }
    for (const std::vector<ValueCell>& row : shown.cells) {
        QStringList& cells = table.rows.emplace_back();
        for (const ValueCell& cell : row) {
            cells << cell.text;
        }
    }
    return table;
}

std::vector<Block> PassportMeasured::blocks(const Subject& subject) {
    const Project& project = subject.outcome->result.project;
    if (!subject.predicting || !subject.predicting->ran() || !applies(project)) {
        return {};
    }
    const std::vector<AdequacyRow> rows = judgeAdequacy(project, subject.predicting->result);
    std::vector<Block> blocks{table(project, rows)};
    for (const QString& sentence : MeasuredText::judgement(project, rows)) {
        blocks.emplace_back(Paragraph{sentence});
    }
    blocks.emplace_back(Paragraph{
        tr("Mean with Student's interval of 95 %; predicted: the range that 95 % of %n part(s) of "
           "the batch lie in; F: the variance of the measured parts over the predicted one, with "
           "what it stays between by chance; inside: measured parts within the predicted range.",
           nullptr, static_cast<int>(subject.predicting->summary.parts))});
    for (const MeasuredQuantity quantity : MeasuredBoxes::quantities(rows)) {
        if (auto figure = PassportFigures::bars(MeasuredText::quantity(quantity),
                                                MeasuredBoxes::chart(project, rows, quantity))) {
            blocks.emplace_back(std::move(*figure));
        }
    }
    return blocks;
}

std::vector<Block> PassportMeasured::heldOut(const Project& project) {
    std::vector<Block> blocks;
    for (const QString& sentence : MeasuredText::holdOut(project, holdOut(project))) {
        blocks.emplace_back(Paragraph{sentence});
    }
    if (!blocks.empty()) {
        blocks.emplace_back(
            Paragraph{tr("The range in parentheses is that of the calibrated inputs at the ends of "
                         "their 95 % intervals.")});
    }
    return blocks;
}

} // namespace sparkout::report
