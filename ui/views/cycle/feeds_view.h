// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_series.h"
#include "ui/chart/plot_view.h"

#include <optional>

class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace sparkout {

class FeedsNote;
class FeedsOverview;
class FeedsPlot;
class TraceComparer;
class TracesPlot;

/// The view "Feeds by stage": programmed and actual feed, accumulated feeds with the radii before
/// and after, axial feed and force; over the whole cycle, one stage or one double stroke.
class FeedsView : public PlotView {
    Q_OBJECT
public:
    explicit FeedsView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] FeedsPlot* plot() const { return m_plot; }
    [[nodiscard]] TracesPlot* traces() const { return m_traces; }
    [[nodiscard]] FeedsOverview* overview() const { return m_overview; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool showsMoment() const override { return true; }
    [[nodiscard]] bool busy() const override; ///< including the traces
    [[nodiscard]] QString brief() const override;
    void showPlace(const Place& place); ///< the double stroke or revolution, and its section
    void showStage(int stage);          ///< from 1; no effect for a stage that did not begin

protected:
    [[nodiscard]] bool draws(const Outcome& outcome) const override;
    [[nodiscard]] bool drawn() const override;
    void takeOutcome(const OutcomePtr& before) override;
    void dropOutcome() override;
    void followCycle() override;
    void showState() override;
    void showLegend() override;
    void toggleCurve(int key) override;
    void showOnly(int key) override;
    void nameParts() override;
    [[nodiscard]] QString noticeText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QString hint() const override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    enum class Span { whole, stage, stroke, free };

    QWidget* buildTools();
    void connectTools();
    void connectPlot();
    void buildTraces();
    void linkCursors();
    void compareTraces();
    void showTraceTimes();
    void fillSpans();
    void fillAxes();
    void fillSections();
    void fitAll();
    void onSpanChosen(int index);
    void onStrokeChosen(int number);
    void onSectionChosen(int index);
    void applySpan();
    void readSpan(); ///< updates the tools to the visible range
    void showSpan();
    void showMoment();
    void bringIntoSight(double time_s);
    void showNote();
    void makeRoomForValues();
    [[nodiscard]] bool isUnrecorded() const; ///< the newest run was too long to record
    [[nodiscard]] bool countsStrokes() const;
    [[nodiscard]] std::vector<int> shownColumns() const;

    FeedsPlot* m_plot;
    TracesPlot* m_traces;
    TraceComparer* m_comparer;
    QToolButton* m_traceExport = nullptr;
    FeedsOverview* m_overview;
    FeedsNote* m_noteDialog = nullptr;
    QComboBox* m_span = nullptr;
    QLabel* m_strokeLabel = nullptr;
    QSpinBox* m_stroke = nullptr;
    QToolButton* m_previous = nullptr;
    QToolButton* m_next = nullptr;
    QComboBox* m_axis = nullptr;
    QComboBox* m_section = nullptr;
    QToolButton* m_note = nullptr;

    Span m_what = Span::whole;
    int m_stage = 1;
    std::optional<int> m_wantedSection;
};

} // namespace sparkout
