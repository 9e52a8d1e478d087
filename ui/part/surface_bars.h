// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/bars/bar_chart.h"
#include "ui/session/setup_state.h"
#include "ui/session/surface_status.h"

#include <QWidget>

#include <vector>

namespace sparkout {

class BarPlot;
class LegendStrip;

/// The surfaces of a part side by side: the time of each cycle and its least margin, as bars. A bar
/// leads to its surface.
class SurfaceBars : public QWidget {
    Q_OBJECT
public:
    explicit SurfaceBars(QWidget* parent = nullptr);

    void setPart(const SetupState& state, const std::vector<SurfaceStatus>& statuses);
    void retranslate(); ///< only the names; setPart() follows

    [[nodiscard]] static BarChart chartOf(const SetupState& state,
                                          const std::vector<SurfaceStatus>& statuses);

signals:
    void surfaceWanted(std::size_t surface);

private:
    void showLegend();

    LegendStrip* m_legend;
    BarPlot* m_plot;
};

} // namespace sparkout
