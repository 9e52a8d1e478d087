// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/compliance_plot.h"

#include "core/units.h"
#include "ui/charts/gauge_curves.h"
#include "ui/charts/longitudinal_layers.h"
#include "ui/charts/longitudinal_series.h"
#include "ui/plot/band_layer.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/compliance/coupling_curves.h"
#include "ui/views/compliance/shaft_scene.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

using style::Hue;

constexpr int placesDrawn = 241;
constexpr double sceneRoom = 1.02; ///< room around the drawing to scale
constexpr double valueRoom = 1.1;  ///< above the highest value
constexpr double shaftShare = 0.8; ///< of the height of the curves
constexpr int opacity = 110;

constexpr CompliancePart stacked[] = {CompliancePart::wheelHead, CompliancePart::headstock,
                                      CompliancePart::tailstock, CompliancePart::bending};

} // namespace

double sumOf(const ComplianceParts& parts) {
    double sum = 0;
    for (const CompliancePart part : allComplianceParts) {
        sum += valueOf(parts, part);
    }
    return sum;
}

double valueOf(const ComplianceParts& parts, CompliancePart part) {
    switch (part) {
    case CompliancePart::wheelHead: return parts.wheelHead;
    case CompliancePart::headstock: return parts.headstock;
    case CompliancePart::tailstock: return parts.tailstock;
    case CompliancePart::bending: return parts.bending;
    case CompliancePart::rests: return parts.rests;
    }
    return 0;
}

CompliancePlot::CompliancePlot(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    plotLayout()->clear();
    addLayer(QStringLiteral("bands"), layer(QStringLiteral("background")), QCustomPlot::limAbove);
    build();
    restyle();
    retranslate();
    connect(this, &QCustomPlot::afterLayout, this, &CompliancePlot::afterLayouting);
    connect(this, &QCustomPlot::mouseMove, this, &CompliancePlot::onMouse);
    setBuilt();
}

CompliancePlot::~CompliancePlot() = default;

LengthCurves* CompliancePlot::curves() const {
    switch (m_content) {
    case ComplianceContent::gauge: return m_gauge.get();
    case ComplianceContent::coupling: return m_coupling.get();
    case ComplianceContent::compliance: break;
    }
    return nullptr;
}

void CompliancePlot::setContent(ComplianceContent content) {
    m_content = content;
    m_gauge->setShown(content == ComplianceContent::gauge);
    m_coupling->setShown(content == ComplianceContent::coupling);
    labelValues();
    if (m_outcome) {
        fill();
        fitValues();
    }
    emit contentChanged();
}

double CompliancePlot::gaugePlace_mm() const {
    const SimulationResult& result = m_outcome->result;
    const Project& project = result.project;
    if (!project.operation->hasZones && project.gauge.position_mm) {
        return *project.gauge.position_mm;
    }
    return result.sections.at(static_cast<std::size_t>(gaugeSection(project))).position_mm;
}

void CompliancePlot::build() {
    auto* margins = new QCPMarginGroup(this);
    m_shaftRect = new QCPAxisRect(this, true);
    m_rect = new QCPAxisRect(this, true);
    plotLayout()->addElement(0, 0, m_shaftRect);
    plotLayout()->addElement(1, 0, m_rect);
    plotLayout()->setRowStretchFactor(0, shaftShare);
    plotLayout()->setRowSpacing(0);
    m_shaftRect->setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), 14, 2));
    m_rect->setMinimumMargins(QMargins(0, 6, 14, 0));
    for (QCPAxisRect* rect : {m_shaftRect, m_rect}) {
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
        for (QCPAxis* axis : rect->axes()) {
            style::setUpAxis(*axis);
        }
        for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
            rect->axis(side)->setVisible(true);
            rect->axis(side)->setTicks(false);
        }
        connect(rect->axis(QCPAxis::atBottom),
                QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                [this](const QCPRange& range) {
                    m_shaftRect->axis(QCPAxis::atBottom)->setRange(range);
                    m_rect->axis(QCPAxis::atBottom)->setRange(range);
                });
    }
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atBottom}) {
        m_shaftRect->axis(side)->setTicks(false);
        m_shaftRect->axis(side)->grid()->setVisible(false);
    }
    m_names = new BandLayer(m_shaftRect, true);
    m_bands = new BandLayer(m_rect, false);
    m_body = new ShaftLayer(m_shaftRect);
    m_scene = new ShaftScene(m_shaftRect);
    const auto graph = [this] {
        QCPGraph* made = addGraph(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
        made->removeFromLegend();
        made->setSelectable(QCP::stNone);
        return made;
    };
    m_base = graph();
    QCPGraph* lower = m_base;
    for (const CompliancePart part : stacked) {
        QCPGraph*& upper = m_stack[static_cast<std::size_t>(part)];
        upper = graph();
        upper->setChannelFillGraph(lower);
        lower = upper;
    }
    m_sum = graph();
    m_used = graph();
    m_used->setLineStyle(QCPGraph::lsNone);
    m_gauge = std::make_unique<GaugeCurves>(*m_rect);
    m_coupling = std::make_unique<CouplingCurves>(*m_rect);
}

void CompliancePlot::setRun(OutcomePtr outcome) {
    const auto shape = [](const OutcomePtr& o) {
        const Part& part = o->result.project.part;
        return std::pair(part.length_mm, part.shaft.ground_from_mm);
    };
    const bool same = m_outcome && shape(m_outcome) == shape(outcome);
    m_outcome = std::move(outcome);
    const Project& project = m_outcome->result.project;
    m_places = complianceAlong(project, placesDrawn);
    m_body->setBody(shaftSteps(project), project.part.length_mm, project.part.diameter_mm / 2,
                    project.part.surface == Surface::internal);
    m_scene->setProject(project, m_body->bounds(), gaugePlace_mm());
    fillBands();
    fill();
    if (!same) {
        fit();
    }
    emit contentChanged();
}

bool CompliancePlot::has(CompliancePart part) const {
    return std::ranges::any_of(
        m_places, [part](const CompliantPlace& p) { return valueOf(p.parts, part) != 0; });
}

QCPGraph* CompliancePlot::stack(CompliancePart part) const {
    return m_stack[static_cast<std::size_t>(part)];
}

/// What is hidden leaves the stack; the sum stays what it is.
void CompliancePlot::fill() {
    const auto n = static_cast<qsizetype>(m_places.size());
    QVector<double> x(n), height(n, 0.0), sum(n);
    for (qsizetype i = 0; i < n; ++i) {
        const CompliantPlace& place = m_places[static_cast<std::size_t>(i)];
        x[i] = place.position_mm;
        sum[i] = sumOf(place.parts) * nmPerMm;
    }
    const bool compliance = m_content == ComplianceContent::compliance;
    m_base->setData(x, height, true);
    for (const CompliancePart part : stacked) {
        const bool shown = m_choice.shows(static_cast<int>(part));
        for (qsizetype i = 0; shown && i < n; ++i) {
            height[i] += valueOf(m_places[static_cast<std::size_t>(i)].parts, part) * nmPerMm;
        }
        stack(part)->setData(x, height, true);
        stack(part)->setVisible(compliance && shown && has(part));
    }
    m_sum->setData(x, sum, true);
    m_sum->setVisible(compliance && m_choice.shows(sumKey));
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
    m_used->setVisible(compliance && m_choice.shows(usedKey));
}

void CompliancePlot::fillBands() {
    std::vector<Band> bands;
    const Project& project = m_outcome->result.project;
    if (project.operation->hasZones) {
        for (const CompliantPoint& point : compliantPoints(project)) {
            Band band;
            const auto index = bands.size();
            band.from = point.position_mm - point.length_mm / 2;
            band.to = point.position_mm + point.length_mm / 2;
            band.colour = style::colour(index == 1 ? Hue::yellow : Hue::sky, palette());
            band.colour.setAlpha(index == 1 ? 38 : 28);
            band.name = Names::zone(static_cast<Zone>(index));
            band.meaning = Names::zoneFull(static_cast<Zone>(index));
            bands.push_back(band);
        }
    } else {
        Band band;
        band.to = project.part.length_mm;
        band.colour = style::colour(Hue::sky, palette());
        band.colour.setAlpha(28);
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
    if (const LengthCurves* lower = curves()) {
        const QCPRange range = lower->values();
        style::setSafeRange(axis, range.lower, range.upper);
    } else {
        double high = 0;
        for (const QCPGraph* graph : {stack(CompliancePart::bending), m_sum, m_used}) {
            bool found = false;
            const QCPRange range = graph->getValueRange(found);
            high = found ? std::max(high, range.upper) : high;
        }
        style::setSafeRange(axis, 0, high > 0 ? high * valueRoom : 1);
    }
    m_fitted = axis.range();
}

void CompliancePlot::refitValues() {
    const QCPRange axis = m_rect->axis(QCPAxis::atLeft)->range();
    const QCPRange drawn = curves() ? curves()->values() : axis;
    constexpr double smallShare = 0.4;
    const bool inside = drawn.lower >= axis.lower && drawn.upper <= axis.upper;
    if (axis == m_fitted && (!inside || drawn.size() < smallShare * axis.size())) {
        fitValues();
    }
}

/// The shaft at one scale along and across, as large as its rect holds.
void CompliancePlot::afterLayouting() {
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
    if (LengthCurves* lower = curves()) {
        lower->toggle(key);
        emit contentChanged();
        replot();
        return;
    }
    m_choice.toggle(key);
    fill();
    emit contentChanged();
    replot();
}

void CompliancePlot::showOnly(int key) {
    if (LengthCurves* lower = curves()) {
        lower->only(key);
        emit contentChanged();
        replot();
        return;
    }
    m_choice.only(key, legendEntries());
    fill();
    emit contentChanged();
    replot();
}

// --- look ---------------------------------------------------------------------------------------

QColor CompliancePlot::colourOf(CompliancePart part) const {
    static constexpr Hue hues[] = {Hue::blue, Hue::green, Hue::orange, Hue::purple, Hue::vermilion};
    return style::dimmed(style::colour(hues[static_cast<int>(part)], palette()), isDimmed());
}

QString CompliancePlot::nameOf(CompliancePart part) {
    switch (part) {
    case CompliancePart::wheelHead: return tr("wheel head");
    case CompliancePart::headstock: return tr("headstock");
    case CompliancePart::tailstock: return tr("tailstock");
    case CompliancePart::bending: return tr("bending");
    case CompliancePart::rests: return tr("taken by steady rests");
    }
    return {};
}

LegendEntries CompliancePlot::legendEntries() const {
    const LengthCurves* lower = curves();
    return lower ? lower->legendEntries() : complianceEntries();
}

LegendEntries CompliancePlot::complianceEntries() const {
    LegendEntries entries;
    const QColor text = style::dimmed(palette().color(QPalette::Text), isDimmed());
    for (const CompliancePart part : stacked) {
        if (has(part)) {
            const int key = static_cast<int>(part);
            const QString name =
                part == CompliancePart::bending && m_outcome
                        && m_outcome->result.project.part.surface == Surface::internal
                    ? tr("bending of the quill")
                    : nameOf(part);
            entries.push_back({colourOf(part), Qt::NoPen, name, key, m_choice.shows(key)});
        }
    }
    if (!m_places.empty()) {
        entries.push_back({text, Qt::SolidLine,
                           has(CompliancePart::rests) ? tr("γ, with the steady rests") : tr("γ"),
                           sumKey, m_choice.shows(sumKey)});
    }
    const bool zones = m_outcome && m_outcome->result.project.operation->hasZones;
    entries.push_back(
        {colourOf(CompliancePart::rests), Qt::NoPen,
         zones ? tr("γ of the zones, as ground with") : tr("γ of the sections, as ground with"),
         usedKey, m_choice.shows(usedKey)});
    return entries;
}

void CompliancePlot::restyle() {
    style::applyPalette(*this, palette());
    for (QCPAxisRect* rect : {m_shaftRect, m_rect}) {
        for (QCPAxis* axis : rect->axes()) {
            axis->setTickLabelFont(font());
            axis->setLabelFont(font());
        }
    }
    for (const CompliancePart part : stacked) {
        QColor fill = colourOf(part);
        stack(part)->setPen(QPen(fill, 1));
        fill.setAlpha(std::min(fill.alpha(), opacity));
        stack(part)->setBrush(fill);
    }
    m_base->setPen(Qt::NoPen);
    m_sum->setPen(QPen(style::dimmed(palette().color(QPalette::Text), isDimmed()), 2));
    const QColor used = colourOf(CompliancePart::rests);
    m_used->setPen(QPen(used, 1));
    m_used->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, used, 8));
    m_gauge->restyle(isDimmed());
    m_coupling->restyle(isDimmed());
    if (m_outcome) {
        fillBands();
    }
}

void CompliancePlot::labelValues() {
    m_rect->axis(QCPAxis::atBottom)
        ->setLabel(m_content == ComplianceContent::gauge
                       ? tr("Place of the gauge from the headstock end of the ground length, mm")
                       : tr("From the headstock end of the ground length, mm"));
    m_rect->axis(QCPAxis::atLeft)
        ->setLabel(curves() ? LengthCurves::axisLabel() : tr("Compliance γ, nm/N"));
}

void CompliancePlot::setTexts() {
    labelValues();
    if (m_outcome) {
        fillBands();
    }
}

} // namespace sparkout
