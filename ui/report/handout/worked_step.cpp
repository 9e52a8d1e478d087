// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/worked_step.h"

#include "core/limits/burn.h"
#include "core/limits/cutting.h"
#include "core/process/coupled_sections.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/quality/depth_limits.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/quality/self_sharpening.h"
#include "core/quality/visit_sheet.h"
#include "core/units.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"

#include <QLocale>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr double milliwattsPerKilowatt = 1e6;
constexpr double fullTurn_deg = 360;
constexpr int percentOf = 100;

/// The numbers for the formulas of a step.
struct StepNumbers {
    const Pass& pass;
    const Visit& visit;
    double stock_mm; ///< left after the cut; negative beyond the target
};

StepNumbers numbersOf(const Outcome& outcome, const HandoutStep& step) {
    const Part& part = *outcome.result.project.part;
    const Visit& visit = *visitAt(outcome.trajectory, step);
    const double side = part.surface == Surface::external ? 1 : -1;
    return {outcome.trajectory.passes[step.pass], visit,
            side * (visit.radius_mm - targetRadius(part))};
}

/// The limits of the depth of cut at the step, each with its formulas.
std::vector<FormulaSheet> limitSheets(const Project& project, double b, double stock) {
    std::vector<FormulaSheet> sheets;
    if (const auto& U = project.material->burn_rise_k) {
        sheets.push_back(burnLimitSheet(project, *U, std::max(0.0, stock)));
    }
    if (const auto& Ra = project.part->tolerance.roughness_ra_um;
        Ra && isRoughnessCalibrated(project)) {
        sheets.push_back(roughnessLimitSheet(project, *Ra / units::umPerMm, b));
    }
    if (auto sheet = selfSharpeningSheet(project)) {
        sheets.push_back(std::move(*sheet));
    }
    if (isCoupled(project)) {
        return sheets; // the sections share the power
    }
    if (const auto& N = project.machine->wheel_drive_kw) {
        sheets.push_back(wheelPowerLimitSheet(project, b, *N * milliwattsPerKilowatt));
    }
    if (const auto& N = project.machine->work_drive_kw) {
        sheets.push_back(workPowerLimitSheet(project, b, *N * milliwattsPerKilowatt));
    }
    return sheets;
}

} // namespace

Facts WorkedStep::facts(const Outcome& outcome, const HandoutStep& step, bool results) {
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    const Place& at = pass.place;
    const bool strokes = outcome.result.project.operation->countsStrokes;
    Facts facts{
        {{tr("Zone or section"), Names::zoneFull(at.zone, at.section)},
         {tr("Stage"), QString::number(at.stage)},
         {strokes ? tr("Double stroke") : tr("Revolution"), QString::number(at.cycleCount)}}};
    if (strokes) {
        facts.facts.emplace_back(
            tr("Step"), QStringLiteral("%1: %2").arg(Names::step(at.step),
                                                     Names::stepMeaning(at.zone, at.step)));
        facts.facts.emplace_back(tr("Revolution of the step"), QString::number(at.revolution));
    }
    const double angle = fullTurn_deg * step.radius / outcome.trajectory.radii;
    facts.facts.emplace_back(
        tr("Radius"),
        QStringLiteral("k = %1, φ = %2°").arg(step.radius).arg(QLocale().toString(angle, 'g', 4)));
    const auto micrometres = [](double mm) {
        return withUnit(Names::significant(mm * units::umPerMm, resultDigits), "µm");
    };
    const auto result = [&](double mm) {
        return results ? micrometres(mm) : withUnit(blankNumber(), "µm");
    };
    facts.facts.emplace_back(tr("Effective width b"),
                             withUnit(Names::significant(pass.effectiveWidth_mm, 4), "mm"));
    facts.facts.emplace_back(tr("Programmed so far, tП"), micrometres(visit.programmed_mm));
    facts.facts.emplace_back(tr("Actual feed a"), result(visit.actual_mm));
    facts.facts.emplace_back(tr("Stock left at this radius"), result(stock));
    return facts;
}

StepBlocks WorkedStep::formulas(const Outcome& outcome, const HandoutStep& step,
                                Citations& citations, const Hidden& hidden) {
    const Project& project = outcome.result.project;
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    const double b = pass.effectiveWidth_mm, a = visit.actual_mm;
    const FormulaSheet balance =
        visitSheet(outcome.result, outcome.trajectory, step.pass, step.radius);
    std::vector<FormulaSheet> forces;
    if (a > 0 || !hasThreshold(project)) { // otherwise the balance alone gives the force
        forces = {normalForceSheet(project, b, a), tangentialForceSheet(project, b, a)};
    }
    forces.push_back(balance);
    const std::vector<FormulaSheet> sheets = limitSheets(project, b, stock);
    std::optional<LeftOut> leftOut;
    if (hidden) {
        leftOut = LeftOut{*hidden};
        for (const FormulaSheet& sheet : forces) {
            leftOut->symbols.unite(computedSymbols(sheet));
        }
        for (const FormulaSheet& sheet : sheets) {
            leftOut->symbols.unite(computedSymbols(sheet));
        }
    }
    StepFormulas formulas(project, pass.place, citations, std::move(leftOut));
    formulas.say(tr("The forces are those of the depth of cut that the elastic balance gives, "
                    "further below."));
    for (const FormulaSheet& sheet : forces) {
        formulas.add(sheet);
    }
    formulas.add(Heading{tr("Limits of the feed at this step")});
    const bool limitsRa = project.part->tolerance.roughness_ra_um.has_value();
    const bool calibrated = isRoughnessCalibrated(project);
    if (limitsRa && !calibrated) {
        formulas.say(LimitNames::guessed());
    }
    if (sheets.empty()) {
        formulas.say(limitsRa ? tr("No other requirement of this project limits the feed.")
                              : tr("No requirement of this project limits the feed."));
        return formulas.take();
    }
    formulas.say(
        limitsRa && calibrated
            ? tr("Each requirement allows a maximum depth of cut; the formulas below say where "
                 "it comes from. Roughness limits the last cut of the cycle alone.")
            : tr("Each requirement allows a maximum depth of cut; the formulas below say where "
                 "it comes from."));
    formulas.add(limits(outcome, step, !hidden));
    for (const FormulaSheet& sheet : sheets) {
        formulas.add(sheet);
    }
    return formulas.take();
}

Table WorkedStep::limits(const Outcome& outcome, const HandoutStep& step, bool results) {
    const Project& project = outcome.result.project;
    const auto [pass, visit, stock] = numbersOf(outcome, step);
    Table table;
    table.head = {tr("Requirement"), tr("Limiting depth of cut, µm"), tr("As a feed, mm/min"),
                  tr("Depth of cut of the step, µm"), tr("Share of the limit, %")};
    table.texts = {true};
    for (const DepthLimit& limit :
         depthLimits(project, pass.effectiveWidth_mm, std::max(0.0, stock))) {
        const bool shared = isCoupled(project) && requirementOf(limit.kind).sharedBySections;
        if (LimitNames::isGuess(limit.kind, project) || shared) {
            continue;
        }
        if (!results) {
            const QString blank = blankNumber();
            table.rows.push_back({Names::constraint(limit.kind), blank, blank, blank, blank});
            continue;
        }
        const double share = percentOf * visit.actual_mm / limit.depth_mm;
        table.rows.push_back(
            {Names::constraint(limit.kind),
             Names::significant(limit.depth_mm * units::umPerMm, resultDigits),
             Names::significant(limit.depth_mm * project.machine->work_speed_rpm, resultDigits),
             Names::significant(visit.actual_mm * units::umPerMm, resultDigits),
             limit.depth_mm > 0 ? Names::significant(share) : tr("not met at any depth")});
    }
    return table;
}

} // namespace sparkout::report
