// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/verdict_model.h"
#include "ui/plot/view.h"
#include "ui/session/kept_runs.h"

#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QListView;
class QMenu;
class QPushButton;
class QSplitter;
class QToolButton;

namespace sparkout {

class ComparePlot;
class CopyTable;
class CursorStrip;
class LegendStrip;
class PlotCursors;
class PlotTools;
class RunsModel;
class RunTableModel;
class Settings;
struct ComparedFeeds;

/// The view "Compare": kept runs laid over the present one, and a table of the inputs and results
/// in which they differ. Runs are kept, renamed, deleted and restored from its list.
class CompareView : public View {
    Q_OBJECT
public:
    explicit CompareView(KeptRuns& kept, QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ComparePlot* plot() const { return m_plot; }
    [[nodiscard]] RunTableModel* table() const { return m_tableModel; }
    [[nodiscard]] QListView* list() const { return m_list; }
    [[nodiscard]] PlotTools* tools() const { return m_tools; }
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    void retranslate() override;

signals:
    void keepWanted(); ///< the present run

protected:
    [[nodiscard]] QString hint() const override;
    void recolour() override;
    void showOutcome() override;
    void followCycle() override;

private:
    void build(Settings* settings);
    void buildTools(Settings* settings);
    QWidget* buildRuns();
    QWidget* buildCurves();
    QWidget* buildTable();
    QAction* makeAction(const char* name, const char16_t* icon, const QKeySequence& keys);
    void connectParts();
    void nameParts();
    void showRuns();
    void showCurves();
    void showTable();
    void showState();
    void showMoment();
    void shareHeight(bool withTable);
    void fitTable(); ///< the values are in sight, what differs has the rest
    void showLegend();
    void fillAxes();
    void buildSecond();
    void nameSecond();
    void fillZones();
    [[nodiscard]] int selectedRun() const; ///< of the kept ones; −1: none
    [[nodiscard]] std::vector<int> chosenRuns() const;
    [[nodiscard]] const RunSummary* summaryOf(int run) const;
    [[nodiscard]] std::optional<Light> lightOfRun(int run) const;
    [[nodiscard]] QString detailOf(int run) const;
    [[nodiscard]] QString toldOf(int run) const;
    [[nodiscard]] std::optional<ComparedFeeds> feedsOf(int run) const;
    [[nodiscard]] QString notice() const;
    [[nodiscard]] QString emptyText() const;
    [[nodiscard]] QStringList heading() const;

    KeptRuns& m_kept;
    ComparePlot* m_plot;
    LegendStrip* m_legend;
    QComboBox* m_zone;
    QComboBox* m_axis;
    QLabel* m_notice;
    QLabel* m_values;
    QListView* m_list;
    RunsModel* m_runs;
    CopyTable* m_table;
    RunTableModel* m_tableModel;
    QLabel* m_empty;
    QPushButton* m_keepHere;
    QSplitter* m_columns;
    QSplitter* m_halves;
    QList<int> m_heights; ///< of the halves, while there is a table
    PlotTools* m_tools = nullptr;
    PlotCursors* m_cursors = nullptr;
    CursorStrip* m_strip = nullptr;
    QMenu* m_second = nullptr;            ///< of the right-hand axes
    std::vector<QAction*> m_seconds = {}; ///< its quantities, row by row
    QAction* m_keep = nullptr;
    QAction* m_restore = nullptr;
    QAction* m_rename = nullptr;
    QAction* m_delete = nullptr;
    OutcomePtr m_good;                    ///< what is shown as the present run
    std::optional<ReadSummary> m_present; ///< of it
    std::size_t m_wanted = 1;             ///< zone or section the user chose, of the present run
};

} // namespace sparkout
