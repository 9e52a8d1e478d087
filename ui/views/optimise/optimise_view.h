// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view.h"
#include "ui/session/document.h"
#include "ui/session/run_controller.h"
#include "ui/session/search_runner.h"

#include <functional>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSplitter;

namespace sparkout {

class ComparePlot;
class CopyTable;
class FoundModel;
class LegendStrip;
class PlotPages;
class PlotTools;
class Settings;
class StageCountPlot;

/// The view "Optimise": searches the grid of the project for the quickest cycle that holds every
/// requirement. The best cycles as they were found; the one chosen beside the present cycle, or
/// the one that it took the place of, curve by curve; the time over the number of stages; what
/// keeps it from being quicker. A cycle is taken by one edit. Results of other inputs are drawn
/// faint.
class OptimiseView : public View {
    Q_OBJECT
public:
    explicit OptimiseView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ComparePlot* curves() const { return m_curves; }
    [[nodiscard]] StageCountPlot* times() const { return m_times; }
    [[nodiscard]] PlotTools* tools() const; ///< of what is shown
    [[nodiscard]] const SearchOutcomePtr& search() const { return m_search; }
    /// The time of the cycle that is compared with, if it ends by itself.
    [[nodiscard]] std::optional<double> before_s() const;
    [[nodiscard]] bool busy() const override { return m_runner->running(); }
    [[nodiscard]] bool stale() const { return m_stale; } ///< what is shown is of other inputs
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString brief() const override;
    void retranslate() override;
    void forget() override;

signals:
    /// The document is to be changed so.
    void editWanted(const std::function<sparkout::Project(sparkout::Project)>& edit,
                    const sparkout::EditText& text);
    void searchShown(); ///< the outcome of a search has been drawn
    void curvesShown(); ///< the chosen cycle has been drawn

protected:
    [[nodiscard]] QString hint() const override;
    void recolour() override;
    void showOutcome() override;

private:
    void build(Settings* settings);
    QWidget* buildRunBar();
    QWidget* buildTools();
    QWidget* buildTable();
    void connectParts();
    void nameParts();

    void chooseContent();
    void chooseZone();
    void fillZones();
    void runSearch();
    void takeSearch(const SearchOutcomePtr& outcome);
    void tryCycle(); ///< runs the chosen one for its curves
    void takeTrial(const OutcomePtr& outcome);
    void takeCycle(); ///< into the document
    void noteStale();
    [[nodiscard]] const FoundCycle* chosen() const;
    [[nodiscard]] bool isTaken() const;

    void showSearch();
    void showCurves();
    void showState();
    void dim();
    [[nodiscard]] QString notice() const;
    [[nodiscard]] QStringList heading() const;

    ComparePlot* m_curves;
    StageCountPlot* m_times;
    QSplitter* m_splitter;
    LegendStrip* m_legend;
    PlotPages* m_pages = nullptr;
    FoundModel* m_found;
    CopyTable* m_table = nullptr;
    QComboBox* m_zone;
    QPushButton* m_run;
    QPushButton* m_stop;
    QPushButton* m_take;
    QPushButton* m_add;
    QCheckBox* m_phases;
    QCheckBox* m_refine;
    QProgressBar* m_progress;
    QLabel* m_state;
    QLabel* m_notice;
    QLabel* m_values;
    OutcomePtr m_good;         ///< the inputs that were accepted last
    OutcomePtr m_own;          ///< what a cycle found took the place of
    OutcomePtr m_before;       ///< what is compared with: that one, or the present one
    SearchOutcomePtr m_search; ///< what is shown
    OutcomePtr m_trial;        ///< the run of the chosen cycle
    std::optional<Project> m_searching;
    std::size_t m_wanted = 1; ///< zone or section the user chose
    bool m_stale = true;
    SearchRunner* m_runner;
    RunController* m_trials;
};

} // namespace sparkout
