// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/longitudinal_plot.h"

#include "ui/charts/longitudinal_layers.h"
#include "ui/plot/band_layer.h"
#include "ui/plot/plot_click.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_style.h"
#include "ui/views/profiles/profiles_text.h"

#include <algorithm>
#include <limits>

namespace sparkout {

namespace {

constexpr double pad = 0.06;
constexpr double scaleBorder = 1.12;

QVector<QCPGraphData> toData(const std::vector<ProfilePoint>& line, double factor) {
    QVector<QCPGraphData> data;
    data.reserve(static_cast<qsizetype>(line.size()));
    for (const ProfilePoint& p : line) {
        data.push_back({p.x, p.y * factor});
    }
    return data;
}

} // namespace

LongitudinalPlot::LongitudinalPlot(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    plotLayout()->clear();
    build();
    connect(this, &QCustomPlot::afterLayout, this, &LongitudinalPlot::afterLayouting);
    connect(this, &QCustomPlot::mouseMove, this, &LongitudinalPlot::onMouse);
    onPlotClick(*this, [this](const QPointF& at) {
        if (const int profile = profileUnder(at.toPoint()); profile >= 0) {
            emit profileClicked(profile);
        }
    });
    setBuilt();
}

void LongitudinalPlot::setSeries(ProfileSeries series, std::vector<ShaftStep> shaft,
                                 std::vector<int> shown) {
    const bool samePart =
        series.length_mm == m_series.length_mm && series.nominal_mm == m_series.nominal_mm;
    m_series = std::move(series);
    m_shaft = std::move(shaft);
    m_shown = std::move(shown);
    if (!samePart) {
        m_sight.reset();
    }
    if (m_pointed >= static_cast<int>(m_series.profiles.size())) {
        m_pointed = -1;
    }
    fill();
}

void LongitudinalPlot::setDiameters(bool diameters) {
    m_diameters = diameters;
    fit();
    label();
}

void LongitudinalPlot::setToScale(bool toScale) {
    m_toScale = toScale;
    fit();
    label();
    restyle();
}

void LongitudinalPlot::setHidden(ProfileLines hidden) {
    m_hidden = std::move(hidden);
    fit();
}

void LongitudinalPlot::fit() {
    m_sight.reset();
    fill();
}

std::vector<double> LongitudinalPlot::sight() const {
    return m_sight ? std::vector<double>{m_sight->x(), m_sight->y(), m_sight->width(),
                                         m_sight->height()}
                   : std::vector<double>();
}

void LongitudinalPlot::setSight(const std::vector<double>& sight) {
    m_sight.reset();
    if (sight.size() != 4) {
        fitAxes();
        return;
    }
    m_linking = true;
    m_sight = QRectF(sight[0], sight[1], sight[2], sight[3]);
    style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), m_sight->left(), m_sight->right());
    style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), m_sight->top(), m_sight->bottom());
    m_linking = false;
}

// --- contents -----------------------------------------------------------------------------------

LengthQuantity LongitudinalPlot::quantity() const {
    return m_toScale     ? LengthQuantity::radius_mm
           : m_diameters ? LengthQuantity::diameter_um
                         : LengthQuantity::radius_um;
}

bool LongitudinalPlot::visible(LengthLine line) const {
    const auto on = [this](ProfileLine what) { return !m_hidden.contains(what); };
    const bool bore = m_series.surface == Surface::internal;
    switch (line) {
    case LengthLine::lowerLimit:
    case LengthLine::upperLimit: return on(ProfileLine::field);
    case LengthLine::target: return on(ProfileLine::target);
    case LengthLine::blankMin: return on(ProfileLine::blank) && (!m_toScale || bore);
    case LengthLine::blankMax: return on(ProfileLine::blank) && (!m_toScale || !bore);
    case LengthLine::min:
    case LengthLine::max: return on(ProfileLine::spread) && !m_toScale;
    case LengthLine::mean: break;
    }
    return on(ProfileLine::profile);
}

void LongitudinalPlot::fill() {
    const bool sections = !m_series.operation->hasZones;
    for (const Curve& curve : m_curves) {
        const bool drawn = visible(curve.line) && (m_toScale || !curve.mirrored);
        curve.graph->setVisible(drawn);
        curve.graph->data()->set(
            toData(lengthLine(m_series, curve.line, quantity()), curve.mirrored ? -1 : 1), true);
        const bool points = sections && !m_toScale && m_series.profiles.size() <= 40;
        const auto mark = [&](LengthLine line, QCPScatterStyle::ScatterShape shape, int size) {
            if (curve.line == line) {
                curve.graph->setScatterStyle(points ? QCPScatterStyle(shape, size)
                                                    : QCPScatterStyle());
            }
        };
        mark(LengthLine::mean, QCPScatterStyle::ssDisc, 5);
        mark(LengthLine::min, QCPScatterStyle::ssTriangle, 4);
        mark(LengthLine::max, QCPScatterStyle::ssTriangleInverted, 4);
    }
    m_body->setVisible(m_toScale);
    m_body->setBody(m_shaft, m_series.length_mm, m_series.target_mm,
                    m_series.surface == Surface::internal);
    fillBands();
    placeGauge();
    fitAxes();
}

void LongitudinalPlot::placeGauge() {
    const bool on = !m_hidden.contains(ProfileLine::gauge) && !m_series.profiles.empty();
    m_gaugeLine->setVisible(on);
    m_gaugeName->setVisible(on);
    m_gaugeLine->start->setCoords(m_series.gauge_mm, 0);
    m_gaugeLine->end->setCoords(m_series.gauge_mm, 1);
    m_gaugeName->position->setCoords(m_series.gauge_mm, 0.02);
}

QCPRange LongitudinalPlot::valuesInSight() const {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const Curve& curve : m_curves) {
        if (curve.graph->visible()) {
            for (const QCPGraphData& point : *curve.graph->data()) {
                low = std::min(low, point.value);
                high = std::max(high, point.value);
            }
        }
    }
    return low <= high ? QCPRange(low, high) : QCPRange(-1, 1);
}

void LongitudinalPlot::fitAxes() {
    if (m_sight || m_toScale) {
        return; // to scale, the layout decides
    }
    m_linking = true;
    const QCPRange values = valuesInSight();
    const double room = values.size() > 0 ? values.size() * pad : 1;
    const double sides = m_series.length_mm * 0.02;
    style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), values.lower - room, values.upper + room);
    style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), -sides, m_series.length_mm + sides);
    m_linking = false;
}

void LongitudinalPlot::afterLayouting() {
    if (m_toScale) {
        keepScale();
    }
    showScale();
    style::fitValueAxes(*m_rect, font());
}

/// Both axes at the same scale, whatever the window's shape.
void LongitudinalPlot::keepScale() {
    const QRectF area = m_rect->rect();
    const QRectF wanted = m_sight.value_or(m_body->bounds());
    const double border = m_sight ? 1 : scaleBorder;
    const double perPixel = border
                            * std::max(wanted.width() / std::max(area.width(), 1.0),
                                       wanted.height() / std::max(area.height(), 1.0));
    const QPointF centre = wanted.center();
    const double dx = area.width() * perPixel / 2;
    const double dy = area.height() * perPixel / 2;
    m_linking = true;
    style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), centre.x() - dx, centre.x() + dx);
    style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), centre.y() - dy, centre.y() + dy);
    m_linking = false;
}

QCPGraph* LongitudinalPlot::graph(LengthLine line, bool mirrored) const {
    const auto found = std::ranges::find_if(
        m_curves, [&](const Curve& c) { return c.line == line && c.mirrored == mirrored; });
    return found == m_curves.end() ? nullptr : found->graph;
}

// --- cursors ------------------------------------------------------------------------------------

ReadCurves LongitudinalPlot::readCurves() const {
    ReadCurves curves;
    for (const Curve& curve : m_curves) {
        if (curve.graph->visible() && !curve.mirrored) {
            const QString name = (m_toScale ? tr("%1, mm") : tr("%1, µm")).arg(nameOf(curve));
            curves.push_back({QString(), name,
                              m_toScale ? Digits::tenThousandths : Digits::signedHundredths,
                              [graph = curve.graph](double x) { return valueAt(*graph, x); }});
        }
    }
    return curves;
}

CursorSubject LongitudinalPlot::cursorSubject() {
    return {[] { return placeLabel(); },
            [this] { return QCPRange(0, m_series.length_mm); },
            [this] { return readCurves(); },
            {},
            {}};
}

// --- pointing -----------------------------------------------------------------------------------

int LongitudinalPlot::profileUnder(const QPoint& at) const {
    const double x = m_rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
    const bool inside = m_rect->rect().contains(at) && x >= 0 && x <= m_series.length_mm;
    return inside ? profileAt(m_series, x) : -1;
}

void LongitudinalPlot::onMouse(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        pointAt(profileUnder(event->pos()));
    }
}

void LongitudinalPlot::pointAt(int profile) {
    if (profile < 0 || profile >= static_cast<int>(m_series.profiles.size())) {
        if (m_pointed >= 0) {
            m_pointed = -1;
            emit pointed({});
        }
        return;
    }
    m_pointed = profile;
    emit pointed(ProfilesText::stretch(m_series,
                                       m_series.profiles[static_cast<std::size_t>(profile)],
                                       !m_hidden.contains(ProfileLine::blank)));
}

void LongitudinalPlot::keyPressEvent(QKeyEvent* event) {
    const int last = static_cast<int>(m_series.profiles.size()) - 1;
    const int key = event->key();
    if (key == Qt::Key_Escape) {
        pointAt(-1);
    } else if ((key == Qt::Key_Left || key == Qt::Key_Right)
               && event->modifiers().testFlag(Qt::ControlModifier)) {
        const int step = key == Qt::Key_Right ? 1 : -1;
        pointAt(m_pointed < 0 ? 0 : std::clamp(m_pointed + step, 0, last));
    } else {
        QCustomPlot::keyPressEvent(event);
    }
}

} // namespace sparkout
