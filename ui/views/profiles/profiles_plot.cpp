// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_plot.h"

#include "ui/plot/plot_style.h"
#include "ui/views/profiles/profiles_layers.h"
#include "ui/views/profiles/profiles_table.h"
#include "ui/views/profiles/profiles_text.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double leastReach = 1.15; ///< of the base circle
constexpr double mostField = 2;     ///< a field that reaches further is cut off
constexpr double border = 1.12;     ///< room for the names of the angles inside the rim
constexpr double edge = 3;          ///< around the drawing [px]
constexpr int leastCirclePoints = 180;
constexpr int mostMarkers = 36; ///< more radii are not marked one by one

QVector<QCPCurveData> toData(const std::vector<ProfilePoint>& line) {
    QVector<QCPCurveData> data;
    data.reserve(static_cast<qsizetype>(line.size()));
    for (const ProfilePoint& p : line) {
        data.push_back({static_cast<double>(data.size()), p.x, p.y});
    }
    return data;
}

} // namespace

ProfilesPlot::ProfilesPlot(QWidget* parent) : ProfilePlot(parent) {
    connect(this, &QCustomPlot::afterLayout, this, &ProfilesPlot::keepScales);
    setBuilt();
}

void ProfilesPlot::setSeries(ProfileSeries series, std::vector<int> shown) {
    const bool sameCells = shown.size() == m_cells.size() && !m_cells.empty();
    m_series = std::move(series);
    m_shown = std::move(shown);
    addZones();
    if (!sameCells || arrangement() != m_arrangement) {
        m_sight.reset();
        rebuild();
        return;
    }
    fill();
    setTexts();
}

void ProfilesPlot::setReference(RadiusReference reference) {
    m_reference = reference;
    fit();
}

void ProfilesPlot::setMagnification(std::optional<double> wanted) {
    m_wanted = wanted;
    fit();
}

void ProfilesPlot::setCircles(ReferenceCircles circles) {
    m_circles = circles;
    addZones();
    m_sight.reset();
    rebuild(); // the numbers may take a line more
}

void ProfilesPlot::addZones() {
    if (m_circles == ReferenceCircles::minimumZone) {
        addMinimumZones(m_series, m_shown);
    }
}

void ProfilesPlot::fit() {
    m_sight.reset();
    fill();
    setTexts();
}

// --- contents -----------------------------------------------------------------------------------

std::vector<double> ProfilesPlot::magnifications() const {
    const Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    return possibleMagnifications(reach, m_series.target_mm);
}

void ProfilesPlot::chooseMagnification() {
    Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    if (m_wanted) {
        m_magnification =
            std::min(*m_wanted, possibleMagnifications(reach, m_series.target_mm).back());
        return;
    }
    if (m_reference == RadiusReference::target && visible(ProfileLine::field)) {
        reach.include(m_series.lowerLimit_mm - m_series.target_mm);
        reach.include(m_series.upperLimit_mm - m_series.target_mm);
    }
    m_magnification = suitableMagnification(reach, m_series.target_mm);
}

void ProfilesPlot::fill() {
    if (m_cells.empty()) {
        return;
    }
    chooseMagnification();
    const double base = m_series.target_mm;
    const Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    m_reach = std::max(base * leastReach, base + m_magnification * reach.outward_mm);
    for (std::size_t i = 0; i < m_cells.size() && visible(ProfileLine::field); ++i) {
        const PolarScale scale = polarScale(m_series, profile(i), m_reference, m_magnification);
        m_reach = std::max(m_reach, std::min(scale.at(m_series.upperLimit_mm), base * mostField));
    }
    m_reach *= border;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        fillCell(i);
    }
    if (m_pointedRadius >= 0) {
        pointAt(m_pointedCell, m_pointedRadius);
    }
}

void ProfilesPlot::fillCell(std::size_t index) {
    const Profile& p = profile(index);
    Cell& cell = m_cells[index];
    const PolarScale scale = polarScale(m_series, p, m_reference, m_magnification);
    cell.field->setRing(scale.at(m_series.lowerLimit_mm), scale.at(m_series.upperLimit_mm),
                        m_reach);
    cell.target->setRadius(std::max(scale.at(m_series.target_mm), 0.0));
    cell.polar->setScale(scale, m_reach);
    cell.profile->data()->set(toData(closedLine(p.radii_mm, scale)), true);
    cell.blank->data()->set(toData(closedLine(m_series.blank_mm, scale)), true);
    fillCircles(cell, p, scale);
    const bool marked = m_series.radii() <= mostMarkers;
    cell.profile->setScatterStyle(marked ? QCPScatterStyle(QCPScatterStyle::ssDisc, 4)
                                         : QCPScatterStyle());
    cell.blank->setScatterStyle(marked ? QCPScatterStyle(QCPScatterStyle::ssCross, 4)
                                       : QCPScatterStyle());
    cell.field->setVisible(visible(ProfileLine::field));
    cell.target->setVisible(visible(ProfileLine::target)
                            && scale.at(m_series.target_mm) <= m_reach);
    cell.profile->setVisible(visible(ProfileLine::profile));
    cell.blank->setVisible(visible(ProfileLine::blank));
}

/// The circles go through the angles of the samples, so that they are seen to touch.
void ProfilesPlot::fillCircles(const Cell& cell, const Profile& p, const PolarScale& scale) {
    const int radii = m_series.radii();
    const int points = radii * std::max(leastCirclePoints / radii, 1);
    const RoundnessZone &square = p.leastSquares, &zone = p.minimumZone;
    const auto line = [&](const RoundnessZone& about, double radius) {
        return toData(circleLine({about.x_mm, about.y_mm, radius}, scale, points));
    };
    cell.leastSquares->data()->set(line(square, square.reference_mm), true);
    cell.inner->data()->set(line(zone, zone.inner_mm), true);
    cell.outer->data()->set(line(zone, zone.outer_mm), true);
    std::vector<ProfilePoint> touching;
    const std::vector<ProfilePoint> samples = closedLine(p.radii_mm, scale);
    for (const std::size_t k : zone.contacts) {
        touching.push_back(samples[k]);
    }
    cell.contacts->data()->set(toData(touching), true);
    const bool zones = m_circles == ReferenceCircles::minimumZone;
    const bool squares = m_circles == ReferenceCircles::leastSquares;
    cell.centre->data()->set(toData({centrePoint(zones ? zone : square, scale)}), true);
    const bool seesZone = zones && visible(ProfileLine::minimumZone);
    for (QCPCurve* curve : {cell.inner, cell.outer, cell.contacts}) {
        curve->setVisible(seesZone);
    }
    const bool seesSquare = squares && visible(ProfileLine::leastSquares);
    cell.leastSquares->setVisible(seesSquare);
    cell.centre->setVisible(seesZone || seesSquare);
}

QCPCurve* ProfilesPlot::curve(int index, ProfileLine line) const {
    const Cell& cell = at(index);
    switch (line) {
    case ProfileLine::profile: return cell.profile;
    case ProfileLine::blank: return cell.blank;
    case ProfileLine::leastSquares: return cell.leastSquares;
    case ProfileLine::minimumZone: return cell.outer;
    default: return nullptr;
    }
}

QString ProfilesPlot::numbers(int index) const {
    return at(index).numbers->text();
}

std::vector<ProfileLine> ProfilesPlot::lines() const {
    using enum ProfileLine;
    switch (m_circles) {
    case ReferenceCircles::leastSquares: return {profile, target, leastSquares, field, blank};
    case ReferenceCircles::minimumZone: return {profile, target, minimumZone, field, blank};
    case ReferenceCircles::none: break;
    }
    return {profile, target, field, blank};
}

/// Without the circles that were not chosen.
CsvTable ProfilesPlot::table() const {
    ProfileLines without = hidden();
    if (m_circles != ReferenceCircles::leastSquares) {
        without.insert(ProfileLine::leastSquares);
    }
    if (m_circles != ReferenceCircles::minimumZone) {
        without.insert(ProfileLine::minimumZone);
    }
    return ProfilesTable::across(m_series, m_shown, without);
}

// --- one scale for all --------------------------------------------------------------------------

void ProfilesPlot::onRangeChanged(QCPAxisRect* rect) {
    if (m_linking) {
        return;
    }
    const QCPRange x = rect->axis(QCPAxis::atBottom)->range();
    const QCPRange y = rect->axis(QCPAxis::atLeft)->range();
    m_sight = QRectF(x.lower, y.lower, x.size(), y.size());
}

PlotHistory::State ProfilesPlot::sight() const {
    return m_sight
               ? PlotHistory::State{m_sight->x(), m_sight->y(), m_sight->width(), m_sight->height()}
               : PlotHistory::State();
}

void ProfilesPlot::setSight(const PlotHistory::State& sight) {
    m_sight.reset();
    if (sight.size() == 4) {
        m_sight = QRectF(sight[0], sight[1], sight[2], sight[3]);
    }
}

void ProfilesPlot::keepScales() {
    double unitsPerPixel = 0;
    for (const Cell& cell : m_cells) {
        const QSizeF area(cell.rect->size());
        const double half = std::max(std::min(area.width(), area.height()) / 2 - edge, 10.0);
        unitsPerPixel = std::max(
            unitsPerPixel, m_sight ? std::max(m_sight->width() / std::max(area.width(), 1.0),
                                              m_sight->height() / std::max(area.height(), 1.0))
                                   : m_reach / half);
    }
    const QPointF centre = m_sight ? m_sight->center() : QPointF();
    m_linking = true;
    for (const Cell& cell : m_cells) {
        const double dx = cell.rect->width() * unitsPerPixel / 2;
        const double dy = cell.rect->height() * unitsPerPixel / 2;
        style::setSafeRange(*cell.rect->axis(QCPAxis::atBottom), centre.x() - dx, centre.x() + dx);
        style::setSafeRange(*cell.rect->axis(QCPAxis::atLeft), centre.y() - dy, centre.y() + dy);
    }
    m_linking = false;
}

// --- pointing -----------------------------------------------------------------------------------

void ProfilesPlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const QCPAxisRect* rect = m_cells[i].rect;
        if (rect->rect().contains(event->pos())) {
            const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
            const double y = rect->axis(QCPAxis::atLeft)->pixelToCoord(event->pos().y());
            pointAt(static_cast<int>(i), nearestRadius(std::atan2(y, x), m_series.radii()));
            return;
        }
    }
    pointAway();
}

void ProfilesPlot::pointAt(int cell, int k) {
    const int radii = m_series.radii();
    m_pointedCell = std::clamp(cell, 0, static_cast<int>(m_cells.size()) - 1);
    m_pointedRadius = (k % radii + radii) % radii;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Profile& p = profile(i);
        const PolarScale scale = polarScale(m_series, p, m_reference, m_magnification);
        const auto here = static_cast<std::size_t>(m_pointedRadius);
        const std::size_t across = (here + p.radii_mm.size() / 2) % p.radii_mm.size();
        m_cells[i].pointer->point(angleOf(m_pointedRadius, radii), scale.at(p.radii_mm[here]),
                                  scale.at(p.radii_mm[across]));
    }
    layer(QStringLiteral("overlay"))->replot();
    emit pointed(ProfilesText::sample(m_series, profile(static_cast<std::size_t>(m_pointedCell)),
                                      m_pointedRadius, visible(ProfileLine::blank)));
}

void ProfilesPlot::pointAway() {
    if (m_pointedRadius < 0) {
        return;
    }
    m_pointedRadius = -1;
    for (const Cell& cell : m_cells) {
        cell.pointer->clear();
    }
    layer(QStringLiteral("overlay"))->replot();
    emit pointed({});
}

// Arrows alone move the plot; with Ctrl they walk from sample to sample.
void ProfilesPlot::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    const bool sideways = (key == Qt::Key_Left || key == Qt::Key_Right)
                          && event->modifiers().testFlag(Qt::ControlModifier);
    const bool upDown = key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    if (m_cells.empty() || (!sideways && !upDown && key != Qt::Key_Escape)) {
        QCustomPlot::keyPressEvent(event);
    } else if (key == Qt::Key_Escape) {
        pointAway();
    } else if (m_pointedRadius < 0) {
        pointAt(m_pointedCell, 0);
    } else if (sideways) {
        pointAt(m_pointedCell, m_pointedRadius + (key == Qt::Key_Right ? 1 : -1));
    } else {
        pointAt(m_pointedCell + (key == Qt::Key_PageDown ? 1 : -1), m_pointedRadius);
    }
}

} // namespace sparkout
