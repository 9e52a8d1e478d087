// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/painted_layer.h"
#include "ui/chart/profiles_look.h"

#include <QFont>
#include <QPalette>
#include <QPen>

class QCPAxisRect;
class QCPCurve;
class QCPLayoutGrid;
class QCPTextElement;
class QCustomPlot;

namespace sparkout {

/// A layer drawn about the origin of an axis rect with equal scales.
class PolarLayer : public PaintedLayer {
    Q_OBJECT
public:
    PolarLayer(QCPAxisRect* rect, const QString& layer);

protected:
    [[nodiscard]] QPointF centre() const; ///< [px]
    [[nodiscard]] double scale() const;   ///< pixels per unit of the axes
    void drawCircle(QCPPainter* painter, double radius) const;

    /// The part of the plane inside the axis rect, seen from the origin [px, rad].
    struct VisiblePart {
        double near = 0, far = 0, from = 0, span = 0;
    };
    [[nodiscard]] VisiblePart visiblePart() const;
    [[nodiscard]] QPolygonF arc(const VisiblePart& part, double radius_px) const;
};

/// The ring between two radii, with its edges.
class PolarRing : public PolarLayer {
    Q_OBJECT
public:
    using PolarLayer::PolarLayer;
    /// A negative inner radius leaves no hole; nothing is drawn beyond `reach`.
    void setRing(double inner, double outer, double reach);
    void setLook(const QPen& edge, const QColor& fill);
    [[nodiscard]] double inner() const { return m_inner; }
    [[nodiscard]] double outer() const { return m_outer; }

protected:
    void draw(QCPPainter* painter) override;

private:
    double m_inner = 0, m_outer = 0, m_reach = 0;
    QPen m_edge;
    QColor m_fill;
};

/// One circle about the origin, as a line.
class PolarCircle : public PolarLayer {
    Q_OBJECT
public:
    using PolarLayer::PolarLayer;
    void setRadius(double radius) { m_radius = radius; }
    void setPen(const QPen& pen) { m_pen = pen; }
    [[nodiscard]] double radius() const { return m_radius; }

protected:
    void draw(QCPPainter* painter) override;

private:
    double m_radius = 0;
    QPen m_pen;
};

/// Spokes every 30° with the four main angles named, and circles at round deviations with their
/// values in µm.
class PolarGrid : public PolarLayer {
    Q_OBJECT
public:
    using PolarLayer::PolarLayer;
    void setScale(const PolarScale& scale, double reach);
    void setLine(std::vector<ProfilePoint> line); ///< labels are placed beside it, by replot()
    [[nodiscard]] const QStringList& drawnLabels() const {
        return m_labels;
    } ///< as of the last replot
    [[nodiscard]] const std::vector<QRectF>& labelBoxes() const { return m_boxes; } ///< theirs

protected:
    void draw(QCPPainter* painter) override;

private:
    struct Mark {
        double radius = 0;
        QString text;
    };
    struct Label {
        QRectF box;
        QString text;
    };
    [[nodiscard]] std::vector<Mark> marks() const;
    [[nodiscard]] std::vector<Label> labelsAlong(const std::vector<Mark>& marks,
                                                 double angle) const;
    void drawSpokes(QCPPainter* painter);
    void drawLabels(QCPPainter* painter, const std::vector<Mark>& marks);
    [[nodiscard]] QRectF labelBox(const Mark& mark, double angle, double away) const;
    [[nodiscard]] bool hasRoom(const QRectF& box) const;
    [[nodiscard]] bool isCrossed(const QRectF& box) const; ///< by the profile
    void drawText(QCPPainter* painter, const QRectF& box, const QString& text) const;

    PolarScale m_scale;
    double m_reach = 1;
    std::vector<ProfilePoint> m_line;
    QStringList m_labels;
    std::vector<QRectF> m_boxes;
    std::vector<QRectF> m_names; ///< areas of the angle names
};

/// Points at one sample and the opposite one.
class PolarPointer : public PolarLayer {
    Q_OBJECT
public:
    explicit PolarPointer(QCPAxisRect* rect);
    void point(double angle, double here, double across); ///< drawn radii
    void clear() { m_shown = false; }
    [[nodiscard]] bool shown() const { return m_shown; }

protected:
    void draw(QCPPainter* painter) override;

private:
    bool m_shown = false;
    double m_angle = 0, m_here = 0, m_across = 0;
};

/// One cross-section of ProfilesPlot: its header, its drawing and its numbers, beside or below. The
/// parts belong to the plot.
class ProfileCell {
public:
    ProfileCell(QCustomPlot& plot, QCPLayoutGrid& into, bool numbersBeside);

    /// Draws a profile within this distance from the centre.
    void fill(const ProfileSeries& series, const Profile& profile, const PolarScale& scale,
              double reach, const ProfileLines& hidden, ReferenceCircles circles);
    /// Hides blank, target and tolerance: of a measured profile only the form is known.
    void showFormAlone() const;
    void restyle(const QFont& font, const QPalette& palette, bool dim);
    void point(const Profile& profile, const PolarScale& scale, int k);
    void removeLayers(); ///< removes parts that are neither plottables nor in a layout

    [[nodiscard]] QCPTextElement* header() const { return m_header; }
    [[nodiscard]] QCPTextElement* numbers() const { return m_numbers; }
    [[nodiscard]] QCPAxisRect* rect() const { return m_rect; }
    [[nodiscard]] PolarRing* field() const { return m_field; }
    [[nodiscard]] PolarCircle* target() const { return m_target; }
    [[nodiscard]] PolarGrid* grid() const { return m_grid; }
    [[nodiscard]] PolarPointer* pointer() const { return m_pointer; }
    [[nodiscard]] QCPCurve* profile() const { return m_profile; }
    [[nodiscard]] QCPCurve* blank() const { return m_blank; }
    [[nodiscard]] QCPCurve* leastSquares() const { return m_leastSquares; }
    [[nodiscard]] QCPCurve* innerCircle() const { return m_inner; }
    [[nodiscard]] QCPCurve* outerCircle() const { return m_outer; }
    [[nodiscard]] QCPCurve* centreMark() const { return m_centre; }
    [[nodiscard]] QCPCurve* contacts() const { return m_contacts; }

private:
    void arrange(QCPLayoutGrid& into, bool numbersBeside) const;
    void fillCircles(const Profile& profile, const PolarScale& scale, const ProfileLines& hidden,
                     ReferenceCircles circles);
    void setCirclePens();

    QCPTextElement* m_header;
    QCPTextElement* m_numbers;
    QCPAxisRect* m_rect;
    PolarRing* m_field;
    PolarGrid* m_grid;
    PolarCircle* m_target;
    PolarPointer* m_pointer;
    QCPCurve* m_blank;
    QCPCurve* m_leastSquares;
    QCPCurve* m_inner; ///< circles of the minimum zone, or the reference circles
    QCPCurve* m_outer;
    QCPCurve* m_centre; ///< centre of the circles
    QCPCurve* m_profile;
    QCPCurve* m_contacts; ///< contacts of the minimum zone
    QPen m_circlePen;
    ReferenceCircles m_circles = ReferenceCircles::none;
};

} // namespace sparkout
