// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_curves.h"

#include "core/project/part.h"
#include "ui/text/names.h"
#include "ui/views/compliance/length_curves.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

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

// --- numbers ------------------------------------------------------------------------------------

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

} // namespace sparkout
