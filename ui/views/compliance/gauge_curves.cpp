// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/gauge_curves.h"

#include "core/process/system_compliance.h"
#include "core/project/part.h"
#include "core/units.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/compliance/length_curves.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr std::size_t mostSections = 6; ///< greatest number of sections drawn as separate lines
constexpr int gaugeSpreadAlpha = 64;

ChartSeries gaugeMark(int key, const QString& name, style::Drawn colour, ChartSeries::Mark mark,
                      double size) {
    return {.key = key,
            .name = name,
            .kind = ChartSeries::Kind::impulses,
            .colour = colour,
            .pen = linePen(1.5, Qt::DotLine),
            .mark = mark,
            .markSize = size};
}

} // namespace

GaugeCurves::GaugeCurves(GaugePlacementPtr placement, OutcomePtr outcome, double present_mm)
    : m_placement(std::move(placement)), m_outcome(std::move(outcome)), m_present_mm(present_mm) {}

double GaugeCurves::fromMiddle_um(double deviation_mm) const {
    return deviation_mm * units::umPerMm - LengthCurves::middle_um(*m_outcome->result.project.part);
}

double GaugeCurves::farthest_um(const GaugePosition& position) const {
    return std::max(fromMiddle_um(position.deviationMax_mm),
                    -fromMiddle_um(position.deviationMin_mm));
}

double GaugeCurves::farthestNow_um() const {
    double farthest = 0;
    for (const SectionResult& section : m_outcome->result.sections) {
        farthest = std::max({farthest, std::abs(fromMiddle_um(section.diameterDeviationMin_mm)),
                             std::abs(fromMiddle_um(section.diameterDeviationMax_mm))});
    }
    return farthest;
}

const GaugePosition* GaugeCurves::best() const {
    return m_placement && m_placement->best ? &m_placement->positions[*m_placement->best] : nullptr;
}

std::vector<GaugeCurves::Place> GaugeCurves::drawn() const {
    std::vector<Place> places;
    const Project& project = m_outcome->result.project;
    const auto zones = compliantPoints(project);
    for (const GaugePosition& position : m_placement->positions) {
        if (project.operation->travels) {
            const CompliantPoint& zone = zones[static_cast<std::size_t>(position.zone)];
            places.push_back({zone.position_mm - zone.length_mm / 2, &position});
            places.push_back({zone.position_mm + zone.length_mm / 2, &position});
        } else {
            places.push_back({position.position_mm, &position});
        }
    }
    return places;
}

std::vector<XY> GaugeCurves::lineOf(const Value& value) const {
    std::vector<XY> line;
    for (const auto& [x_mm, position] : drawn()) {
        const bool ended = position->status == RunStatus::completed;
        line.push_back({x_mm, ended ? value(*position) : std::numeric_limits<double>::quiet_NaN()});
    }
    return line;
}

/// All sections if they are few, otherwise some from end to end.
std::vector<ChartSeries> GaugeCurves::sections() const {
    const std::size_t all = m_outcome->result.sections.size();
    const std::size_t count = std::min(all, mostSections);
    std::vector<ChartSeries> series;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t section = count < 2 ? 0 : i * (all - 1) / (count - 1);
        series.push_back({.key = sectionKey + static_cast<int>(i),
                          .name = nameOf(section),
                          .colour = style::oneOfSeries(i),
                          .pen = runPen(static_cast<int>(i), {}),
                          .points = lineOf([this, section](const GaugePosition& at) {
                              return section < at.meanDeviations_mm.size()
                                         ? fromMiddle_um(at.meanDeviations_mm[section])
                                         : std::numeric_limits<double>::quiet_NaN();
                          })});
    }
    return series;
}

QString GaugeCurves::nameOf(std::size_t section) const {
    return Names::zone(m_outcome->result.sections[section].zone, static_cast<int>(section));
}

LineChart GaugeCurves::chart() const {
    LineChart chart = LengthCurves::chart();
    chart.across.label = tr("Place of the gauge from the headstock end of the ground length, mm");
    if (!m_placement) {
        return chart;
    }
    const ChartSeries farthest{
        .key = farthestKey,
        .name = tr("farthest from the middle"),
        .pen = linePen(2.5),
        .points = lineOf([this](const GaugePosition& at) { return farthest_um(at); })};
    ChartSeries best = gaugeMark(bestKey, tr("best place"), style::Drawn::bestGaugePlace,
                                 ChartSeries::Mark::diamond, 12);
    if (const GaugePosition* at = this->best()) {
        best.points = {{at->position_mm, farthest_um(*at)}};
    }
    ChartSeries present = gaugeMark(presentKey, tr("current place"),
                                    style::Drawn::presentGaugePlace, ChartSeries::Mark::disc, 9);
    present.points = {{m_present_mm, farthestNow_um()}};
    const ChartSeries spread{
        .key = spreadKey,
        .name = tr("all diameters"),
        .kind = ChartSeries::Kind::band,
        .colour = style::Drawn::allDiameters,
        .points =
            lineOf([this](const GaugePosition& at) { return fromMiddle_um(at.deviationMax_mm); }),
        .lower =
            lineOf([this](const GaugePosition& at) { return fromMiddle_um(at.deviationMin_mm); }),
        .alpha = gaugeSpreadAlpha};
    chart.series = {farthest, best, present, spread};
    for (ChartSeries& section : sections()) {
        chart.series.push_back(std::move(section));
    }
    for (const ChartSeries& of : chart.series) {
        LengthCurves::read(chart, of, Digits::signedHundredths);
    }
    LengthCurves::addLimits(chart, *m_outcome->result.project.part, limitsKey);
    chart.table = [self = *this] { return self.table(); };
    chart.placeText = [self = *this](double x_mm) { return self.valuesAt(x_mm); };
    return chart;
}

// --- numbers ------------------------------------------------------------------------------------

ChartTable GaugeCurves::table() const {
    CsvTable table;
    table.header << tr("Gauge at, mm") << tr("Compliance there, mm/N") << tr("Minimum diameter, µm")
                 << tr("Maximum diameter, µm") << tr("Farthest from the middle, µm")
                 << tr("Margin to the limits, µm") << tr("Time, s") << tr("Cycle ended by");
    for (std::size_t i = 0; i < m_outcome->result.sections.size(); ++i) {
        table.header << tr("%1, mean diameter, µm").arg(nameOf(i));
    }
    for (const GaugePosition& position : m_placement->positions) {
        std::vector<CsvCell> row{position.position_mm,
                                 position.compliance_mm_per_n,
                                 fromMiddle_um(position.deviationMin_mm),
                                 fromMiddle_um(position.deviationMax_mm),
                                 farthest_um(position),
                                 position.margin_mm * units::umPerMm,
                                 position.time_s,
                                 Names::status(position.status)};
        for (const double mean_mm : position.meanDeviations_mm) {
            row.emplace_back(fromMiddle_um(mean_mm));
        }
        table.rows.push_back(std::move(row));
    }
    return {table};
}

QString GaugeCurves::valuesAt(double x_mm) const {
    if (m_placement->positions.empty()) {
        return {};
    }
    const std::vector<Place> places = drawn();
    const auto nearest = std::ranges::min_element(
        places, {}, [x_mm](const Place& place) { return std::abs(place.x_mm - x_mm); });
    const GaugePosition& at = *nearest->position;
    if (at.status != RunStatus::completed) {
        return tr("Gauge at %1 mm: %2")
            .arg(QLocale().toString(at.position_mm, 'f', 1), Names::status(at.status));
    }
    return tr("Gauge at %1 mm: diameters from %2 (%3) to %4 µm (%5), at most %6 µm from "
              "the middle of the field")
        .arg(QLocale().toString(at.position_mm, 'f', 1),
             Names::signedMicrometres(fromMiddle_um(at.deviationMin_mm)), nameOf(at.sectionOfMin),
             Names::signedMicrometres(fromMiddle_um(at.deviationMax_mm)), nameOf(at.sectionOfMax),
             Names::micrometres(farthest_um(at)));
}

} // namespace sparkout
