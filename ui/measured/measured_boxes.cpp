// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/measured_boxes.h"

#include "core/batch/batch_summary.h"
#include "core/project/part.h"
#include "ui/measured/measured_text.h"
#include "ui/table/csv_table.h"
#include "ui/text/field_text.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

constexpr double normalQuartile = 0.6745; ///< quartile of the standard normal distribution
constexpr double whiskerReach = 2;        ///< standard deviations, without given extremes

} // namespace

std::vector<BoxKind> MeasuredBoxes::kinds() {
    return {{tr("predicted"), barColour(style::Drawn::frequency)},
            {tr("measured"), barColour(Tone::orange)}};
}

std::optional<BarBox> MeasuredBoxes::predicted(const PredictedRange& range) {
    if (range.quartiles) {
        const Quartiles& of = *range.quartiles;
        return BarBox{range.least, of.low, of.median, of.high, range.most, predictedKind};
    }
    if (range.least == range.most && range.count > 0) { // no scatter
        return BarBox{range.mean, range.mean, range.mean, range.mean, range.mean, predictedKind};
    }
    return std::nullopt;
}

std::optional<BarBox> MeasuredBoxes::measured(const MeasuredStatistics& of) {
    if (!of.isSummary) {
        if (of.values.empty()) {
            return std::nullopt;
        }
        const Quartiles quartiles = quartilesOf(of.values);
        return BarBox{of.values.front(), quartiles.low,    quartiles.median,
                      quartiles.high,    of.values.back(), measuredKind};
    }
    if (!of.deviation) {
        return std::nullopt;
    }
    const double half = normalQuartile * *of.deviation, reach = whiskerReach * *of.deviation;
    return BarBox{std::min(of.least.value_or(of.mean - reach), of.mean - half),
                  of.mean - half,
                  of.mean,
                  of.mean + half,
                  std::max(of.greatest.value_or(of.mean + reach), of.mean + half),
                  measuredKind};
}

QString MeasuredBoxes::category(const QString& place, Kind kind) {
    return place + u'\n' + kinds().at(kind).name;
}

QString MeasuredBoxes::summaryRemark() {
    return tr("For entered statistics, the box is that of a normal law with their mean and "
              "standard deviation.");
}

void MeasuredBoxes::addLimits(BarChart& chart, const Project& project, MeasuredQuantity quantity) {
    const Part& part = *project.part;
    const Tolerance& tolerance = part.tolerance;
    std::optional<double> limit;
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation:
        chart.band =
            BarBand{part.lower_deviation_um, part.upper_deviation_um, tr("tolerance band")};
        return;
    case MeasuredQuantity::radial_runout: limit = tolerance.radial_runout_um; break;
    case MeasuredQuantity::roundness: limit = tolerance.roundness_um; break;
    case MeasuredQuantity::cylindricity: limit = tolerance.cylindricity_um; break;
    case MeasuredQuantity::roughness_ra: limit = tolerance.roughness_ra_um; break;
    }
    if (limit) {
        chart.limits.push_back({*limit, tr("limit")});
    }
}

BarChart MeasuredBoxes::chart(const Project& project, const std::vector<AdequacyRow>& rows,
                              MeasuredQuantity quantity) {
    BarChart chart;
    std::size_t places = 0, all = 0;
    bool hasSummary = false, hasCorners = false;
    for (const AdequacyRow& row : rows) {
        if (row.measured.quantity != quantity) {
            continue;
        }
        ++all;
        const auto of = measured(row.measured);
        if (!of || places == mostPlaces) {
            continue;
        }
        ++places;
        const QString place = MeasuredText::place(project, row.measured.place);
        const bool isDrawn = row.predicted && knowsMachine(requirementOn(quantity), project);
        if (const auto box = isDrawn ? predicted(*row.predicted) : std::nullopt) {
            chart.categories << category(place, predictedKind);
            chart.boxes.push_back(*box);
        } else {
            hasCorners = hasCorners || isDrawn;
        }
        chart.categories << category(place, measuredKind);
        chart.boxes.push_back(*of);
        hasSummary = hasSummary || row.measured.isSummary;
    }
    if (chart.empty()) {
        return chart;
    }
    chart.shape = BarChart::Shape::boxes;
    chart.what = tr("Zone or section");
    chart.axis = MeasuredText::quantity(quantity);
    chart.unit = unitText("µm");
    chart.number = [quantity](double value) { return MeasuredText::value(value, quantity); };
    chart.boxKinds = kinds();
    addLimits(chart, project, quantity);
    QStringList remarks{tr("Box: the middle half of the parts; its line and the figure at the box "
                           "are the median; whiskers: the smallest and the largest part.")};
    if (hasSummary) {
        remarks << summaryRemark();
    }
    if (hasCorners) {
        remarks << tr("Corner parts are not a sample: their prediction has no box.");
    }
    if (all > places) {
        remarks << tr("%1 of %2 comparisons are drawn.").arg(places).arg(all);
    }
    chart.remark = remarks.join(u' ');
    return chart;
}

std::vector<MeasuredQuantity> MeasuredBoxes::quantities(const std::vector<AdequacyRow>& rows) {
    std::vector<MeasuredQuantity> found;
    for (const AdequacyRow& row : rows) {
        if (std::ranges::find(found, row.measured.quantity) == found.end()) {
            found.push_back(row.measured.quantity);
        }
    }
    return found;
}

namespace {

struct AdequacyTable {
    Q_DECLARE_TR_FUNCTIONS(AdequacyTable)
};

/// The sort key; missing values come last.
template <class Of, class Number>
CsvCell orNone(const std::optional<Of>& of, Number Of::*number) {
    return of ? CsvCell(static_cast<double>((*of).*number)) : CsvCell(QString());
}

template <class Owner>
QString hintOf(std::span<const Output<Owner>> rows, std::string_view key) {
    const auto row = std::ranges::find(rows, key, &Output<Owner>::key);
    Q_ASSERT(row != rows.end());
    return outputHint(*row);
}

std::vector<ValueHead> headsOf() {
    return {
        {.text = AdequacyTable::tr("Quantity"), .key = "quantity", .isText = true},
        {.text = AdequacyTable::tr("Verdict"), .key = "verdict", .isText = true},
        {.text = AdequacyTable::tr("n"), .tip = hintOf(adequacyOutputs(), "count"), .key = "count"},
        {.text = AdequacyTable::tr("Mean ± 95 %, µm"),
         .tip = hintOf(adequacyOutputs(), "mean_95_um"),
         .key = "mean"},
        {.text = AdequacyTable::tr("Bias (limit), µm"),
         .tip = hintOf(adequacyOutputs(), "bias_95_um"),
         .key = "bias"},
        {.text = AdequacyTable::tr("Predicted, µm"),
         .tip = hintOf(predictedOutputs(), "low_um"),
         .key = "predicted"},
        {.text = AdequacyTable::tr("F"),
         .tip = hintOf(varianceRatioOutputs(), "value"),
         .key = "scatter"},
        {.text = AdequacyTable::tr("Inside"),
         .tip = hintOf(insideShareOutputs(), "interval_95"),
         .key = "inside"}};
}

/// The table with all numbers and their digits.
CsvTable sheetOf(const Project& project, const std::vector<AdequacyRow>& rows) {
    CsvTable table;
    table.header << AdequacyTable::tr("Quantity") << AdequacyTable::tr("Where");
    addOutputHeads(table.header, adequacyOutputs());
    addOutputHeads(table.header, predictedOutputs());
    addOutputHeads(table.header, varianceRatioOutputs());
    addOutputHeads(table.header, insideShareOutputs());
    table.header << AdequacyTable::tr("Verdict");
    for (const AdequacyRow& row : rows) {
        const auto ownerOf = [](const auto& part) { return part ? &*part : nullptr; };
        const AdequacyOf of{project, row};
        std::vector<CsvCell>& cells = table.rows.emplace_back();
        cells = {MeasuredText::quantity(row.measured.quantity),
                 MeasuredText::place(project, row.measured.place)};
        addOutputCells(cells, adequacyOutputs(), &of);
        addOutputCells(cells, predictedOutputs(), ownerOf(row.predicted));
        addOutputCells(cells, varianceRatioOutputs(), ownerOf(row.scatter));
        addOutputCells(cells, insideShareOutputs(), ownerOf(row.share));
        cells.emplace_back(MeasuredText::verdict(row.verdict));
    }
    return table;
}

} // namespace

ValueTable adequacyTable(const Project& project, const std::vector<AdequacyRow>& rows) {
    ValueTable table{.columns = headsOf(), .sheet = sheetOf(project, rows), .isList = true};
    for (const AdequacyRow& row : rows) {
        const QString name = MeasuredText::name(project, row.measured);
        const auto count = static_cast<double>(row.measured.count);
        table.addRow(
            {.text = name},
            {{.text = name},
             {.text = MeasuredText::briefVerdict(row.verdict),
              .tip = MeasuredText::verdict(row.verdict)},
             {.text = QString::number(row.measured.count), .value = count},
             {.text = MeasuredText::mean(row), .value = row.measured.mean},
             {.text = MeasuredText::bias(row), .value = orNone(row.bias95, &Interval::low)},
             {.text = MeasuredText::predicted(project, row),
              .value = orNone(row.predicted, &PredictedRange::low)},
             {.text = MeasuredText::scatter(row),
              .value = orNone(row.scatter, &VarianceRatio::ratio)},
             {.text = MeasuredText::share(row), .value = orNone(row.share, &InsideShare::inside)}});
    }
    return table;
}

} // namespace sparkout
