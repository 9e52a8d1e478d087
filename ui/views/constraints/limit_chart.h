// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/accuracy_limit.h"
#include "core/study/outcome.h"
#include "ui/tables/csv_table.h"

#include <QCoreApplication>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace sparkout {

/// The cuts of one zone or section of a run below the limits that are on, with one of them marked:
/// the data for drawing, reading and tables.
class LimitChart {
    Q_DECLARE_TR_FUNCTIONS(LimitChart)
public:
    LimitChart() = default; ///< an empty chart
    /// Marks a requirement as setMarked() does.
    LimitChart(OutcomePtr outcome, int group, std::optional<ConstraintResult> requirement);

    /// Marks the worst place of a requirement; empty: the place where the group is nearest to its
    /// limit.
    void setMarked(std::optional<ConstraintResult> requirement);

    [[nodiscard]] bool isEmpty() const { return !m_outcome; } ///< whether it has no run
    [[nodiscard]] int group() const { return m_group; }
    [[nodiscard]] const LimitGroup* cuts() const;                      ///< null if there are none
    [[nodiscard]] const LimitPoints& limit(ConstraintKind kind) const; ///< empty: off
    /// The least of the limits; empty if none binds every cut.
    [[nodiscard]] const LimitPoints& stepless() const { return m_stepless; }
    /// The limit by accuracy; empty if none follows from drawing and compliance.
    [[nodiscard]] const LimitPoints& accuracy(AccuracyProof proof) const;
    /// The machine's greatest infeed; empty if it bounds no cut, or is not known.
    [[nodiscard]] const LimitPoints& machineFeed() const { return m_machineFeed; }
    /// The binding one of the limits proved for every cut, by rising stock.
    [[nodiscard]] const std::vector<BoundCurve>& envelope() const { return m_envelope; }
    [[nodiscard]] static QString boundName(const BoundCurve& piece); ///< "burn", "machine's feed"
    /// The limit that binds at this stock; empty if there is none.
    [[nodiscard]] QString boundAt(double stock_mm) const;
    /// The limit as published, pass by pass.
    [[nodiscard]] const LimitPoints& published() const { return m_published; }
    /// The programmed feed per step of each stage.
    [[nodiscard]] const LimitPoints& programmed() const { return m_programmed; }
    /// A feed of 1 µm per cut in mm/min; empty where a cut belongs to a stroke.
    [[nodiscard]] std::optional<double> perMinute() const;
    [[nodiscard]] const std::optional<ConstraintResult>& requirement() const {
        return m_requirement;
    }
    [[nodiscard]] const std::optional<LimitedCut>& marked() const { return m_marked; }
    [[nodiscard]] QString markText() const;
    [[nodiscard]] QString valuesAt(const LimitedCut& cut) const;
    [[nodiscard]] QString feedLabel() const;
    /// Range of the stock in the cycle, from the least to the deepest [mm].
    [[nodiscard]] std::pair<double, double> stocks_mm() const;
    /// A row for each cut within the stocks, with the requested limits.
    [[nodiscard]] CsvTable table(const std::function<bool(double stock_mm)>& inSight,
                                 const std::function<bool(ConstraintKind)>& wanted) const;

private:
    void findEnvelope();
    /// Limits of a cut by the engine, not read off the curves.
    [[nodiscard]] std::vector<DepthLimit> limitsOf(const LimitedCut& cut) const;

    OutcomePtr m_outcome;
    int m_group = -1;
    std::map<ConstraintKind, LimitPoints> m_limits;
    LimitPoints m_stepless, m_published, m_programmed, m_machineFeed;
    std::vector<BoundCurve> m_envelope;
    std::map<AccuracyProof, LimitPoints> m_accuracy;
    std::optional<ConstraintResult> m_requirement;
    std::optional<LimitedCut> m_marked;
};

} // namespace sparkout
