// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "ui/plot/painted_layer.h"

#include <vector>

namespace sparkout {

/// A coloured interval of the horizontal axis with its name.
struct Band {
    double from = 0, to = 0; ///< in the unit of the axis
    QColor colour;
    QString name;    ///< "stage 1", drawn above the axis rect
    QString brief;   ///< "st. 1", used if names are too long; may be empty
    QString meaning; ///< "E1: plunge-in", for tooltips
};

/// A zone or section, from end to end, in the colour of its kind.
[[nodiscard]] Band zoneBand(Zone zone, int section, double from, double to, const QPalette& palette,
                            int middleAlpha = 38);

/// Draws bands behind the curves of one axis rect, and their names in one line of its upper margin,
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
    [[nodiscard]] std::vector<Name> namesIn(const QRectF& area, bool brief) const;
    void drawNames(QCPPainter* painter, const QRectF& area);

    bool m_showNames;
    std::vector<Band> m_bands;
    std::vector<DrawnName> m_drawnNames;
};

} // namespace sparkout
