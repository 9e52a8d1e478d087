// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/cycle_card.h"

#include "ui/report/parts/cycle_card_parts.h"
#include "ui/report/parts/feeds_figure.h"
#include "ui/report/parts/part_sketch.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/example_texts.h"

namespace sparkout::report {

Report cycleCard(const OutcomePtr& outcome, const QString& file, const QDate& date) {
    const Project& project = outcome->result.project;
    Report report =
        begunReport(CycleCard::tr("Cycle card of a grinding operation"), project, file, date);
    auto& blocks = report.blocks;
    const auto heading = [&blocks](const QString& text) { blocks.push_back(Heading{text}); };
    blocks.push_back(CycleCard::header(project, date));
    blocks.push_back(partSketch(outcome));
    heading(CycleCard::tr("Tooling and settings"));
    blocks.push_back(CycleCard::settings(*outcome));
    heading(CycleCard::tr("Regimes by stage"));
    blocks.push_back(CycleCard::stages(*outcome));
    heading(CycleCard::tr("Verdict"));
    for (Block& block : CycleCard::verdict(*outcome)) {
        blocks.push_back(std::move(block));
    }
    heading(CycleCard::tr("Predicted accuracy"));
    blocks.push_back(CycleCard::accuracy(*outcome));
    if (!outcome->constraints.empty()) {
        heading(CycleCard::tr("Requirements and margins"));
        blocks.push_back(CycleCard::requirements(*outcome));
    }
    if (auto figure = feedsFigure(outcome)) {
        heading(CycleCard::tr("Course of the cycle"));
        blocks.push_back(std::move(*figure));
    }
    const auto texts = [&](const QString& name, const QStringList& lines) {
        if (!lines.isEmpty()) {
            heading(name);
            for (const QString& line : lines) {
                blocks.push_back(Paragraph{line});
            }
        }
    };
    texts(CycleCard::tr("What rests on estimates"), CycleCard::estimates(*outcome));
    texts(CycleCard::tr("Remarks"), CycleCard::remarks(*outcome));
    const QString notes = manyLines(exampleNotes(project.notes)).trimmed();
    texts(CycleCard::tr("Notes"), notes.isEmpty() ? QStringList() : QStringList{notes});
    blocks.push_back(Paragraph{
        CycleCard::tr("The numbers are predictions of a model and are to be confirmed at the "
                      "machine. The card follows the layout of an operation card and claims no "
                      "conformity with the form of any standard.")});
    return report;
}

} // namespace sparkout::report
