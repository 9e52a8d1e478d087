// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/bar_chart.h"
#include "ui/chart/plot_view.h"
#include "ui/session/studies.h"
#include "ui/views/part/overview_charts.h"

#include <QFrame>
#include <QString>

#include <array>
#include <optional>

class QLabel;
class QPushButton;
class QToolButton;

class QGridLayout;
class QScrollArea;

namespace sparkout {

class BarPlot;
class LegendStrip;

/// One chart of the overview: its title, its legend, a button to enlarge it to the page, and,
/// without data, a text on its content with a button for the next step.
class OverviewTile : public QFrame {
    Q_OBJECT
public:
    OverviewTile(const QString& name, QWidget* parent); ///< `name` begins its parts' names, too

    [[nodiscard]] BarPlot* plot() const { return m_plot; }
    void addExport(); ///< adds the export button; requires the tools of the plot
    void setTitle(const QString& title);
    void setChart(BarChart chart); ///< no replot
    /// Shows a text in place of the chart; a step without text has no button.
    void setEmpty(const QString& text, const QString& step = {});
    void setAlone(bool isAlone); ///< whether it fills the page
    void retranslate();
    void fitHeight(); ///< sets the height for the chart and the current font

    [[nodiscard]] bool isEmpty() const;
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString emptyText() const;

signals:
    void enlargeAsked();
    void stepAsked(); ///< the button of the empty tile was clicked

private:
    void showLegend();
    void nameStep();
    void showParts();

    QLabel* m_title;
    QToolButton* m_enlarge;
    LegendStrip* m_legend;
    BarPlot* m_plot;
    QLabel* m_remark;
    QLabel* m_empty;
    QPushButton* m_step;
    bool m_isAlone = false;
};

class KeptRuns;

/// The view "Overview": the cycle at a glance, as bar charts on one page, each of which can be
/// enlarged. A click on a bar opens the view with the details.
class OverviewView : public PlotView {
    Q_OBJECT
public:
    explicit OverviewView(const KeptRuns& kept, QWidget* parent = nullptr,
                          Settings* settings = nullptr);

    void setBatch(BatchOutcomePtr batch); ///< the newest batch, or null
    [[nodiscard]] OverviewTile* tile(OverviewChart chart) const {
        return m_tiles[static_cast<std::size_t>(chart)];
    }
    void enlarge(OverviewChart chart); ///< enlarges a chart to the page; again: shows all
    [[nodiscard]] std::optional<OverviewChart> enlarged() const { return m_alone; }
    [[nodiscard]] int columns() const { return m_columns; }

    void offerKeeping(bool offers); ///< shows or hides the button that keeps the current run

    [[nodiscard]] QString title() const override;

signals:
    void stageAsked(int stage);     ///< counted from 1, for the view of the feeds
    void sectionAsked(int section); ///< counted from 0, for the view of the profiles
    void requirementAsked(const sparkout::ConstraintResult& requirement);
    void viewAsked(const QString& name);
    void keepAsked(); ///< requests keeping the current run

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    [[nodiscard]] bool isFaint(const ViewPlot& plot) const override;
    void showState() override;
    void showLegend() override {} ///< each tile has its own
    void recolour() override;
    [[nodiscard]] QString remark() const override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void dropStudies() override;
    void build();
    [[nodiscard]] int columnsWithRoom() const;
    void arrange(); ///< uses as many columns as fit
    void follow(OverviewChart chart, std::size_t series, std::size_t category);
    void showCycle();
    void showBatch();
    void showRuns();
    [[nodiscard]] bool isBatchStale() const;
    [[nodiscard]] std::vector<RunBars> shownRuns() const;
    [[nodiscard]] QStringList headingOf(OverviewChart chart) const;

    const KeptRuns& m_kept;
    std::array<OverviewTile*, allOverviewCharts.size()> m_tiles{};
    QScrollArea* m_scroll;
    QGridLayout* m_grid = nullptr;
    int m_columns = 0;
    std::optional<OverviewChart> m_alone;
    BatchOutcomePtr m_batch;
    bool m_offersKeeping = true;
    bool m_runsChanged = true, m_batchChanged = true; ///< changed while the view was hidden
};

} // namespace sparkout
