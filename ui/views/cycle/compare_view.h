// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/plot_view.h"
#include "ui/results/run_table.h"
#include "ui/session/kept_runs.h"
#include "ui/session/run_controller.h"

#include <optional>
#include <vector>

class QComboBox;
class QListView;
class QPushButton;
class QSplitter;

namespace sparkout {

class ComparePlot;
class CopyTable;
class RunsPanel;
class SecondAxisMenu;
class ValueModel;
struct ComparedFeeds;

/// The view "Compare": the curves of kept runs and the current run, and a table of the inputs and
/// results that differ. Its list keeps, renames, deletes and restores runs.
class CompareView : public PlotView {
    Q_OBJECT
public:
    explicit CompareView(KeptRuns& kept, QWidget* parent = nullptr, Settings* settings = nullptr);

    /// Sets the newest run; a refused one keeps the previous.
    void setJudged(const JudgedRun& judged);
    [[nodiscard]] ComparePlot* plot() const { return m_plot; }
    [[nodiscard]] ValueModel* table() const { return m_tableModel; }
    [[nodiscard]] const std::vector<RunRow>& rows() const { return m_rows; } ///< rows of the table
    [[nodiscard]] QListView* list() const;

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool showsMoment() const override { return true; }

signals:
    void keepWanted(); ///< requests keeping the current run

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    void dropOutcome() override;
    [[nodiscard]] bool drawn() const override;
    void showState() override; ///< also updates the kept runs, which may change independently
    void followCycle() override;
    [[nodiscard]] QString noticeText() const override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;

private:
    void build();
    QWidget* buildUpper();
    QWidget* buildCurves();
    QWidget* buildTable();
    void connectParts();
    void showJudged();
    void showCurves();
    void showTable();
    void shareHeight(bool withTable);
    void fitTable(); ///< sizes the columns to show the values; the first takes the rest
    [[nodiscard]] int widthOfWords(int column) const;
    [[nodiscard]] int heightOfHeads() const;
    void fillAxes();
    void fillZones();
    [[nodiscard]] std::vector<int> chosenRuns() const;
    [[nodiscard]] std::optional<ComparedFeeds> feedsOf(int run) const;
    [[nodiscard]] QStringList runNotes(int run) const;
    [[nodiscard]] QString emptyText() const;

    KeptRuns& m_kept;
    ComparePlot* m_plot;
    SecondAxisMenu* m_second;
    QComboBox* m_zone;
    QComboBox* m_axis;
    RunsPanel* m_runs;
    std::vector<RunRow> m_rows; ///< rows of the table
    ValueModel* m_tableModel;
    CopyTable* m_table;
    QLabel* m_empty;
    QPushButton* m_keepHere;
    QSplitter* m_columns;
    QSplitter* m_halves;
    QList<int> m_heights;                 ///< heights of the two parts while there is a table
    std::optional<ReadSummary> m_present; ///< summary of the current run
    JudgedRun m_judged;
    std::size_t m_wanted = 1; ///< zone or section of the current run chosen by the user
};

} // namespace sparkout
