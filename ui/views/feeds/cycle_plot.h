// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/chart_plot.h"
#include "ui/views/feeds/feeds_chart.h"

#include <optional>

namespace sparkout {

class HairLine;

/// Charts over the time of a cycle, all within the same visible times. The values follow what is
/// visible; lines mark the moment of the cycle and the time under the mouse.
class CyclePlot : public ChartPlot {
    Q_OBJECT
public:
    explicit CyclePlot(QWidget* parent);

    [[nodiscard]] virtual const CycleTimes& times() const = 0;
    [[nodiscard]] virtual QString timeLabel() const = 0; ///< "Time, min"
    void setMoment(std::optional<double> time_s);        ///< moment of the cycle; empty: its end
    [[nodiscard]] std::optional<double> moment_s() const { return m_moment_s; }
    /// Within a plot, wheel and drag move only the time.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;
    [[nodiscard]] CursorSubject cursorSubject() override;

signals:
    void timesWanted(double from_s, double to_s); ///< the user moved them
    void timeClicked(double time_s);

protected:
    void follow(); ///< updates content and ranges to the visible times; no replot
    [[nodiscard]] bool isFollowing() const { return m_isFollowing; }
    void showChoice() override; ///< hidden curves are not used for scaling
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    void cellsBuilt() override;

private:
    void onTimesChanged(const QCPRange& range);

    HairLine* m_momentLine;
    HairLine* m_hairLine;
    std::optional<double> m_moment_s;
    QString m_label; ///< of the last content
    bool m_isFollowing = false;
};

} // namespace sparkout
