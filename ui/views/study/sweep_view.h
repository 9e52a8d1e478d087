// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/plot_view.h"
#include "ui/views/study/phase_chart.h"
#include "ui/views/study/sweep_shown.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class QAction;
class QComboBox;
class QPushButton;
class QSpinBox;

namespace sparkout {

class ChartPlot;
class PhaseBar;
class RunBar;
class SweepAxisBox;

/// The view "Sweep": one or two inputs varied over a range and any result over them, as curves or
/// as a map. A short sweep runs by itself after a change of the inputs, a long one on demand;
/// outdated results are drawn faint. The values of a point can be applied to the project. It can
/// also show the check of all stocks: size against stock.
class SweepView : public StudyView {
    Q_OBJECT
public:
    explicit SweepView(QWidget* parent = nullptr, Settings* settings = nullptr,
                       Studies* studies = nullptr);

    [[nodiscard]] ChartPlot* curves() const { return m_curves; }
    [[nodiscard]] ChartPlot* map() const { return m_map; }
    [[nodiscard]] const SweepResultPtr& sweep() const { return studies().sweep.result(); }
    [[nodiscard]] ChartPlot* phases() const { return m_phases; }
    [[nodiscard]] bool busy() const override;
    /// Whether the result belongs to other inputs.
    [[nodiscard]] bool stale() const { return studies().sweep.stale(); }

    [[nodiscard]] QString title() const override;

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    [[nodiscard]] bool drawn() const override;
    [[nodiscard]] bool faint() const override;
    [[nodiscard]] const Project* shownProject() const override;
    void showOutcome() override;
    void showState() override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;

private:
    void dropStudies() override;
    QWidget* buildTools();
    void connectParts();
    void connectEdits();
    void nameButtons();
    [[nodiscard]] ChartPlot& plot() const; ///< the visible one
    void chooseEntry();
    void chooseSubject();
    [[nodiscard]] bool showsPhases() const; ///< otherwise a sweep

    void follow(bool asked); ///< called when good() or the content has changed
    void followSweep(bool asked);
    void takePhases();
    void forgetSweep();
    void runSweep();
    void takeSweep();
    void edit(const std::function<Project(Project)>& edit, const EditText& text);
    void choosePoint(std::optional<std::size_t> point);
    void takeValues();

    void fillEntries();
    void showSweep();
    void showEntry();
    void showFront();
    void showPresent();
    [[nodiscard]] QString sweepRemark() const; ///< a remark on the shown content
    [[nodiscard]] SweepEntry chosenEntry() const;

    QComboBox* m_subject;        ///< a sweep, or the check of all stocks
    QComboBox *m_entry, *m_side; ///< the result; its values or margins
    PhaseBar* m_phaseBar;
    std::array<SweepAxisBox*, 2> m_axes;
    ChartPlot* m_curves;
    ChartPlot* m_map;
    ChartPlot* m_phases;
    PhaseOutcomePtr m_phasesShown;
    QSpinBox* m_point; ///< number of the chosen point, from 1; 0: none
    RunBar* m_bar;
    QWidget* m_toolBar = nullptr;
    QAction* m_take;
    QPushButton *m_takeButton, *m_add;
    std::vector<SweepEntry> m_entries; ///< entries of the box
    std::string m_wanted = "diameter"; ///< result the user chose
    SweepShown m_shown;                ///< the drawn content
    Issues m_refused;                  ///< reasons why the current sweep cannot be run
    bool m_edited = false;             ///< whether a requested edit has not been run yet
    bool m_asked = false;              ///< whether to run after that edit
};

} // namespace sparkout
