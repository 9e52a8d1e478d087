// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/coupling_curves.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/compliance/length_curves.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

using style::Drawn;

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
        series(differenceKey, tr("coupled less independent"), Drawn::couplingDifference, diamond)};
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
