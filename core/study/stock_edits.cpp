// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stock_edits.h"

#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/study/stage_edits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sparkout {

namespace {

constexpr double sameStock_mm = 1e-9;

double sumFrom(const std::vector<Stage>& stages, std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < stages.size(); ++i) {
        sum += stages[i].stock_mm;
    }
    return sum;
}

} // namespace

bool stocksAddUp(const Project& project) {
    return std::abs(sumFrom(project.cycle->stages, 0) - project.part->stock_mm) <= sameStock_mm;
}

Project withFittedStocks(Project project) {
    auto& stages = project.cycle->stages;
    if (stages.empty() || stocksAddUp(project)) {
        return project;
    }
    const double stock_mm = project.part->stock_mm;
    auto rest = stages.begin(); // gets the remainder
    if (sumFrom(stages, 1) >= stock_mm) {
        const double scale = stock_mm / sumFrom(stages, 0);
        for (Stage& stage : stages) {
            stage.stock_mm = tidyStock(stage.stock_mm * scale);
        }
        rest = std::ranges::max_element(stages, {}, &Stage::stock_mm); // it absorbs the rounding
    }
    rest->stock_mm = tidyStock(rest->stock_mm + stock_mm - sumFrom(stages, 0));
    return project;
}

} // namespace sparkout
