// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/sketch_callout.h"

#include "core/units.h"
#include "ui/report/cell_text.h"
#include "ui/text/number_text.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr double sizePoints = 11, deviationPoints = 6, signPoints = 8;
constexpr double sizeHeight = 7.5, roughnessHeight = 9, frameHeight = 6, frameCell = 7;
constexpr double apart = 1, thinLine = 0.2, fineLine = 0.25, mainLine = 0.35;

void line(FormSheet& sheet, double x1, double y1, double x2, double y2, double width = mainLine) {
    sheet.lines.push_back({QLineF(x1, y1, x2, y2), width});
}

constexpr int leastDecimals = 3, mostDecimals = 6;

/// Both deviations have the same decimals, as many as either needs.
int decimalsOf(double upper_um, double lower_um) {
    int decimals = leastDecimals;
    const auto isWhole = [](double value) { return std::abs(value - std::round(value)) < 1e-9; };
    for (double scale = 1;
         decimals < mostDecimals && !(isWhole(upper_um * scale) && isWhole(lower_um * scale));
         scale *= 10) {
        ++decimals;
    }
    return decimals;
}

} // namespace

DrawnDimension DrawnDimension::of(const Part& part) {
    DrawnDimension made;
    const QString whole = drawnSize(part);
    made.nominal = whole.left(whole.indexOf(u'(')).trimmed();
    const double upper = part.upper_deviation_um, lower = part.lower_deviation_um;
    const int decimals = decimalsOf(upper, lower);
    const auto text = [decimals](double value_um) {
        if (value_um == 0) {
            return QString();
        }
        const QString digits =
            QLocale().toString(std::abs(value_um) / units::umPerMm, 'f', decimals);
        return (value_um < 0 ? QStringLiteral("−") : QStringLiteral("+")) + digits;
    };
    made.isSymmetric = upper == -lower && upper != 0;
    made.upper = made.isSymmetric ? text(upper).replace(u'+', u'±') : text(upper);
    made.lower = made.isSymmetric ? QString() : text(lower);
    return made;
}

double SketchCallout::widthOf(const QString& text, double points) {
    return TextBox::widestLine(text, sheetFont(points)) / unitsPerMm;
}

SketchCallout::SketchCallout(const Part& part, std::size_t number, const QString& datum)
    : m_number(number) {
    const DrawnDimension size = DrawnDimension::of(part);
    m_nominal = size.nominal;
    m_upper = size.upper;
    m_lower = size.lower;
    m_isSymmetric = size.isSymmetric;
    const Tolerance& of = part.tolerance;
    const auto add = [this](Sign sign, const std::optional<double>& value_um, const QString& to) {
        if (value_um) {
            m_frames.push_back({sign, printedNumber(*value_um / units::umPerMm, 6), to});
        }
    };
    add(Sign::roundness, of.roundness_um, {});
    add(Sign::cylindricity, of.cylindricity_um, {});
    add(Sign::runout, of.radial_runout_um, datum);
    add(Sign::totalRunout, of.total_runout_um, datum);
    double height = sizeHeight;
    double width = circle_mm + apart + widthOf(m_nominal, sizePoints) + apart
                   + (m_isSymmetric ? widthOf(m_upper, sizePoints)
                                    : std::max(widthOf(m_upper, deviationPoints),
                                               widthOf(m_lower, deviationPoints)))
                   + 2 * apart;
    if (of.roughness_ra_um) {
        m_roughness = QStringLiteral("Ra ") + printedNumber(*of.roughness_ra_um);
        height += roughnessHeight;
        width = std::max(width, circle_mm + 6 + widthOf(m_roughness, signPoints) + 2 * apart);
    }
    for (const Frame& frame : m_frames) {
        height += frameHeight;
        width = std::max(
            width,
            circle_mm + apart + frameCell + widthOf(frame.value, signPoints) + 2 * apart
                + (frame.datum.isEmpty() ? 0 : widthOf(frame.datum, signPoints) + 2 * apart));
    }
    m_size = {width + apart, height + apart};
}

void SketchCallout::drawText(FormSheet& sheet, const QRectF& cell, const QString& text,
                             double points, Qt::Alignment align) {
    if (!text.isEmpty()) {
        sheet.texts.push_back({cell, text, points, align});
    }
}

void SketchCallout::drawArrow(FormSheet& sheet, const QPointF& tip, const QPointF& from,
                              double length_mm) {
    const double length = length_mm, half = length_mm * 0.18;
    const double angle = std::atan2(from.y() - tip.y(), from.x() - tip.x());
    const QPointF along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
    QPainterPath path(tip);
    path.lineTo(tip + along * length + across * half);
    path.lineTo(tip + along * length - across * half);
    path.closeSubpath();
    sheet.shapes.push_back({path, 0, true});
}

void SketchCallout::drawNumber(FormSheet& sheet, const QPointF& middle, std::size_t number) {
    QPainterPath path;
    path.addEllipse(middle, circle_mm / 2, circle_mm / 2);
    sheet.shapes.push_back({path, thinLine, false});
    drawText(sheet,
             QRectF(middle.x() - circle_mm / 2, middle.y() - circle_mm / 2, circle_mm, circle_mm),
             QString::number(number), 10, Qt::AlignHCenter);
}

void SketchCallout::draw(FormSheet& sheet, const QPointF& at) const {
    drawNumber(sheet, at + QPointF(circle_mm / 2, m_size.height() - circle_mm / 2), m_number);
    QPointF place = at;
    drawSize(sheet, place);
    place.ry() += sizeHeight;
    if (!m_roughness.isEmpty()) {
        drawRoughness(sheet, place);
        place.ry() += roughnessHeight;
    }
    for (const Frame& frame : m_frames) {
        drawFrame(sheet, place, frame);
        place.ry() += frameHeight;
    }
}

void SketchCallout::drawSize(FormSheet& sheet, const QPointF& at) const {
    const double left = at.x() + circle_mm + apart;
    const double nominal = widthOf(m_nominal, sizePoints) + 0.2; // plus an allowance for rounding
    drawText(sheet, {left, at.y(), nominal, sizeHeight - apart}, m_nominal, sizePoints);
    double x = left + nominal + 0.6;
    if (m_isSymmetric) {
        const double width = widthOf(m_upper, sizePoints) + 0.2;
        drawText(sheet, {x, at.y(), width, sizeHeight - apart}, m_upper, sizePoints);
        x += width;
    } else {
        const double width =
            std::max(widthOf(m_upper, deviationPoints), widthOf(m_lower, deviationPoints)) + 0.2;
        const double half = (sizeHeight - apart) / 2;
        drawText(sheet, {x, at.y(), width, half}, m_upper, deviationPoints);
        drawText(sheet, {x, at.y() + half, width, half}, m_lower, deviationPoints);
        x += width;
    }
    line(sheet, left, at.y() + sizeHeight - apart / 2, x, at.y() + sizeHeight - apart / 2,
         thinLine);
}

void SketchCallout::drawRoughness(FormSheet& sheet, const QPointF& at) const {
    // The sign of a surface from which material is removed, its shelf above Ra.
    constexpr double bar = 3.2, whole = 7, slope = 0.58;
    const double foot = at.y() + roughnessHeight - 0.8,
                 x = at.x() + circle_mm + apart + bar * slope;
    line(sheet, x - bar * slope, foot - bar, x, foot);
    line(sheet, x - bar * slope, foot - bar, x + bar * slope, foot - bar);
    line(sheet, x, foot, x + whole * slope, foot - whole);
    const double width = widthOf(m_roughness, signPoints) + 0.2;
    line(sheet, x + whole * slope, foot - whole, x + whole * slope + width + apart, foot - whole);
    drawText(sheet, {x + whole * slope + 0.6, foot - whole + 0.3, width, 4}, m_roughness,
             signPoints);
}

void SketchCallout::drawFrame(FormSheet& sheet, const QPointF& at, const Frame& frame) const {
    double x = at.x() + circle_mm + apart;
    const double height = frameHeight - 0.8;
    drawSign(sheet, frame.sign, {x, at.y(), frameCell, height});
    sheet.frame({x, at.y(), frameCell, height}, thinLine);
    x += frameCell;
    for (const QString& text : {frame.value, frame.datum}) {
        if (!text.isEmpty()) {
            const QRectF cell(x, at.y(), widthOf(text, signPoints) + 2 * apart, height);
            sheet.frame(cell, thinLine);
            drawText(sheet, cell, text, signPoints, Qt::AlignHCenter);
            x += cell.width();
        }
    }
}

void SketchCallout::drawSign(FormSheet& sheet, Sign sign, const QRectF& cell) {
    const QPointF middle = cell.center();
    const double r = cell.height() * 0.32;
    QPainterPath circle;
    switch (sign) {
    case Sign::roundness:
        circle.addEllipse(middle, r, r);
        sheet.shapes.push_back({circle, fineLine, false});
        return;
    case Sign::cylindricity:
        circle.addEllipse(middle, r * 0.62, r * 0.62);
        sheet.shapes.push_back({circle, fineLine, false});
        for (const double side : {-1.0, 1.0}) {
            const double x = middle.x() + side * r * 1.1;
            line(sheet, x - r * 0.4, middle.y() + r, x + r * 0.4, middle.y() - r, fineLine);
        }
        return;
    case Sign::runout:
    case Sign::totalRunout: break;
    }
    const bool total = sign == Sign::totalRunout;
    const double shift = total ? r * 0.75 : 0;
    for (const double side : {-1.0, 1.0}) {
        if (!total && side > 0) {
            break;
        }
        const QPointF foot(middle.x() + side * shift - r * 0.8, middle.y() + r);
        const QPointF tip = foot + QPointF(r * 1.6, -2 * r);
        line(sheet, foot.x(), foot.y(), tip.x(), tip.y());
        drawArrow(sheet, tip, foot, r);
    }
    if (total) {
        line(sheet, middle.x() - shift - r * 0.8, middle.y() + r, middle.x() + shift - r * 0.8,
             middle.y() + r);
    }
}

} // namespace sparkout::report
