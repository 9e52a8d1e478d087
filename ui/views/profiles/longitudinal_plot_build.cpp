// SPDX-License-Identifier: GPL-3.0-or-later
// The longitudinal plot: building, labels and colours.
#include "core/units.h"
#include "ui/charts/longitudinal_layers.h"
#include "ui/plot/band_layer.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/profiles/longitudinal_plot.h"
#include "ui/views/profiles/profiles_text.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

ProfileLine lookOf(LengthLine line) {
    switch (line) {
    case LengthLine::lowerLimit:
    case LengthLine::upperLimit: return ProfileLine::field;
    case LengthLine::target: return ProfileLine::target;
    case LengthLine::blankMin:
    case LengthLine::blankMax: return ProfileLine::blank;
    case LengthLine::min:
    case LengthLine::max: return ProfileLine::spread;
    case LengthLine::mean: break;
    }
    return ProfileLine::profile;
}

/// To two digits, as an exaggeration is told.
double roundTo2(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
}

} // namespace

void LongitudinalPlot::build() {
    m_rect = new QCPAxisRect(this, true);
    plotLayout()->addElement(0, 0, m_rect);
    m_rect->setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), 14, 0));
    for (QCPAxis* axis : m_rect->axes()) {
        style::setUpAxis(*axis);
        connect(axis, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this, [this] {
            if (!m_linking) {
                const QCPRange x = m_rect->axis(QCPAxis::atBottom)->range();
                const QCPRange y = m_rect->axis(QCPAxis::atLeft)->range();
                m_sight = QRectF(x.lower, y.lower, x.size(), y.size());
            }
        });
    }
    m_rect->axis(QCPAxis::atTop)->setVisible(true);
    m_rect->axis(QCPAxis::atTop)->setTicks(false);
    m_rect->axis(QCPAxis::atRight)->setVisible(true);
    m_rect->axis(QCPAxis::atRight)->setTicks(false);
    m_bands = new BandLayer(m_rect, true);
    m_body = new ShaftLayer(m_rect);
    for (const LengthLine line : lengthLines) {
        for (const bool mirrored : {false, true}) {
            QCPGraph* graph =
                addGraph(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
            graph->removeFromLegend();
            graph->setSelectable(QCP::stNone);
            m_curves.push_back({line, mirrored, graph});
        }
    }
    graph(LengthLine::upperLimit)->setChannelFillGraph(graph(LengthLine::lowerLimit));
    graph(LengthLine::blankMax)->setChannelFillGraph(graph(LengthLine::blankMin));
    graph(LengthLine::max)->setChannelFillGraph(graph(LengthLine::min));
    m_gaugeLine = new QCPItemLine(this);
    m_gaugeName = new QCPItemText(this);
    for (QCPItemPosition* position :
         {m_gaugeLine->start, m_gaugeLine->end, m_gaugeName->position}) {
        position->setAxisRect(m_rect);
        position->setAxes(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
        position->setTypeX(QCPItemPosition::ptPlotCoords);
        position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    for (QCPAbstractItem* item :
         std::initializer_list<QCPAbstractItem*>{m_gaugeLine, m_gaugeName}) {
        item->setSelectable(false);
        item->setClipAxisRect(m_rect);
    }
    m_gaugeName->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_gaugeName->setPadding(QMargins(3, 0, 3, 0));
    restyle();
    retranslate();
}

void LongitudinalPlot::fillBands() {
    std::vector<Band> bands;
    const bool sections = !m_series.operation->hasZones;
    for (std::size_t i = 0; i < m_series.profiles.size(); ++i) {
        const Profile& p = m_series.profiles[i];
        if (sections && std::ranges::find(m_shown, static_cast<int>(i)) == m_shown.end()) {
            continue;
        }
        const bool middle = p.zone == Zone::nz;
        QColor colour =
            style::colour(middle ? style::Drawn::middleZone : style::Drawn::endZone, palette());
        colour.setAlpha(middle ? 38 : 28);
        const QString full = Names::zoneFull(p.zone, p.section);
        QString name = Names::zone(p.zone, p.section);
        if (p.zone == Zone::rz1) {
            name = tr("%1 (entry)").arg(name);
        } else if (p.zone == Zone::rz2) {
            name = tr("%1 (exit)").arg(name);
        }
        Band band;
        band.from = p.from_mm;
        band.to = p.to_mm;
        band.colour = colour;
        band.name = name;
        band.meaning = full;
        bands.push_back(band);
    }
    std::ranges::sort(bands, {}, &Band::from);
    m_bands->setBands(std::move(bands));
}

QString LongitudinalPlot::nameOf(const Curve& curve) const {
    QString name;
    switch (curve.line) {
    case LengthLine::lowerLimit: name = tr("lower limit"); break;
    case LengthLine::upperLimit: name = tr("upper limit"); break;
    case LengthLine::target: name = tr("target"); break;
    case LengthLine::blankMin: name = tr("blank, smallest"); break;
    case LengthLine::blankMax: name = tr("blank, largest"); break;
    case LengthLine::min: name = tr("smallest"); break;
    case LengthLine::max: name = tr("largest"); break;
    case LengthLine::mean: name = tr("mean"); break;
    }
    return curve.mirrored ? tr("%1, other side").arg(name) : name;
}

void LongitudinalPlot::label() {
    showScale();
    m_rect->axis(QCPAxis::atLeft)
        ->setLabel(m_toScale     ? tr("Radius, mm")
                   : m_diameters ? tr("Diameter from\nnominal, µm")
                                 : tr("Radius from\ntarget, µm"));
    m_gaugeName->setText(ProfileLook::name(ProfileLine::gauge));
    for (const Curve& curve : m_curves) {
        curve.graph->setName(nameOf(curve));
    }
}

/// How much the drawing exaggerates, or how little of the error a drawing to scale can show.
QString LongitudinalPlot::scaleText() const {
    const QCPRange x = m_rect->axis(QCPAxis::atBottom)->range();
    const QCPRange y = m_rect->axis(QCPAxis::atLeft)->range();
    const double width = std::max(m_rect->width(), 1), height = std::max(m_rect->height(), 1);
    if (m_toScale) {
        const double pixel_um = y.size() / height * units::umPerMm;
        const double field_um = (m_series.upperLimit_mm - m_series.lowerLimit_mm) * units::umPerMm;
        return tr("to scale: one pixel is %1 µm; the tolerance of the radius, %2 µm, is %3 of it")
            .arg(Names::significant(pixel_um), Names::significant(field_um),
                 Names::significant(field_um / pixel_um, 2));
    }
    const double times = (height / y.size() * units::umPerMm) / (width / x.size());
    return tr("heights exaggerated %1").arg(ProfilesText::magnification(roundTo2(times)));
}

QString LongitudinalPlot::placeLabel() {
    return tr("From the headstock end of the ground length, mm");
}

void LongitudinalPlot::showScale() {
    const QString axis = placeLabel();
    const QString text = scaleText();
    QString line = axis + u'\n' + text;
    if (!m_toScale) {
        line = tr("%1; %2").arg(axis, text);
        if (QFontMetrics(font()).horizontalAdvance(line) >= m_rect->width()) {
            line = tr("%1; %2").arg(tr("From the headstock end, mm"), text);
        }
    }
    m_rect->axis(QCPAxis::atBottom)->setLabel(line);
}

void LongitudinalPlot::setTexts() {
    label();
    fillBands();
}

void LongitudinalPlot::restyle() {
    style::applyPalette(*this, palette());
    for (QCPAxis* axis : m_rect->axes()) {
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
    }
    for (const Curve& curve : m_curves) {
        const ProfileLine look = lookOf(curve.line);
        curve.graph->setPen(ProfileLook::pen(look, palette(), isDimmed()));
        const bool top = curve.line == LengthLine::upperLimit || curve.line == LengthLine::blankMax
                         || curve.line == LengthLine::max;
        curve.graph->setBrush(top && !curve.mirrored && !m_toScale
                                  ? QBrush(ProfileLook::fill(look, palette(), isDimmed()))
                                  : QBrush(Qt::NoBrush));
    }
    const QPen gauge = ProfileLook::pen(ProfileLine::gauge, palette(), isDimmed());
    m_gaugeLine->setPen(gauge);
    m_gaugeName->setColor(gauge.color());
    m_gaugeName->setFont(font());
    fillBands();
}

} // namespace sparkout
