// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <vector>

namespace sparkout {

/// A coloured stretch of the horizontal axis with its name.
struct Band {
    double from = 0, to = 0; ///< in the axis' unit
    QColor colour;
    QString name;    ///< "E1", drawn above the axis rect
    QString meaning; ///< "plunge-in", for tooltips
};

/// Draws bands behind the curves of one axis rect, and their names in its upper margin, where they
/// cover no data; names that would overlap go to a second line or are left out.
class BandLayer : public QCPLayerable {
    Q_OBJECT
public:
    BandLayer(QCPAxisRect* rect, bool showNames);

    void setBands(std::vector<Band> bands) { m_bands = std::move(bands); }
    [[nodiscard]] const std::vector<Band>& bands() const { return m_bands; }
    [[nodiscard]] const Band* bandAt(double x) const;
    /// Names drawn by the last replot, widest band first.
    [[nodiscard]] const QStringList& drawnNames() const { return m_drawnNames; }

    static int nameMargin(const QFont& font); ///< height the names need above the rect

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    void drawNames(QCPPainter* painter, const QRectF& area);

    QCPAxisRect* m_rect;
    bool m_showNames;
    std::vector<Band> m_bands;
    QStringList m_drawnNames;
};

} // namespace sparkout
