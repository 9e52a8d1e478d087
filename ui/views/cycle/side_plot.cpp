// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/side_plot.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"

#include <algorithm>
#include <tuple>

namespace sparkout {

namespace {

/// Paints the wheel, the deflected part, its tolerance and the gauge of a SidePlot.
class SideScene : public PaintedLayer {
public:
    explicit SideScene(SidePlot& plot);

protected:
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    [[nodiscard]] double yOf(double radius_mm) const; ///< [px]
    [[nodiscard]] double xOf(double length_mm) const; ///< [px]
    void drawField(QCPPainter& painter) const;
    void drawBody(QCPPainter& painter) const;
    void drawWheel(QCPPainter& painter) const;
    void drawYield(QCPPainter& painter) const;
    void drawGauge(QCPPainter& painter) const;

    SidePlot& m_plot;
};

constexpr int metalAlpha = 40, goalAlpha = 60, grainAlpha = 150;
constexpr double arrowHead = 5;  ///< [px]
constexpr double leastArrow = 4; ///< shorter yields have no arrow [px]
constexpr double besideText = 6; ///< [px]

SideScene::SideScene(SidePlot& plot)
    : PaintedLayer(plot, QStringLiteral("main"), Edges::sharp), m_plot(plot) {}

QRect SideScene::clipRect() const {
    return m_plot.painted().adjusted(0, 0, 1, 0);
}

double SideScene::xOf(double length_mm) const {
    return m_plot.across().coordToPixel(length_mm);
}

double SideScene::yOf(double radius_mm) const {
    return m_plot.up().coordToPixel(m_plot.above_um(radius_mm));
}

void SideScene::draw(QCPPainter* painter) {
    if (m_plot.scene().surfaces.empty()) {
        return;
    }
    m_plot.drawPartAxis(*painter);
    painter->setClipRect(m_plot.cell().rect().adjusted(0, 0, 1, 1));
    drawBody(*painter);
    drawField(*painter);
    drawGauge(*painter);
    drawWheel(*painter);
    drawYield(*painter);
}

/// Draws the tolerance of the finished part without load.
void SideScene::drawField(QCPPainter& painter) const {
    if (!m_plot.shows(SidePlot::fieldKey)) {
        return;
    }
    const LayerSeries& limits = m_plot.limits();
    const QColor green = m_plot.colourOf(SidePlot::fieldKey);
    const QRectF field(QPointF(xOf(0), yOf(limits.upperLimit_mm)),
                       QPointF(xOf(limits.length_mm), yOf(limits.lowerLimit_mm)));
    painter.setPen(QPen(green, 1));
    painter.setBrush(style::thinned(green, goalAlpha));
    painter.drawRect(field);
}

void SideScene::drawBody(QCPPainter& painter) const {
    const GrindingScene& scene = m_plot.scene();
    const QColor text = m_plot.colourOf(SidePlot::surfaceKey);
    const double foot =
        scene.removalSign > 0 ? m_plot.cell().bottom() + 1.0 : double(m_plot.cell().top());
    const bool whole = m_plot.shows(SidePlot::surfaceKey);
    for (const SceneSurface& surface : scene.surfaces) {
        const double left = xOf(surface.stretch.from_mm), right = xOf(surface.stretch.to_mm);
        const double seen = yOf(m_plot.seen_mm(surface));
        if (whole) {
            painter.fillRect(
                QRectF(QPointF(left, std::min(seen, foot)), QPointF(right, std::max(seen, foot))),
                style::thinned(text, metalAlpha));
            painter.setPen(QPen(text, 2));
            painter.drawLine(QLineF(left, seen, right, seen));
        }
        if (surface.yield_mm > 0 && m_plot.shows(SidePlot::unloadedKey)) {
            const double still = yOf(surface.radius_mm);
            painter.setPen(QPen(text, 1, Qt::DashLine));
            painter.drawLine(QLineF(left, still, right, still));
        }
    }
}

void SideScene::drawWheel(QCPPainter& painter) const {
    if (!m_plot.shows(SidePlot::wheelKey)) {
        return;
    }
    const QRectF wheel = m_plot.wheelRect();
    const QColor colour = m_plot.colourOf(SidePlot::wheelKey);
    painter.fillRect(wheel, QBrush(style::thinned(colour, grainAlpha), Qt::Dense4Pattern));
    painter.setPen(QPen(colour, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(wheel);
}

/// Draws an arrow from the undeflected to the deflected surface, under the middle of the wheel.
void SideScene::drawYield(QCPPainter& painter) const {
    const GrindingScene& scene = m_plot.scene();
    const SceneSurface& at = scene.surfaces[scene.leading];
    const double from = yOf(at.radius_mm), to = yOf(m_plot.seen_mm(at));
    const bool shown = m_plot.shows(SidePlot::unloadedKey) && std::abs(to - from) >= leastArrow;
    if (!shown) {
        return;
    }
    const double middle_mm = std::clamp((scene.wheel.from_mm + scene.wheel.to_mm) / 2,
                                        at.stretch.from_mm, at.stretch.to_mm);
    const double x = xOf(middle_mm), head = to > from ? -arrowHead : arrowHead;
    const QColor colour = m_plot.palette().color(QPalette::Text);
    painter.setAntialiasing(true);
    painter.setPen(QPen(colour, 2));
    painter.drawLine(QLineF(x, from, x, to));
    painter.drawLine(QLineF(x, to, x - arrowHead, to + head));
    painter.drawLine(QLineF(x, to, x + arrowHead, to + head));
    painter.setAntialiasing(false);
    const QString text =
        SidePlot::tr("y %1 µm").arg(Names::significant(at.yield_mm * units::umPerMm));
    const QFontMetrics metrics(m_plot.font());
    const bool below = to > from; // beyond the arrow, in the metal
    QRectF box(x + besideText, below ? to + 2 : to - metrics.height() - 2,
               metrics.horizontalAdvance(text) + 2, metrics.height());
    if (box.right() > m_plot.cell().right()) {
        box.moveRight(x - besideText);
    }
    painter.setFont(m_plot.font());
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

void SideScene::drawGauge(QCPPainter& painter) const {
    const double x = xOf(m_plot.scene().gauge_mm);
    const QColor colour =
        style::dimmed(style::colour(style::Drawn::gauge, m_plot.palette()), m_plot.isDimmed());
    const QCPAxisRect& cell = m_plot.cell();
    painter.setPen(QPen(colour, 1, Qt::DashDotLine));
    painter.drawLine(QLineF(x, cell.top(), x, cell.bottom()));
    const QFontMetrics metrics(m_plot.font());
    const QString name = SidePlot::tr("gauge");
    const QRectF box(x + 3, cell.bottom() - metrics.height() - 2.0,
                     metrics.horizontalAdvance(name) + 2, metrics.height());
    painter.setFont(m_plot.font());
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, name);
}

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
        {.key = surfaceKey, .name = tr("surface under load"), .pen = linePen(1)},
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

// --- displayed moment ---------------------------------------------------------------------------

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
