// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/failing_stock.h"

#include "core/phases/sampled_phases.h"
#include "core/project/part.h"
#include "core/quality/drawing_constraints.h"
#include "core/units.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr double mostFormChange_mm = 1e-6, nearest_um = 0.01, nearestShare = 0.01;
constexpr double clear_um = 2 * nearest_um; ///< sufficient accuracy of an upper bound

/// Stocks that fail, or may.
struct Suspect {
    StockRange stocks;
    double leastMargin = 0;   ///< relative
    bool isOfLargest = false; ///< at the largest of them, otherwise at the least
};

/// The least relative margin of a cycle at an end of a piece; ∞ if it does not end.
double leastMargin(const PieceEnd& end) {
    double least = std::numeric_limits<double>::infinity();
    for (const ConstraintResult& each : end.constraints) {
        least = std::min(least, each.relativeMargin);
    }
    return least;
}

/// The evaluation of a piece's requirements by the shared run.
class SharedRun {
public:
    SharedRun(const PhasePiece& piece, const SimulationResult& result)
        : failing{piece.from_mm, piece.to_mm}
        , m_result(result)
        , m_piece{piece.from_mm, piece.to_mm}
        , m_low_um(2 * (piece.from_mm - result.project.part->stock_mm) * units::umPerMm)
        , m_high_um(2 * (piece.to_mm - result.project.part->stock_mm) * units::umPerMm) {
        if (result.status != RunStatus::completed) {
            m_fails = true;
            leastMargin = -std::numeric_limits<double>::infinity();
            return;
        }
        const PartAccuracy accuracy = requiredAccuracy(result, clear_um);
        for (const ConstraintResult& each : evaluateConstraints(result, accuracy)) {
            take(each);
        }
    }

    /// Whether all requirements are certainly met, so that the piece's own ends need not be run.
    [[nodiscard]] bool holds() const { return !m_fails && !m_isNear && !m_mayBurn; }
    [[nodiscard]] bool fails() const { return m_fails; }
    /// Whether all but burning is certainly met, which more stock may prevent.
    [[nodiscard]] bool holdsIfNotBurned() const { return !m_fails && !m_isNear; }
    double leastMargin = std::numeric_limits<double>::infinity(); ///< relative, at the worse end
    StockRange failing;          ///< stocks of the piece for which the worst diameter fails
    bool failsAtLargest = false; ///< the largest stock of the piece fails by more than the least

private:
    void take(const ConstraintResult& each) {
        const Requirement& row = requirementOf(each.kind);
        if (row.scope == ConstraintScope::setting) {
            m_fails |= !each.holds;
            leastMargin = std::min(leastMargin, each.relativeMargin);
            return;
        }
        if (row.isDeviation) {
            takeDiameter(each);
            return;
        }
        leastMargin = std::min(leastMargin, each.relativeMargin);
        const bool isOfDepths =
            row.scope == ConstraintScope::pass || each.kind == ConstraintKind::roughness;
        const bool isLength = isLengthOf(row);
        const auto beyond = [&](double sign) {
            return (!isLength || sign * each.margin > nearest_um)
                   && (!isOfDepths || sign * each.relativeMargin > nearestShare);
        };
        if (each.kind == ConstraintKind::burn) {
            m_mayBurn = !beyond(1) || !each.isWhole;
        } else if (beyond(-1)) {
            m_fails = true;
        } else if (!beyond(1) || !each.isWhole) {
            m_isNear = true;
        }
    }

    void takeDiameter(const ConstraintResult& each) {
        const Part& part = *m_result.project.part;
        const bool isBore = part.surface == Surface::internal;
        const double width_um = part.upper_deviation_um - part.lower_deviation_um;
        const double sign = each.isLeast != isBore ? 1 : -1;
        const double low_um = each.margin + sign * m_low_um;
        const double high_um = each.margin + sign * m_high_um;
        const double margin_um = std::min(low_um, high_um);
        leastMargin = std::min(leastMargin, width_um > 0 ? margin_um / width_um : margin_um);
        m_fails |= margin_um < -nearest_um;
        m_isNear |= margin_um < nearest_um || !each.isWhole;
        if (margin_um < m_worst_um) {
            m_worst_um = margin_um;
            failing = belowZero(low_um, high_um);
            failsAtLargest = high_um < low_um;
        }
    }

    /// The stocks of the piece for which a margin that is affine in the stock is negative; all if
    /// it is negative at both ends.
    [[nodiscard]] StockRange belowZero(double low_um, double high_um) const {
        StockRange range = m_piece;
        const double share = low_um / (low_um - high_um); // share of the piece at which it is zero
        const double zero_mm = m_piece.from_mm + share * (m_piece.to_mm - m_piece.from_mm);
        if (low_um < 0 && high_um >= 0) {
            range.to_mm = zero_mm;
        } else if (low_um >= 0 && high_um < 0) {
            range.from_mm = zero_mm;
        }
        return range;
    }

    static bool isLengthOf(const Requirement& row) { return row.unit == std::string_view("µm"); }

    const SimulationResult& m_result;
    StockRange m_piece;
    double m_worst_um = 0;      ///< margin of a diameter that fails
    double m_low_um, m_high_um; ///< diameters at the ends of the piece less those of the run
    bool m_fails = false, m_isNear = false, m_mayBurn = false;
};

/// Keeps the worst failing stocks.
class Suspects {
public:
    void add(Suspect suspect) {
        m_worst.push_back(suspect);
        std::ranges::push_heap(m_worst, {}, &Suspect::leastMargin);
        if (m_worst.size() > most) {
            std::ranges::pop_heap(m_worst, {}, &Suspect::leastMargin);
            m_worst.pop_back();
        }
    }

    /// A stock near the worst for which the project itself fails: next to the end of a piece the
    /// control may make the steps of its neighbour.
    [[nodiscard]] std::optional<double> stock_mm(const Project& project,
                                                 const std::stop_token& stop) {
        std::ranges::sort(m_worst, {}, &Suspect::leastMargin);
        for (const Suspect& each : m_worst) {
            std::optional<double> found_mm;
            double least = std::numeric_limits<double>::infinity();
            for (const double further : {0.01, 0.99, 0.5}) {
                const double share = each.isOfLargest ? 1 - further : further;
                Project made = project;
                made.part->stock_mm =
                    each.stocks.from_mm + share * (each.stocks.to_mm - each.stocks.from_mm);
                const std::optional<CycleTrial> trial = tried(made, stop);
                if (trial && !trial->holds && (!found_mm || trial->leastMargin < least)) {
                    least = trial->leastMargin;
                    found_mm = made.part->stock_mm;
                }
                if (least < nearlyAsMuch * each.leastMargin) {
                    break;
                }
            }
            if (found_mm) {
                return found_mm;
            }
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t most = 64;
    static constexpr double nearlyAsMuch = 0.9; ///< relative to a negative margin
    std::vector<Suspect> m_worst;               ///< a heap with the least of them first
};

/// Whether the piece's steps burn a blank of this stock, or it is stopped.
bool burns(const Project& project, const PhasePiece& piece, double stock_mm,
           const std::stop_token& stop) {
    const SimulationResult result = simulatePiece(project, piece, stock_mm, stop);
    return result.status != RunStatus::completed
           || std::ranges::any_of(evaluateConstraints(result), [](const ConstraintResult& each) {
                  return each.kind == ConstraintKind::burn && !each.holds;
              });
}

/// At the angle of the wheel that the project states.
std::optional<double> failingStock_mm(const Project& project, StockRange range,
                                      const std::stop_token& stop) {
    Project part = project;
    part.runs.clear();
    part.notes.clear();
    part.batch.reset();
    const bool isShared = formChange_mm(part, range.to_mm - range.from_mm) <= mostFormChange_mm;
    Suspects suspects;
    const auto visit = [&](const PhasePiece& piece, const SimulationResult& result) {
        const SharedRun shared(piece, result);
        if (isShared && shared.holds()) {
            return true;
        }
        if (isShared && shared.fails()) {
            suspects.add({shared.failing, shared.leastMargin, shared.failsAtLargest});
            return true;
        }
        if (isShared && shared.holdsIfNotBurned()) {
            if (!burns(part, piece, piece.from_mm, stop)) {
                return true;
            }
            if (burns(part, piece, piece.to_mm, stop)) {
                suspects.add({shared.failing, shared.leastMargin});
                return !stop.stop_requested();
            }
        }
        const DecidedPiece decided = decidePiece(part, piece, stop);
        for (const StockRange& stocks : decided.failing()) {
            suspects.add({stocks, decided.leastMargin,
                          leastMargin(decided.high) < leastMargin(decided.low)});
        }
        return !stop.stop_requested();
    };
    if (!visitPhasePieces(part, range.from_mm, range.to_mm, visit, stop)) {
        return std::nullopt;
    }
    return suspects.stock_mm(part, stop);
}

} // namespace

std::optional<Project> failingStock(const Project& project, StockRange range,
                                    const std::stop_token& stop) {
    std::vector<Project> parts = atOtherWheelPhases(project);
    parts.insert(parts.begin(), project);
    for (Project& part : parts) {
        if (const auto stock_mm = failingStock_mm(part, range, stop)) {
            part.part->stock_mm = *stock_mm;
            return std::move(part);
        }
    }
    return std::nullopt;
}

} // namespace sparkout
