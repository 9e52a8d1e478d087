// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/longitudinal_plot.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/chart/free_place.h"
#include "ui/chart/longitudinal_layers.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/plot_cursors.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/part/profiles_text.h"

#include <algorithm>
#include <cmath>
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

/// Rounds an exaggeration to two digits.
double roundTo2(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
}

} // namespace

LongitudinalPlot::LongitudinalPlot(QWidget* parent) : FramedPlot(parent) {
    build();
    connect(this, &QCustomPlot::afterLayout, this, &LongitudinalPlot::afterLayouting);
    onClick([this](const QPointF& at) {
        if (const int profile = profileUnder(at.toPoint()); profile >= 0) {
            emit profileClicked(profile);
        }
    });
    built();
}

void LongitudinalPlot::setSeries(ProfileSeries series, std::vector<ShaftStep> shaft,
                                 std::vector<int> shown) {
    const bool samePart =
        series.length_mm == m_series.length_mm && series.nominal_mm == m_series.nominal_mm;
    m_series = std::move(series);
    m_shaft = std::move(shaft);
    m_shown = std::move(shown);
    if (!samePart) {
        showAll();
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

void LongitudinalPlot::fit() {
    showAll();
    fill();
}

void LongitudinalPlot::setVisibleRange(const PlotHistory::State& range) {
    FramedPlot::setVisibleRange(range);
    if (frame()) {
        setRanges(*m_rect, {frame()->left(), frame()->right()},
                  {frame()->top(), frame()->bottom()});
    } else {
        fitAxes();
    }
}

// --- building -----------------------------------------------------------------------------------

void LongitudinalPlot::build() {
    m_rect = addCell();
    m_rect->setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), 14, 0));
    followMoves(*m_rect);
    m_bands = new BandLayer(m_rect, true);
    m_body = new ShaftLayer(m_rect);
    for (const LengthLine line : lengthLines) {
        for (const bool mirrored : {false, true}) {
            m_curves.push_back({line, mirrored, addLine(*m_rect)});
        }
    }
    graph(LengthLine::upperLimit)->setChannelFillGraph(graph(LengthLine::lowerLimit));
    graph(LengthLine::blankMax)->setChannelFillGraph(graph(LengthLine::blankMin));
    graph(LengthLine::max)->setChannelFillGraph(graph(LengthLine::min));
    m_gaugeLine = new QCPItemLine(this);
    m_gaugeName = new QCPItemText(this);
    const auto points = {m_gaugeLine->start, m_gaugeLine->end, m_gaugeName->position};
    anchor(points, *m_rect);
    for (QCPItemPosition* point : points) {
        point->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    for (QCPAbstractItem* item :
         std::initializer_list<QCPAbstractItem*>{m_gaugeLine, m_gaugeName}) {
        item->setSelectable(false);
        item->setClipAxisRect(m_rect);
    }
    m_gaugeName->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_gaugeName->setPadding(QMargins(3, 0, 3, 0));
}

void LongitudinalPlot::fillBands() {
    std::vector<Band> bands;
    const bool sections = !m_series.operation->travels;
    for (std::size_t i = 0; i < m_series.profiles.size(); ++i) {
        const Profile& p = m_series.profiles[i];
        if (sections && std::ranges::find(m_shown, static_cast<int>(i)) == m_shown.end()) {
            continue;
        }
        Band band = zoneBand(p.zone, p.section, p.from_mm, p.to_mm);
        if (p.zone == Zone::rz1) {
            band.name = tr("%1 (entry)").arg(band.name);
        } else if (p.zone == Zone::rz2) {
            band.name = tr("%1 (exit)").arg(band.name);
        }
        bands.push_back(std::move(band));
    }
    std::ranges::sort(bands, {}, &Band::from);
    m_bands->setBands(std::move(bands));
}

// --- contents -----------------------------------------------------------------------------------

LengthQuantity LongitudinalPlot::quantity() const {
    return m_toScale     ? LengthQuantity::radius_mm
           : m_diameters ? LengthQuantity::diameter_um
                         : LengthQuantity::radius_um;
}

bool LongitudinalPlot::draws(LengthLine line) const {
    const auto on = [this](ProfileLine what) { return visible(what); };
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
    const bool sections = !m_series.operation->travels;
    for (const Curve& curve : m_curves) {
        const bool drawn = draws(curve.line) && (m_toScale || !curve.mirrored);
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
    const bool on = visible(ProfileLine::gauge) && !m_series.profiles.empty();
    m_gaugeLine->setVisible(on);
    m_gaugeLine->start->setCoords(m_series.gauge_mm, 0);
    m_gaugeLine->end->setCoords(m_series.gauge_mm, 1);
}

/// Places the name beside its line, at a height without curves.
void LongitudinalPlot::placeGaugeName() {
    const QRectF room(m_rect->rect());
    const double x = m_rect->axis(QCPAxis::atBottom)->coordToPixel(m_series.gauge_mm);
    const bool isSeen = m_gaugeLine->visible() && x >= room.left() && x <= room.right();
    m_gaugeName->setVisible(isSeen);
    if (!isSeen) {
        return;
    }
    FreePlace places(room.adjusted(1, 1, -1, -1));
    places.addCurve({{x, room.top()}, {x, room.bottom()}});
    for (const Curve& curve : m_curves) {
        QPolygonF points;
        for (const QCPGraphData& point : *curve.graph->data()) {
            points << curve.graph->coordsToPixels(point.key, point.value);
        }
        if (curve.graph->visible()) {
            places.addCurve(points);
        }
    }
    const QSizeF text = QFontMetricsF(font()).boundingRect(m_gaugeName->text()).size();
    const QMargins around = m_gaugeName->padding();
    const QSizeF size(text.width() + around.left() + around.right(), text.height());
    m_gaugeName->position->setPixelPosition(places.nearest(size, {x, room.top()}).place.topLeft());
}

QCPRange LongitudinalPlot::visibleValues() const {
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
    if (frame() || m_toScale) {
        return; // to scale, the layout decides
    }
    const QCPRange values = visibleValues();
    const double room = values.size() > 0 ? values.size() * pad : 1;
    const double sides = m_series.length_mm * 0.02;
    setRanges(*m_rect, {-sides, m_series.length_mm + sides},
              {values.lower - room, values.upper + room});
}

void LongitudinalPlot::afterLayouting() {
    if (m_toScale) {
        keepScale();
    }
    showScale();
    style::fitValueAxes(*m_rect, font());
    placeGaugeName();
}

/// Keeps one scale for both axes, whatever the window's shape.
void LongitudinalPlot::keepScale() {
    const QRectF area = m_rect->rect();
    const QRectF wanted = frame().value_or(m_body->bounds());
    const double border = frame() ? 1 : scaleBorder;
    const double perPixel = border
                            * std::max(wanted.width() / std::max(area.width(), 1.0),
                                       wanted.height() / std::max(area.height(), 1.0));
    showAround(*m_rect, wanted.center(), perPixel);
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
    CursorSubject subject = ViewPlot::cursorSubject();
    subject.axis = [] { return placeLabel(); };
    return subject;
}

std::vector<ProfileLine> LongitudinalPlot::lines() const {
    using enum ProfileLine;
    return {profile, spread, target, field, blank, gauge};
}

CsvTable LongitudinalPlot::table() const {
    return ProfilesTable::along(m_series, quantity(), hidden());
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
                                       visible(ProfileLine::blank)));
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

// --- look and texts -----------------------------------------------------------------------------

QString LongitudinalPlot::nameOf(const Curve& curve) const {
    QString name;
    switch (curve.line) {
    case LengthLine::lowerLimit: name = tr("lower limit"); break;
    case LengthLine::upperLimit: name = tr("upper limit"); break;
    case LengthLine::target: name = tr("target"); break;
    case LengthLine::blankMin: name = tr("blank, minimum"); break;
    case LengthLine::blankMax: name = tr("blank, maximum"); break;
    case LengthLine::min: name = tr("minimum"); break;
    case LengthLine::max: name = tr("maximum"); break;
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

/// The exaggeration, or for a drawing to scale the size of a pixel.
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
    ViewPlot::restyle();
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
}

} // namespace sparkout
