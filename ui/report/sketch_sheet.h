// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "ui/report/format/form_sheet.h"
#include "ui/report/sketch_callout.h"

#include <QCoreApplication>
#include <QRectF>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace sparkout::report {

/// A cylinder of the part's form, from the headstock end [mm].
struct OutlineStep {
    double from_mm = 0, to_mm = 0;
    double diameter_mm = 0;
};

/// A ground surface at its place.
struct GroundStep : OutlineStep {
    std::size_t surface = 0; ///< index into the set-up
    bool isBore = false;
};

/// The part of a set-up as drawn: its outer form with the ground diameters, its bores, and the
/// ground surfaces.
class PartOutline {
public:
    explicit PartOutline(const Setup& setup);

    [[nodiscard]] double length_mm() const { return m_length_mm; }
    [[nodiscard]] double largest_mm() const; ///< outer diameter
    /// The outer form from end to end; assumed where the inputs do not define it.
    [[nodiscard]] const std::vector<OutlineStep>& outer() const { return m_outer; }
    [[nodiscard]] bool isOuterKnown() const { return m_outerKnown; }
    [[nodiscard]] const std::vector<OutlineStep>& bores() const { return m_bores; }
    [[nodiscard]] const std::vector<GroundStep>& ground() const { return m_ground; } ///< by place

private:
    void addOuter(const Setup& setup);
    void addBores();

    double m_length_mm = 0;
    bool m_outerKnown = true;
    std::vector<OutlineStep> m_outer, m_bores;
    std::vector<GroundStep> m_ground;
};

/// The sketch of an operation in drawing style: the part on the machine, its supports, the ground
/// surfaces in lines of double width, with numbers, sizes, tolerances and lengths.
class SketchSheet {
    Q_DECLARE_TR_FUNCTIONS(SketchSheet)
public:
    /// Draws into an area of a sheet [mm].
    static void draw(FormSheet& sheet, const QRectF& room, const Setup& setup);
    static QString description(const Setup& setup); ///< a description in words

private:
    SketchSheet(FormSheet& sheet, const QRectF& room, const Setup& setup);

    [[nodiscard]] double x(double along_mm) const { return m_left + along_mm * m_scaleX; }
    [[nodiscard]] double half(double diameter_mm) const { return diameter_mm / 2 * m_scaleY; }
    void line(double x1, double y1, double x2, double y2, double width,
              Qt::PenStyle style = Qt::SolidLine);

    [[nodiscard]] bool hasBores() const { return !m_outline.bores().empty(); }
    [[nodiscard]] bool isInChuck() const;
    [[nodiscard]] QString datum() const;
    void drawOuter();
    void drawBores();
    void drawHatch();
    void drawGround();
    void drawGaps(const GroundStep& step);
    void drawFeed(const GroundStep& step);
    void drawSupports();
    void drawCentre(double x, double side);
    void drawClamp(double x, double y, double side);
    void drawRests();
    void drawDatum(const QPointF& at, const QString& letter);
    void drawCallouts();
    void drawLeader(const GroundStep& step, const QPointF& from);
    void drawTable();
    static QString limits(const Part& part); ///< tolerances of form and position, a table's cell
    void drawLengths();
    void drawDimension(double from_mm, double to_mm, double y, double below);
    void drawLegend();
    /// The left edges of boxes of these widths, each as near as possible to its place; empty if
    /// they do not fit.
    [[nodiscard]] std::vector<double> spread(const std::vector<double>& widths,
                                             const std::vector<double>& places) const;

    FormSheet& m_sheet;
    QRectF m_room;
    const Setup& m_setup;
    PartOutline m_outline;
    double m_scaleX = 1, m_scaleY = 1, m_left = 0, m_axis = 0;
    bool m_hasTable = false;
    std::vector<SketchCallout> m_callouts; ///< callouts of the ground steps, in their order
};

} // namespace sparkout::report
