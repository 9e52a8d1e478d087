// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/study_figure.h"

#include "core/batch/batch_run.h"
#include "core/batch/batch_summary.h"
#include "core/dynamic_programming/state_grid.h"
#include "core/optimisation/optimise.h"
#include "core/optimisation/variants.h"
#include "core/project/validate.h"
#include "core/units.h"

#include <string_view>

namespace sparkout {

namespace {

constexpr double studyPercent = 100;

/// The mean diameter of a place; it has both limits and so both indices.
const CharacteristicSummary* diameterOf(const BatchSummary& summary, const PlaceName& place) {
    for (const CharacteristicSummary& each : summary.characteristics) {
        if (std::string_view(each.characteristic.name) == "diameter"
            && each.characteristic.section == static_cast<int>(place.index())) {
            return &each;
        }
    }
    return nullptr;
}

std::optional<double> valueOf(const std::optional<Estimate>& index) {
    return index ? std::optional(index->value) : std::nullopt;
}

std::optional<double> inMinutes(const std::optional<double>& time_s) {
    return time_s ? std::optional(*time_s / units::secondsPerMinute) : std::nullopt;
}

/// Time of the proved quickest cycle of a grid [s].
std::optional<double> provedTime_s(const Project& project) {
    if (hasErrors(validate(project)) || Variants(project).fault() != GridFault::none) {
        return std::nullopt;
    }
    const SearchSummary summary = optimise(project);
    return summary.status == SearchStatus::proved && summary.best
               ? std::optional(summary.best->time_s)
               : std::nullopt;
}

} // namespace

std::optional<double> batchFigure(const Figure& figure, const Project& project) {
    if (!project.batch) {
        return std::nullopt;
    }
    const BatchResult batch = runBatch(project);
    if (batch.status != BatchStatus::completed) {
        return std::nullopt;
    }
    const BatchSummary summary = summarise(batch);
    if (figure.name == FigureName::batchBad) {
        return summary.bad.value * studyPercent;
    }
    const CharacteristicSummary* const diameter = diameterOf(summary, figure.place);
    if (!diameter) {
        return std::nullopt;
    }
    switch (figure.name) {
    case FigureName::batchMean: return diameter->moments.mean;
    case FigureName::batchDeviation: return diameter->moments.deviation;
    case FigureName::batchMeanHalf:
        return diameter->mean95
                   ? std::optional((diameter->mean95->high - diameter->mean95->low) / 2)
                   : std::nullopt;
    case FigureName::batchPp: return valueOf(diameter->pp);
    case FigureName::batchPpk: return valueOf(diameter->ppk);
    default: return std::nullopt;
    }
}

std::optional<double> searchFigure(const Figure& figure, const Project& project) {
    if (figure.name == FigureName::bestTime) {
        return project.optimisation ? inMinutes(provedTime_s(project)) : std::nullopt;
    }
    if (!project.optimisation || stateGridFault(project) != StateGridFault::none) {
        return std::nullopt;
    }
    const StateGridSize size = usualStateGrid(project);
    const auto best_s = [&] { return provedTime_s(withGridSearch(project, size)); };
    if (figure.name == FigureName::levelsBestTime) {
        return inMinutes(best_s());
    }
    const auto grid = fillStateGrid(project, size);
    if (!grid || !grid->time_s) {
        return std::nullopt;
    }
    if (figure.name == FigureName::levelsRuleTime) {
        return inMinutes(grid->time_s);
    }
    const auto proved_s = best_s();
    return proved_s ? std::optional((*grid->time_s / *proved_s - 1) * studyPercent) : std::nullopt;
}

} // namespace sparkout
