// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/compliance_plot.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/profile_series.h"
#include "ui/chart/longitudinal_layers.h"
#include "ui/chart/profiles_look.h"
#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QPainterPath>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {
constexpr double above = 2.1;      ///< height for the wheel, in largest radii
constexpr double below = 1.9;      ///< height for rests and names
constexpr double holder = 0.08;    ///< length of a centre or chuck, relative to the shaft's
constexpr int wheelShade = 70;     ///< opacity of 255
constexpr double restHalf = 0.2;   ///< half width of a rest, in largest radii
constexpr double noteGap = 6;      ///< between an object and its name, in pixels
constexpr double gaugeHalf = 1.25; ///< half length of the gauge's line, in largest radii

QString stiffnessText(double value_n_um) {
    return printedNumber(value_n_um, 4);
}

/// Half the height of a name with spacing.
double halfLine(const QCPPainter* painter) {
    return painter->fontMetrics().height() / 2.0 + 1;
}
} // namespace

ShaftScene::ShaftScene(QCPAxisRect* rect)
    : PaintedLayer(*rect, QStringLiteral("main"), Edges::smooth) {}

void ShaftScene::setProject(const Project& project, const QRectF& body, double gauge_mm) {
    m_project = project;
    m_gauge_mm = gauge_mm;
    m_from_mm = body.left();
    m_to_mm = body.right();
    m_high_mm = body.height() / 2;
    const Part& part = *project.part;
    const bool bore = part.surface == Surface::internal;
    const double length = body.width();
    const double right = bore && part.shaft.quill ? part.shaft.quill->length_mm : holder * length;
    m_bounds = QRectF(m_from_mm - holder * length, -below * m_high_mm,
                      length * (1 + holder) + right, (above + below) * m_high_mm);
}

QPointF ShaftScene::at(double x_mm, double y_mm) const {
    return {m_rect->axis(QCPAxis::atBottom)->coordToPixel(x_mm),
            m_rect->axis(QCPAxis::atLeft)->coordToPixel(y_mm)};
}

QRectF ShaftScene::box(double from_mm, double to_mm, double low_mm, double high_mm) const {
    return {at(from_mm, high_mm), at(to_mm, low_mm)};
}

QString ShaftScene::stiffness(double Stiffness::*unit, const QString& name) const {
    if (!m_project.machine->stiffness_n_um) {
        return name;
    }
    return QStringLiteral("%1 %2 %3")
        .arg(name, stiffnessText((*m_project.machine->stiffness_n_um).*unit), unitText("N/µm"));
}

void ShaftScene::note(QCPPainter* painter, const QPointF& where, int flags, const QString& text) {
    note(painter, where, flags, text, mParentPlot->palette().color(QPalette::Text));
}

void ShaftScene::note(QCPPainter* painter, const QPointF& where, int flags, const QString& text,
                      const QColor& colour) {
    const QRectF all = m_rect->rect();
    QRectF rect = painter->fontMetrics().boundingRect(QRect(), flags, text);
    rect.moveCenter(where);
    if (flags & Qt::AlignLeft) {
        rect.moveLeft(where.x());
    } else if (flags & Qt::AlignRight) {
        rect.moveRight(where.x());
    }
    rect.moveLeft(std::clamp(rect.left(), all.left() + 2,
                             std::max(all.right() - rect.width() - 2, all.left() + 2)));
    rect.moveTop(std::clamp(rect.top(), all.top() + 2.0,
                            std::max(all.bottom() - rect.height() - 2, all.top() + 2.0)));
    for (const auto& [other, words] : m_notes) { // a line lower, or higher at the lower edge
        if (rect.intersects(other)) {
            const bool fits = other.bottom() + rect.height() < all.bottom();
            rect.moveTop(fits ? other.bottom() : other.top() - rect.height());
        }
    }
    m_notes.push_back({rect, text});
    painter->setPen(colour);
    painter->drawText(rect, flags | Qt::TextDontClip, text);
}

/// A centre, or the jaws of a chuck.
void ShaftScene::drawSupport(QCPPainter* painter, bool tailstock) {
    const Part& part = *m_project.part;
    const bool bore = part.surface == Surface::internal;
    const bool chuck = bore || part.shaft.mounting == Mounting::chuck;
    if (tailstock && chuck) {
        return;
    }
    const double end = tailstock ? m_to_mm : m_from_mm;
    const double out = (tailstock ? 1 : -1) * holder * (m_to_mm - m_from_mm);
    if (chuck) {
        const double high = m_high_mm * 1.15;
        painter->drawRect(box(end + out, end, -high, high));
    } else {
        const double half = part.diameter_mm / 2;
        painter->drawPolygon(
            QPolygonF{at(end, 0), at(end + out, half * 0.6), at(end + out, -half * 0.6)});
    }
    const double y = -m_high_mm * (1 + (below - 1) / 2);
    const QString text = tailstock ? stiffness(&Stiffness::tailstock, tr("tailstock"))
                                   : stiffness(&Stiffness::headstock, tr("headstock"));
    QPointF beside = at(end + out, 0) + QPointF(tailstock ? noteGap : -noteGap, 0);
    if (bore) { // the wheel may cover the chuck
        beside.setX(std::min(beside.x(), m_wheelBox.left() - noteGap));
    }
    const QRectF all = m_rect->rect();
    const double room = tailstock ? all.right() - beside.x() : beside.x() - all.left();
    if (painter->fontMetrics().horizontalAdvance(text) < room - 2) {
        note(painter, beside, tailstock ? Qt::AlignLeft : Qt::AlignRight, text);
    } else {
        QPointF under = at(end + out, y); // a slender part leaves little space
        under.setY(std::max(under.y(), at(0, -m_high_mm).y() + halfLine(painter)));
        note(painter, under, tailstock ? Qt::AlignRight : Qt::AlignLeft, text);
    }
}

void ShaftScene::drawRests(QCPPainter* painter) {
    const Shaft& shaft = m_project.part->shaft;
    if (m_project.part->surface == Surface::internal) {
        return;
    }
    for (const SteadyRest& rest : shaft.steady_rests) {
        double reached = 0, radius = m_project.part->diameter_mm / 2;
        for (const ShaftSegment& segment : shaft.segments) {
            radius = segment.diameter_mm / 2;
            reached += segment.length_mm;
            if (reached >= rest.position_mm) {
                break;
            }
        }
        const double x = m_from_mm + rest.position_mm;
        const double half = restHalf * m_high_mm;
        const double foot = -m_high_mm * (1 + (below - 1) * 0.6);
        painter->drawPolygon(QPolygonF{at(x, -radius), at(x - half, foot), at(x + half, foot)});
        note(painter, at(x, -m_high_mm * below * 0.94), Qt::AlignHCenter,
             QStringLiteral("%1 %2").arg(stiffnessText(rest.stiffness_n_um), unitText("N/µm")));
    }
}

/// Places the wheel at the entry reversal if it travels, otherwise at the middle.
void ShaftScene::placeWheel() {
    const Part& part = *m_project.part;
    const double width = m_project.wheel->width_mm, radius = part.diameter_mm / 2;
    double from = (part.length_mm - width) / 2;
    if (m_project.operation->travels) {
        from = m_project.machine->entry_side == EntrySide::headstock
                   ? -m_project.machine->overrun_entry_mm
                   : part.length_mm + m_project.machine->overrun_entry_mm - width;
    }
    const bool bore = part.surface == Surface::internal;
    const double D = m_project.wheel->diameter_mm;
    m_wheelBox = bore ? box(from, from + width, radius - D, radius)
                      : box(from, from + width, radius, radius + D);
}

void ShaftScene::drawWheel(QCPPainter* painter) {
    const Part& part = *m_project.part;
    painter->drawRect(m_wheelBox);
    QPointF where(m_wheelBox.right() + noteGap,
                  std::min(at(0, m_high_mm * (1 + (above - 1) * 0.7)).y(),
                           at(0, m_high_mm).y() - halfLine(painter)));
    if (part.surface == Surface::internal && part.shaft.quill) {
        const Quill& quill = *part.shaft.quill;
        const double half = quill.diameter_mm / 2 * m_rect->height()
                            / m_rect->axis(QCPAxis::atLeft)->range().size();
        const double along =
            quill.length_mm * m_rect->width() / m_rect->axis(QCPAxis::atBottom)->range().size();
        const double middle = m_wheelBox.center().y();
        painter->drawRect(QRectF(m_wheelBox.right(), middle - half, along, 2 * half));
        const double end = at(0, m_high_mm * gaugeHalf).y(); // end of the gauge's line
        where.setY(end - painter->fontMetrics().height());
    }
    const QString text = stiffness(&Stiffness::wheel_head, tr("wheel head"));
    if (where.x() + painter->fontMetrics().horizontalAdvance(text) < m_rect->right()) {
        note(painter, where, Qt::AlignLeft, text);
    } else { // on the wheel's other side
        note(painter, QPointF(m_wheelBox.left() - noteGap, where.y()), Qt::AlignRight, text);
    }
}

void ShaftScene::drawGauge(QCPPainter* painter) {
    const QColor colour =
        ProfileLook::pen(ProfileLine::gauge, mParentPlot->palette(), false).color();
    painter->setPen(QPen(colour, 1.5, Qt::DashDotLine));
    const double high = painter->fontMetrics().height();
    QPointF end = at(m_gauge_mm, -m_high_mm * gaugeHalf);
    end.setY(std::max(end.y(), at(0, -m_high_mm).y() + high)); // the name is below the part
    QPainterPath clear;                                        // areas of the texts
    clear.addRect(m_rect->rect());
    for (const auto& [rect, words] : m_notes) {
        QPainterPath text;
        text.addRect(rect.adjusted(-1, 0, 1, 0));
        clear -= text;
    }
    painter->save();
    painter->setClipPath(clear, Qt::IntersectClip);
    painter->drawLine(at(m_gauge_mm, m_high_mm * gaugeHalf), end);
    painter->restore();
    note(painter, end + QPointF(4, -high / 2), Qt::AlignLeft, ProfileLook::name(ProfileLine::gauge),
         colour);
}

void ShaftScene::draw(QCPPainter* painter) {
    const QPalette palette = mParentPlot->palette();
    painter->setFont(mParentPlot->font());
    m_notes.clear();
    placeWheel();
    const QColor fill = style::thinned(palette.color(QPalette::Text), wheelShade);
    const QPen edge(palette.color(QPalette::Text), 1);
    const auto solid = [&] {
        painter->setPen(edge);
        painter->setBrush(fill);
    };
    for (const bool tailstock : {false, true}) {
        solid();
        drawSupport(painter, tailstock);
    }
    solid();
    drawRests(painter);
    const QColor wheel = style::thinned(style::colour(style::Drawn::wheel, palette), wheelShade);
    painter->setPen(edge);
    painter->setBrush(wheel);
    drawWheel(painter);
    painter->setBrush(Qt::NoBrush);
    drawGauge(painter);
}

namespace {

using style::Drawn;

constexpr double sceneRoom = 1.02; ///< room around the drawing to scale
constexpr double shaftShare = 0.8; ///< relative to the height of the curves

} // namespace

CompliancePlot::CompliancePlot(QWidget* parent) : ChartPlot(parent, 1) {
    build();
    connect(this, &QCustomPlot::afterLayout, this, &CompliancePlot::afterLayouting);
    setChart([this] { return made(); });
    built();
}

LineChart CompliancePlot::made() const {
    LineChart chart = m_content == ComplianceContent::gauge      ? m_gauge.chart()
                      : m_content == ComplianceContent::coupling ? m_coupling.chart()
                                                                 : m_gamma.chart();
    chart.readSpan = {0, m_outcome ? m_outcome->result.project.part->length_mm : 0};
    return chart;
}

void CompliancePlot::setContent(ComplianceContent content) {
    m_content = content;
    remake();
    if (m_outcome) {
        fitValues();
    }
}

void CompliancePlot::setGauge(GaugePlacementPtr placement, OutcomePtr outcome) {
    m_gauge = {std::move(placement), std::move(outcome), gaugePlace_mm()};
    remake();
}

void CompliancePlot::setCoupling(CouplingPtr comparison) {
    m_coupling = CouplingCurves(std::move(comparison));
    remake();
}

double CompliancePlot::gaugePlace_mm() const {
    const SimulationResult& result = m_outcome->result;
    const Project& project = result.project;
    if (!project.operation->travels && project.gauge->position_mm) {
        return *project.gauge->position_mm;
    }
    return result.sections.at(static_cast<std::size_t>(gaugeSection(project))).position_mm;
}

void CompliancePlot::build() {
    auto* margins = new QCPMarginGroup(this);
    m_shaftRect = addCell(0);
    plotLayout()->setRowStretchFactor(0, shaftShare);
    plotLayout()->setRowSpacing(0);
    m_shaftRect->setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), 14, 2));
    cell().setMinimumMargins(QMargins(0, 6, 14, 0));
    for (QCPAxisRect* rect : {m_shaftRect, &cell()}) {
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    }
    tie({m_shaftRect, &cell()}, QCPAxis::atBottom);
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atBottom}) {
        m_shaftRect->axis(side)->setTicks(false);
        m_shaftRect->axis(side)->grid()->setVisible(false);
    }
    m_names = new BandLayer(m_shaftRect, true);
    m_bands = new BandLayer(&cell(), false);
    m_body = new ShaftLayer(m_shaftRect);
    m_scene = new ShaftScene(m_shaftRect);
}

void CompliancePlot::setRun(OutcomePtr outcome) {
    const auto shape = [](const OutcomePtr& o) {
        const Part& part = *o->result.project.part;
        return std::pair(part.length_mm, part.shaft.ground_from_mm);
    };
    const bool same = m_outcome && shape(m_outcome) == shape(outcome);
    m_outcome = std::move(outcome);
    const Project& project = m_outcome->result.project;
    m_body->setBody(shaftSteps(project), project.part->length_mm, project.part->diameter_mm / 2,
                    project.part->surface == Surface::internal);
    m_scene->setProject(project, m_body->bounds(), gaugePlace_mm());
    m_gamma = ComplianceCurves(m_outcome);
    remake();
    if (!same) {
        fit();
    } else {
        refitValues();
    }
}

void CompliancePlot::fillBands() {
    std::vector<Band> bands;
    const Project& project = m_outcome->result.project;
    if (project.operation->travels) {
        for (const CompliantPoint& point : compliantPoints(project)) {
            bands.push_back(zoneBand(static_cast<Zone>(bands.size()), 0,
                                     point.position_mm - point.length_mm / 2,
                                     point.position_mm + point.length_mm / 2));
        }
    } else {
        Band band;
        band.to = project.part->length_mm;
        band.colour = [](const QPalette& palette) {
            return style::thinned(style::colour(Drawn::endZone, palette), 28);
        };
        band.name = tr("ground length");
        bands.push_back(band);
    }
    std::ranges::sort(bands, {}, &Band::from);
    m_names->setBands(bands);
    m_bands->setBands(std::move(bands));
}

void CompliancePlot::fit() {
    fitValues();
    m_fitting = true;
}

void CompliancePlot::refitValues() {
    const QCPRange axis = up().range();
    const ChartSpan drawn = chart().values();
    constexpr double smallShare = 0.4;
    const bool inside = drawn.low >= axis.lower && drawn.high <= axis.upper;
    if (hasFittedValues() && (!inside || drawn.size() < smallShare * axis.size())) {
        fitValues();
    }
}

/// Scales the shaft equally along and across, as large as its rect allows.
void CompliancePlot::afterLayouting() {
    const QRectF area = m_shaftRect->rect();
    const double width = std::max(area.width(), 1.0), height = std::max(area.height(), 1.0);
    QCPAxis* x = m_shaftRect->axis(QCPAxis::atBottom);
    const QRectF all = m_scene->bounds();
    const bool untouched = m_fitting || x->range() == m_fittedAlong; // not zoomed
    if (untouched && !all.isEmpty()) {
        m_fitting = false;
        const double perPixel = sceneRoom * std::max(all.width() / width, all.height() / height);
        const double middle = all.center().x();
        style::setSafeRange(*x, middle - perPixel * width / 2, middle + perPixel * width / 2);
        if (x->range() != m_fittedAlong) {
            replot(QCustomPlot::rpQueuedReplot); // the ticks are still those of the old range
        }
        m_fittedAlong = x->range();
    }
    const double half = x->range().size() / width * height / 2;
    style::setSafeRange(*m_shaftRect->axis(QCPAxis::atLeft), all.center().y() - half,
                        all.center().y() + half);
}

QList<QCPAxis*> CompliancePlot::movedAxes(QCPAxisRect& rect) const {
    QList<QCPAxis*> axes{rect.axis(QCPAxis::atBottom)};
    if (&rect == &cell()) {
        axes << rect.axis(QCPAxis::atLeft);
    }
    return axes;
}

// --- look, words and numbers --------------------------------------------------------------------

void CompliancePlot::setTexts() {
    ChartPlot::setTexts();
    if (m_outcome) {
        fillBands();
    }
}

QString CompliancePlot::valuesAt(const QPointF& at) const {
    const bool isInside =
        cell().rect().contains(at.toPoint()) || m_shaftRect->rect().contains(at.toPoint());
    return isInside && chart().placeText ? chart().placeText(across().pixelToCoord(at.x()))
                                         : QString();
}

} // namespace sparkout
