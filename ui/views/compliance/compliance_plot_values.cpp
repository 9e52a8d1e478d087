// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and words of the plot of the compliance: table, values under the mouse and at cursors.
#include "ui/charts/gauge_curves.h"
#include "ui/plot/plot_cursors.h"
#include "ui/text/names.h"
#include "ui/views/compliance/compliance_plot.h"
#include "ui/views/compliance/coupling_curves.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace sparkout {

CsvTable CompliancePlot::table() const {
    const LengthCurves* lower = curves();
    return lower ? lower->table() : complianceTable();
}

CsvTable CompliancePlot::complianceTable() const {
    CsvTable table;
    table.header << tr("From the headstock end of the ground length, mm") << tr("γ, mm/N");
    for (const CompliancePart part : allComplianceParts) {
        table.header << tr("%1, mm/N").arg(nameOf(part));
    }
    for (const CompliantPlace& place : m_places) {
        std::vector<CsvCell> row{place.position_mm, sumOf(place.parts)};
        for (const CompliancePart part : allComplianceParts) {
            row.emplace_back(valueOf(place.parts, part));
        }
        table.rows.push_back(std::move(row));
    }
    if (m_places.empty() && m_outcome) {
        for (const SectionResult& section : m_outcome->result.sections) {
            table.rows.push_back({section.position_mm, section.compliance_mm_per_n});
        }
    }
    return table;
}

// --- pointing -----------------------------------------------------------------------------------

void CompliancePlot::onMouse(QMouseEvent* event) {
    const double x = m_rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
    const bool inside =
        m_rect->rect().contains(event->pos()) || m_shaftRect->rect().contains(event->pos());
    const LengthCurves* lower = curves();
    emit pointed(!inside ? QString() : lower ? lower->valuesAt(x) : complianceAt(x));
}

QString CompliancePlot::complianceAt(double x_mm) const {
    if (m_places.empty() || x_mm < m_places.front().position_mm
        || x_mm > m_places.back().position_mm) {
        return {};
    }
    const auto nearest = std::ranges::min_element(
        m_places, {}, [x_mm](const CompliantPlace& p) { return std::abs(p.position_mm - x_mm); });
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

// --- cursors ------------------------------------------------------------------------------------

/// γ of the zone a place lies in; sections are points.
std::optional<double> CompliancePlot::groundWith(double x_mm) const {
    const Project& project = m_outcome->result.project;
    if (!project.operation->hasZones) {
        return std::nullopt;
    }
    std::size_t zone = 0;
    for (const CompliantPoint& point : compliantPoints(project)) {
        if (std::abs(x_mm - point.position_mm) <= point.length_mm / 2) {
            return m_outcome->result.sections.at(zone).compliance_mm_per_n * nmPerMm;
        }
        ++zone;
    }
    return std::nullopt;
}

ReadCurves CompliancePlot::complianceCurves() const {
    ReadCurves curves;
    const auto add = [&](const QString& name, auto value) {
        curves.push_back({QString(), tr("%1, nm/N").arg(name), Digits::significant, value});
    };
    const auto along = [this](auto value) {
        return [this, value](double x) {
            std::vector<XY> line;
            for (const CompliantPlace& place : m_places) {
                line.push_back({place.position_mm, value(place.parts) * nmPerMm});
            }
            return valueAt(line, x);
        };
    };
    if (!m_places.empty() && m_choice.shows(sumKey)) {
        add(tr("γ"), along(sumOf));
    }
    for (const CompliancePart part : allComplianceParts) {
        const bool rests = part == CompliancePart::rests;
        if (has(part) && m_choice.shows(rests ? sumKey : static_cast<int>(part))) {
            add(nameOf(part),
                along([part](const ComplianceParts& parts) { return valueOf(parts, part); }));
        }
    }
    if (m_outcome && m_outcome->result.project.operation->hasZones && m_choice.shows(usedKey)) {
        add(tr("γ of the zones, as ground with"), [this](double x) { return groundWith(x); });
    }
    return curves;
}

ReadCurves CompliancePlot::readCurves() const {
    const LengthCurves* lower = curves();
    return lower ? lower->readCurves() : complianceCurves();
}

CursorSubject CompliancePlot::cursorSubject() {
    return {
        [this] { return m_rect->axis(QCPAxis::atBottom)->label(); },
        [this] { return QCPRange(0, m_outcome ? m_outcome->result.project.part.length_mm : 0); },
        [this] { return readCurves(); },
        {},
        {}};
}

} // namespace sparkout
