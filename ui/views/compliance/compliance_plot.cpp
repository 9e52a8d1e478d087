// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_plot.h"

#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/study/length_lines.h"
#include "ui/charts/longitudinal_layers.h"
#include "ui/plot/painted_layer.h"
#include "ui/views/compliance/shaft_scene.h"

#include <algorithm>
#include <utility>

namespace sparkout {

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
                                     point.position_mm + point.length_mm / 2, palette()));
        }
    } else {
        Band band;
        band.to = project.part->length_mm;
        band.colour = style::thinned(style::colour(Drawn::endZone, palette()), 28);
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

void CompliancePlot::restyle() {
    ChartPlot::restyle();
    if (m_outcome) {
        fillBands();
    }
}

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
