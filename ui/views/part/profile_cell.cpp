// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/profile_cell.h"

#include "core/units.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"
#include "ui/views/part/profiles_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace sparkout {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int spokeStep = 30;            ///< [°]
constexpr double leastLinesApart = 1.05; ///< distance of the grid's circles, in line heights
constexpr int mostCircles = 100;
constexpr double wholeCircle_px = 2000; ///< larger circles are drawn as visible arcs
constexpr double margin_px = 20;

QPointF direction(double angle) {
    return {std::cos(angle), -std::sin(angle)}; // the pixels' y runs downwards
}

} // namespace

PolarLayer::PolarLayer(QCPAxisRect* rect, const QString& layer)
    : PaintedLayer(*rect, layer, Edges::smooth) {}

QPointF PolarLayer::centre() const {
    return {m_rect->axis(QCPAxis::atBottom)->coordToPixel(0),
            m_rect->axis(QCPAxis::atLeft)->coordToPixel(0)};
}

double PolarLayer::scale() const {
    const QCPAxis* axis = m_rect->axis(QCPAxis::atBottom);
    return axis->coordToPixel(1) - axis->coordToPixel(0);
}

PolarLayer::VisiblePart PolarLayer::visiblePart() const {
    const QRectF rect = m_rect->rect();
    const QPointF c = centre();
    const QPointF middle = rect.center() - c;
    const double half = std::hypot(rect.width(), rect.height()) / 2;
    const double away = std::hypot(middle.x(), middle.y());
    if (away <= half) {
        return {0, away + half, 0, 2 * std::numbers::pi};
    }
    const double spread = std::asin(half / away);
    return {away - half, away + half, std::atan2(-middle.y(), middle.x()) - spread, 2 * spread};
}

QPolygonF PolarLayer::arc(const VisiblePart& part, double radius_px) const {
    constexpr int parts = 120;
    QPolygonF points;
    for (int i = 0; i <= parts; ++i) {
        points << centre() + radius_px * direction(part.from + part.span * i / parts);
    }
    return points;
}

// Only the visible part of a very large circle is drawn, since dashes are slow.
void PolarLayer::drawCircle(QCPPainter* painter, double radius) const {
    const double r = radius * scale();
    const VisiblePart seen = visiblePart();
    if (r < seen.near - margin_px || r > seen.far + margin_px) {
        return;
    }
    if (r <= wholeCircle_px) {
        painter->drawEllipse(centre(), r, r);
    } else {
        painter->drawPolyline(arc(seen, r));
    }
}

// --- ring and circle ----------------------------------------------------------------------------

void PolarRing::setRing(double inner, double outer, double reach) {
    m_inner = std::max(inner, 0.0);
    m_outer = std::max(outer, 0.0);
    m_reach = reach;
}

void PolarRing::setLook(const QPen& edge, const QColor& fill) {
    m_edge = edge;
    m_fill = fill;
}

void PolarRing::draw(QCPPainter* painter) {
    const VisiblePart seen = visiblePart();
    const double inner = std::max(m_inner * scale(), seen.near - margin_px);
    const double outer = std::min(std::min(m_outer, m_reach) * scale(), seen.far + margin_px);
    if (outer <= inner) {
        return;
    }
    QPainterPath ring;
    if (outer <= wholeCircle_px) {
        ring.addEllipse(centre(), outer, outer);
        ring.addEllipse(centre(), std::max(inner, 0.0), std::max(inner, 0.0)); // odd-even: a hole
    } else {
        QPolygonF polygon = arc(seen, outer);
        const QPolygonF back = arc(seen, std::max(inner, 0.0));
        std::copy(back.crbegin(), back.crend(), std::back_inserter(polygon));
        ring.addPolygon(polygon);
    }
    painter->fillPath(ring, m_fill);
    painter->setPen(m_edge);
    painter->setBrush(Qt::NoBrush);
    for (const double edge : {m_inner, m_outer}) {
        if (edge > 0 && edge <= m_reach) {
            drawCircle(painter, edge);
        }
    }
}

void PolarCircle::draw(QCPPainter* painter) {
    painter->setPen(m_pen);
    painter->setBrush(Qt::NoBrush);
    drawCircle(painter, m_radius);
}

// --- grid ---------------------------------------------------------------------------------------

void PolarGrid::setScale(const PolarScale& scale, double reach) {
    m_scale = scale;
    m_reach = reach;
}

void PolarGrid::setLine(std::vector<ProfilePoint> line) {
    m_line = std::move(line);
}

void PolarGrid::draw(QCPPainter* painter) {
    painter->setFont(mParentPlot->font());
    painter->setBrush(Qt::NoBrush);
    drawSpokes(painter);
    const std::vector<Mark> circles = marks();
    painter->setPen(QPen(style::thinned(mParentPlot->palette().color(QPalette::Text), 50), 0));
    for (const Mark& mark : circles) {
        drawCircle(painter, mark.radius);
    }
    drawLabels(painter, circles);
}

void PolarGrid::drawSpokes(QCPPainter* painter) {
    const double reach = m_reach * scale();
    const QPalette palette = mParentPlot->palette();
    painter->setPen(QPen(style::thinned(palette.color(QPalette::Text), 130), 0));
    drawCircle(painter, m_reach);
    for (int angle = 0; angle < 360; angle += spokeStep) {
        painter->setPen(
            QPen(style::thinned(palette.color(QPalette::Text), angle % 90 == 0 ? 90 : 40), 0));
        painter->drawLine(centre(), centre() + reach * direction(angle * degree));
    }
    m_names.clear();
    // Names are outside the rim if there is room, otherwise just inside a large enough circle.
    constexpr double share = 0.2; ///< share of the radius that a name may cover
    const QFontMetricsF metrics(mParentPlot->font());
    for (int angle = 0; angle < 360; angle += 90) {
        const QString name = mParentPlot->locale().toString(angle) + QChar(0x00B0);
        const QSizeF size(metrics.horizontalAdvance(name) + 4, metrics.height() - 2);
        const QPointF to = direction(angle * degree);
        const QPointF half(to.x() * (size.width() / 2 + 1), to.y() * (size.height() / 2 + 1));
        QRectF box(QPointF(), size);
        box.moveCenter(centre() + reach * to + half);
        if (!QRectF(m_rect->rect()).contains(box)) {
            if (size.width() > share * reach) {
                continue;
            }
            box.moveCenter(centre() + reach * to - half);
        }
        drawText(painter, box, name);
        m_names.push_back(box);
    }
}

void PolarGrid::drawText(QCPPainter* painter, const QRectF& box, const QString& text) const {
    const QPalette palette = mParentPlot->palette();
    const QColor ground = style::thinned(palette.color(QPalette::Base), 190);
    painter->fillRect(box, ground);
    painter->setPen(palette.color(QPalette::Text));
    painter->drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

std::vector<PolarGrid::Mark> PolarGrid::marks() const {
    const QFontMetricsF metrics(mParentPlot->font());
    const double apart = leastLinesApart * metrics.height() / scale(); // in units of the axes
    const double step_um = roundUp125(apart / m_scale.magnification * units::umPerMm);
    const auto drawn = [&](int n) {
        return m_scale.at(m_scale.reference_mm + n * step_um / units::umPerMm);
    };
    const double perStep = drawn(1) - drawn(0);
    const int first = static_cast<int>(std::ceil((0.25 * apart - drawn(0)) / perStep));
    const int last = static_cast<int>(std::floor((m_reach - drawn(0)) / perStep + 1e-9));
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step_um) + 1e-9)));
    std::vector<Mark> marks;
    for (int n = first; n <= last && n - first < mostCircles; ++n) {
        const QString number = Names::fixed(n * step_um, n == 0 ? 0 : decimals);
        marks.push_back({drawn(n), n > 0 ? QLatin1Char('+') + number : number});
    }
    return marks;
}

/// @param away 1: just outside its circle, −1: just inside
QRectF PolarGrid::labelBox(const Mark& mark, double angle, double away) const {
    const QFontMetricsF metrics(mParentPlot->font());
    QRectF box(0, 0, metrics.horizontalAdvance(mark.text) + 4, metrics.height() - 2);
    box.moveCenter(centre()
                   + (mark.radius * scale() + away * (box.height() / 2 + 2)) * direction(angle));
    return box;
}

bool PolarGrid::isCrossed(const QRectF& box) const {
    QPointF before;
    for (std::size_t i = 0; i < m_line.size(); ++i) {
        const QPointF here = centre() + scale() * QPointF(m_line[i].x, -m_line[i].y);
        if (i > 0) {
            const QLineF edge(before, here);
            const QRectF around = QRectF(before, here).normalized().adjusted(-2, -2, 2, 2);
            const QLineF down(box.topLeft(), box.bottomRight()),
                up(box.bottomLeft(), box.topRight());
            if (around.intersects(box)
                && (box.contains(here) || edge.intersects(down) == QLineF::BoundedIntersection
                    || edge.intersects(up) == QLineF::BoundedIntersection)) {
                return true;
            }
        }
        before = here;
    }
    return false;
}

/// Whether a label fits here: visible, within the rim, clear of the angle names and the profile.
bool PolarGrid::hasRoom(const QRectF& box) const {
    const QPointF away = box.center() - centre();
    return QRectF(m_rect->rect()).contains(box)
           && std::hypot(away.x(), away.y()) + box.height() / 2 <= m_reach * scale()
           && std::ranges::none_of(m_names,
                                   [&](const QRectF& name) { return name.intersects(box); })
           && !isCrossed(box);
}

/// The labels that fit along a spoke without touching each other.
std::vector<PolarGrid::Label> PolarGrid::labelsAlong(const std::vector<Mark>& marks,
                                                     double angle) const {
    std::vector<Label> labels;
    for (const Mark& mark : marks) {
        for (const double away : {1.0, -1.0}) {
            const QRectF box = labelBox(mark, angle, away);
            const bool touches = !labels.empty() && labels.back().box.intersects(box);
            if (hasRoom(box) && !touches) {
                labels.push_back({box, mark.text});
                break;
            }
        }
    }
    return labels;
}

void PolarGrid::drawLabels(QCPPainter* painter, const std::vector<Mark>& marks) {
    m_labels.clear();
    m_boxes.clear();
    // Places the values along the spoke with room for most of them, preferably a steep one.
    std::vector<Label> best;
    for (const double angle : {70.0, 110.0, 250.0, 290.0, 20.0, 160.0, 200.0, 340.0}) {
        std::vector<Label> labels = labelsAlong(marks, angle * degree);
        if (labels.size() > best.size()) {
            best = std::move(labels);
        }
    }
    for (const Label& label : best) {
        drawText(painter, label.box, label.text);
        m_labels << label.text;
        m_boxes.push_back(label.box);
    }
}

// --- pointer ------------------------------------------------------------------------------------

PolarPointer::PolarPointer(QCPAxisRect* rect) : PolarLayer(rect, QStringLiteral("overlay")) {}

void PolarPointer::point(double angle, double here, double across) {
    m_shown = true;
    m_angle = angle;
    m_here = here;
    m_across = across;
}

void PolarPointer::draw(QCPPainter* painter) {
    if (!m_shown) {
        return;
    }
    const QColor text = mParentPlot->palette().color(QPalette::Text);
    // In a gap there is no radius.
    const bool hasHere = std::isfinite(m_here), hasAcross = std::isfinite(m_across);
    const QPointF here = centre() + (hasHere ? m_here : 0) * scale() * direction(m_angle);
    const QPointF across = centre() - (hasAcross ? m_across : 0) * scale() * direction(m_angle);
    painter->setPen(QPen(text, 1, Qt::DotLine));
    painter->drawLine(here, across);
    painter->setPen(QPen(text, 1.5));
    painter->setBrush(Qt::NoBrush);
    if (hasHere) {
        painter->drawEllipse(here, 5, 5);
    }
    if (hasAcross) {
        painter->drawRect(QRectF(across - QPointF(4, 4), QSizeF(8, 8)));
    }
}

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
