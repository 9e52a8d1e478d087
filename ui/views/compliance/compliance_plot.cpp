// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_plot.h"

#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/study/length_lines.h"
#include "ui/charts/longitudinal_layers.h"
#include "ui/plot/band_layer.h"
#include "ui/views/compliance/compliance_curves.h"
#include "ui/views/compliance/coupling_curves.h"
#include "ui/views/compliance/gauge_curves.h"
#include "ui/views/compliance/shaft_scene.h"

#include <algorithm>

namespace sparkout {

namespace {

using style::Drawn;

constexpr double sceneRoom = 1.02; ///< room around the drawing to scale
constexpr double shaftShare = 0.8; ///< of the height of the curves

} // namespace

CompliancePlot::CompliancePlot(QWidget* parent) : ViewPlot(parent) {
    build();
    connect(this, &QCustomPlot::afterLayout, this, &CompliancePlot::afterLayouting);
    built();
}

CompliancePlot::~CompliancePlot() = default;

LengthCurves& CompliancePlot::curves() const {
    switch (m_content) {
    case ComplianceContent::gauge: return *m_gauge;
    case ComplianceContent::coupling: return *m_coupling;
    case ComplianceContent::compliance: break;
    }
    return *m_gamma;
}

void CompliancePlot::setContent(ComplianceContent content) {
    curves().setShown(false);
    m_content = content;
    curves().setShown(true);
    labelValues();
    if (m_outcome) {
        fitValues();
    }
    emit contentChanged();
}

double CompliancePlot::gaugePlace_mm() const {
    const SimulationResult& result = m_outcome->result;
    const Project& project = result.project;
    if (!project.operation->hasZones && project.gauge->position_mm) {
        return *project.gauge->position_mm;
    }
    return result.sections.at(static_cast<std::size_t>(gaugeSection(project))).position_mm;
}

void CompliancePlot::build() {
    auto* margins = new QCPMarginGroup(this);
    m_shaftRect = addCell(0);
    m_rect = addCell(1);
    plotLayout()->setRowStretchFactor(0, shaftShare);
    plotLayout()->setRowSpacing(0);
    m_shaftRect->setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), 14, 2));
    m_rect->setMinimumMargins(QMargins(0, 6, 14, 0));
    for (QCPAxisRect* rect : {m_shaftRect, m_rect}) {
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    }
    tie({m_shaftRect, m_rect}, QCPAxis::atBottom);
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atBottom}) {
        m_shaftRect->axis(side)->setTicks(false);
        m_shaftRect->axis(side)->grid()->setVisible(false);
    }
    m_names = new BandLayer(m_shaftRect, true);
    m_bands = new BandLayer(m_rect, false);
    m_body = new ShaftLayer(m_shaftRect);
    m_scene = new ShaftScene(m_shaftRect);
    m_gamma = std::make_unique<ComplianceCurves>(*this, *m_rect);
    m_gauge = std::make_unique<GaugeCurves>(*this, *m_rect);
    m_coupling = std::make_unique<CouplingCurves>(*this, *m_rect);
    curves().setShown(true);
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
    fillBands();
    m_gamma->show(m_outcome);
    if (!same) {
        fit();
    } else {
        refitValues();
    }
    emit contentChanged();
}

void CompliancePlot::fillBands() {
    std::vector<Band> bands;
    const Project& project = m_outcome->result.project;
    if (project.operation->hasZones) {
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

void CompliancePlot::fitValues() {
    QCPAxis& axis = *m_rect->axis(QCPAxis::atLeft);
    const QCPRange range = curves().values();
    style::setSafeRange(axis, range.lower, range.upper);
    m_fitted = axis.range();
}

void CompliancePlot::refitValues() {
    const QCPRange axis = m_rect->axis(QCPAxis::atLeft)->range();
    const QCPRange drawn = curves().values();
    constexpr double smallShare = 0.4;
    const bool inside = drawn.lower >= axis.lower && drawn.upper <= axis.upper;
    if (axis == m_fitted && (!inside || drawn.size() < smallShare * axis.size())) {
        fitValues();
    }
}

/// The shaft at one scale along and across, as large as its rect holds.
void CompliancePlot::afterLayouting() {
    if (style::fitValueAxes(*m_rect, font())) {
        replot(QCustomPlot::rpQueuedReplot);
    }
    const QRectF area = m_shaftRect->rect();
    const double width = std::max(area.width(), 1.0), height = std::max(area.height(), 1.0);
    QCPAxis* x = m_shaftRect->axis(QCPAxis::atBottom);
    const QRectF all = m_scene->bounds();
    const bool untouched = m_fitting || x->range() == m_fittedAlong; // by a zoom
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
    if (&rect == m_rect) {
        axes << rect.axis(QCPAxis::atLeft);
    }
    return axes;
}

void CompliancePlot::toggleCurve(int key) {
    curves().toggle(key);
    emit contentChanged();
    replot();
}

void CompliancePlot::showOnly(int key) {
    curves().only(key);
    emit contentChanged();
    replot();
}

// --- look, words and numbers --------------------------------------------------------------------

void CompliancePlot::restyle() {
    ViewPlot::restyle();
    m_gamma->restyle();
    m_gauge->restyle();
    m_coupling->restyle();
    if (m_outcome) {
        fillBands();
    }
}

void CompliancePlot::labelValues() {
    m_rect->axis(QCPAxis::atBottom)->setLabel(curves().placeLabel());
    m_rect->axis(QCPAxis::atLeft)->setLabel(curves().axisLabel());
}

void CompliancePlot::setTexts() {
    labelValues();
    if (m_outcome) {
        fillBands();
    }
}

LegendEntries CompliancePlot::legendEntries() const {
    return curves().legendEntries();
}

CsvTable CompliancePlot::table() const {
    return curves().table();
}

ReadCurves CompliancePlot::readCurves() const {
    return curves().readCurves();
}

QCPRange CompliancePlot::readSpan() const {
    return {0, m_outcome ? m_outcome->result.project.part->length_mm : 0};
}

QString CompliancePlot::valuesAt(const QPointF& at) const {
    const bool inside =
        m_rect->rect().contains(at.toPoint()) || m_shaftRect->rect().contains(at.toPoint());
    return inside ? curves().valuesAt(m_rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x()))
                  : QString();
}

} // namespace sparkout
