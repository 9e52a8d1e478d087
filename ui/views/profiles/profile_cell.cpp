// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profile_cell.h"

#include "ui/plot/plot_style.h"
#include "ui/plot/view_plot.h"
#include "ui/views/profiles/profiles_layers.h"
#include "ui/views/profiles/shown_zone.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr int leastCirclePoints = 180;
constexpr std::size_t mostMarkers = 36; ///< for more radii markers are omitted
constexpr double markSize_px = 8;
constexpr int tallest = 100'000;

QVector<QCPCurveData> toData(const std::vector<ProfilePoint>& line) {
    QVector<QCPCurveData> data;
    data.reserve(static_cast<qsizetype>(line.size()));
    for (const ProfilePoint& p : line) {
        data.push_back({static_cast<double>(data.size()), p.x, p.y});
    }
    return data;
}

} // namespace

ProfileCell::ProfileCell(QCustomPlot& plot, QCPLayoutGrid& into, bool numbersBeside)
    : m_header(new QCPTextElement(&plot))
    , m_numbers(new QCPTextElement(&plot))
    , m_rect(new QCPAxisRect(&plot, true)) {
    arrange(into, numbersBeside);
    for (QCPAxis* axis : style::axesOf(*m_rect)) {
        axis->setVisible(false);
        axis->grid()->setVisible(false);
    }
    m_field = new PolarRing(m_rect, QStringLiteral("bands"));
    m_grid = new PolarGrid(m_rect, QStringLiteral("grid"));
    m_target = new PolarCircle(m_rect, QStringLiteral("main"));
    m_pointer = new PolarPointer(m_rect);
    for (QCPCurve** curve :
         {&m_blank, &m_leastSquares, &m_inner, &m_outer, &m_centre, &m_profile, &m_contacts}) {
        *curve = ViewPlot::addCurve(*m_rect);
    }
    m_centre->setLineStyle(QCPCurve::lsNone);
    m_contacts->setLineStyle(QCPCurve::lsNone);
}

void ProfileCell::arrange(QCPLayoutGrid& into, bool numbersBeside) const {
    into.addElement(0, 0, m_header);
    into.addElement(1, 0, m_rect);
    into.setRowStretchFactor(0, 0.001);
    if (numbersBeside) {
        into.addElement(1, 1, m_numbers);
        into.setColumnStretchFactor(1, 0.001);
        m_numbers->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
        m_numbers->setMaximumSize(tallest, tallest); // otherwise its lines set the row's height
    } else {
        into.addElement(2, 0, m_numbers);
        into.setRowStretchFactor(2, 0.001);
        m_numbers->setTextFlags(Qt::AlignHCenter | Qt::AlignTop);
    }
    m_header->setMargins(QMargins(2, 2, 2, 0));
    m_numbers->setMargins(QMargins(2, 0, 4, 2));
    m_rect->setAutoMargins(QCP::msNone);
    m_rect->setMargins(QMargins(2, 0, 2, 0));
}

void ProfileCell::removeLayers() {
    delete m_field;
    delete m_target;
    delete m_grid;
    delete m_pointer;
}

void ProfileCell::fill(const ProfileSeries& series, const Profile& profile, const PolarScale& scale,
                       double reach, const ProfileLines& hidden, ReferenceCircles circles) {
    m_field->setRing(scale.at(series.lowerLimit_mm), scale.at(series.upperLimit_mm), reach);
    m_target->setRadius(std::max(scale.at(series.target_mm), 0.0));
    m_grid->setScale(scale, reach);
    m_profile->data()->set(toData(closedLine(profile.radii_mm, scale)), true);
    m_blank->data()->set(toData(closedLine(series.blankOf(profile), scale)), true);
    fillCircles(profile, scale, hidden, circles);
    const bool marked = profile.radii_mm.size() <= mostMarkers;
    m_profile->setScatterStyle(marked ? QCPScatterStyle(QCPScatterStyle::ssDisc, 4)
                                      : QCPScatterStyle());
    m_blank->setScatterStyle(marked ? QCPScatterStyle(QCPScatterStyle::ssCross, 4)
                                    : QCPScatterStyle());
    m_grid->setLine(hidden.contains(ProfileLine::profile) ? std::vector<ProfilePoint>()
                                                          : closedLine(profile.radii_mm, scale));
    m_field->setVisible(!hidden.contains(ProfileLine::field));
    m_target->setVisible(!hidden.contains(ProfileLine::target)
                         && scale.at(series.target_mm) <= reach);
    m_profile->setVisible(!hidden.contains(ProfileLine::profile));
    m_blank->setVisible(!hidden.contains(ProfileLine::blank));
}

void ProfileCell::showFormAlone() const {
    m_blank->setVisible(false);
    m_field->setVisible(false);
    m_target->setVisible(false);
}

/// Draws the circles through the angles of the samples, so that the contact is visible.
void ProfileCell::fillCircles(const Profile& profile, const PolarScale& scale,
                              const ProfileLines& hidden, ReferenceCircles circles) {
    const int radii = static_cast<int>(profile.radii_mm.size());
    const int points = radii * std::max(leastCirclePoints / radii, 1);
    const auto line = [&](const RoundnessZone& about, double radius) {
        return toData(circleLine({about.x_mm, about.y_mm, radius}, scale, points));
    };
    const RoundnessZone* const zone = shownZone(profile, circles);
    const bool squares = circles == ReferenceCircles::leastSquares;
    const auto shown = lineOf(circles);
    const bool sees = zone && shown && !hidden.contains(*shown);
    m_leastSquares->data()->set(line(profile.leastSquares, profile.leastSquares.reference_mm),
                                true);
    std::vector<ProfilePoint> touching;
    if (zone) {
        m_inner->data()->set(line(*zone, zone->inner_mm), true);
        m_outer->data()->set(line(*zone, zone->outer_mm), true);
        m_centre->data()->set(toData({centrePoint(*zone, scale)}), true);
    }
    if (circles == ReferenceCircles::minimumZone) {
        const std::vector<ProfilePoint> samples = closedLine(profile.radii_mm, scale);
        for (const std::size_t k : profile.minimumZone.contacts) {
            touching.push_back(samples[k]);
        }
    }
    m_contacts->data()->set(toData(touching), true);
    m_inner->setVisible(sees && !squares);
    m_outer->setVisible(sees && !squares);
    m_contacts->setVisible(sees && circles == ReferenceCircles::minimumZone);
    m_leastSquares->setVisible(sees && squares);
    m_centre->setVisible(sees);
    m_circles = circles;
    setCirclePens();
}

/// The circle that only bounds the profile is dotted.
void ProfileCell::setCirclePens() {
    QPen bound = m_circlePen;
    bound.setStyle(Qt::DotLine);
    m_inner->setPen(m_circles == ReferenceCircles::circumscribed ? bound : m_circlePen);
    m_outer->setPen(m_circles == ReferenceCircles::inscribed ? bound : m_circlePen);
}

void ProfileCell::restyle(const QFont& font, const QPalette& palette, bool dim) {
    m_header->setFont(font); // the size of the numbers depends on their space
    for (QCPTextElement* element : {m_header, m_numbers}) {
        element->setTextColor(palette.color(QPalette::Text));
    }
    const auto pen = [&](ProfileLine line) { return ProfileLook::pen(line, palette, dim); };
    m_field->setLook(pen(ProfileLine::field), ProfileLook::fill(ProfileLine::field, palette, dim));
    m_target->setPen(pen(ProfileLine::target));
    m_blank->setPen(pen(ProfileLine::blank));
    m_leastSquares->setPen(pen(ProfileLine::leastSquares));
    m_circlePen = pen(ProfileLine::minimumZone);
    setCirclePens();
    const QPen mark(m_circlePen.color(), 1.6);
    m_centre->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssPlus, mark, Qt::NoBrush, markSize_px));
    m_contacts->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, mark, Qt::NoBrush, markSize_px));
    m_profile->setPen(pen(ProfileLine::profile));
}

void ProfileCell::point(const Profile& profile, const PolarScale& scale, int k) {
    const auto here = static_cast<std::size_t>(k);
    const std::size_t across = (here + profile.radii_mm.size() / 2) % profile.radii_mm.size();
    m_pointer->point(angleOf(k, static_cast<int>(profile.radii_mm.size())),
                     scale.at(profile.radii_mm[here]), scale.at(profile.radii_mm[across]));
}

} // namespace sparkout
