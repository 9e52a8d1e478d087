// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/feed_series.h"
#include "ui/views/view.h"

#include <optional>

class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace sparkout {

class FeedsPlot;
class LegendStrip;

/// The view "Feeds by stage": programmed and actual feed, accumulated feeds with the radii before
/// and after, axial feed or force; over the whole cycle, one stage or one double stroke.
class FeedsView : public View {
    Q_OBJECT
public:
    explicit FeedsView(QWidget* parent = nullptr);

    [[nodiscard]] FeedsPlot* plot() const { return m_plot; }
    [[nodiscard]] double lastUpdate_ms() const { return m_lastUpdate_ms; } ///< series and replot
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    void setOutcome(sparkout::OutcomePtr outcome) override; ///< one replot, later
    void retranslate() override;

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    enum class Span { whole, stage, stroke, free };

    void buildToolBar(QWidget* bar);
    void buildLabels();
    void connectTools();
    void scheduleUpdate();
    void redraw();
    void showOutcome();
    void fillSpans();
    void fillAxes();
    void fillSections();
    void onSpanChosen(int index);
    void onStrokeChosen(int number);
    void onSectionChosen(int index);
    void applySpan();
    void showSpan();
    void showState();
    void showLegend();
    [[nodiscard]] FeedSeries currentSeries() const;

    FeedsPlot* m_plot = nullptr;
    LegendStrip* m_legend = nullptr;
    QLabel* m_notice = nullptr;
    QLabel* m_values = nullptr;
    QComboBox* m_span = nullptr;
    QLabel* m_strokeLabel = nullptr;
    QSpinBox* m_stroke = nullptr;
    QToolButton* m_previous = nullptr;
    QToolButton* m_next = nullptr;
    QComboBox* m_axis = nullptr;
    QComboBox* m_section = nullptr;
    QToolButton* m_fit = nullptr;

    OutcomePtr m_latest; ///< what was given last, maybe refused
    OutcomePtr m_good;   ///< what the curves show
    bool m_stale = false;
    bool m_queued = false;
    Span m_what = Span::whole;
    int m_stage = 1;
    std::optional<int> m_wantedSection;
    double m_lastUpdate_ms = 0;
};

} // namespace sparkout
