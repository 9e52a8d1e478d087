// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_style.h"
#include "ui/text/shown_scale.h"

#include <qcustomplot.h>

#include <cmath>

namespace sparkout {

/// The position of a value on an axis with equal steps or equal ratios: the axes themselves stay
/// linear, since QCustomPlot's colour maps require that.
struct SweepScale {
    bool ratios = false;
    ShownScale shown = {}; ///< from the value to the displayed number

    [[nodiscard]] double at(double value) const { return ratios ? std::log10(value) : value; }
    [[nodiscard]] double valueAt(double place) const {
        return ratios ? std::pow(10.0, place) : place;
    }
};

/// Ticks at round values of such an axis.
class SweepTicker : public NumberTicker {
public:
    explicit SweepTicker(SweepScale scale) : m_scale(scale) {}

protected:
    QVector<double> createTickVector(double step, const QCPRange& range) override;
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;

private:
    SweepScale m_scale;
};

} // namespace sparkout
