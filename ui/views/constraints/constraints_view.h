// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/quality/limit_series.h"
#include "ui/plot/view.h"

#include <optional>
#include <string>
#include <tuple>

class QCheckBox;
class QComboBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QSplitter;

namespace sparkout {

class ConstraintsPlot;
class CopyTable;
class CursorStrip;
class LegendStrip;
class MarginModel;
class PlotCursors;
class PlotTools;
class Settings;

/// The view "Constraints": the actual feed over the stock left under all limits, the requirements
/// by how much of their limit they use up, and how the chosen one's number came about.
class ConstraintsView : public View {
    Q_OBJECT
public:
    explicit ConstraintsView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ConstraintsPlot* plot() const { return m_plot; }
    [[nodiscard]] PlotTools* tools() const { return m_tools; }
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }
    [[nodiscard]] MarginModel* margins() const { return m_model; }
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    void retranslate() override;
    void forget() override;

signals:
    /// Chosen: other views may follow; entered: it wants to be seen where it came about.
    void requirementChosen(const sparkout::ConstraintResult& requirement);
    void requirementEntered(const sparkout::ConstraintResult& requirement);
    void pathAsked(const std::string& path); ///< the input that turns a limit on

protected:
    [[nodiscard]] QString hint() const override;
    void recolour() override;
    void showOutcome() override;
    void followCycle() override;

private:
    using GroupKey = std::tuple<Zone, int, bool>; ///< zone, section, whether the wheel stands
    [[nodiscard]] static GroupKey keyOf(const LimitGroup& group);

    void build(Settings* settings);
    void buildTools(QWidget* bar, Settings* settings);
    QWidget* buildMargins();
    QWidget* buildSheet();
    void connectParts();
    void nameParts();
    void fillGroups();
    void showGroup(int group);
    void choose(int row);
    void selectChosen();
    void showState();
    void showSheet();
    void drawIcons();
    [[nodiscard]] int wantedGroup() const;
    [[nodiscard]] std::optional<ConstraintResult> chosen() const;

    ConstraintsPlot* m_plot;
    LegendStrip* m_legend;
    QComboBox* m_zone;
    QCheckBox* m_logarithmic;
    QCheckBox* m_places;
    QSplitter* m_splitter;
    CopyTable* m_table = nullptr;
    MarginModel* m_model;
    QPlainTextEdit* m_sheet;
    QPushButton* m_goTo;
    QLabel* m_notice;
    QLabel* m_off;
    QLabel* m_values;
    PlotTools* m_tools = nullptr;
    PlotCursors* m_cursors = nullptr;
    CursorStrip* m_strip = nullptr;
    OutcomePtr m_good;                        ///< what is shown
    std::optional<GroupKey> m_group;          ///< the user chose
    std::optional<ConstraintResult> m_chosen; ///< by the user, maybe of an earlier run
};

} // namespace sparkout
