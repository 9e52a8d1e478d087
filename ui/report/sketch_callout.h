// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/part.h"
#include "ui/report/format/form_sheet.h"

#include <QCoreApplication>
#include <QPointF>
#include <QSizeF>
#include <QString>

#include <vector>

namespace sparkout::report {

/// A diameter as on a drawing: ⌀30h6 and its deviations in millimetres, one above the other at half
/// height. A deviation of 0 is not written.
struct DrawnDimension {
    QString nominal; ///< "⌀30h6"
    QString upper, lower;
    bool isSymmetric = false; ///< "±0.008", in full height, for both

    [[nodiscard]] static DrawnDimension of(const Part& part);
};

/// The annotations of one ground surface: its number in a circle, the size with deviations, the
/// roughness sign and the frames of its tolerances, one below the other.
class SketchCallout {
    Q_DECLARE_TR_FUNCTIONS(SketchSheet)
public:
    static constexpr double circle_mm = 7; ///< diameter

    /// The datum letters denote the axis for runout.
    SketchCallout(const Part& part, std::size_t number, const QString& datum);

    [[nodiscard]] QSizeF size() const { return m_size; }
    /// With its upper left corner at a point.
    void draw(FormSheet& sheet, const QPointF& at) const;

    /// A number in a circle about a point.
    static void drawNumber(FormSheet& sheet, const QPointF& middle, std::size_t number);
    static void drawText(FormSheet& sheet, const QRectF& cell, const QString& text, double points,
                         Qt::Alignment align = Qt::AlignLeft);
    [[nodiscard]] static double widthOf(const QString& text, double points); ///< [mm]
    static void drawArrow(FormSheet& sheet, const QPointF& tip, const QPointF& from,
                          double length_mm = 2.8);

private:
    enum class Sign { roundness, cylindricity, runout, totalRunout };
    struct Frame {
        Sign sign;
        QString value;
        QString datum; ///< may be empty
    };
    static void drawSign(FormSheet& sheet, Sign sign, const QRectF& cell);
    void drawSize(FormSheet& sheet, const QPointF& at) const;
    void drawRoughness(FormSheet& sheet, const QPointF& at) const;
    void drawFrame(FormSheet& sheet, const QPointF& at, const Frame& frame) const;

    std::size_t m_number;
    QString m_nominal, m_upper, m_lower; ///< parts of the size
    bool m_isSymmetric = false;
    QString m_roughness; ///< "Ra 0.8"; empty: not required
    std::vector<Frame> m_frames;
    QSizeF m_size;
};

} // namespace sparkout::report
