// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/quality/limit_series.h"
#include "ui/chart/plot_view.h"

#include <optional>
#include <string>
#include <tuple>

class QCheckBox;
class QComboBox;
class QLabel;
class QTextEdit;
class QPushButton;
class QSplitter;

namespace sparkout {

class ConstraintsPlot;
class CopyTable;
class MarginModel;

/// The view "Constraints": the actual feed over the stock left below all limits, the requirements
/// by their usage of the limit, and the calculation of the selected one.
class ConstraintsView : public PlotView {
    Q_OBJECT
public:
    explicit ConstraintsView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ConstraintsPlot* plot() const { return m_plot; }
    [[nodiscard]] MarginModel* margins() const { return m_model; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool showsMoment() const override { return true; }
    /// Selects it at its place, like a click on its row.
    void showRequirement(const ConstraintResult& requirement);

signals:
    /// `chosen`: other views may follow; `entered`: its place is to be shown.
    void requirementChosen(const sparkout::ConstraintResult& requirement);
    void requirementEntered(const sparkout::ConstraintResult& requirement);
    void pathAsked(const std::string& path); ///< the input that turns a limit on

protected:
    void resizeEvent(QResizeEvent* event) override;
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void recolour() override;
    void takeOutcome(const OutcomePtr& before) override;
    void dropOutcome() override;
    [[nodiscard]] bool drawn() const override;
    void showState() override;
    void followCycle() override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;

private:
    void dropStudies() override;
    using GroupKey = std::tuple<Zone, int, bool>; ///< zone, section, whether the wheel dwells
    [[nodiscard]] static GroupKey keyOf(const LimitGroup& group);

    void build();
    QWidget* buildTools();
    QWidget* buildCurves();
    QWidget* buildMargins();
    QWidget* buildSheet();
    void connectParts();
    void fillGroups();
    void showGroup(int group);
    void choose(int row);
    void selectChosen();
    void showSheet();
    [[nodiscard]] int wantedGroup() const;
    [[nodiscard]] std::optional<ConstraintResult> chosen() const;

    ConstraintsPlot* m_plot;
    QComboBox* m_zone;
    QCheckBox* m_logarithmic;
    QCheckBox* m_places;
    QSplitter* m_splitter;
    QSplitter* m_lower = nullptr; ///< the margins and the formula of one
    CopyTable* m_table = nullptr;
    MarginModel* m_model;
    QTextEdit* m_sheet;
    QPushButton* m_goTo;
    QLabel* m_off;                            ///< the limits that are
    std::optional<GroupKey> m_group;          ///< the user chose
    std::optional<ConstraintResult> m_chosen; ///< by the user, possibly for an earlier run
};

} // namespace sparkout
