// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_view.h"
#include "ui/session/studies.h"
#include "ui/views/overview/overview_charts.h"

#include <array>
#include <optional>

class QGridLayout;
class QScrollArea;

namespace sparkout {

class KeptRuns;
class OverviewTile;

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
