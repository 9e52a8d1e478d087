// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/accuracy_limit.h"
#include "core/study/outcome.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/line_chart.h"
#include "ui/table/csv_table.h"

#include <QCoreApplication>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace sparkout {

/// The cuts of one zone or section of a run below the limits that are on, with one of them marked:
/// the data for drawing, reading and tables. The least of the limits, the stepless limit, is
/// emphasised; the area above it is forbidden.
class LimitChart {
    Q_DECLARE_TR_FUNCTIONS(LimitChart)
public:
    /// Keys of the legend; the others are the kinds of the limits.
    enum Key {
        actualKey = 100,
        steplessKey,
        accuracyKey,
        estimateKey,
        publishedKey,
        programmedKey,
        machineKey
    };

    LimitChart() = default; ///< an empty chart
    /// Marks a requirement as setMarked() does.
    LimitChart(OutcomePtr outcome, int group, std::optional<ConstraintResult> requirement);

    /// Marks the worst place of a requirement; empty: the place where the group is nearest to its
    /// limit.
    void setMarked(std::optional<ConstraintResult> requirement);

    [[nodiscard]] bool isEmpty() const { return !m_outcome; } ///< whether it has no run
    [[nodiscard]] int group() const { return m_group; }
    [[nodiscard]] const LimitGroup* cuts() const; ///< null if there are none
    /// The binding one of the limits proved for every cut, by rising stock.
    [[nodiscard]] const std::vector<BoundCurve>& envelope() const { return m_envelope; }
    [[nodiscard]] static QString boundName(const BoundCurve& piece); ///< "burn", "machine's feed"
    [[nodiscard]] static int keyOf(const BoundCurve& piece); ///< key of the limit it is part of
    /// The limit that binds at this stock; empty if there is none.
    [[nodiscard]] QString boundAt(double stock_mm) const;
    [[nodiscard]] const std::optional<ConstraintResult>& requirement() const {
        return m_requirement;
    }
    [[nodiscard]] const std::optional<LimitedCut>& marked() const { return m_marked; }
    [[nodiscard]] QString markText() const;
    [[nodiscard]] QString valuesAt(const LimitedCut& cut) const;
    /// The chart in µm, the cycle from left to right; its first series are the cuts.
    [[nodiscard]] LineChart chart(bool isLogarithmic) const;
    /// A row for each cut within the stocks, with the requested limits.
    [[nodiscard]] CsvTable table(const std::function<bool(double stock_mm)>& inSight,
                                 const std::function<bool(ConstraintKind)>& wanted) const;

private:
    [[nodiscard]] const LimitPoints& limit(ConstraintKind kind) const; ///< empty: off
    /// The limit by accuracy; empty if none follows from drawing and compliance.
    [[nodiscard]] const LimitPoints& accuracy(AccuracyProof proof) const;
    /// A feed of 1 µm per cut in mm/min; empty where a cut belongs to a stroke.
    [[nodiscard]] std::optional<double> perMinute() const;
    [[nodiscard]] QString feedLabel() const;
    /// Range of the stock in the cycle, from the least to the deepest [mm].
    [[nodiscard]] std::pair<double, double> stocks_mm() const;
    void findEnvelope();
    void addCuts(LineChart& chart) const;
    void addLimits(LineChart& chart) const;
    void addEnvelope(LineChart& chart) const;
    /// Limits of a cut by the engine, not read off the curves.
    [[nodiscard]] std::vector<DepthLimit> limitsOf(const LimitedCut& cut) const;

    OutcomePtr m_outcome;
    int m_group = -1;
    std::map<ConstraintKind, LimitPoints> m_limits;
    LimitPoints m_stepless; ///< the least of the limits; empty if none binds every cut
    LimitPoints m_published, m_programmed, m_machineFeed;
    std::vector<BoundCurve> m_envelope;
    std::map<AccuracyProof, LimitPoints> m_accuracy;
    std::optional<ConstraintResult> m_requirement;
    std::optional<LimitedCut> m_marked;
};

class HairLine;

/// The actual feed of one zone or section over the stock left, below the curves of all limits that
/// are on, with the names of those that bind and a text beside the marked cut.
class ConstraintsPlot : public ChartPlot {
    Q_OBJECT
public:
    explicit ConstraintsPlot(QWidget* parent = nullptr);

    void setRun(OutcomePtr outcome, int group); ///< no replot
    void setLogarithmic(bool on);
    /// Marks the worst place of a requirement; empty: the place where the group is nearest to its
    /// limit.
    void setMarked(const std::optional<ConstraintResult>& requirement);
    void setMoment(std::optional<double> stock_mm); ///< stock at the moment of the cycle
    void fitNext() { m_fitNext = true; }            ///< the next run is of another part

    [[nodiscard]] int group() const { return m_limits.group(); }
    [[nodiscard]] const LimitChart& limits() const { return m_limits; }
    [[nodiscard]] std::optional<double> moment_um() const; ///< stock of the moment's line
    /// The text beside the mark in the last replot; empty if there is none.
    [[nodiscard]] QRectF callOut() const;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override; ///< the visible cuts

private:
    class Labels;

    LimitChart m_limits;
    Labels* m_labels;
    HairLine* m_moment;
    bool m_isLogarithmic = false;
    bool m_fitNext = false;
};

} // namespace sparkout
