// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_report.h"

#include "core/file/csv_line.h"
#include "core/printable.h"
#include "core/process/coupled_sections.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/quality/cycle_constraints.h"
#include "core/quality/ranges.h"
#include "core/quality/result_names.h"
#include "core/quality/shop_numbers.h"
#include "core/quality/verdict.h"
#include "core/quality/waviness_outputs.h"
#include "core/units.h"
#include "words/issue_words.h"
#include "words/search_words.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

constexpr std::size_t labelWidth = 26, cellWidth = 12;

/// Formats four significant digits without an exponent.
std::string significant(double value) {
    return fixed(value, decimalsOf(value, 4));
}

std::size_t codePoints(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

std::string label(const std::string& text) {
    const std::size_t size = codePoints(text);
    return text + std::string(size < labelWidth ? labelWidth - size : 1, ' ');
}

/// Right-aligns a text.
std::string cell(const std::string& text) {
    const std::size_t size = codePoints(text);
    return std::string(size < cellWidth ? cellWidth - size : 1, ' ') + text;
}

/// "-" without a value.
std::string valueText(const OutputValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return std::to_string(*whole);
    }
    const auto* number = std::get_if<double>(&value);
    return number ? significant(*number) : "-";
}

/// A value with a mark if it lies outside its band.
std::string marked(BandSide band, const std::string& value) {
    const char* const mark = band == BandSide::below ? "(<)" : band == BandSide::above ? "(>)" : "";
    return mark + value;
}

std::string nameOf(const OutputRow& row, bool revolutions = false) {
    return std::string("  ") + row.labelOf(revolutions)
           + (*row.unit ? std::string(", ") + row.unit : std::string());
}

std::string bandText(const ShopNumbers& shop) {
    const bool isOutside = std::ranges::any_of(shop.stages, [](const ShopColumn& stage) {
        return std::ranges::any_of(shopColumnOutputs(), [&stage](const Output<ShopColumn>& row) {
            const BandSide band = row.bandOf(stage);
            return band == BandSide::below || band == BandSide::above;
        });
    });
    return isOutside ? label("  (<) below, (>) above") + "the usual: energy "
                           + fixed(leastSpecificEnergy_j_mm3, 0) + "…"
                           + fixed(mostSpecificEnergy_j_mm3, 0) + " J/mm³, overlap from "
                           + fixed(leastOverlap, 0) + '\n'
                     : std::string();
}

/// The shop's figures as text: a row for each quantity, a column for each stage and one for the
/// cycle. `revolutions`: revolutions are counted, not double strokes.
std::string shopText(const ShopNumbers& shop, bool revolutions) {
    std::vector<const ShopColumn*> columns;
    std::string text = label("shop figures");
    for (const ShopColumn& stage : shop.stages) {
        columns.push_back(&stage);
        text += cell("stage " + std::to_string(columns.size()));
    }
    columns.push_back(&shop.cycle);
    text += cell("cycle") + '\n';
    for (const Output<ShopColumn>& row : shopColumnOutputs()) {
        const auto has = [&row](const ShopColumn* column) { return row.of(*column).index() != 0; };
        if (row.detail || (row.sparse && std::ranges::none_of(columns, has))) {
            continue;
        }
        const bool isInSeconds =
            std::string_view(row.unit) == "min" && shop.cycle.time_s < shortTime_s;
        text += label(isInSeconds ? std::string("  ") + row.labelOf(revolutions) + ", s"
                                  : nameOf(row, revolutions));
        for (const ShopColumn* column : columns) {
            OutputValue value = row.of(*column);
            if (auto* const number = std::get_if<double>(&value); number && isInSeconds) {
                *number *= units::secondsPerMinute;
            }
            text += cell(marked(row.bandOf(*column), valueText(value)));
        }
        text += '\n';
    }
    text += bandText(shop);
    for (const Output<ShopNumbers>& row : shopOutputs()) {
        if (!row.detail) {
            text += label(nameOf(row)) + valueText(row.of(shop))
                    + (row.bandOf(shop) == BandSide::above ? ", near a whole number: waviness" : "")
                    + '\n';
        }
    }
    return text;
}

std::string padded(std::string name) {
    constexpr std::size_t column = 21;
    name.resize(std::max(column, name.size() + 1), ' ');
    return name;
}

std::string um(double value_mm) {
    return fixed(value_mm * units::umPerMm, 3);
}

std::string wavesText(const Harmonic& largest, double height_mm) {
    return "waviness " + um(height_mm) + ", most of order " + std::to_string(largest.lobes)
           + ", amplitude " + um(largest.amplitude_mm);
}

std::string accuracyText(const SimulationResult& result, const PartAccuracy& accuracy) {
    if (!FinishedSurface(result.project).isWhole()) {
        return "strips stay uncut    size, roundness, runout, cylindricity, form and Ra are not "
               "known\n";
    }
    std::string text = "deviations, µm       min, max of the diameter; radial runout; roundness by "
                       "minimum zone, least squares";
    text += '\n';
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        text += padded("  " + sectionName(section.zone, static_cast<int>(i), First::inTexts))
                + um(section.diameterDeviationMin_mm) + ", " + um(section.diameterDeviationMax_mm)
                + "; " + um(section.radialRunout_mm) + "; "
                + um(accuracy.sections[i].minimumZone.deviation()) + ", "
                + um(accuracy.sections[i].leastSquares.deviation()) + '\n';
        if (i < result.ifEven.size()) {
            text += padded("") + um(result.ifEven[i].least_mm) + ", " + um(result.ifEven[i].most_mm)
                    + " with an even number of lobes\n";
        }
        if (const auto of = placeWaves(result, i); of && of->largest()) {
            text += padded("") + wavesText(*of->largest(), of->waves->height_mm) + '\n';
        }
    }
    for (std::size_t i = 0; i < accuracy.zones.size(); ++i) {
        const ZoneForm& zone = accuracy.zones[i];
        const std::size_t inZone = result.zoneSections.size() / accuracy.zones.size();
        text +=
            padded("  " + sectionName(result.sections[i].zone, static_cast<int>(i), First::inTexts))
            + std::to_string(inZone) + " sections: cylindricity " + um(zone.cylindricity_mm)
            + ", total runout " + um(zone.totalRunout_mm) + ", taper " + um(zone.profile.taper_mm)
            + '\n';
    }
    if (const double engaged = engagedShare(*result.project.part); engaged < 1) {
        text += "interrupted surface  " + fixed(engaged * 100, 1) + " % of the turn is ground\n";
    }
    const Machine& machine = *result.project.machine;
    if (const bool round = isRoundnessKnown(machine); !round || !isRunoutKnown(machine)) {
        text += std::string("machine not known    ")
                + (round                    ? "runout is the model's"
                   : isRunoutKnown(machine) ? "roundness and cylindricity are the model's"
                                            : "runout, roundness and cylindricity are the model's")
                + " alone\n";
    }
    return text + "cylindricity, µm     " + um(accuracy.minimumZone.deviation())
           + " by minimum zone, " + um(accuracy.leastSquares.deviation())
           + " by least squares\ntotal runout, µm     " + um(accuracy.totalRunout_mm)
           + "\nform                 " + formKey(accuracy.profile.form) + "; taper "
           + um(accuracy.profile.taper_mm) + " µm, crown " + um(accuracy.profile.crown_mm)
           + " µm\n";
}

std::string metText(bool isMet) {
    return isMet ? "met" : "not met";
}

std::string unknownText(const ConstraintResult& constraint) {
    return constraint.knowsMachine                       ? ""
           : constraint.kind == ConstraintKind::waviness ? ", waves of the wheel not known"
                                                         : ", machine not known";
}

std::string constraintLine(const ConstraintResult& constraint) {
    const Requirement& row = requirementOf(constraint.kind);
    const int decimals = row.digits.printed;
    const std::string unit = row.unit, name = padded(std::string("  ") + row.key);
    if (!constraint.isWhole) {
        return name + "not known: strips uncut, " + fixed(constraint.limit, decimals) + " " + unit
               + "  " + metText(false) + " in " + whereText(constraint, First::inTexts) + '\n';
    }
    if (constraint.mostValue) {
        return name + fixed(constraint.value, decimals) + "…"
               + fixed(*constraint.mostValue, decimals) + " estimated, "
               + fixed(constraint.limit, decimals) + " " + unit + "  "
               + (isOpen(constraint) ? "not decided" : metText(constraint.holds)) + " in "
               + whereText(constraint, First::inTexts) + '\n';
    }
    if (!isComputed(constraint)) {
        return name + "not known, " + fixed(constraint.limit, decimals) + ' ' + unit
               + "  not decided in " + whereText(constraint, First::inTexts)
               + unknownText(constraint) + '\n';
    }
    const std::string value = fixed(constraint.value, decimals);
    const std::string limit = fixed(constraint.limit, decimals);
    const std::string margin = fixed(constraint.margin, decimals);
    if (isLowerBound(constraint)) {
        return name + "≥ " + value + ", " + limit + ", ≤ " + margin + ' ' + unit
               + "  not decided in " + whereText(constraint, First::inTexts)
               + unknownText(constraint) + '\n';
    }
    return name + value + ", " + limit + ", " + margin + (unit.empty() ? "" : " ") + unit + "  "
           + metText(constraint.holds) + " in " + whereText(constraint, First::inTexts)
           + unknownText(constraint) + '\n';
}

std::string requirementsText(const SimulationResult& result,
                             const std::vector<ConstraintResult>& constraints) {
    std::string text = "requirements         value, limit, margin at its worst place\n";
    for (const ConstraintResult& constraint : worstByKind(constraints)) {
        text += constraintLine(constraint);
    }
    if (const auto burn = burnStateOf(result)) {
        text += "nearest to burning   " + um(burn->visit.depth_mm) + " µm cut with "
                + um(burn->visit.stock_mm) + " µm of stock left: damaged "
                + um(burn->damagedDepth_mm) + " µm deep; the finished surface is "
                + fixed(burn->rise_k, 0) + " K hotter\n";
    }
    return text;
}

} // namespace

std::string issueLine(const std::string& file, const Issue& issue) {
    std::string line = file + ": ";
    if (!issue.path.empty()) {
        line += issue.path + ": ";
    }
    if (issue.severity == Severity::warning) {
        line += "warning: ";
    }
    line += issueSentence(issue);
    return printable(line); // one line for each fault, whatever a key or a file name contains
}

std::string fitForStocks(bool isFit, const std::string& stocks) {
    return (isFit ? "fit for every stock of " : "unfit for stocks of ") + stocks;
}

std::string setupText(const Setup& setup, const SetupRun& run) {
    std::string text = "\npart   ";
    if (!run.isCompleted(setup)) {
        return text + "not every surface is completed\n";
    }
    text += run.holds(setup) ? "every surface meets its requirements\n"
                             : "not every surface meets its requirements\n";
    std::vector<std::pair<const char*, double>> times{{"main time To", run.time.main_min}};
    if (run.time.isPieceEntered) {
        times.insert(times.end(), {{"auxiliary time Ta", run.time.auxiliary_min},
                                   {"piece time T1", run.time.piece_min},
                                   {"preparation Tp", run.time.preparation_min},
                                   {"with share of Tp", run.time.calculation_min}});
    }
    for (const auto& [name, minutes] : times) {
        text += padded(std::string("  ") + name)
                + SearchWording().time(minutes * units::secondsPerMinute) + '\n';
    }
    return text;
}

std::string statusSentence(const SimulationResult& result) {
    const std::string reached = "the gauge reads " + fixed(result.gaugeReading_mm, 5) + " mm, "
                                + fixed(result.remainingStock_mm * units::umPerMm, 3)
                                + " µm per side remain to the target";
    switch (result.status) {
    case RunStatus::completed: return "completed";
    case RunStatus::cannotReachSize:
        return "the cycle cannot reach size: nothing more is removed; " + reached;
    case RunStatus::tooLong:
        return "the cycle is longer than " + std::to_string(maxVisits) + " visits of a radius; "
               + reached;
    case RunStatus::groundAway:
        return "the part is ground away: one infeed is larger than its radius";
    case RunStatus::stopped: return "stopped; " + reached;
    case RunStatus::refused: return "refused";
    case RunStatus::notSolved:
        return (isCoupled(result.project)
                    ? "the balance of the coupled sections was not solved; "
                    : "no balance: the compliance of a section is negative, since the even load "
                      "beyond a steady rest presses it against the wheel; couple the sections; ")
               + reached;
    }
    return {};
}

std::string resultText(const SimulationResult& result,
                       const std::vector<ConstraintResult>& constraints,
                       const std::string& headline) {
    std::string text = printable(result.project.title) + '\n';
    text += "status               " + statusSentence(result) + '\n';
    text += "judged               " + headline + '\n';
    text += "machining time       " + SearchWording().time(result.time_s) + '\n';
    text += result.project.operation->travels ? "double strokes       " : "revolutions          ";
    text += std::to_string(result.cycleCount) + " (by stage:";
    for (const int count : result.countsByStage) {
        text += ' ' + std::to_string(count);
    }
    text += ")\npeak normal force    " + fixed(result.peakNormalForce_n, 2) + " N at "
            + placeText(result.peakNormalForceAt, First::inTexts) + '\n';
    text += "peak power           " + fixed(result.peakPower_w, 1) + " W at "
            + placeText(result.peakPowerAt, First::inTexts) + '\n';
    text += accuracyText(result, accuracyOf(result)) + requirementsText(result, constraints);
    return text + shopText(shopNumbers(result), !result.project.operation->travels);
}

std::string traceCsv(const SimulationResult& result, const Trajectory& trajectory) {
    const bool strokes = result.project.operation->travels;
    const bool zones = result.project.operation->travels;
    std::string csv = strokes ? "time_min,double_stroke,stage," : "time_min,revolution,stage,";
    csv += zones ? "zone," : "section,";
    csv += strokes ? "step,revolution,radius," : "radius,";
    csv += "programmed_mm,actual_mm,accumulated_mm,radius_um,normal_force_n\n";
    const double nominal = result.project.part->diameter_mm / 2;
    for (const Pass& pass : trajectory.passes) {
        const Place& place = pass.place;
        std::string where =
            ',' + std::to_string(place.cycleCount) + ',' + std::to_string(place.stage) + ',';
        where += zones ? csvCell(zoneKey(place.zone)) : std::to_string(place.section);
        if (strokes) {
            where += ',' + csvCell(stepKey(place.step)) + ',' + std::to_string(place.revolution);
        }
        for (int k = 0; k < trajectory.radii; ++k) {
            const Visit& visit = trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
            csv += numberText(visit.time_s / units::secondsPerMinute) + where + ','
                   + std::to_string(k) + ',' + numberText(visit.programmed_mm) + ','
                   + numberText(visit.actual_mm) + ',' + numberText(visit.accumulated_mm) + ','
                   + (visit.isGap() ? std::string()
                                    : numberText((visit.radius_mm - nominal) * units::umPerMm))
                   + ',' + numberText(visit.normalForce_n) + '\n';
        }
    }
    return csv;
}

} // namespace sparkout::cli
