// SPDX-License-Identifier: GPL-3.0-or-later
// What the part comes out as: the verdict, the accuracy and the requirements.
#include "ui/report/parts/cycle_card_parts.h"

#include "core/quality/finished_surface.h"
#include "core/units.h"
#include "ui/charts/verdict_model.h"
#include "ui/charts/verdict_shop_text.h"
#include "ui/charts/verdict_why.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/estimate_names.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/verdict/verdict_text.h"

#include <algorithm>

namespace sparkout::report {

std::vector<Block> CycleCard::verdict(const Outcome& outcome) {
    const bool good = verdict::overallLight(outcome) != Light::fails;
    std::vector<Block> blocks;
    blocks.push_back(Facts{{{tr("Prediction for the part"), good ? tr("good") : tr("not good")},
                            {tr("Machining time"), verdict::time(outcome.result)}}});
    QStringList lines{verdict::overall(outcome)};
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
    const auto micrometres = [](double value_mm) {
        return Names::micrometres(value_mm * units::umPerMm);
    };
    const auto deviation = [](double value_mm) {
        return Names::signedMicrometres(value_mm * units::umPerMm);
    };
    Table table;
    table.head = {tr("Zone or section"),
                  tr("From the headstock end, mm"),
                  tr("Smallest deviation, µm"),
                  tr("Largest deviation, µm"),
                  tr("Radial runout, µm"),
                  tr("Roundness, µm"),
                  tr("Ra, µm")};
    const bool roughness = std::ranges::any_of(outcome.constraints, [](const ConstraintResult& c) {
        return c.kind == ConstraintKind::roughness;
    });
    if (!roughness) {
        table.head.removeLast();
    }
    const bool whole = FinishedSurface(outcome.result.project).isWhole();
    const auto& sections = outcome.result.sections;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const SectionResult& section = sections[i];
        const SectionAccuracy& form = outcome.accuracy.sections.at(i);
        QStringList row{Names::zoneFull(section.zone, static_cast<int>(i)),
                        Names::significant(section.position_mm),
                        whole ? deviation(section.diameterDeviationMin_mm) : cell({}),
                        whole ? deviation(section.diameterDeviationMax_mm) : cell({}),
                        whole ? micrometres(section.radialRunout_mm) : cell({}),
                        whole ? micrometres(form.minimumZone.deviation()) : cell({})};
        if (roughness) {
            const auto ra =
                std::ranges::find_if(outcome.constraints, [&](const ConstraintResult& c) {
                    return c.kind == ConstraintKind::roughness && c.section == static_cast<int>(i);
                });
            row << (ra == outcome.constraints.end() ? cell({}) : Names::value(*ra));
        }
        table.rows.push_back(row);
    }
    table.texts = {true};
    return table;
}

Table CycleCard::requirements(const Outcome& outcome) {
    Table table;
    table.head = {tr("Zone or section"), tr("Requirement"), tr("Value"),  tr("Limit"),
                  tr("Margin"),          tr("Unit"),        tr("Verdict")};
    table.texts = {true, true, false, false, false, true, true};
    for (const ConstraintResult& c : outcome.constraints) {
        table.rows.push_back({Names::where(c), Names::constraint(c.kind), Names::value(c),
                              Names::limit(c), Names::margin(c), requirementUnit(c.kind),
                              lightName(c)});
    }
    return table;
}

QStringList CycleCard::estimates(const Outcome& outcome) {
    std::vector<std::pair<QString, QStringList>> groups; // requirements by what is behind them
    for (const ConstraintResult& c : outcome.constraints) {
        const QString inputs = EstimateNames::inputs(c.kind);
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

QStringList CycleCard::remarks(const Outcome& outcome) {
    QStringList lines = shop::remarks(outcome.shop);
    for (const Issue& issue : outcome.issues) {
        lines << manyLines(Names::issue(issue));
    }
    return lines;
}

} // namespace sparkout::report
