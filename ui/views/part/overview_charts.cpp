// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/overview_charts.h"

#include "core/process/system_compliance.h"
#include "core/project/part.h"
#include "core/quality/diameter_shares.h"
#include "core/quality/verdict.h"
#include "core/units.h"
#include "ui/chart/quantity_colour.h"
#include "ui/measured/measured_boxes.h"
#include "ui/results/verdict_table.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

using Shape = BarChart::Shape;
using style::Drawn;

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double mostUsage = 200; ///< greatest drawn usage [%]

QString significantText(double value) {
    return Names::significant(value);
}

/// The section with the diameter nearest to its limit.
std::optional<int> criticalSection(const Outcome& outcome) {
    const ConstraintResult* worst = nullptr;
    for (const ConstraintResult& of : outcome.constraints) {
        const bool isDiameter =
            of.kind == ConstraintKind::diameterMin || of.kind == ConstraintKind::diameterMax;
        if (isDiameter && (!worst || of.margin < worst->margin)) {
            worst = &of;
        }
    }
    return worst ? std::optional(worst->section) : std::nullopt;
}

/// All zones, or some of the sections including the critical one.
std::vector<int> drawnSections(const Outcome& outcome) {
    const Project& project = outcome.result.project;
    const auto count = static_cast<int>(outcome.result.sections.size());
    return project.operation->travels
               ? shownSections(count, 0)
               : shownSections(count, gaugeSection(project), criticalSection(outcome));
}

QString nameOfSection(const Outcome& outcome, int section) {
    return Names::zone(outcome.result.sections[static_cast<std::size_t>(section)].zone, section);
}

BarColour colourOfStep(std::size_t step) {
    return [step](const QPalette& palette) {
        return tone(style::stepOfStroke(step, palette), palette);
    };
}

/// The steps that take time, in order.
std::vector<std::size_t> stepsTaken(const Outcome& outcome) {
    std::vector<std::size_t> steps;
    for (std::size_t step = 0; step < strokeSteps; ++step) {
        if (std::ranges::any_of(outcome.steps.time_s,
                                [step](const StepSums& sums) { return sums.of[step] > 0; })) {
            steps.push_back(step);
        }
    }
    return steps;
}

} // namespace

QString OverviewCharts::title(OverviewChart chart) {
    switch (chart) {
    case OverviewChart::times: return tr("Time by stage and step");
    case OverviewChart::stock: return tr("Removed by stage and step");
    case OverviewChart::diameters: return tr("Components of the diameter deviations");
    case OverviewChart::requirements: return tr("Limits used up");
    case OverviewChart::boxes: return tr("Batch: mean diameters");
    case OverviewChart::parts: return tr("Batch: good and rejected parts");
    case OverviewChart::runs: return tr("Kept runs: time and margin");
    }
    return {};
}

// --- time and stock -----------------------------------------------------------------------------

/// A series for each step that takes time, without values.
std::vector<BarSeries> OverviewCharts::stepSeries(const Outcome& outcome) {
    std::vector<BarSeries> series;
    for (const std::size_t step : stepsTaken(outcome)) {
        const bool isStep = static_cast<StrokeStep>(step) != StrokeStep::none;
        series.push_back({strokeStepName(static_cast<StrokeStep>(step)),
                          isStep ? colourOfStep(step) : barColour(Drawn::actualFeed),
                          hatchAt(series.size()),
                          {}});
    }
    return series;
}

/// All stages, or those that take longest, in order.
std::vector<std::size_t> OverviewCharts::stagesShown(const Outcome& outcome) {
    const std::vector<double>& times = outcome.result.timeByStage_s;
    std::vector<std::size_t> stages(times.size());
    std::iota(stages.begin(), stages.end(), std::size_t{0});
    std::ranges::stable_sort(stages, std::greater(),
                             [&times](std::size_t stage) { return times[stage]; });
    stages.resize(std::min(stages.size(), mostStages));
    std::ranges::sort(stages);
    return stages;
}

QString OverviewCharts::stagesRemark(const Outcome& outcome) {
    const std::size_t all = outcome.result.timeByStage_s.size();
    return all > mostStages ? tr("%1 of %2 stages: the longest ones.").arg(mostStages).arg(all)
                            : QString();
}

BarChart OverviewCharts::times(const Outcome& outcome) {
    BarChart chart;
    chart.isLying = true;
    chart.what = tr("Stage");
    chart.axis = tr("Time");
    chart.number = significantText;
    const std::vector<std::size_t> stages = stagesShown(outcome);
    for (const std::size_t stage : stages) {
        chart.categories << tr("Stage %1").arg(stage + 1);
    }
    QStringList remarks{stagesRemark(outcome)};
    if (outcome.steps.empty()) { // not recorded
        BarSeries all{{}, barColour(Drawn::actualFeed), Hatch::none, {}};
        for (const std::size_t stage : stages) {
            all.values.push_back(outcome.result.timeByStage_s[stage]);
        }
        chart.series.push_back(std::move(all));
        chart.fitTimeUnit();
        remarks << tr("The cycle is too long to be recorded step by step.");
        chart.remark = remarks.join(u' ').trimmed();
        return chart;
    }
    chart.series = stepSeries(outcome);
    const std::vector<std::size_t> steps = stepsTaken(outcome);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const std::size_t stage : stages) {
            chart.series[i].values.push_back(outcome.steps.time_s[stage].of[steps[i]]);
        }
    }
    chart.fitTimeUnit();
    chart.hasTotals = chart.series.size() > 1;
    chart.remark = stagesRemark(outcome);
    return chart;
}

QString OverviewCharts::sectionsRemark(const Outcome& outcome) {
    const std::size_t all = outcome.result.sections.size();
    const std::size_t shown = drawnSections(outcome).size();
    return shown < all ? tr("%1 of %2 sections: the ends, the gauge's and the one whose diameter "
                            "is nearest to its limit.")
                             .arg(shown)
                             .arg(all)
                       : QString();
}

BarChart OverviewCharts::stock(const Outcome& outcome) {
    BarChart chart;
    if (outcome.steps.empty()) {
        return chart;
    }
    chart.isLying = true;
    chart.what = tr("Stage and zone");
    chart.axis = tr("Removed per side");
    chart.unit = unitText("µm");
    chart.number = significantText;
    chart.series = stepSeries(outcome);
    chart.hasTotals = chart.series.size() > 1;
    chart.remark = QStringList{stagesRemark(outcome), sectionsRemark(outcome)}.join(u' ').trimmed();
    const std::vector<std::size_t> steps = stepsTaken(outcome);
    std::vector<Zone> zoneOf; // by category
    for (const std::size_t stage : stagesShown(outcome)) {
        for (const int section : drawnSections(outcome)) {
            const auto index = static_cast<std::size_t>(section);
            chart.categories << tr("Stage %1, %2", "number, zone")
                                    .arg(stage + 1)
                                    .arg(Names::within(nameOfSection(outcome, section)));
            zoneOf.push_back(outcome.result.sections[index].zone);
            for (std::size_t i = 0; i < steps.size(); ++i) {
                chart.series[i].values.push_back(outcome.steps.removed_mm[index][stage].of[steps[i]]
                                                 * units::umPerMm);
            }
        }
    }
    chart.partName = [steps, zoneOf](std::size_t series, std::size_t category) {
        const Zone zone = zoneOf[category];
        const Step step = stepOf(zone, static_cast<StrokeStep>(steps[series]));
        return step == Step::none
                   ? QString()
                   : QStringLiteral("%1 %2").arg(Names::step(step), Names::stepMeaning(zone, step));
    };
    return chart;
}

// --- diameters and requirements -----------------------------------------------------------------

QString OverviewCharts::briefPlace(const Outcome& outcome, int section) {
    return outcome.result.project.operation->travels
               ? nameOfSection(outcome, section)
               : tr("S%1", "section, in little room").arg(section + 1);
}

BarChart OverviewCharts::diameters(const Outcome& outcome) {
    BarChart chart;
    if (outcome.result.sections.empty()) {
        return chart;
    }
    chart.what = tr("Diameter");
    chart.axis = tr("From nominal");
    chart.unit = unitText("µm");
    chart.number = Names::signedMicrometres;
    chart.remark = sectionsRemark(outcome);
    const Part& part = *outcome.result.project.part;
    chart.band = BarBand{part.lower_deviation_um, part.upper_deviation_um, tr("tolerance band")};
    chart.sumName = tr("deviation, the sum");
    chart.series = {{tr("gauge at the end"), barColour(Drawn::gauge), hatchAt(0), {}},
                    {outcome.result.project.operation->travels ? tr("zone against the gauge")
                                                               : tr("section against the gauge"),
                     barColour(Tone::orange),
                     hatchAt(1),
                     {}},
                    {tr("spread in the section"), barColour(Tone::purple), hatchAt(2), {}}};
    for (const int section : drawnSections(outcome)) {
        for (const DiameterEnd end : {DiameterEnd::smallest, DiameterEnd::largest}) {
            const DiameterShares shares =
                diameterShares(outcome.result, static_cast<std::size_t>(section), end);
            const QString which =
                end == DiameterEnd::smallest ? tr("min", "diameter") : tr("max", "diameter");
            chart.categories << briefPlace(outcome, section) + u'\n' + which;
            chart.series[0].values.push_back(shares.reading_um);
            chart.series[1].values.push_back(shares.section_um);
            chart.series[2].values.push_back(shares.form_um);
            chart.sums.push_back(shares.deviation_um());
        }
    }
    return chart;
}

std::vector<int> OverviewCharts::sectionsOfDiameters(const Outcome& outcome) {
    std::vector<int> sections;
    for (const int section : drawnSections(outcome)) {
        sections.insert(sections.end(), 2, section);
    }
    return sections;
}

/// The worst result of each kind, unmet ones first and then by usage; machine ranges, which may be
/// used up to their ends, only if they are not met.
std::vector<ConstraintResult> OverviewCharts::requirementsShown(const Outcome& outcome) {
    std::vector<ConstraintResult> shown = worstByKind(outcome.constraints);
    std::erase_if(shown,
                  [](const ConstraintResult& of) { return Names::isRange(of.kind) && of.holds; });
    std::ranges::stable_sort(shown, std::greater(), [](const ConstraintResult& of) {
        return std::pair(!of.holds, usageOf(of));
    });
    return shown;
}

BarChart OverviewCharts::requirements(const Outcome& outcome) {
    BarChart chart;
    chart.isLying = true;
    chart.what = tr("Requirement");
    chart.axis = tr("Share of tolerance or limit");
    chart.unit = QStringLiteral("%");
    chart.number = [](double value) { return Names::fixed(value, value < 10 ? 1 : 0); };
    chart.most = mostUsage;
    chart.hasTotals = true;
    chart.limits = {{100, tr("limit")}};
    const std::vector<ConstraintResult> shown = requirementsShown(outcome);
    constexpr std::array lights{Light::fails, Light::undecided, Light::close, Light::holds};
    constexpr std::array drawn{Drawn::fails, Drawn::close, Drawn::close, Drawn::holds};
    constexpr std::array hatches{Hatch::crossed, Hatch::falling, Hatch::rising, Hatch::none};
    for (std::size_t i = 0; i < lights.size(); ++i) {
        BarSeries series{lightName(lights[i]), barColour(drawn[i]), hatches[i], {}};
        series.atLeast = lights[i] == Light::undecided; // the value is a lower bound
        for (const ConstraintResult& of : shown) {
            series.values.push_back(of.isWhole && lightOf(of) == lights[i] ? 100 * usageOf(of)
                                                                           : noNumber);
        }
        if (std::ranges::any_of(series.values, [](double value) { return std::isfinite(value); })) {
            chart.series.push_back(std::move(series));
        }
    }
    for (const ConstraintResult& of : shown) {
        const int section = of.at ? of.at->section : of.section;
        chart.categories << QStringLiteral("%1, %2").arg(
            Names::constraintBrief(of.kind),
            Names::within(section >= 0 ? briefPlace(outcome, section) : Names::where(of)));
    }
    const auto settings = static_cast<int>(worstByKind(outcome.constraints).size() - shown.size());
    chart.remark = settings > 0
                       ? tr("%n ranges of the machine are met and not drawn.", nullptr, settings)
                       : QString();
    return chart;
}

// --- batch --------------------------------------------------------------------------------------

/// Empty for corners, which are not a sample, and if no part reached size.
BarChart OverviewCharts::boxes(const BatchOutcome& batch,
                               const std::vector<MeasuredStatistics>& measured) {
    BarChart chart;
    bool hasMeasured = false, hasSummary = false;
    const BatchSummary& summary = batch.summary;
    const std::vector<std::size_t> places = placesOf(summary, "diameter", mostPlaces);
    const auto percentile = [](const CharacteristicSummary& of, double order) {
        const auto found = std::ranges::find(of.percentiles, order, &Percentile::order);
        return found == of.percentiles.end() ? noNumber : found->value;
    };
    for (const std::size_t place : places) {
        const CharacteristicSummary& of = summary.characteristics[place];
        if (!summary.isSample || of.count == 0) {
            return {};
        }
        const QString name = Names::zone(of.characteristic.zone, of.characteristic.section);
        chart.categories << name;
        chart.boxes.push_back({of.least.value, percentile(of, 0.25), percentile(of, 0.5),
                               percentile(of, 0.75), of.most.value});
        for (const MeasuredStatistics& parts : measured) {
            const bool isHere = parts.quantity == MeasuredQuantity::diameter_deviation
                                && parts.place == of.characteristic.section;
            if (const auto box = isHere ? MeasuredBoxes::measured(parts) : std::nullopt) {
                chart.categories << MeasuredBoxes::category(name, MeasuredBoxes::measuredKind);
                chart.boxes.push_back(*box);
                hasMeasured = true;
                hasSummary = hasSummary || parts.isSummary;
            }
        }
        if (of.characteristic.low && of.characteristic.high) {
            chart.band =
                BarBand{*of.characteristic.low, *of.characteristic.high, tr("tolerance band")};
        }
    }
    chart.shape = Shape::boxes;
    chart.what = tr("Zone or section");
    chart.axis = tr("From nominal");
    chart.unit = unitText("µm");
    chart.number = Names::signedMicrometres;
    chart.boxColour = barColour(Drawn::frequency);
    if (hasMeasured) {
        chart.boxKinds = MeasuredBoxes::kinds();
    }
    QStringList remarks{tr("Box: the middle half of the parts; its line and the figure at the box "
                           "are the median; whiskers: the smallest and the largest part.")};
    if (hasSummary) {
        remarks << MeasuredBoxes::summaryRemark();
    }
    if (!summary.exactPercentiles) {
        remarks << tr("The quartiles are exact to within a bin.");
    }
    if (const std::size_t all = placesOf(summary, "diameter").size(); places.size() < all) {
        remarks << tr("%1 of %2 sections, where the Ppk is lowest.").arg(places.size()).arg(all);
    }
    chart.remark = remarks.join(u' ');
    return chart;
}

BarChart OverviewCharts::parts(const BatchOutcome& batch) {
    const BatchSummary& summary = batch.summary;
    BarChart chart;
    const std::int64_t good = summary.parts - summary.bad.count;
    const std::int64_t out = summary.bad.count - summary.failed;
    if (summary.parts <= 0) {
        return chart;
    }
    chart.shape = Shape::ring;
    chart.what = tr("Batch");
    chart.axis = tr("Parts");
    chart.categories << tr("Parts");
    const auto all = static_cast<double>(summary.parts);
    chart.number = [all](double value) {
        return QStringLiteral("%1 (%2)").arg(Names::fixed(value, 0),
                                             LimitNames::percent(value / all));
    };
    const auto slice = [&chart](const QString& name, Drawn drawn, Hatch hatch, std::int64_t count) {
        if (count > 0) {
            chart.series.push_back({name, barColour(drawn), hatch, {static_cast<double>(count)}});
        }
    };
    slice(tr("good"), Drawn::goodPart, Hatch::none, good);
    slice(tr("out of tolerance"), Drawn::partOutside, Hatch::crossed, out);
    slice(tr("size not reached"), Drawn::sizeNotReached, Hatch::rising, summary.failed);
    chart.centre = tr("%1 of %2\ngood", "numbers of parts").arg(good).arg(summary.parts);
    return chart;
}

// --- runs ---------------------------------------------------------------------------------------

BarChart OverviewCharts::runs(const std::vector<RunBars>& runs, int kept) {
    BarChart chart;
    if (kept == 0) {
        return chart;
    }
    chart.shape = Shape::grouped;
    chart.what = tr("Run");
    chart.axis = tr("Machining time");
    chart.secondAxis = tr("Minimum margin");
    chart.secondUnit = QStringLiteral("%");
    chart.number = significantText;
    chart.secondNumber = [](double value) {
        return Names::fixed(value, std::abs(value) < 10 ? 1 : 0);
    };
    chart.series = {
        {tr("machining time"), barColour(Drawn::yourCycle), hatchAt(0), {}},
        {tr("minimum margin"), barColour(Drawn::everyRequirementHolds), hatchAt(1), {}, true}};
    for (const RunBars& run : runs) {
        chart.categories << run.name;
        chart.series[0].values.push_back(run.time_min.value_or(noNumber) * units::secondsPerMinute);
        const std::optional<ConstraintResult>& least = run.least;
        chart.series[1].values.push_back(least ? 100 * least->relativeMargin : noNumber);
        chart.secondNames << (least ? QStringLiteral("%1, %2").arg(
                                  Names::inSentence(Names::constraint(least->kind)),
                                  Names::within(Names::where(*least)))
                                    : QString());
    }
    chart.secondOf = tr("Requirement");
    chart.fitTimeUnit();
    const int shown = static_cast<int>(runs.size()) - 1;
    QStringList remarks{
        tr("Margin of the decided requirement nearest to its limit; below 0 if one is not met.")};
    if (shown < kept) {
        remarks
            << tr("The current run and the newest %1 of the %2 kept runs.").arg(shown).arg(kept);
    }
    chart.remark = remarks.join(u' ');
    return chart;
}

} // namespace sparkout
