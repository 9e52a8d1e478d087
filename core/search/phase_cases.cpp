// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/phase_cases.h"

#include "core/batch/scenario_source.h"
#include "core/phases/failing_stock.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/simulation/stage_control.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

OptimisationScenarios scenariosOf(const Project& project) {
    return project.optimisation && project.batch && areOfBatch(project.optimisation->scenarios)
               ? project.optimisation->scenarios
               : OptimisationScenarios::nominal;
}

/// Finds the stock of the whole part; the end if there is none.
auto stockAmong(const std::vector<GivenFactor>& factors) {
    return std::ranges::find_if(factors, [](const GivenFactor& factor) {
        return factor.kind == FactorKind::stock && factor.place < 0;
    });
}

/// Indices of the corners that differ in more than the stock, in the order of the factors.
std::vector<std::int64_t> cornersOf(const std::vector<GivenFactor>& factors) {
    const auto stock = stockAmong(factors);
    const std::int64_t bit =
        stock == factors.end() ? 0 : std::int64_t{1} << (stock - factors.begin());
    std::vector<std::int64_t> corners;
    const std::int64_t all = cornerCount(factors);
    for (std::int64_t i = 0; i < all; ++i) {
        if ((i & bit) == 0) {
            corners.push_back(i);
        }
    }
    if (corners.size() == 1) {
        corners.clear(); // only the nominal part is left
    }
    return corners;
}

/// The stated stock, extended to the least and the greatest of a batch that counts.
StockRange wholeStocks(const Project& project) {
    const double stock_mm = project.part->stock_mm;
    StockRange stocks{stock_mm, stock_mm};
    if (scenariosOf(project) != OptimisationScenarios::nominal) {
        const std::vector<GivenFactor> factors = scatteredFactors(project);
        const auto factor = stockAmong(factors);
        if (factor != factors.end()) {
            const FactorEnds ends = cornerEnds(*factor);
            stocks = {std::min(stock_mm, ends.low), std::max(stock_mm, ends.high)};
        }
    }
    return stocks;
}

/// The nominal part, as −1, and corners of its batch, each with all stocks of the range.
class Cases {
public:
    explicit Cases(const Project& best) : m_part(best), m_cases(phaseCases(best)) {
        m_part.runs.clear();
        if (m_cases.corners > 0) {
            Project sampled = m_part;
            sampled.batch->scenarios = Scenarios::corners;
            m_source.emplace(std::move(sampled));
        }
    }

    /// All cases, the corners with the most factors at their upper ends first, since more
    /// compliance, dullness, runout or flow stress usually makes a cycle worse.
    [[nodiscard]] std::vector<std::int64_t> worstFirst() const {
        std::vector<std::int64_t> order{-1};
        if (m_source) {
            std::ranges::copy(cornersOf(m_source->factors()), std::back_inserter(order));
        }
        const auto upperEnds = [](std::int64_t corner) {
            return std::popcount(static_cast<std::uint64_t>(corner));
        };
        std::ranges::sort(order.begin() + 1, order.end(), [&](std::int64_t a, std::int64_t b) {
            return std::pair(upperEnds(a), a) > std::pair(upperEnds(b), b);
        });
        return order;
    }
    [[nodiscard]] std::optional<FailingPart> failing(std::int64_t one,
                                                     const std::stop_token& stop) const {
        Project part = one < 0 ? m_part : m_source->project(one);
        auto found = failingStock(part, m_cases.stocks, stop);
        return found ? std::optional(FailingPart{
                   std::move(*found), PhaseCase{one, std::move(part), wholeStocks(m_part)}})
                     : std::nullopt;
    }

private:
    Project m_part;
    PhaseCases m_cases;
    std::optional<ScenarioSource> m_source;
};

/// Replaces the worst result by a worse one of the stocks of the range; false if the cycle fails
/// for one of them, or has a smaller margin there than required.
bool takeWorst(const Project& project, const StockRange& stocks, double least,
               const std::stop_token& stop, std::optional<ConstraintResult>& worst) {
    const auto holdsAt = [&](const Project& part) {
        const auto holds = [&](const PhasePiece& piece, const SimulationResult&) {
            const DecidedPiece decided = decidePiece(part, piece, stop);
            if (!decided.holdsWhole() || !decided.worst || stop.stop_requested()) {
                return false;
            }
            if (!worst || decided.worst->relativeMargin < worst->relativeMargin) {
                worst = decided.worst;
            }
            return worst->relativeMargin >= least;
        };
        return visitPhasePieces(part, stocks.from_mm, stocks.to_mm, holds, stop);
    };
    return holdsAt(project) && std::ranges::all_of(atOtherWheelPhases(project), holdsAt)
           && !stop.stop_requested();
}

} // namespace

PhaseCases phaseCases(const Project& project) {
    double infeed_mm = 0;
    for (const double each_mm : fedByStep_mm(project)) {
        infeed_mm = std::max(infeed_mm, each_mm);
    }
    PhaseCases cases{widened(wholeStocks(project), infeed_mm)};
    if (scenariosOf(project) == OptimisationScenarios::corners) {
        cases.corners = static_cast<std::int64_t>(cornersOf(scatteredFactors(project)).size());
    }
    return cases;
}

std::optional<Project> failingCase(const Project& best, const std::stop_token& stop) {
    auto failing = CaseOrder().failingInOtherCase(best, stop);
    return failing ? std::move(failing->part) : std::nullopt;
}

std::optional<FailingPart> CaseOrder::failingInKnownCase(const Project& best,
                                                         const std::stop_token& stop) {
    if (m_failed.empty()) {
        return std::nullopt;
    }
    const Cases cases(best);
    for (const std::int64_t each : m_failed) {
        if (auto found = cases.failing(each, stop)) {
            std::rotate(m_failed.begin(), std::ranges::find(m_failed, each),
                        std::next(std::ranges::find(m_failed, each)));
            return found;
        }
    }
    return std::nullopt;
}

std::optional<FailingPart> CaseOrder::failingInOtherCase(const Project& best,
                                                         const std::stop_token& stop) {
    const Cases cases(best);
    for (const std::int64_t each : cases.worstFirst()) {
        if (std::ranges::count(m_failed, each) > 0 || stop.stop_requested()) {
            continue;
        }
        if (auto found = cases.failing(each, stop)) {
            m_failed.insert(m_failed.begin(), each);
            return found;
        }
    }
    return std::nullopt;
}

std::optional<ConstraintResult> worstOfCases(const Project& best, double least,
                                             const std::stop_token& stop) {
    const PhaseCases cases = phaseCases(best);
    Project part = best;
    part.runs.clear();
    std::optional<ConstraintResult> worst;
    if (!takeWorst(part, cases.stocks, least, stop, worst)) {
        return std::nullopt;
    }
    if (cases.corners > 0) {
        part.batch->scenarios = Scenarios::corners;
        const ScenarioSource source(std::move(part));
        for (const std::int64_t corner : cornersOf(source.factors())) {
            if (!takeWorst(source.project(corner), cases.stocks, least, stop, worst)) {
                return std::nullopt;
            }
        }
    }
    return worst;
}

} // namespace sparkout
