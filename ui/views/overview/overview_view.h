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

/// The view "Overview": the cycle at a glance, as charts of bars on one page, each of which can be
/// enlarged to all of it. A bar leads to the view that has the details.
class OverviewView : public PlotView {
    Q_OBJECT
public:
    explicit OverviewView(const KeptRuns& kept, QWidget* parent = nullptr,
                          Settings* settings = nullptr);

    void setBatch(BatchOutcomePtr batch); ///< the newest that was run; null: none
    [[nodiscard]] OverviewTile* tile(OverviewChart chart) const {
        return m_tiles[static_cast<std::size_t>(chart)];
    }
    void enlarge(OverviewChart chart); ///< to the whole page; again: all of them
    [[nodiscard]] std::optional<OverviewChart> enlarged() const { return m_alone; }
    [[nodiscard]] int columns() const { return m_columns; }

    void offerKeeping(bool offers); ///< the button that keeps the present run

    [[nodiscard]] QString title() const override;

signals:
    void stageAsked(int stage);     ///< from 1, in the view of the feeds
    void sectionAsked(int section); ///< from 0, in that of the profiles
    void requirementAsked(const sparkout::ConstraintResult& requirement);
    void viewAsked(const QString& name);
    void keepAsked(); ///< the present run is to be kept

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
    void arrange(); ///< the tiles in as many columns as have room
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
    bool m_runsChanged = true, m_batchChanged = true; ///< while it was hidden
};

} // namespace sparkout
