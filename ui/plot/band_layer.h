// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "ui/plot/line_chart.h"
#include "ui/plot/painted_layer.h"

#include <vector>

namespace sparkout {

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
