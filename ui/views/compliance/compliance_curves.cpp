// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_curves.h"

#include "core/project/part.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

using style::Drawn;

constexpr double valueRoom = 1.1; ///< headroom above the highest value
constexpr int opacity = 110;

constexpr CompliancePart stacked[] = {CompliancePart::wheelHead, CompliancePart::headstock,
                                      CompliancePart::tailstock, CompliancePart::bending};

} // namespace

ComplianceCurves::ComplianceCurves(ViewPlot& plot, QCPAxisRect& rect)
    : LengthCurves(plot, rect), m_base(plot.addLine(rect)) {
    QCPGraph* lower = m_base;
    for (const CompliancePart part : stacked) {
        QCPGraph*& upper = m_stack[static_cast<std::size_t>(part)];
        upper = plot.addLine(rect);
        upper->setChannelFillGraph(lower);
        lower = upper;
    }
    m_sum = plot.addLine(rect);
    m_used = plot.addLine(rect);
    m_used->setLineStyle(QCPGraph::lsNone);
}

QCPGraph* ComplianceCurves::stack(CompliancePart part) const {
    return m_stack[static_cast<std::size_t>(part)];
}

const std::vector<CompliantPlace>& ComplianceCurves::places() const {
    static const std::vector<CompliantPlace> none;
    return m_outcome ? m_outcome->compliance : none;
}

bool ComplianceCurves::has(CompliancePart part) const {
    return std::ranges::any_of(
        places(), [part](const CompliantPlace& p) { return valueOf(p.parts, part) != 0; });
}

bool ComplianceCurves::hasZones() const {
    return m_outcome && m_outcome->result.project.operation->hasZones;
}

void ComplianceCurves::show(OutcomePtr outcome) {
    m_outcome = std::move(outcome);
    fillUsed();
    applyChoice();
}

void ComplianceCurves::fillUsed() {
    std::vector<const SectionResult*> sections;
    for (const SectionResult& section : m_outcome->result.sections) {
        sections.push_back(&section);
    }
    std::ranges::sort(sections, {}, &SectionResult::position_mm);
    QVector<double> at, gamma;
    for (const SectionResult* section : sections) {
        at << section->position_mm;
        gamma << section->compliance_mm_per_n * nmPerMm;
    }
    m_used->setData(at, gamma, true);
}

/// A hidden part leaves the stack; the sum is unchanged.
void ComplianceCurves::applyChoice() {
    const auto n = static_cast<qsizetype>(places().size());
    QVector<double> x(n), height(n, 0.0), sum(n);
    for (qsizetype i = 0; i < n; ++i) {
        const CompliantPlace& place = places()[static_cast<std::size_t>(i)];
        x[i] = place.position_mm;
        sum[i] = sumOf(place.parts) * nmPerMm;
    }
    m_base->setData(x, height, true);
    for (const CompliancePart part : stacked) {
        for (qsizetype i = 0; chosen(static_cast<int>(part)) && i < n; ++i) {
            height[i] += valueOf(places()[static_cast<std::size_t>(i)].parts, part) * nmPerMm;
        }
        stack(part)->setData(x, height, true);
        stack(part)->setVisible(shows(static_cast<int>(part)) && has(part));
    }
    m_sum->setData(x, sum, true);
    m_sum->setVisible(shows(sumKey));
    m_used->setVisible(shows(usedKey));
}

QCPRange ComplianceCurves::values() const {
    double high = 0;
    for (const QCPGraph* graph : {stack(CompliancePart::bending), m_sum, m_used}) {
        bool found = false;
        const QCPRange range = graph->getValueRange(found);
        high = found ? std::max(high, range.upper) : high;
    }
    return {0, high > 0 ? high * valueRoom : 1};
}

// --- look ---------------------------------------------------------------------------------------

QColor ComplianceCurves::colourOf(CompliancePart part) const {
    switch (part) {
    case CompliancePart::wheelHead: return plot().toned(Drawn::wheelHead);
    case CompliancePart::headstock: return plot().toned(Drawn::headstock);
    case CompliancePart::tailstock: return plot().toned(Drawn::tailstock);
    case CompliancePart::bending: return plot().toned(Drawn::bending);
    case CompliancePart::rests: break;
    }
    return plot().toned(Drawn::rests);
}

void ComplianceCurves::restyle() {
    for (const CompliancePart part : stacked) {
        QColor fill = colourOf(part);
        stack(part)->setPen(QPen(fill, 1));
        fill.setAlpha(std::min(fill.alpha(), opacity));
        stack(part)->setBrush(fill);
    }
    m_base->setPen(Qt::NoPen);
    m_sum->setPen(QPen(plot().ink(), 2));
    const QColor used = colourOf(CompliancePart::rests);
    m_used->setPen(QPen(used, 1));
    m_used->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, used, 8));
}

QString ComplianceCurves::axisLabel() const {
    return tr("Compliance γ, nm/N");
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

LegendEntries ComplianceCurves::legendEntries() const {
    LegendEntries entries;
    for (const CompliancePart part : stacked) {
        if (has(part)) {
            const bool quill = part == CompliancePart::bending && m_outcome
                               && m_outcome->result.project.part->surface == Surface::internal;
            entries.push_back(entry(static_cast<int>(part), colourOf(part), Qt::NoPen,
                                    quill ? tr("bending of the quill") : nameOf(part)));
        }
    }
    if (!places().empty()) {
        entries.push_back(
            entry(sumKey, plot().ink(), Qt::SolidLine,
                  has(CompliancePart::rests) ? tr("γ, with the steady rests") : tr("γ")));
    }
    entries.push_back(entry(usedKey, colourOf(CompliancePart::rests), Qt::NoPen,
                            hasZones() ? tr("γ of the zones used in the run")
                                       : tr("γ of the sections used in the run")));
    return entries;
}

// --- numbers ------------------------------------------------------------------------------------

CsvTable ComplianceCurves::table() const {
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
    return table;
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

ReadCurves ComplianceCurves::readCurves() const {
    ReadCurves curves;
    const auto add = [&](const QString& name, auto value) {
        curves.push_back({QString(), tr("%1, nm/N").arg(name), Digits::significant, value});
    };
    const auto along = [this](auto value) {
        return [this, value](double x) {
            std::vector<XY> line;
            for (const CompliantPlace& place : places()) {
                line.push_back({place.position_mm, value(place.parts) * nmPerMm});
            }
            return valueAt(line, x);
        };
    };
    if (!places().empty() && shows(sumKey)) {
        add(tr("γ"), along(sumOf));
    }
    for (const CompliancePart part : allComplianceParts) {
        const bool rests = part == CompliancePart::rests;
        if (has(part) && shows(rests ? sumKey : static_cast<int>(part))) {
            add(nameOf(part),
                along([part](const ComplianceParts& parts) { return valueOf(parts, part); }));
        }
    }
    if (hasZones() && shows(usedKey)) {
        add(tr("γ of the zones used in the run"), [this](double x) { return groundWith(x); });
    }
    return curves;
}

} // namespace sparkout
