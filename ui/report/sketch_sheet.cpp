// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/sketch_sheet.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/report/card_rows.h"
#include "ui/report/cell_text.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

namespace sparkout::report {

namespace {

constexpr double assumedWall = 1.5; ///< outer diameter over the largest bore, if not given

/// The steps with another one placed over them.
std::vector<OutlineStep> overlaid(const std::vector<OutlineStep>& steps, const OutlineStep& over) {
    std::vector<OutlineStep> all;
    const auto add = [&all](double from, double to, double diameter) {
        if (to > from) {
            all.push_back({from, to, diameter});
        }
    };
    for (const OutlineStep& step : steps) {
        add(step.from_mm, std::min(step.to_mm, over.from_mm), step.diameter_mm);
        if (step.from_mm <= over.from_mm && over.from_mm < step.to_mm) {
            add(over.from_mm, over.to_mm, over.diameter_mm);
        }
        add(std::max(step.from_mm, over.to_mm), step.to_mm, step.diameter_mm);
    }
    return all;
}

} // namespace

PartOutline::PartOutline(const Setup& setup) {
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const Part& part = *setup.surfaces[i].project.part;
        const double from = part.shaft.ground_from_mm;
        GroundStep step;
        step.from_mm = from;
        step.to_mm = from + part.length_mm;
        step.diameter_mm = part.diameter_mm;
        step.surface = i;
        step.isBore = part.surface == Surface::internal;
        m_ground.push_back(step);
        m_length_mm = std::max(m_length_mm, step.to_mm);
    }
    std::ranges::stable_sort(m_ground, {}, [](const GroundStep& s) { return s.from_mm; });
    addOuter(setup);
    addBores();
}

void PartOutline::addOuter(const Setup& setup) {
    double at = 0;
    for (const ShaftSegment& segment : setup.surfaces.front().project.part->shaft.segments) {
        m_outer.push_back({at, at + segment.length_mm, segment.diameter_mm});
        at += segment.length_mm;
    }
    m_length_mm = std::max(m_length_mm, at);
    if (at < m_length_mm) { // the shaft is too short for the ground surface, or not given
        double diameter = 0;
        for (const GroundStep& step : m_ground) {
            diameter = std::max(diameter, step.diameter_mm * (step.isBore ? assumedWall : 1));
        }
        m_outerKnown = std::ranges::none_of(m_ground, &GroundStep::isBore);
        m_outer.push_back(
            {at, m_length_mm, m_outer.empty() ? diameter : m_outer.back().diameter_mm});
    }
    for (const GroundStep& step : m_ground) {
        if (!step.isBore) {
            m_outer = overlaid(m_outer, step);
        }
    }
}

void PartOutline::addBores() {
    std::vector<OutlineStep> bores;
    for (const GroundStep& step : m_ground) {
        if (step.isBore) {
            bores.push_back(step);
        }
    }
    if (bores.empty()) {
        return;
    }
    // Between and beyond the bores the part has a through hole of the smaller neighbour's diameter.
    double at = 0;
    for (std::size_t i = 0; i < bores.size(); ++i) {
        if (bores[i].from_mm > at) {
            const double before = i > 0 ? bores[i - 1].diameter_mm : bores[i].diameter_mm;
            m_bores.push_back({at, bores[i].from_mm, std::min(before, bores[i].diameter_mm)});
        }
        m_bores.push_back(bores[i]);
        at = std::max(at, bores[i].to_mm);
    }
    if (at < m_length_mm) {
        m_bores.push_back({at, m_length_mm, bores.back().diameter_mm});
    }
}

double PartOutline::largest_mm() const {
    return std::ranges::max_element(m_outer, {}, &OutlineStep::diameter_mm)->diameter_mm;
}

namespace {

constexpr double outline = 0.35, doubled = 0.8, fine = 0.2, hatching = 0.15;
constexpr double legendBand = 7, edge = 3, leaderRoom = 14, lanePitch = 6.5;
constexpr double leastPartHeight = 22, mostPartHeight = 62, mostPartWidth = 190;
constexpr double overhang = 8;       ///< of the centre line
constexpr double spareAbove = 0.4;   ///< share of the unused height
constexpr double calloutShare = 0.7; ///< the part is at least this share of the callouts' width
constexpr double lengthPoints = 9, tableRow = 4.8, tableWidth = 132;
constexpr std::size_t tableRows = 10;

struct Interval {
    double from_mm, to_mm;
    friend auto operator<=>(const Interval&, const Interval&) = default;
};

QString lengthText(double value_mm) {
    return printedNumber(value_mm, 6);
}

} // namespace

void SketchSheet::draw(FormSheet& sheet, const QRectF& room, const Setup& setup) {
    SketchSheet drawing(sheet, room, setup);
    SheetDrawing& drawn = sheet.drawing;
    drawn = {description(setup),
             {sheet.lines.size(), 0},
             {sheet.shapes.size(), 0},
             {sheet.texts.size(), 0}};
    drawing.drawOuter();
    drawing.drawBores();
    drawing.drawGround();
    drawing.drawSupports();
    drawing.m_hasTable ? drawing.drawTable() : drawing.drawCallouts();
    drawing.drawLengths();
    drawn.lines.to = sheet.lines.size();
    drawn.shapes.to = sheet.shapes.size();
    drawn.texts.to = sheet.texts.size();
    drawing.drawLegend();
}

SketchSheet::SketchSheet(FormSheet& sheet, const QRectF& room, const Setup& setup)
    : m_sheet(sheet)
    , m_room(room.adjusted(edge, edge, -edge, -edge))
    , m_setup(setup)
    , m_outline(setup) {
    std::vector<double> widths, middles;
    double above = 0;
    for (const GroundStep& step : m_outline.ground()) {
        m_callouts.emplace_back(*setup.surfaces[step.surface].project.part, step.surface + 1,
                                datum());
        widths.push_back(m_callouts.back().size().width());
        middles.push_back(m_room.left());
        above = std::max(above, m_callouts.back().size().height());
    }
    m_hasTable = spread(widths, middles).empty();
    const std::size_t count = m_callouts.size();
    const auto rows = static_cast<double>(std::min(count, tableRows) + 1);
    above = m_hasTable ? rows * tableRow + SketchCallout::circle_mm + 2 : above;
    const double lanes = m_hasTable ? 1 : static_cast<double>(count) + 2; // lengths, places, whole
    const double below = lanes * lanePitch + overhang + legendBand;
    const double height =
        std::clamp(m_room.height() - above - leaderRoom - below, leastPartHeight, mostPartHeight);
    const double largest = m_outline.largest_mm();
    // A slender part is drawn thicker, one that is short relative to its callouts longer.
    const double uniform = std::min(mostPartWidth / m_outline.length_mm(), height / largest);
    const double callouts = m_hasTable ? mostPartWidth : std::reduce(widths.begin(), widths.end());
    m_scaleX =
        std::max(uniform, std::min(mostPartWidth, calloutShare * callouts) / m_outline.length_mm());
    m_scaleY = std::max(uniform, leastPartHeight / largest);
    if (const double spare = m_room.height() - above - leaderRoom - largest * m_scaleY - below;
        !m_hasTable && spare > 0) { // somewhat above the middle
        m_room.setTop(m_room.top() + spareAbove * spare);
    }
    m_left = m_room.center().x() - m_outline.length_mm() * m_scaleX / 2;
    m_axis = m_room.top() + above + leaderRoom + half(largest);
}

void SketchSheet::line(double x1, double y1, double x2, double y2, double width,
                       Qt::PenStyle style) {
    m_sheet.lines.push_back({QLineF(x1, y1, x2, y2), width, style});
}

bool SketchSheet::isInChuck() const {
    return hasBores() || m_setup.surfaces.front().project.part->shaft.mounting == Mounting::chuck;
}

QString SketchSheet::datum() const {
    return isInChuck() ? tr("A", "datum") : tr("A", "datum") + tr("B", "datum");
}

void SketchSheet::drawOuter() {
    const double width = m_outline.isOuterKnown() ? outline : fine;
    double before = 0;
    for (const OutlineStep& step : m_outline.outer()) {
        const double h = half(step.diameter_mm);
        for (const double side : {-1.0, 1.0}) {
            line(x(step.from_mm), m_axis + side * h, x(step.to_mm), m_axis + side * h, width);
        }
        const double face = std::max(before, h);
        line(x(step.from_mm), m_axis - face, x(step.from_mm), m_axis + face, width);
        before = h;
    }
    line(x(m_outline.length_mm()), m_axis - before, x(m_outline.length_mm()), m_axis + before,
         width);
    line(m_left - overhang, m_axis, x(m_outline.length_mm()) + overhang, m_axis, fine,
         Qt::DashDotLine);
}

/// Above the axis the part is drawn in section.
void SketchSheet::drawBores() {
    double before = 0;
    for (const OutlineStep& bore : m_outline.bores()) {
        const double h = half(bore.diameter_mm);
        line(x(bore.from_mm), m_axis - h, x(bore.to_mm), m_axis - h, outline);
        if (before > 0 && before != h) {
            line(x(bore.from_mm), m_axis - std::max(before, h), x(bore.from_mm), m_axis, outline);
        }
        before = h;
    }
    if (hasBores()) {
        drawHatch();
    }
}

void SketchSheet::drawHatch() {
    constexpr double pitch = 2.5;
    for (const OutlineStep& outer : m_outline.outer()) {
        for (const OutlineStep& bore : m_outline.bores()) {
            const double x0 = x(std::max(outer.from_mm, bore.from_mm));
            const double x1 = x(std::min(outer.to_mm, bore.to_mm));
            const double y0 = m_axis - half(outer.diameter_mm),
                         y1 = m_axis - half(bore.diameter_mm);
            if (x1 <= x0 || y1 <= y0) {
                continue;
            }
            for (double sum = std::ceil((x0 + y0) / pitch) * pitch; sum < x1 + y1; sum += pitch) {
                const double from = std::max(x0, sum - y1), to = std::min(x1, sum - y0);
                line(from, sum - from, to, sum - to, hatching);
            }
        }
    }
}

void SketchSheet::drawGround() {
    for (const GroundStep& step : m_outline.ground()) {
        const double h = half(step.diameter_mm);
        line(x(step.from_mm), m_axis - h, x(step.to_mm), m_axis - h, doubled);
        if (!step.isBore) {
            line(x(step.from_mm), m_axis + h, x(step.to_mm), m_axis + h, doubled);
        }
        drawGaps(step);
        drawFeed(step);
    }
}

/// The edges of gaps, the first of them turned to the front.
void SketchSheet::drawGaps(const GroundStep& step) {
    const auto& gaps = m_setup.surfaces[step.surface].project.part->gaps;
    if (step.isBore || gaps.empty()) {
        return;
    }
    const double front = gaps.front().from_deg + gaps.front().width_deg / 2;
    for (const SurfaceGap& cut : gaps) {
        for (const double side : {cut.from_deg, cut.from_deg + cut.width_deg}) {
            const double angle = (side - front) * std::numbers::pi / 180;
            if (std::cos(angle) > 0) { // otherwise behind
                const double y = m_axis + half(step.diameter_mm) * std::sin(angle);
                line(x(step.from_mm), y, x(step.to_mm), y, outline);
            }
        }
    }
}

/// Draws the feed along the surface for a traverse, towards it for a plunge; beside the leader.
void SketchSheet::drawFeed(const GroundStep& step) {
    constexpr double distance = 3, length = 7, shortest = 12;
    const double from = x(step.from_mm), to = x(step.to_mm), side = step.isBore ? 1 : -1;
    const double surface = m_axis - half(step.diameter_mm);
    if (to - from < shortest) {
        return;
    }
    if (m_setup.surfaces[step.surface].project.operation->travels) {
        const double y = surface + side * distance;
        const QPointF a(from + (to - from) * 0.6, y), b(from + (to - from) * 0.95, y);
        line(a.x(), y, b.x(), y, outline);
        SketchCallout::drawArrow(m_sheet, a, b);
        SketchCallout::drawArrow(m_sheet, b, a);
    } else {
        const double at = from + (to - from) * 0.82;
        const double tail = surface + side * (length + 1);
        line(at, tail, at, surface + side, outline);
        SketchCallout::drawArrow(m_sheet, {at, surface + side}, {at, tail});
    }
}

void SketchSheet::drawCentre(double x, double side) {
    constexpr double reach = 6, spread = 3.5;
    line(x, m_axis, x + side * reach, m_axis - spread, outline);
    line(x, m_axis, x + side * reach, m_axis + spread, outline);
}

void SketchSheet::drawClamp(double x, double y, double side) {
    constexpr double length = 7;
    line(x, y, x, y + side * length, outline);
    SketchCallout::drawArrow(m_sheet, {x, y}, {x, y + side * length});
}

void SketchSheet::drawSupports() {
    const OutlineStep& first = m_outline.outer().front();
    const double at = x(first.from_mm) + std::min(4.0, (x(first.to_mm) - x(first.from_mm)) / 2);
    const double h = half(first.diameter_mm);
    drawClamp(at, m_axis + h, 1);
    const double right = x(m_outline.length_mm());
    if (isInChuck()) {
        drawClamp(at, m_axis - h, -1);
        SketchCallout::drawText(m_sheet, {at + 1, m_axis + h + 3, 4, 4}, QStringLiteral("3"), 8);
        drawDatum({m_left - 12, m_axis}, tr("A", "datum"));
    } else {
        drawCentre(m_left, -1);
        drawCentre(right, 1);
        drawDatum({m_left - 12, m_axis}, tr("A", "datum"));
        drawDatum({right + 12, m_axis}, tr("B", "datum"));
    }
    drawRests();
}

void SketchSheet::drawRests() {
    constexpr double height = 5;
    for (const SteadyRest& rest : m_setup.surfaces.front().project.part->shaft.steady_rests) {
        const auto step = std::ranges::find_if(m_outline.outer(), [&](const OutlineStep& s) {
            return s.from_mm <= rest.position_mm && rest.position_mm <= s.to_mm;
        });
        if (step == m_outline.outer().end()) {
            continue;
        }
        const QPointF tip(x(rest.position_mm), m_axis + half(step->diameter_mm));
        QPainterPath path(tip);
        path.lineTo(tip + QPointF(-height * 0.5, height));
        path.lineTo(tip + QPointF(height * 0.5, height));
        path.closeSubpath();
        m_sheet.shapes.push_back({path, outline, false});
    }
}

void SketchSheet::drawDatum(const QPointF& at, const QString& letter) {
    constexpr double base = 3.6, height = 3.2, stem = 3, box = 6;
    QPainterPath path(at + QPointF(-base / 2, 0));
    path.lineTo(at + QPointF(base / 2, 0));
    path.lineTo(at + QPointF(0, -height));
    path.closeSubpath();
    m_sheet.shapes.push_back({path, 0, true});
    line(at.x() - 4, at.y(), at.x() + 4, at.y(), fine);
    line(at.x(), at.y() - height, at.x(), at.y() - height - stem, fine);
    const QRectF cell(at.x() - box / 2, at.y() - height - stem - box, box, box);
    m_sheet.frame(cell, fine);
    SketchCallout::drawText(m_sheet, cell, letter, 9, Qt::AlignHCenter);
}

std::vector<double> SketchSheet::spread(const std::vector<double>& widths,
                                        const std::vector<double>& places) const {
    constexpr double between = 2;
    // Pushes boxes to the right from the first on, and to the left from the last on; the result is
    // the mean of both.
    std::vector<double> wanted = places;
    for (std::size_t i = 1; i < widths.size(); ++i) {
        wanted[i] = std::max(wanted[i], wanted[i - 1] + widths[i - 1] + between);
    }
    double before = std::numeric_limits<double>::infinity();
    for (std::size_t i = widths.size(); i-- > 0;) {
        before = std::min(places[i], before - between - widths[i]);
        wanted[i] = (wanted[i] + before) / 2;
    }
    std::vector<double> at(widths.size());
    double next = m_room.left();
    for (std::size_t i = 0; i < widths.size(); ++i) {
        at[i] = std::max(wanted[i], next);
        next = at[i] + widths[i] + between;
    }
    double end = m_room.right();
    for (std::size_t i = widths.size(); i-- > 0;) {
        at[i] = std::min(at[i], end - widths[i]);
        end = at[i] - between;
    }
    return !at.empty() && at.front() < m_room.left() - 1e-6 ? std::vector<double>() : at;
}

void SketchSheet::drawLeader(const GroundStep& step, const QPointF& from) {
    const QPointF tip((x(step.from_mm) + x(step.to_mm)) / 2, m_axis - half(step.diameter_mm));
    const QPointF start = from + QPointF(0, SketchCallout::circle_mm / 2); // below all texts
    line(start.x(), start.y(), tip.x(), tip.y(), fine);
    SketchCallout::drawArrow(m_sheet, tip, start);
}

void SketchSheet::drawCallouts() {
    std::vector<double> widths, places;
    double height = 0;
    for (std::size_t i = 0; i < m_callouts.size(); ++i) {
        const GroundStep& step = m_outline.ground()[i];
        widths.push_back(m_callouts[i].size().width());
        places.push_back((x(step.from_mm) + x(step.to_mm)) / 2 - SketchCallout::circle_mm / 2);
        height = std::max(height, m_callouts[i].size().height());
    }
    const std::vector<double> at = spread(widths, places);
    for (std::size_t i = 0; i < m_callouts.size(); ++i) {
        const double bottom = m_room.top() + height;
        m_callouts[i].draw(m_sheet, {at[i], bottom - m_callouts[i].size().height()});
        constexpr double r = SketchCallout::circle_mm / 2;
        drawLeader(m_outline.ground()[i], {at[i] + r, bottom - r});
    }
}

/// With many surfaces the part has only their numbers.
void SketchSheet::drawTable() {
    const std::array<std::pair<QString, double>, 6> columns{{{tr("No."), 8},
                                                             {tr("Size"), 36},
                                                             {tr("Ra"), 12},
                                                             {tr("Tolerances, mm"), 48},
                                                             {tr("L, mm"), 13},
                                                             {tr("From the end, mm"), 15}}};
    const auto row = [&](double left, double top, const QStringList& texts) {
        double x = left;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const QRectF cell(x, top, columns.at(i).second, tableRow);
            m_sheet.frame(cell, fine);
            const QString text = texts.value(static_cast<qsizetype>(i));
            if (!text.isEmpty()) {
                m_sheet.texts.push_back(fitted(cell.adjusted(0.6, 0, -0.6, 0), text, 8,
                                               i == 3 ? Qt::AlignLeft : Qt::AlignHCenter));
            }
            x += columns.at(i).second;
        }
    };
    QStringList head;
    for (const auto& [name, width] : columns) {
        head << name;
    }
    const std::size_t count = m_setup.surfaces.size();
    for (std::size_t from = 0; from < count; from += tableRows) {
        const double left =
            m_room.left() + static_cast<double>(from / tableRows) * (tableWidth + 2);
        row(left, m_room.top(), head);
        for (std::size_t i = from; i < std::min(count, from + tableRows); ++i) {
            const Part& part = *m_setup.surfaces[i].project.part;
            const auto ra = part.tolerance.roughness_ra_um;
            row(left, m_room.top() + static_cast<double>(i - from + 1) * tableRow,
                {QString::number(i + 1), drawnSize(part), ra ? printedNumber(*ra) : QString(),
                 limits(part), lengthText(part.length_mm), lengthText(part.shaft.ground_from_mm)});
        }
    }
    std::vector<double> widths, places;
    for (const GroundStep& step : m_outline.ground()) {
        widths.push_back(SketchCallout::circle_mm);
        places.push_back((x(step.from_mm) + x(step.to_mm)) / 2 - SketchCallout::circle_mm / 2);
    }
    const std::vector<double> at = spread(widths, places);
    constexpr double r = SketchCallout::circle_mm / 2;
    const double y =
        m_room.top() + static_cast<double>(std::min(count, tableRows) + 1) * tableRow + 2 + r;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const GroundStep& step = m_outline.ground()[i];
        SketchCallout::drawNumber(m_sheet, {at[i] + r, y}, step.surface + 1);
        drawLeader(step, {at[i] + r, y});
    }
}

QString SketchSheet::limits(const Part& part) {
    QStringList all;
    const auto add = [&all](const QString& name, const std::optional<double>& value_um) {
        if (value_um) {
            all << name + QChar(0xa0) + printedNumber(*value_um / units::umPerMm, 6);
        }
    };
    const Tolerance& of = part.tolerance;
    add(tr("of roundness"), of.roundness_um);
    add(tr("of cylindricity"), of.cylindricity_um);
    add(tr("of radial runout"), of.radial_runout_um);
    add(tr("of total runout"), of.total_runout_um);
    return all.join(QStringLiteral("; "));
}

void SketchSheet::drawDimension(double from_mm, double to_mm, double y, double below) {
    const double from = x(from_mm), to = x(to_mm);
    const QString text = lengthText(to_mm - from_mm);
    const double width = SketchCallout::widthOf(text, lengthPoints) + 0.4;
    constexpr double textHeight = 4.2, arrows = 7;
    for (const double at : {from, to}) {
        line(at, below, at, y + 1.5, fine);
    }
    const bool outside = to - from < std::max(width, arrows);
    line(outside ? from - 4 : from, y, outside ? to + width + 4 : to, y, fine);
    SketchCallout::drawArrow(m_sheet, {from, y}, {outside ? from - 4 : to, y});
    SketchCallout::drawArrow(m_sheet, {to, y}, {outside ? to + 4 : from, y});
    const double left = outside ? to + 3.5 : (from + to - width) / 2;
    SketchCallout::drawText(m_sheet, {left, y - textHeight, width, textHeight}, text, lengthPoints);
}

void SketchSheet::drawLengths() {
    std::set<Interval> intervals{{0, m_outline.length_mm()}};
    if (!m_hasTable) {
        for (const GroundStep& step : m_outline.ground()) {
            intervals.insert({step.from_mm, step.to_mm});
            if (step.from_mm > 0) {
                intervals.insert({0, step.from_mm});
            }
        }
    }
    std::vector<Interval> sorted(intervals.begin(), intervals.end());
    std::ranges::stable_sort(sorted, {}, [](const Interval& i) { return i.to_mm - i.from_mm; });
    std::vector<std::vector<std::pair<double, double>>> lanes; // occupied ranges of each [mm]
    const double below = m_axis + half(m_outline.largest_mm()) + 1;
    for (const Interval& i : sorted) {
        const double width =
            SketchCallout::widthOf(lengthText(i.to_mm - i.from_mm), lengthPoints) + 1;
        const bool outside = x(i.to_mm) - x(i.from_mm) < std::max(width, 7.0);
        const std::pair span(x(i.from_mm) - (outside ? 4 : 0),
                             x(i.to_mm) + (outside ? width + 5 : 0));
        const auto isFree = [&span](const auto& lane) {
            return std::ranges::none_of(lane, [&span](const auto& other) {
                return span.first < other.second - 1e-9 && other.first < span.second - 1e-9;
            });
        };
        auto lane = std::ranges::find_if(lanes, isFree);
        if (lane == lanes.end()) {
            lane = lanes.emplace(lanes.end());
        }
        lane->push_back(span);
        drawDimension(i.from_mm, i.to_mm,
                      below + overhang + static_cast<double>(lane - lanes.begin()) * lanePitch,
                      below);
    }
}

void SketchSheet::drawLegend() {
    QStringList signs;
    if (isInChuck()) {
        signs << tr("arrows onto the part: chuck with 3 jaws");
    } else {
        signs << tr("angles at the ends: centres") << tr("arrow below: driver");
    }
    if (!m_setup.surfaces.front().project.part->shaft.steady_rests.empty()) {
        signs << tr("triangles: steady rests");
    }
    signs << tr("lines of double width: surfaces ground")
          << tr("arrows at them: feed of the wheel");
    if (!m_outline.isOuterKnown()) {
        signs << tr("outer form assumed");
    }
    m_sheet.texts.push_back(
        fitted({m_room.left(), m_room.bottom() - legendBand + 2, m_room.width(), legendBand - 2},
               tr("Signs: %1.").arg(signs.join(QStringLiteral("; "))), 7.5));
}

QString SketchSheet::description(const Setup& setup) {
    QStringList all;
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const Part& part = *setup.surfaces[i].project.part;
        QStringList of{drawnSize(part),
                       tr("length %1 mm, %2 mm from the end")
                           .arg(lengthText(part.length_mm), lengthText(part.shaft.ground_from_mm))};
        all << tr("surface %1: %2")
                   .arg(CardRows::surfaceName(setup, i),
                        (of + CardRows::tolerances(part)).join(QStringLiteral(", ")));
    }
    return all.join(QStringLiteral("; "));
}

} // namespace sparkout::report
