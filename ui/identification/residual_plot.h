// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"

#include <vector>

namespace sparkout {

/// What one group of measured values leaves over after a fit.
class ResidualPlot : public ViewPlot {
    Q_OBJECT

public:
    explicit ResidualPlot(QWidget* parent = nullptr);

    void setResiduals(const std::vector<double>& at, const std::vector<double>& values,
                      const QString& across, const QString& up);
    void fit() override;
    void restyle() override;
    [[nodiscard]] QSize minimumSizeHint() const override;

private:
    QCPAxisRect* m_rect;
    QCPGraph* m_points;
    QCPItemStraightLine* m_zero;
};

} // namespace sparkout
