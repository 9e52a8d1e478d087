// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/compliance_curves.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/names.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

double LengthCurves::middle_um(const Part& part) {
    return (part.upper_deviation_um + part.lower_deviation_um) / 2;
}

LineChart LengthCurves::chart() {
    LineChart chart;
    chart.isFramed = true;
    chart.across.label = tr("From the headstock end of the ground length, mm");
    chart.up.label = tr("Diameter from the middle of the field, µm");
    chart.up.room = 0.08;
    return chart;
}

void LengthCurves::addLimits(LineChart& chart, const Part& part, int key) {
    constexpr double farAway = 3;
    const double limit_um = (part.upper_deviation_um - part.lower_deviation_um) / 2;
    ChartSpan drawn = chart.values();
    drawn.add(0);
    if (limit_um < farAway * std::max(-drawn.low, drawn.high)) {
        drawn.add(-limit_um);
        drawn.add(limit_um);
    }
    chart.up.range = drawn;
    for (const double limit : {-limit_um, limit_um}) {
        chart.series.push_back(
            {.key = key,
             .name = tr("limits of the field, ±%1 µm").arg(Names::significant(limit_um)),
             .colour = style::Drawn::limit,
             .pen = linePen(1.5, Qt::DashLine),
             .points = {{0, limit}, {part.length_mm, limit}}});
    }
}

void LengthCurves::read(LineChart& chart, const ChartSeries& of, Digits digits) {
    if (of.points.size() < 2 || of.points.front().x >= of.points.back().x) {
        return;
    }
    if (of.kind != ChartSeries::Kind::band) {
        chart.read(of, tr("%1, µm").arg(of.name), digits);
        return;
    }
    ChartSeries lower = of;
    lower.points = of.lower;
    chart.read(lower, tr("%1: minimum, µm").arg(of.name), digits);
    chart.read(of, tr("%1: maximum, µm").arg(of.name), digits);
}

namespace {

using style::Drawn;

constexpr double valueRoom = 1.1; ///< room above the highest value
constexpr int stackAlpha = 110;

struct StackedPart {
    CompliancePart part;
    Drawn colour;
};

constexpr StackedPart stackedParts[] = {{CompliancePart::wheelHead, Drawn::wheelHead},
                                        {CompliancePart::headstock, Drawn::headstock},
                                        {CompliancePart::tailstock, Drawn::tailstock},
                                        {CompliancePart::bending, Drawn::bending}};

} // namespace

const std::vector<CompliantPlace>& ComplianceCurves::places() const {
    static const std::vector<CompliantPlace> none;
    return m_outcome ? m_outcome->compliance : none;
}

bool ComplianceCurves::has(CompliancePart part) const {
    return std::ranges::any_of(
        places(), [part](const CompliantPlace& p) { return valueOf(p.parts, part) != 0; });
}

bool ComplianceCurves::hasZones() const {
    return m_outcome && m_outcome->result.project.operation->travels;
}

std::vector<XY>
ComplianceCurves::along(const std::function<double(const ComplianceParts&)>& value) const {
    std::vector<XY> line;
    for (const CompliantPlace& place : places()) {
        line.push_back({place.position_mm, value(place.parts) * nmPerMm});
    }
    return line;
}

LineChart ComplianceCurves::chart() const {
    LineChart chart = LengthCurves::chart();
    chart.up.label = tr("Compliance γ, nm/N");
    if (!m_outcome) {
        return chart;
    }
    const bool isBore = m_outcome->result.project.part->surface == Surface::internal;
    for (const StackedPart& of : stackedParts) {
        const CompliancePart part = of.part;
        if (has(part)) {
            chart.series.push_back(
                {.key = static_cast<int>(part),
                 .name = isBore && part == CompliancePart::bending ? tr("bending of the quill")
                                                                   : nameOf(part),
                 .kind = ChartSeries::Kind::stack,
                 .colour = of.colour,
                 .pen = linePen(1),
                 .points = along([part](const ComplianceParts& at) { return valueOf(at, part); }),
                 .alpha = stackAlpha});
        }
    }
    if (!places().empty()) {
        chart.series.push_back(
            {.key = sumKey,
             .name = has(CompliancePart::rests) ? tr("γ, with the steady rests") : tr("γ"),
             .pen = linePen(2),
             .points = along(sumOf)});
    }
    ChartSeries used{.key = usedKey,
                     .name = hasZones() ? tr("γ of the zones used in the run")
                                        : tr("γ of the sections used in the run"),
                     .kind = ChartSeries::Kind::points,
                     .colour = Drawn::rests,
                     .mark = ChartSeries::Mark::disc,
                     .markSize = 8};
    for (const SectionResult& section : m_outcome->result.sections) {
        used.points.push_back({section.position_mm, section.compliance_mm_per_n * nmPerMm});
    }
    chart.series.push_back(used);
    double high = chart.values().high;
    const auto stack = along([](const ComplianceParts& at) {
        double height = 0;
        for (const StackedPart& of : stackedParts) {
            height += valueOf(at, of.part);
        }
        return height;
    });
    for (const XY& top : stack) { // above the sum where rests take their part
        high = std::max(high, top.y);
    }
    chart.up.range = {0, high > 0 ? high * valueRoom : 1};
    chart.up.room = 0;
    addReadings(chart);
    chart.table = [self = *this] { return self.table(); };
    chart.placeText = [self = *this](double x_mm) { return self.valuesAt(x_mm); };
    return chart;
}

QString ComplianceCurves::nameOf(CompliancePart part) {
    switch (part) {
    case CompliancePart::wheelHead: return tr("wheel head");
    case CompliancePart::headstock: return tr("headstock");
    case CompliancePart::tailstock: return tr("tailstock");
    case CompliancePart::bending: return tr("bending");
    case CompliancePart::rests: return tr("taken by steady rests");
    }
    return {};
}

// --- numbers of the compliance -------------------------------------------------------------------

ChartTable ComplianceCurves::table() const {
    CsvTable table;
    table.header << tr("From the headstock end of the ground length, mm") << tr("γ, mm/N");
    for (const CompliancePart part : allComplianceParts) {
        table.header << tr("%1, mm/N").arg(nameOf(part));
    }
    for (const CompliantPlace& place : places()) {
        std::vector<CsvCell> row{place.position_mm, sumOf(place.parts)};
        for (const CompliancePart part : allComplianceParts) {
            row.emplace_back(valueOf(place.parts, part));
        }
        table.rows.push_back(std::move(row));
    }
    if (places().empty() && m_outcome) {
        for (const SectionResult& section : m_outcome->result.sections) {
            table.rows.push_back({section.position_mm, section.compliance_mm_per_n});
        }
    }
    return {table};
}

QString ComplianceCurves::valuesAt(double x_mm) const {
    if (places().empty() || x_mm < places().front().position_mm
        || x_mm > places().back().position_mm) {
        return {};
    }
    const auto nearest = std::ranges::min_element(
        places(), {}, [x_mm](const CompliantPlace& p) { return std::abs(p.position_mm - x_mm); });
    const auto value = [](double gamma_mm_n) { return Names::significant(gamma_mm_n * nmPerMm); };
    QStringList parts;
    for (const CompliancePart part : allComplianceParts) {
        if (has(part)) {
            parts << QStringLiteral("%1 %2").arg(nameOf(part),
                                                 value(valueOf(nearest->parts, part)));
        }
    }
    return tr("At %1 mm: γ %2 nm/N = %3")
        .arg(Names::significant(nearest->position_mm, 4), value(sumOf(nearest->parts)),
             parts.join(QStringLiteral(" + ")));
}

/// In traverse grinding γ of the zone that contains a place; sections are points.
std::optional<double> ComplianceCurves::groundWith(double x_mm) const {
    std::size_t zone = 0;
    for (const CompliantPoint& point : compliantPoints(m_outcome->result.project)) {
        if (std::abs(x_mm - point.position_mm) <= point.length_mm / 2) {
            return m_outcome->result.sections.at(zone).compliance_mm_per_n * nmPerMm;
        }
        ++zone;
    }
    return std::nullopt;
}

void ComplianceCurves::addReadings(LineChart& chart) const {
    const auto add = [&](int key, const QString& name, const std::vector<XY>& line) {
        chart.read({.key = key, .points = line}, tr("%1, nm/N").arg(name), Digits::significant);
    };
    if (!places().empty()) {
        add(sumKey, tr("γ"), along(sumOf));
    }
    for (const CompliancePart part : allComplianceParts) {
        if (has(part)) {
            add(part == CompliancePart::rests ? sumKey : static_cast<int>(part), nameOf(part),
                along([part](const ComplianceParts& parts) { return valueOf(parts, part); }));
        }
    }
    if (hasZones()) {
        chart.readings.push_back({usedKey,
                                  {{},
                                   tr("%1, nm/N").arg(tr("γ of the zones used in the run")),
                                   Digits::significant,
                                   [self = *this](double x) { return self.groundWith(x); }}});
    }
}

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

// --- numbers of the gauge positions --------------------------------------------------------------

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

namespace {

/// With more decimals, since the two models often differ by less than a hundredth.
QString fine(double value_um) {
    return Names::fixed(value_um, 3);
}

} // namespace

double CouplingCurves::fromMiddle_um(const SectionResult& section) const {
    return meanDiameterDeviation(section, *m_comparison->independent.project.part) * units::umPerMm
           - LengthCurves::middle_um(*m_comparison->independent.project.part);
}

LineChart CouplingCurves::chart() const {
    LineChart chart = LengthCurves::chart();
    if (!m_comparison) {
        return chart;
    }
    const auto series = [](int key, const QString& name, Drawn colour, ChartSeries::Mark mark) {
        return ChartSeries{.key = key,
                           .name = name,
                           .colour = colour,
                           .pen = style::line(colour, {}),
                           .mark = mark,
                           .markSize = 6};
    };
    using enum ChartSeries::Mark;
    chart.series = {
        series(independentKey, tr("sections independent"), Drawn::independentSections, disc),
        series(coupledKey, tr("sections coupled"), Drawn::coupledSections, square),
        series(differenceKey, tr("coupled minus independent"), Drawn::couplingDifference, diamond)};
    for (std::size_t i = 0; i < m_comparison->differences_mm.size(); ++i) {
        const SectionResult& independent = m_comparison->independent.sections[i];
        const double values[] = {fromMiddle_um(independent),
                                 fromMiddle_um(m_comparison->coupled.sections[i]),
                                 m_comparison->differences_mm[i] * units::umPerMm};
        for (std::size_t line = 0; line < chart.series.size(); ++line) {
            chart.series[line].points.push_back({independent.position_mm, values[line]});
        }
    }
    for (const ChartSeries& of : chart.series) {
        LengthCurves::read(chart, of, Digits::thousandths);
    }
    LengthCurves::addLimits(chart, *m_comparison->independent.project.part, limitsKey);
    chart.table = [self = *this] { return self.table(); };
    chart.placeText = [self = *this](double x_mm) { return self.valuesAt(x_mm); };
    return chart;
}

QString CouplingCurves::summary() const {
    const auto largest = std::ranges::max_element(
        m_comparison->differences_mm, {}, [](double difference) { return std::abs(difference); });
    const auto at = static_cast<std::size_t>(largest - m_comparison->differences_mm.begin());
    const auto spread = [this](const SimulationResult& result) {
        const auto [low, high] = std::ranges::minmax_element(
            result.sections, {}, [this](const SectionResult& s) { return fromMiddle_um(s); });
        return fine(fromMiddle_um(*high) - fromMiddle_um(*low));
    };
    const auto time = [](const SimulationResult& result) { return Names::time(result.time_s, 4); };
    QString text =
        tr("Coupling changes the diameter most at %2 mm, by %1 µm. Spread over the length: "
           "independent %3 µm, coupled %4 µm. Time: %5 and %6.")
            .arg(fine(*largest * units::umPerMm),
                 Names::significant(m_comparison->independent.sections[at].position_mm, 4),
                 spread(m_comparison->independent), spread(m_comparison->coupled),
                 time(m_comparison->independent), time(m_comparison->coupled));
    for (const auto& [result, form] : {std::pair(&m_comparison->independent, tr("Independent: %1")),
                                       std::pair(&m_comparison->coupled, tr("Coupled: %1"))}) {
        if (result->status != RunStatus::completed) {
            text += u' ' + form.arg(Names::status(result->status));
        }
    }
    return text;
}

ChartTable CouplingCurves::table() const {
    CsvTable table;
    table.header << tr("Section") << tr("Position, mm")
                 << tr("Independent, mean diameter from the middle, µm")
                 << tr("Coupled, mean diameter from the middle, µm") << tr("Difference, µm");
    for (std::size_t i = 0; i < m_comparison->differences_mm.size(); ++i) {
        const SectionResult& section = m_comparison->independent.sections[i];
        table.rows.push_back({static_cast<double>(i), section.position_mm, fromMiddle_um(section),
                              fromMiddle_um(m_comparison->coupled.sections[i]),
                              m_comparison->differences_mm[i] * units::umPerMm});
    }
    return {table};
}

QString CouplingCurves::valuesAt(double x_mm) const {
    if (m_comparison->differences_mm.empty()) {
        return {};
    }
    const auto& sections = m_comparison->independent.sections;
    const auto nearest = std::ranges::min_element(
        sections, {}, [x_mm](const SectionResult& s) { return std::abs(s.position_mm - x_mm); });
    const auto i = static_cast<std::size_t>(nearest - sections.begin());
    return tr("%1 at %2 mm: independent %3 µm, coupled %4 µm, difference %5 µm")
        .arg(Names::zone(Zone::section, static_cast<int>(i)),
             Names::significant(nearest->position_mm, 4), fine(fromMiddle_um(*nearest)),
             fine(fromMiddle_um(m_comparison->coupled.sections[i])),
             fine(m_comparison->differences_mm[i] * units::umPerMm));
}

} // namespace sparkout
