// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace sparkout {

class CompliancePlot;
class ComplianceStudies;
class LegendStrip;
class CursorStrip;
class PlotCursors;
class PlotTools;
class Settings;

/// The view "Compliance": the part on its supports, to scale, and how far the system yields along
/// it, by what yields; or where to put the gauge, or what coupled sections change.
class ComplianceView : public View {
    Q_OBJECT
public:
    explicit ComplianceView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] CompliancePlot* plot() const { return m_plot; }
    [[nodiscard]] PlotTools* tools() const { return m_tools; }
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    void retranslate() override;

signals:
    void gaugeWanted(double position_mm); ///< there, from the headstock end of the ground length

protected:
    [[nodiscard]] QString hint() const override;
    void recolour() override;
    void showOutcome() override;

private:
    void buildTools(QWidget* bar, Settings* settings);
    void buildStudies();
    void chooseContent();
    void ask(); ///< for what the content shows beyond the run
    void showStudy(const OutcomePtr& of);
    void showState();
    [[nodiscard]] QString notice() const;
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QString complianceSummary() const;
    [[nodiscard]] QString gaugeSummary() const;
    [[nodiscard]] bool studied() const; ///< what is shown belongs to the run shown
    [[nodiscard]] bool canPutGauge() const;

    CompliancePlot* m_plot;
    LegendStrip* m_legend;
    QLabel* m_summary;
    QLabel* m_notice;
    QLabel* m_values;
    QComboBox* m_content;
    QPushButton* m_put;
    ComplianceStudies* m_studies;
    PlotTools* m_tools = nullptr;
    PlotCursors* m_cursors = nullptr;
    CursorStrip* m_strip = nullptr;
    OutcomePtr m_good;    ///< what the plot shows
    OutcomePtr m_studied; ///< what its diameters belong to
    int m_done = 0, m_total = 0;
    bool m_fitNext = false; ///< with the next answer
};

} // namespace sparkout
