// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/cycle_card.h"

#include "core/project/machine.h"
#include "core/quality/ranges.h"
#include "core/units.h"
#include "ui/report/cell_text.h"
#include "ui/report/operation_setup.h"
#include "ui/report/run_figures.h"
#include "ui/results/result_tables.h"
#include "ui/results/verdict_table.h"
#include "ui/text/calibration_text.h"
#include "ui/text/example_texts.h"
#include "ui/text/judgement_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <algorithm>

namespace sparkout::report {

QStringList OutcomeRemarks::estimates(const Outcome& outcome) {
    std::vector<std::pair<QString, QStringList>> groups; // requirements grouped by their estimates
    for (const ConstraintResult& c : outcome.constraints) {
        const QString inputs = EstimateNames::inputs(outcome.result.project, c.kind);
        const auto same = [&inputs](const auto& group) { return group.first == inputs; };
        auto group = std::ranges::find_if(groups, same);
        if (inputs.isEmpty()) {
            continue;
        }
        if (group == groups.end()) {
            group = groups.insert(group, {inputs, {}});
        }
        const QString name = Names::constraint(c.kind);
        const QString word = group->second.isEmpty() ? name : Names::inSentence(name);
        if (!group->second.contains(name) && !group->second.contains(word)) {
            group->second << word;
        }
    }
    QStringList lines;
    for (const auto& [inputs, names] : groups) {
        lines << QStringLiteral("%1: %2.").arg(names.join(QStringLiteral(", ")), inputs);
    }
    if (!lines.isEmpty()) {
        lines.prepend(tr("These predictions rest on inputs that are estimates, to be calibrated at "
                         "the machine."));
    }
    return lines;
}

QStringList OutcomeRemarks::remarks(const Outcome& outcome) {
    QStringList lines = shopRemarks(outcome.shop);
    for (std::size_t i = 0; i < outcome.result.ifEven.size(); ++i) {
        const auto& [least_mm, most_mm] = outcome.result.ifEven[i];
        lines << tr("%1: with an even number of lobes the diameters are %2…%3 µm from nominal.")
                     .arg(Names::zoneFull(outcome.result.sections[i].zone, static_cast<int>(i)),
                          Names::signedMicrometres(least_mm * units::umPerMm),
                          Names::signedMicrometres(most_mm * units::umPerMm));
    }
    for (const Issue& issue : outcome.issues) {
        lines << manyLines(Names::issue(issue));
    }
    return lines;
}

std::vector<Block> CycleCard::verdict(const Outcome& outcome, const Judgement& judgement) {
    std::vector<Block> blocks;
    blocks.push_back(Facts{{{tr("Prediction"), JudgementText::headline(judgement)},
                            {tr("Machining time"), verdict::time(outcome.result)}}});
    QStringList lines = JudgementText::lines(judgement);
    if (outcome.result.status != RunStatus::completed) {
        lines.prepend(verdict::status(outcome.result));
    }
    for (const ConstraintResult& c : outcome.constraints) {
        if (!c.holds && c.isWhole) {
            lines << verdict::why(outcome, c);
        }
    }
    if (const QString off = LimitNames::notChecked(outcome.result.project); !off.isEmpty()) {
        lines << off + QLatin1Char('.');
    }
    for (const QString& line : lines) {
        blocks.push_back(Paragraph{line});
    }
    return blocks;
}

Table CycleCard::accuracy(const Outcome& outcome) {
    const auto deviation = [](double value_mm) {
        return Names::signedMicrometres(value_mm * units::umPerMm);
    };
    const Machine& machine = *outcome.result.project.machine;
    const bool knowsRunout = isRunoutKnown(machine), knowsRoundness = isRoundnessKnown(machine);
    Table table;
    table.head = {tr("Zone or section"),
                  tr("From the headstock end, mm"),
                  tr("Minimum deviation, µm"),
                  tr("Maximum deviation, µm"),
                  Names::ofMachine(tr("Radial runout, µm"), knowsRunout),
                  Names::ofMachine(tr("Roundness, µm"), knowsRoundness),
                  RequirementCells::roughnessHead(outcome.result.project)};
    const bool roughness = std::ranges::any_of(outcome.constraints, [](const ConstraintResult& c) {
        return c.kind == ConstraintKind::roughness;
    });
    if (!roughness) {
        table.head.removeLast();
    }
    const bool whole = FinishedSurface(outcome.result.project).isWhole();
    const auto amount = [whole](double value_mm, bool isKnown) {
        return whole ? Names::formAmount(value_mm * units::umPerMm, isKnown) : cell({});
    };
    const auto& sections = outcome.result.sections;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const SectionResult& section = sections[i];
        const SectionAccuracy& form = outcome.accuracy.sections.at(i);
        QStringList row{Names::zoneFull(section.zone, static_cast<int>(i)),
                        Names::significant(section.position_mm),
                        whole ? deviation(section.diameterDeviationMin_mm) : cell({}),
                        whole ? deviation(section.diameterDeviationMax_mm) : cell({}),
                        amount(section.radialRunout_mm, knowsRunout),
                        amount(form.minimumZone.deviation(), knowsRoundness)};
        if (roughness) {
            const auto ra =
                std::ranges::find_if(outcome.constraints, [&](const ConstraintResult& c) {
                    return c.kind == ConstraintKind::roughness && c.section == static_cast<int>(i);
                });
            row << (ra == outcome.constraints.end() ? cell({}) : RequirementCells(*ra).value());
        }
        table.rows.push_back(row);
    }
    table.texts = {true};
    return table;
}

Table CycleCard::zoneForms(const Outcome& outcome) {
    Table table;
    const Machine& machine = *outcome.result.project.machine;
    const bool knowsRunout = isRunoutKnown(machine), knowsRoundness = isRoundnessKnown(machine);
    table.head = {tr("Zone"), Names::ofMachine(tr("Cylindricity, µm"), knowsRoundness),
                  Names::ofMachine(tr("Total runout, µm"), knowsRunout), tr("Taper, µm"),
                  tr("Crown, µm")};
    table.texts = {true};
    const auto& zones = outcome.accuracy.zones;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        using units::umPerMm;
        table.rows.push_back({Names::zoneFull(outcome.result.sections.at(i).zone),
                              Names::formAmount(zones[i].cylindricity_mm * umPerMm, knowsRoundness),
                              Names::formAmount(zones[i].totalRunout_mm * umPerMm, knowsRunout),
                              Names::signedMicrometres(zones[i].profile.taper_mm * umPerMm),
                              Names::signedMicrometres(zones[i].profile.crown_mm * umPerMm)});
    }
    return table;
}

Table CycleCard::requirements(const Outcome& outcome) {
    Table table;
    table.head = {tr("Zone or section"), tr("Requirement"), tr("Unit"),   tr("Value"),
                  tr("Limit"),           tr("Margin"),      tr("Verdict")};
    table.texts = {true, true, true, false, false, false, true};
    for (const ConstraintResult& c : outcome.constraints) {
        const RequirementCells cells(c);
        table.rows.push_back({Names::where(c), Names::constraint(c.kind), requirementUnit(c.kind),
                              cells.value(), Names::limit(c), cells.margin(), cells.verdict()});
    }
    return table;
}

Report CycleCard::write(const OutcomePtr& outcome, const QString& file, const QDate& date,
                        const BatchOutcomePtr& batch, const BatchOutcomePtr& predicting) {
    const Project& project = outcome->result.project;
    Report report = begunReport(tr("Cycle card of a grinding operation"), project, file, date);
    auto& blocks = report.blocks;
    const auto heading = [&blocks](const QString& text) { blocks.push_back(Heading{text}); };
    blocks.push_back(OperationSetup::header(project, date));
    blocks.push_back(partSketch(outcome));
    heading(tr("Tooling and settings"));
    blocks.push_back(OperationSetup::settings(*outcome));
    heading(tr("Settings by stage"));
    blocks.push_back(OperationSetup::stages(*outcome));
    heading(tr("Verdict"));
    for (Block& block : verdict(*outcome, judgementOf(*outcome, batch.get(), predicting.get()))) {
        blocks.push_back(std::move(block));
    }
    heading(tr("Predicted accuracy"));
    blocks.push_back(accuracy(*outcome));
    if (!outcome->accuracy.zones.empty() && FinishedSurface(project).isWhole()) {
        blocks.push_back(zoneForms(*outcome));
    }
    if (!outcome->constraints.empty()) {
        heading(tr("Requirements and margins"));
        blocks.push_back(requirements(*outcome));
    }
    if (auto figure = feedsFigure(outcome)) {
        heading(tr("Course of the cycle"));
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
    if (Table calibrated = CalibratedTable::of(project); !calibrated.rows.empty()) {
        heading(tr("Calibrated inputs"));
        blocks.push_back(std::move(calibrated));
    }
    texts(tr("Values based on estimates"), OutcomeRemarks::estimates(*outcome));
    texts(tr("Remarks"), OutcomeRemarks::remarks(*outcome));
    const QString notes = manyLines(exampleNotes(project.notes)).trimmed();
    texts(tr("Notes"), notes.isEmpty() ? QStringList() : QStringList{notes});
    blocks.push_back(Paragraph{tr("The numbers are predictions of a model and are to be confirmed "
                                  "at the machine. The card follows the layout of an operation "
                                  "card and claims no conformity with the form of any standard.")});
    return report;
}

} // namespace sparkout::report
