// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/views/constraints/limit_chart.h"

#include <map>
#include <optional>

namespace sparkout {

class FreePlace;
class HairLine;

/// The actual feed of one zone or section over the stock left, the cycle from left to right, below
/// the curves of all limits that are on. The least of them, the stepless limit, is emphasised; the
/// area above it is forbidden. Drawn in µm.
class ConstraintsPlot : public ViewPlot {
    Q_OBJECT
public:
    static constexpr int actualKey = 100, steplessKey = 101; ///< other keys: the kind of the limit
    static constexpr int accuracyKey = 102, estimateKey = 103, publishedKey = 104,
                         programmedKey = 105, envelopeKey = 106, machineKey = 107;

    explicit ConstraintsPlot(QWidget* parent = nullptr);

    void setRun(OutcomePtr outcome, int group); ///< no replot
    void setLogarithmic(bool on);
    /// Marks the worst place of a requirement; empty: the place where the group is nearest to its
    /// limit.
    void setMarked(const std::optional<ConstraintResult>& requirement);
    void setMoment(std::optional<double> stock_mm); ///< stock at the moment of the cycle
    void fit() override;
    void fitNext() { m_fitNext = true; } ///< the next run is of another part
    void restyle() override;

    [[nodiscard]] int group() const { return m_chart.group(); }
    [[nodiscard]] bool hasCuts() const { return m_actual->data()->size() > 0; }
    [[nodiscard]] QCPAxis* stockAxis() const { return m_rect->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* feedAxis() const { return m_rect->axis(QCPAxis::atLeft); }
    [[nodiscard]] QCPCurve* actual() const { return m_actual; }
    [[nodiscard]] QCPCurve* exceeded() const { return m_exceeded; } ///< cuts above their limit
    [[nodiscard]] QCPGraph* stepless() const { return m_stepless; }
    [[nodiscard]] QCPGraph* limit(ConstraintKind kind) const;       ///< null if it is off
    [[nodiscard]] QCPGraph* accuracy() const { return m_accuracy; } ///< proved
    [[nodiscard]] QCPGraph* estimate() const { return m_estimate; } ///< by accuracy, at steady feed
    [[nodiscard]] QCPGraph* published() const { return m_published; }   ///< by eq. 22 of the source
    [[nodiscard]] QCPGraph* programmed() const { return m_programmed; } ///< S_p1, S_p2, …
    [[nodiscard]] QCPGraph* machineFeed() const { return m_machine; }
    /// The envelope of the proved limits, a piece for each binding one, by rising stock; and their
    /// names.
    [[nodiscard]] const std::vector<QCPCurve*>& pieces() const { return m_pieces; }
    [[nodiscard]] QString pieceName(std::size_t piece) const { return m_names[piece]->text(); }
    [[nodiscard]] const LimitChart& chart() const { return m_chart; }
    /// The axis in mm/min, beside the feed per revolution.
    [[nodiscard]] QCPAxis* minuteAxis() const { return m_rect->axis(QCPAxis::atRight); }
    [[nodiscard]] const std::optional<LimitedCut>& marked() const { return m_chart.marked(); }
    [[nodiscard]] std::optional<double> moment_um() const; ///< stock of the moment's line
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] QCPRange readSpan() const override { return stocks_um(); }
    [[nodiscard]] CsvTable table() const override; ///< the cuts in sight

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void build();
    void fill();
    void fillCuts(const LimitGroup& group);
    void fillEnvelope();
    void placeNames(FreePlace& places); ///< on pieces that are wide enough
    [[nodiscard]] QColor colourOf(const BoundCurve& piece) const;
    void restyleEnvelope();
    void followFeeds();
    void fillMark();
    void placeMark();
    template <typename Drawn>
    [[nodiscard]] QPolygonF pixelsOf(const Drawn& drawn) const;
    [[nodiscard]] QPen penOf(int key) const;
    [[nodiscard]] QCPRange stocks_um() const; ///< range of the cycle
    [[nodiscard]] double highestCut() const;
    [[nodiscard]] double highestFeed() const; ///< [µm]
    void fitStock();
    void fitFeeds();
    void refit();

    LimitChart m_chart;
    QCPAxisRect* m_rect = nullptr;
    QCPGraph* m_ceiling = nullptr; ///< upper edge of the forbidden area
    QCPGraph* m_stepless = nullptr;
    QCPGraph* m_accuracy = nullptr;
    QCPGraph* m_estimate = nullptr;
    QCPGraph* m_published = nullptr;
    QCPGraph* m_programmed = nullptr;
    QCPGraph* m_machine = nullptr;
    std::vector<QCPCurve*> m_pieces;   ///< pieces of the envelope
    std::vector<QCPItemText*> m_names; ///< names of the pieces
    std::map<ConstraintKind, QCPGraph*> m_limits;
    QCPCurve* m_actual = nullptr;
    QCPCurve* m_exceeded = nullptr;
    QCPCurve* m_mark = nullptr;
    QCPItemText* m_markText = nullptr;
    QCPItemLine* m_markLine = nullptr; ///< leader from a distant text to the mark
    HairLine* m_moment = nullptr;
    QCPRange m_fittedStock; ///< axis range of the last fit
    QCPRange m_fittedFeeds; ///< axis range of the last fit
    bool m_fitNext = false;
};

} // namespace sparkout
