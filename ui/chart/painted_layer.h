// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "ui/chart/line_chart.h"

#include <optional>
#include <qcustomplot.h>
#include <vector>

namespace sparkout {

/// A painting on a layer of a plot, besides its curves: anywhere in the plot, or within an axis
/// rect.
class PaintedLayer : public QCPLayerable {
protected:
    enum class Edges { sharp, smooth };

    PaintedLayer(QCustomPlot& plot, const QString& layer, Edges edges)
        : QCPLayerable(&plot, layer), m_edges(edges) {}
    PaintedLayer(QCPAxisRect& rect, const QString& layer, Edges edges)
        : QCPLayerable(rect.parentPlot(), layer), m_rect(&rect), m_edges(edges) {}

    void applyDefaultAntialiasingHint(QCPPainter* painter) const override {
        painter->setAntialiasing(m_edges == Edges::smooth);
    }
    [[nodiscard]] QRect clipRect() const override {
        return m_rect ? m_rect->rect() : QCPLayerable::clipRect();
    }

    QCPAxisRect* m_rect = nullptr; ///< null: the whole plot

private:
    Edges m_edges;
};

/// A vertical line at one value of the horizontal axes, through every axis rect of a plot whose
/// range contains it: under the mouse, or at the moment of the cycle that the views share. On its
/// own layer, so that moving it redraws no curve.
class HairLine : public PaintedLayer {
    Q_OBJECT
public:
    enum class Role { mouse, moment };
    explicit HairLine(QCustomPlot& plot, Role role = Role::mouse);

    void setAt(std::optional<double> x); ///< draws at once; empty: no line
    [[nodiscard]] std::optional<double> at() const { return m_x; }
    [[nodiscard]] Role role() const { return m_role; }

    static QString layerName() { return QStringLiteral("hairline"); }

protected:
    void draw(QCPPainter* painter) override;

private:
    Role m_role;
    std::optional<double> m_x;
};

/// A zone or section, from end to end, in the colour of its kind.
[[nodiscard]] Band zoneBand(Zone zone, int section, double from, double to, int middleAlpha = 38);

/// Draws bands behind all else in one axis rect, and their names in one line of its upper margin,
/// where they cover no data. A name always touches its band and has its colour; where not all names
/// fit, the brief names are tried, then the narrowest bands have none.
class BandLayer : public PaintedLayer {
    Q_OBJECT
public:
    BandLayer(QCPAxisRect* rect, bool showNames);

    void setBands(std::vector<Band> bands) { m_bands = std::move(bands); }
    [[nodiscard]] const std::vector<Band>& bands() const { return m_bands; }
    [[nodiscard]] const Band* bandAt(double x) const;

    /// A name drawn by the last replot.
    struct DrawnName {
        QString text;
        QRectF box;
    };
    [[nodiscard]] const std::vector<DrawnName>& drawnNames() const { return m_drawnNames; }

    static int nameMargin(const QFont& font); ///< height the names need above the rect

protected:
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    struct Name;
    [[nodiscard]] QColor colourOf(const Band& band) const;
    [[nodiscard]] std::vector<Name> namesIn(const QRectF& area, bool brief) const;
    void drawNames(QCPPainter* painter, const QRectF& area);

    bool m_showNames;
    std::vector<Band> m_bands;
    std::vector<DrawnName> m_drawnNames;
};

} // namespace sparkout
