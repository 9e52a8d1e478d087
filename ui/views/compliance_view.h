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
    void retranslate() override;

protected:
    void changeEvent(QEvent* event) override;
    void showOutcome() override;

private:
    void buildTools(QWidget* bar, Settings* settings);
    void showState();
    [[nodiscard]] QString summary() const;

    CompliancePlot* m_plot;
    LegendStrip* m_legend;
    QLabel* m_summary;
    QLabel* m_notice;
    QLabel* m_values;
    PlotTools* m_tools = nullptr;
    OutcomePtr m_good; ///< what the plot shows
};

} // namespace sparkout
