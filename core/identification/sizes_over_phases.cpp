// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/sizes_over_phases.h"

#include "core/batch/characteristics.h"
#include "core/batch/worker_pool.h"
#include "core/phases/phase_decision.h"
#include "core/project/part.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sparkout {

SizesOverPhases sizesOverPhases(const Project& project, const CycleFactors& factors,
                                const std::stop_token& stop) {
    constexpr std::size_t stocks = 256;
    const StockRange range = usualPhases(project);
    const Project scaled = scaledProject(project, factors);
    std::vector<std::vector<double>> found(stocks);
    forEachIndex(workerCount(0), 0, static_cast<std::int64_t>(stocks), stop,
                 [&](std::size_t, std::int64_t index) {
                     Project part = scaled;
                     part.part->stock_mm = range.from_mm
                                           + (range.to_mm - range.from_mm)
                                                 * (static_cast<double>(index) + 0.5) / stocks;
                     const SimulationResult result = simulateUnchecked(part, nullptr, stop);
                     if (result.status == RunStatus::completed) {
                         for (const SectionResult& section : result.sections) {
                             found[static_cast<std::size_t>(index)].push_back(
                                 meanDeviation_um(section, part.part->diameter_mm));
                         }
                     }
                     return true;
                 });
    std::erase_if(found, [](const std::vector<double>& one) { return one.empty(); });
    SizesOverPhases sizes;
    const auto count = static_cast<double>(found.size());
    for (std::size_t i = 0; !found.empty() && i < found.front().size(); ++i) {
        double sum = 0, squares = 0;
        for (const std::vector<double>& one : found) {
            sum += one[i];
            squares += one[i] * one[i];
        }
        sizes.means_um.push_back(sum / count);
        sizes.deviations_um.push_back(
            std::sqrt(std::max(0.0, squares / count - sum / count * sum / count)));
    }
    return sizes;
}

} // namespace sparkout
