// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/side_plot.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "ui/text/names.h"
#include "ui/views/layers/side_scene.h"

#include <algorithm>
#include <tuple>

namespace sparkout {

namespace {
using style::Drawn;
using units::umPerMm;
constexpr double wheelRoom = 0.3, metalRoom = 0.08; ///< shares of the heights; the wheel is above
constexpr double endRoom = 0.02;                    ///< margin, as a share of the length
} // namespace

SidePlot::SidePlot(QWidget* parent) : PartPlot(parent) {
    setNotAntialiasedElements(QCP::aeNone);
    new SideScene(*this);
    setChart([this] { return made(); });
    built();
}

// --- contents -----------------------------------------------------------------------------------

void SidePlot::setRun(OutcomePtr outcome) {
    const auto frame = [](const LayerSeries& s) {
        return std::tuple(s.operation, s.length_mm, s.target_mm,
                          s.columns.empty() ? 0 : s.columns.front().blank_mm);
    };
    const bool same = m_outcome && frame(m_outcome->layers) == frame(outcome->layers);
    m_outcome = std::move(outcome);
    remake();
    if (!same) {
        m_scene = grindingScene(m_outcome->result, m_outcome->trajectory, {});
        fit();
    }
}

void SidePlot::setScene(GrindingScene scene) {
    m_scene = std::move(scene);
}

const LayerSeries& SidePlot::limits() const {
    static const LayerSeries none;
    return m_outcome ? m_outcome->layers : none;
}

/// The wheel's travel from end to end, and all radii of the stock.
LineChart SidePlot::made() const {
    LineChart chart = partChart();
    using enum ChartSeries::Kind;
    chart.series = {
        {.key = wheelKey, .name = tr("wheel"), .kind = band, .colour = Drawn::wheel},
        {.key = surfaceKey, .name = tr("surface, given way"), .pen = linePen(1)},
        {.key = unloadedKey, .name = tr("without load"), .pen = linePen(1, Qt::DashLine)},
        {.key = fieldKey,
         .name = tr("tolerance band"),
         .kind = band,
         .colour = Drawn::toleranceField}};
    if (limits().columns.empty()) {
        return chart;
    }
    const Project& project = m_outcome->result.project;
    const double L = project.part->length_mm, B = project.wheel->width_mm;
    const bool travels = project.operation->travels;
    double left = travels ? project.machine->overrun_entry_mm : (B - L) / 2;
    double right = travels ? project.machine->overrun_exit_mm : left;
    if (project.machine->entry_side == EntrySide::tailstock) {
        std::swap(left, right);
    }
    const double margin = endRoom * (L + left + right);
    chart.across.range = {-left - margin, L + right + margin};
    const GrindingScene blank = grindingScene(m_outcome->result, m_outcome->trajectory, Progress{});
    double low = above_um(limits().lowerLimit_mm), high = above_um(limits().upperLimit_mm);
    for (const double radius_mm : {blank.edge_mm, limits().columns.front().final_mm}) {
        low = std::min(low, above_um(radius_mm));
        high = std::max(high, above_um(radius_mm));
    }
    const bool bore = limits().removalSign < 0;
    const double size = high - low;
    chart.up.range = {low - size * (bore ? wheelRoom : metalRoom),
                      high + size * (bore ? metalRoom : wheelRoom)};
    return chart;
}

double SidePlot::above_um(double radius_mm) const {
    return (radius_mm - limits().target_mm) * umPerMm;
}

double SidePlot::seen_mm(const SceneSurface& surface) const {
    return surface.radius_mm - m_scene.removalSign * surface.yield_mm;
}

QRectF SidePlot::wheelRect() const {
    const double edge = up().coordToPixel(above_um(m_scene.edge_mm));
    const double far = m_scene.removalSign > 0 ? std::min<double>(cell().top(), edge)
                                               : std::max(cell().bottom() + 1.0, edge);
    return {QPointF(across().coordToPixel(m_scene.wheel.from_mm), std::min(edge, far)),
            QPointF(across().coordToPixel(m_scene.wheel.to_mm), std::max(edge, far))};
}

// --- what is shown ------------------------------------------------------------------------------

QColor SidePlot::colourOf(Key key) const {
    return style::dimmed(chartColour(chart().find(key)->colour, palette()), isDimmed());
}

QString SidePlot::values() const {
    if (m_scene.surfaces.empty()) {
        return {};
    }
    const SceneSurface& at = m_scene.surfaces[m_scene.leading];
    const auto um = [](double value_mm) { return Names::significant(value_mm * umPerMm); };
    const QString zone = Names::zone(at.zone, at.section);
    if (!(m_scene.cut_mm > 0)) {
        return tr("%1, radius %2: the wheel does not touch it; programmed %3 µm.")
            .arg(zone)
            .arg(m_scene.radius)
            .arg(um(m_scene.programmed_mm));
    }
    return tr("%1, radius %2: programmed %3 µm; lag %4 µm = cut %5 µm + yield %6 µm; normal "
              "force %7 N.")
        .arg(zone)
        .arg(m_scene.radius)
        .arg(um(m_scene.programmed_mm), um(m_scene.cut_mm + at.yield_mm), um(m_scene.cut_mm),
             um(at.yield_mm), Names::significant(m_scene.force_n));
}

CsvTable SidePlot::table() const {
    CsvTable table;
    table.header << tr("Zone or section") << tr("From, mm") << tr("To, mm")
                 << tr("Radius from target, µm") << tr("Yield, µm");
    for (const SceneSurface& surface : m_scene.surfaces) {
        std::vector<CsvCell> row;
        row.emplace_back(Names::zone(surface.zone, surface.section));
        for (const double value : {surface.stretch.from_mm, surface.stretch.to_mm,
                                   above_um(surface.radius_mm), surface.yield_mm * umPerMm}) {
            row.emplace_back(value);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
