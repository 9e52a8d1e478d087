// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_series.h"
#include "ui/plot/view.h"

#include <optional>

class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace sparkout {

class FeedsNote;
class FeedsOverview;
class FeedsPlot;
class LegendStrip;
class CursorStrip;
class PlotCursors;
class PlotTools;
class Settings;

/// The view "Feeds by stage": programmed and actual feed, accumulated feeds with the radii before
/// and after, axial feed and force; over the whole cycle, one stage or one double stroke.
class FeedsView : public View {
    Q_OBJECT
public:
    explicit FeedsView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] FeedsPlot* plot() const { return m_plot; }
    [[nodiscard]] FeedsOverview* overview() const { return m_overview; }
    [[nodiscard]] LegendStrip* legend() const { return m_legend; }
    [[nodiscard]] PlotTools* tools() const { return m_tools; }
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }
    [[nodiscard]] double lastUpdate_ms() const { return m_lastUpdate_ms; } ///< filling and replot
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString brief() const override;
    void retranslate() override;
    void showPlace(const Place& place); ///< the double stroke or revolution, and its section

protected:
    void showOutcome() override;
    void followCycle() override;
    [[nodiscard]] QString hint() const override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class Span { whole, stage, stroke, free };

    void buildToolBar(QWidget* bar);
    void buildPlotTools(Settings* settings);
    void nameTools();
    void buildLabels();
    void connectTools();
    void connectPlot();
    void fillSpans();
    void fillAxes();
    void fillSections();
    void fitAll();
    void onSpanChosen(int index);
    void onStrokeChosen(int number);
    void onSectionChosen(int index);
    void applySpan();
    void readSpan(); ///< which part of the cycle the times in sight are
    void showSpan();
    void showMoment();
    void bringIntoSight(double time_s);
    void showState();
    void showLegend();
    void showNote();
    [[nodiscard]] std::vector<int> shownColumns() const;

    FeedsPlot* m_plot = nullptr;
    FeedsOverview* m_overview = nullptr;
    LegendStrip* m_legend = nullptr;
    PlotTools* m_tools = nullptr;
    PlotCursors* m_cursors = nullptr;
    CursorStrip* m_strip = nullptr;
    FeedsNote* m_noteDialog = nullptr;
    QLabel* m_notice = nullptr;
    QLabel* m_values = nullptr;
    QComboBox* m_span = nullptr;
    QLabel* m_strokeLabel = nullptr;
    QSpinBox* m_stroke = nullptr;
    QToolButton* m_previous = nullptr;
    QToolButton* m_next = nullptr;
    QComboBox* m_axis = nullptr;
    QComboBox* m_section = nullptr;
    QToolButton* m_note = nullptr;

    OutcomePtr m_good; ///< what the curves show
    Span m_what = Span::whole;
    int m_stage = 1;
    std::optional<int> m_wantedSection;
    double m_lastUpdate_ms = 0;
};

} // namespace sparkout
