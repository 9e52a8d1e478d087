// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"
#include "ui/views/part/framed_plot.h"

#include <vector>

namespace sparkout {

class BandLayer;
class ShaftLayer;

/// The part along its axis: mean, smallest and largest radius (or diameter) of each zone or section
/// against the tolerance band; exaggerated, or the shaft drawn to scale.
class LongitudinalPlot : public FramedPlot {
    Q_OBJECT
public:
    explicit LongitudinalPlot(QWidget* parent = nullptr);

    /// `shown` are the profiles in the cross-sections; in plunge they are marked here.
    void setSeries(ProfileSeries series, std::vector<ShaftStep> shaft, std::vector<int> shown);
    void setDiameters(bool diameters); ///< D − d instead of R − R_t
    void setToScale(bool toScale);
    void fit() override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeFor(98, 3); }
    void setVisibleRange(const PlotHistory::State& range) override;
    void restyle() override;

    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] bool toScale() const { return m_toScale; }
    [[nodiscard]] LengthQuantity quantity() const; ///< the drawn quantity
    [[nodiscard]] QCPGraph* graph(LengthLine line, bool mirrored = false) const;
    [[nodiscard]] BandLayer* bands() const { return m_bands; }
    [[nodiscard]] const QCPItemText* gaugeName() const { return m_gaugeName; }
    [[nodiscard]] std::vector<ProfileLine> lines() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] QCPRange readSpan() const override { return {0, m_series.length_mm}; }
    [[nodiscard]] CursorSubject cursorSubject() override;
    [[nodiscard]] QString scaleText() const; ///< exaggeration, or size of a pixel

signals:
    void profileClicked(int profile); ///< index of the zone or section

protected:
    void setTexts() override;
    void showChoice() override { fit(); }
    void onMouse(QMouseEvent* event) override;
    void pointAway() override { pointAt(-1); }
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Curve {
        LengthLine line = LengthLine::mean;
        bool mirrored = false; ///< draws the other side of the axis, to scale
        QCPGraph* graph = nullptr;
    };

    void build();
    void fill();
    void fillBands();
    void placeGauge();
    void placeGaugeName();
    void label();
    void fitAxes();
    void afterLayouting();
    void keepScale();
    void showScale();
    [[nodiscard]] bool draws(LengthLine line) const;
    [[nodiscard]] QString nameOf(const Curve& curve) const;
    [[nodiscard]] static QString placeLabel();
    [[nodiscard]] QCPRange visibleValues() const;
    [[nodiscard]] int profileUnder(const QPoint& at) const; ///< −1: none
    void pointAt(int profile);

    ProfileSeries m_series;
    std::vector<ShaftStep> m_shaft;
    std::vector<int> m_shown;
    std::vector<Curve> m_curves;
    QCPAxisRect* m_rect = nullptr;
    BandLayer* m_bands = nullptr;
    ShaftLayer* m_body = nullptr;
    QCPItemLine* m_gaugeLine = nullptr;
    QCPItemText* m_gaugeName = nullptr;
    bool m_diameters = false;
    bool m_toScale = false;
    int m_pointed = -1;
};

} // namespace sparkout
