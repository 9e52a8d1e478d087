// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/study_view.h"
#include "ui/session/run_controller.h"

#include <optional>

class QCheckBox;
class QComboBox;
class QPushButton;
class QSplitter;

namespace sparkout {

class ComparePlot;
class CopyTable;
class MarginFrontPlot;
class RunBar;
class StageCountPlot;
class StateGridBar;
class StateGridPlot;
class ValueModel;
struct SearchTicks;
struct ValueTable;

/// The view "Optimise": searches the grid of the project for the quickest cycle that meets every
/// requirement. The answer beside what it is held against; the best cycles as they were found; the
/// one chosen beside the present cycle, or the one that it took the place of, curve by curve; the
/// time over the number of stages; the margin over the time; what keeps it from being quicker. A
/// cycle is taken by one edit. Results of other inputs are drawn faint. Or, instead of a search,
/// the grid of dynamic programming as the published rule fills it.
class OptimiseView : public StudyView {
    Q_OBJECT
public:
    explicit OptimiseView(QWidget* parent = nullptr, Settings* settings = nullptr,
                          Studies* studies = nullptr);

    /// Whose surface in front is searched, with the wear of its wheel; without one it does not
    /// wear. It is to outlive the view.
    void setDocument(const Document& document) { m_document = &document; }
    /// What is ticked, whether or not the surface in front can be asked so.
    [[nodiscard]] SearchTicks ticks() const;
    [[nodiscard]] ComparePlot* curves() const { return m_curves; }
    [[nodiscard]] StageCountPlot* times() const { return m_times; }
    [[nodiscard]] MarginFrontPlot* margins() const { return m_margins; }
    [[nodiscard]] StateGridPlot* stateGrid() const { return m_grid; }
    [[nodiscard]] const SearchOutcomePtr& search() const { return studies().search.result(); }
    /// The time of the cycle that is compared with, if it ends by itself.
    [[nodiscard]] std::optional<double> before_s() const;
    [[nodiscard]] bool busy() const override;
    /// What is shown is of other inputs, or of another wear of the wheel.
    [[nodiscard]] bool stale() const;

    [[nodiscard]] QString title() const override;

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    void dropOutcome() override;
    [[nodiscard]] bool drawn() const override;
    [[nodiscard]] bool faint() const override;
    [[nodiscard]] bool isFaint(const ViewPlot& plot) const override;
    void showState() override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;
    [[nodiscard]] const Project* shownProject() const override;
    bool event(QEvent* event) override;

private:
    void dropStudies() override;
    CopyTable* buildTable();
    CopyTable* buildAnswer();
    void limitAnswer(); ///< to what the curves with the names of their axes leave it
    [[nodiscard]] ValueTable tableOfFound() const;
    void listAnswer();
    void listFound();
    void connectParts();
    void nameButtons();
    void nameRun(); ///< the button that searches, or continues

    [[nodiscard]] bool showsGrid() const; ///< of states, else of the search
    void followGrid();                    ///< where it is shown
    void takeGrid();
    void moveGrid(int moment);
    void chooseContent();
    void chooseZone();
    void fillZones();
    [[nodiscard]] SearchWish wish() const; ///< what is asked for in the row above, and the front
    void runSearch();
    void takeSearch();
    void addToAnswer(); ///< what the search found since
    void tryCycle();    ///< runs the chosen one for its curves
    void takeTrial(const OutcomePtr& outcome);
    void takeCycle(); ///< into the document
    [[nodiscard]] const FoundCycle* chosen() const;
    [[nodiscard]] bool isTaken() const;

    void showSearch();
    void fillCurves();
    /// The least relative margin of the cycle that is compared with, if it ends by itself.
    [[nodiscard]] std::optional<double> beforeMargin() const;
    void showBefore(); ///< in the plots of the search, and beside its answer
    void chooseRow(std::size_t row);
    void showCurves();
    [[nodiscard]] bool isGiven() const;   ///< what is to be searched
    [[nodiscard]] bool isFound() const;   ///< a cycle
    [[nodiscard]] bool hasCurves() const; ///< the front plot

    const Document* m_document = nullptr;
    ComparePlot* m_curves;
    StageCountPlot* m_times;
    MarginFrontPlot* m_margins;
    StateGridPlot* m_grid;
    StateGridBar* m_gridBar;
    QWidget* m_choice = nullptr; ///< of what is drawn, and how it leaves
    QSplitter* m_splitter;
    ValueModel* m_answer;
    ValueModel* m_found;
    SearchOutcomePtr m_listed; ///< in m_found: the newest may be about to be shown
    CopyTable* m_answerTable = nullptr;
    CopyTable* m_table = nullptr;
    QComboBox* m_zone;
    RunBar* m_bar;
    QPushButton* m_take;
    QPushButton* m_add;
    QComboBox* m_method;
    QCheckBox* m_phases;
    QCheckBox* m_refine;
    OutcomePtr m_own;         ///< what a cycle found took the place of
    OutcomePtr m_before;      ///< what is compared with: that one, or the present one
    OutcomePtr m_trial;       ///< the run of the chosen cycle
    std::size_t m_wanted = 1; ///< zone or section the user chose
    bool m_goesOn = false;    ///< the search whose answer is shown
    RunController* m_trials;
};

} // namespace sparkout
