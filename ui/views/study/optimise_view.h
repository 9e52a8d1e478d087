// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/plot_view.h"
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
/// requirement. It shows the answer with its references; the best cycles found; the chosen cycle
/// against the current one, or against the one that it replaced, curve by curve; the time over the
/// number of stages; the margin over the time; and the requirements that limit the time. A cycle is
/// taken by one edit. Outdated results are drawn faint. Alternatively it shows the grid of dynamic
/// programming as filled by the published rule.
class OptimiseView : public StudyView {
    Q_OBJECT
public:
    explicit OptimiseView(QWidget* parent = nullptr, Settings* settings = nullptr,
                          Studies* studies = nullptr);

    /// Sets the document whose current surface is searched, with the wear of its wheel; without one
    /// the wheel does not wear. It must outlive the view.
    void setDocument(const Document& document) { m_document = &document; }
    /// The ticked options, whether or not they apply to the current surface.
    [[nodiscard]] SearchTicks ticks() const;
    [[nodiscard]] ComparePlot* curves() const { return m_curves; }
    [[nodiscard]] StageCountPlot* times() const { return m_times; }
    [[nodiscard]] MarginFrontPlot* margins() const { return m_margins; }
    [[nodiscard]] StateGridPlot* stateGrid() const { return m_grid; }
    [[nodiscard]] const SearchOutcomePtr& search() const { return studies().search.result(); }
    /// The time of the reference cycle, if that ends by itself.
    [[nodiscard]] std::optional<double> before_s() const;
    [[nodiscard]] bool busy() const override;
    /// Whether the results belong to other inputs, or to another wear of the wheel.
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
    void limitAnswer(); ///< limits it to the height that the curves and their axis titles leave
    [[nodiscard]] ValueTable tableOfFound() const;
    void listAnswer();
    void listFound();
    void connectParts();
    void nameButtons();
    void nameRun(); ///< names the button that searches or continues

    [[nodiscard]] bool showsGrid() const; ///< the grid of states, otherwise the search
    void followGrid();                    ///< only while it is shown
    void takeGrid();
    void moveGrid(int moment);
    void chooseContent();
    void chooseZone();
    void fillZones();
    [[nodiscard]] SearchWish wish() const; ///< the options of the tool row, and the front
    void runSearch();
    void takeSearch();
    void addToAnswer(); ///< adds new results of the running search
    void tryCycle();    ///< runs the chosen one for its curves
    void takeTrial(const OutcomePtr& outcome);
    void takeCycle(); ///< changes the document
    [[nodiscard]] const FoundCycle* chosen() const;
    [[nodiscard]] bool isTaken() const;

    void showSearch();
    void fillCurves();
    /// The least relative margin of the reference cycle, if that ends by itself.
    [[nodiscard]] std::optional<double> beforeMargin() const;
    void showBefore(); ///< shows the reference in the plots and beside the answer
    void chooseRow(std::size_t row);
    void showCurves();
    [[nodiscard]] bool isGiven() const;   ///< there is a grid to search
    [[nodiscard]] bool isFound() const;   ///< a cycle was found
    [[nodiscard]] bool hasCurves() const; ///< the front plot has curves

    const Document* m_document = nullptr;
    ComparePlot* m_curves;
    StageCountPlot* m_times;
    MarginFrontPlot* m_margins;
    StateGridPlot* m_grid;
    StateGridBar* m_gridBar;
    QWidget* m_choice = nullptr; ///< content and exports
    QSplitter* m_splitter;
    ValueModel* m_answer;
    ValueModel* m_found;
    SearchOutcomePtr m_listed; ///< listed in m_found; a newer one may not be shown yet
    CopyTable* m_answerTable = nullptr;
    CopyTable* m_table = nullptr;
    QComboBox* m_zone;
    RunBar* m_bar;
    QPushButton* m_take;
    QPushButton* m_add;
    QComboBox* m_method;
    QCheckBox* m_phases;
    QCheckBox* m_refine;
    OutcomePtr m_own;         ///< the cycle that a taken one replaced
    OutcomePtr m_before;      ///< the reference: m_own or the current run
    OutcomePtr m_trial;       ///< the run of the chosen cycle
    std::size_t m_wanted = 1; ///< zone or section the user chose
    bool m_goesOn = false;    ///< whether the shown search is still running
    RunController* m_trials;
};

} // namespace sparkout
