// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/view.h"

class QLabel;

namespace sparkout {

class CompliancePlot;
class LegendStrip;
class PlotTools;
class Settings;

/// The view "Compliance": the part on its supports, to scale, and how far the system yields along
/// it, by what yields.
class ComplianceView : public View {
    Q_OBJECT
public:
    explicit ComplianceView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] CompliancePlot* plot() const { return m_plot; }
    [[nodiscard]] PlotTools* tools() const { return m_tools; }
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    void setOutcome(sparkout::OutcomePtr outcome) override; ///< one replot, later
    void retranslate() override;

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void buildTools(QWidget* bar, Settings* settings);
    void scheduleUpdate();
    void redraw();
    void showOutcome();
    void showState();
    [[nodiscard]] QString summary() const;

    CompliancePlot* m_plot;
    LegendStrip* m_legend;
    QLabel* m_summary;
    QLabel* m_notice;
    QLabel* m_values;
    PlotTools* m_tools = nullptr;
    OutcomePtr m_latest; ///< what was given last, maybe refused
    OutcomePtr m_good;   ///< what the plot shows
    bool m_stale = false;
    bool m_queued = false;
};

} // namespace sparkout
