// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/phase_decision.h"

#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/simulation/stage_control.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sparkout {

namespace {

/// Decides on one piece.
class PieceJudge {
public:
    PieceJudge(const Project& project, PhasePiece piece, std::stop_token stop)
        : m_project(project), m_stop(std::move(stop)) {
        m_decided.piece = std::move(piece);
    }

    DecidedPiece decide() {
        const PhasePiece& piece = m_decided.piece;
        m_decided.low = endAt(piece.from_mm);
        m_decided.high = endAt(piece.to_mm);
        if (piece.status != RunStatus::completed || m_decided.low.constraints.empty()
            || m_decided.low.constraints.size() != m_decided.high.constraints.size()) {
            m_decided.leastMargin = piece.status == RunStatus::completed ? 0 : -1;
            if (piece.status == RunStatus::completed) { // nothing is required
                m_decided.holds = StockRange{piece.from_mm, piece.to_mm};
            }
            return std::move(m_decided);
        }
        StockRange holds{piece.from_mm, piece.to_mm};
        for (std::size_t i = 0; i < m_decided.low.constraints.size(); ++i) {
            narrow(holds, i);
        }
        if (holds.from_mm <= holds.to_mm) {
            m_decided.holds = holds;
        }
        return std::move(m_decided);
    }

private:
    PieceEnd endAt(double stock_mm) {
        const SimulationResult result = simulatePiece(m_project, m_decided.piece, stock_mm, m_stop);
        PieceEnd end;
        for (const SectionResult& section : result.sections) {
            end.deviations.push_back(
                {section.diameterDeviationMin_mm, section.diameterDeviationMax_mm});
        }
        m_decided.time_s = result.time_s;
        if (result.status == RunStatus::completed) {
            end.constraints = evaluateConstraints(result);
        }
        return end;
    }

    /// Restricts the range to stocks for which this requirement is met, too.
    void narrow(StockRange& holds, std::size_t index) {
        const ConstraintResult& low = m_decided.low.constraints[index];
        const ConstraintResult& high = m_decided.high.constraints[index];
        for (const ConstraintResult* each : {&low, &high}) {
            if (!m_decided.worst || each->relativeMargin < m_decided.worst->relativeMargin) {
                m_decided.worst = *each;
                m_decided.leastMargin = each->relativeMargin;
            }
        }
        if (low.holds && high.holds) {
            return;
        }
        if (!low.holds && !high.holds) {
            holds.to_mm = holds.from_mm - 1; // none
            return;
        }
        const double change = changeBetween(low, high, index);
        if (low.holds) {
            holds.to_mm = std::min(holds.to_mm, change);
        } else {
            holds.from_mm = std::max(holds.from_mm, change);
        }
    }

    /// The last stock for which it is met. Diameters are linear; otherwise by bisection.
    double changeBetween(const ConstraintResult& low, const ConstraintResult& high,
                         std::size_t index) {
        const PhasePiece& piece = m_decided.piece;
        if (low.kind == ConstraintKind::diameterMin || low.kind == ConstraintKind::diameterMax) {
            const double share = low.margin / (low.margin - high.margin);
            return piece.from_mm + std::clamp(share, 0.0, 1.0) * (piece.to_mm - piece.from_mm);
        }
        double held = low.holds ? piece.from_mm : piece.to_mm;
        double failed = low.holds ? piece.to_mm : piece.from_mm;
        constexpr int halvings = 40;
        for (int i = 0; i < halvings && !m_stop.stop_requested(); ++i) {
            const double middle = held + (failed - held) / 2;
            const PieceEnd end = endAt(middle);
            const bool holds = index < end.constraints.size() && end.constraints[index].holds;
            (holds ? held : failed) = middle;
        }
        return held;
    }

    const Project& m_project;
    std::stop_token m_stop;
    DecidedPiece m_decided;
};

} // namespace

std::vector<StockRange> DecidedPiece::failing() const {
    if (!holds) {
        return {{piece.from_mm, piece.to_mm}};
    }
    std::vector<StockRange> ranges;
    if (holds->from_mm > piece.from_mm) {
        ranges.push_back({piece.from_mm, holds->from_mm});
    }
    if (holds->to_mm < piece.to_mm) {
        ranges.push_back({holds->to_mm, piece.to_mm});
    }
    return ranges;
}

std::vector<StockRange> PhaseDecision::failingRanges() const {
    std::vector<StockRange> ranges;
    for (const FailingStocks& each : failing) { // neighbouring pieces overlap
        if (ranges.empty() || each.stocks.from_mm > ranges.back().to_mm) {
            ranges.push_back(each.stocks);
        }
        ranges.back().to_mm = std::max(ranges.back().to_mm, each.stocks.to_mm);
    }
    return ranges;
}

bool canDecidePhases(const Project& project) {
    return project.gauge->control == Control::gauge;
}

StockRange widened(const StockRange& stocks, double largestInfeed_mm) {
    constexpr double leastShare = 0.01; // least share of the stock: a blank has some
    return {std::max(stocks.from_mm - largestInfeed_mm / 2, leastShare * stocks.from_mm),
            stocks.to_mm + largestInfeed_mm / 2};
}

StockRange usualPhases(const Project& project) {
    double most_mm = 0;
    for (const double infeed_mm : fedByStep_mm(project)) {
        most_mm = std::max(most_mm, infeed_mm);
    }
    return widened({project.part->stock_mm, project.part->stock_mm}, most_mm);
}

DecidedPiece decidePiece(const Project& project, PhasePiece piece, const std::stop_token& stop) {
    return PieceJudge(project, std::move(piece), stop).decide();
}

PhaseDecision decidePhases(const Project& project, StockRange range, const std::stop_token& stop,
                           std::size_t mostPieces) {
    PhaseDecision decision;
    decision.range = range;
    if (!canDecidePhases(project) || hasErrors(validate(project))) {
        return decision;
    }
    std::vector<PhasePiece> pieces =
        phasePieces(project, range.from_mm, range.to_mm, stop, mostPieces);
    decision.hasTooMany = pieces.empty() && !stop.stop_requested();
    for (PhasePiece& piece : pieces) {
        decision.pieces.push_back(decidePiece(project, std::move(piece), stop));
        const DecidedPiece& decided = decision.pieces.back();
        for (const StockRange& stocks : decided.failing()) {
            decision.failing.push_back({stocks, decided.piece.status, decided.worst});
        }
    }
    decision.isDecided = !decision.hasTooMany && !stop.stop_requested();
    return decision;
}

} // namespace sparkout
