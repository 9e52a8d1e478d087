// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/read_curves.h"
#include "ui/plot/view_plot.h"
#include "ui/tables/csv_table.h"

#include <map>
#include <optional>

namespace sparkout {

class HairLine;
struct CursorSubject;

/// The actual feed of one zone or section over the stock left, the cycle from left to right, under
/// the curves of all limits that are on. The least of them, the stepless limit, stands out; above
/// it is forbidden. Drawn in µm.
class ConstraintsPlot : public ViewPlot {
    Q_OBJECT
public:
    static constexpr int actualKey = 100, steplessKey = 101; ///< else the kind of the limit

    explicit ConstraintsPlot(QWidget* parent = nullptr);

    void setRun(OutcomePtr outcome, int group); ///< no replot
    void setLogarithmic(bool on);
    /// Marks where a requirement was worst; nothing: where the group comes nearest to its limit.
    void setMarked(const std::optional<ConstraintResult>& requirement);
    void setMoment(std::optional<double> stock_mm); ///< left where the cycle stands
    void fit();
    void fitNext() { m_fitNext = true; } ///< the next run is of another part
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle() override;

    [[nodiscard]] int group() const { return m_group; }
    [[nodiscard]] bool hasCuts() const { return m_actual->data()->size() > 0; }
    [[nodiscard]] QCPAxis* stockAxis() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* feedAxis() const { return m_rect->axis(QCPAxis::atLeft); }
    [[nodiscard]] QCPCurve* actual() const { return m_actual; }
    [[nodiscard]] QCPCurve* exceeded() const { return m_exceeded; } ///< cuts above their limit
    [[nodiscard]] QCPGraph* stepless() const { return m_stepless; }
    [[nodiscard]] QCPGraph* limit(ConstraintKind kind) const; ///< null: off
    [[nodiscard]] const std::optional<LimitedCut>& marked() const { return m_markedCut; }
    [[nodiscard]] std::optional<double> moment_um() const; ///< stock of the line
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] ReadCurves readCurves() const; ///< the shown ones
    [[nodiscard]] CursorSubject cursorSubject();
    [[nodiscard]] CsvTable table() const; ///< the cuts in sight

private:
    void setTexts() override;
    void build();
    void fill();
    void fillCuts(const LimitGroup& group);
    void fillMark();
    void placeMark();
    void show();
    void onMouse(QMouseEvent* event);
    void choose(int key, bool only);
    [[nodiscard]] const LimitGroup* shownGroup() const;
    [[nodiscard]] QString markText() const;
    [[nodiscard]] QString valuesAt(const LimitedCut& cut) const;
    [[nodiscard]] QPen penOf(int key) const;
    [[nodiscard]] QCPGraph* addLine();
    [[nodiscard]] QString feedLabel() const;
    [[nodiscard]] double highestCut() const;
    [[nodiscard]] double highestFeed() const; ///< [µm]
    void fitStock();
    void fitFeeds();
    void refit();
    /// Limits of a cut as the engine gives them, not read off the curves.
    [[nodiscard]] std::vector<DepthLimit> limitsOf(const LimitedCut& cut) const;

    OutcomePtr m_outcome;
    int m_group = -1;
    std::optional<ConstraintResult> m_requirement;
    std::optional<LimitedCut> m_markedCut;
    CurveChoice m_choice;
    QCPAxisRect* m_rect = nullptr;
    QCPGraph* m_ceiling = nullptr; ///< upper edge of what is forbidden
    QCPGraph* m_stepless = nullptr;
    std::map<ConstraintKind, QCPGraph*> m_limits;
    QCPCurve* m_actual = nullptr;
    QCPCurve* m_exceeded = nullptr;
    QCPCurve* m_mark = nullptr;
    QCPItemText* m_markText = nullptr;
    HairLine* m_moment = nullptr;
    QCPRange m_fittedStock; ///< of the axis, as it was fitted last
    QCPRange m_fittedFeeds; ///< likewise
    bool m_fitNext = false;
};

} // namespace sparkout
