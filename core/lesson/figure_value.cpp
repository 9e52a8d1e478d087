// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/figure_value.h"

#include "core/batch/batch_run.h"
#include "core/batch/batch_summary.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/ranges.h"
#include "core/quality/roughness.h"
#include "core/search/optimise.h"
#include "core/search/state_grid.h"
#include "core/search/variants.h"
#include "core/simulation/progress.h"
#include "core/simulation/simulate.h"
#include "core/simulation/stage_control.h"
#include "core/surface/burn.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace sparkout {

namespace {

using units::umPerMm;

constexpr double wholePercent = 100;

// Figures that need more than one run: of the project's batch, its search, or dynamic programming
// on its levels. Each call computes them anew.

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

/// A figure of the batch, or of a zone or section over it; empty if the project's batch cannot be
/// run, or the figure is not known.
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
        return summary.bad.value * wholePercent;
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

/// A figure of the search; empty without a grid or without a fit cycle.
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
    return proved_s ? std::optional((*grid->time_s / *proved_s - 1) * wholePercent) : std::nullopt;
}

/// The least relative margin of all requirements, or of one kind.
std::optional<double> leastMarginOf(const FigureSource& run, std::optional<ConstraintKind> kind) {
    std::optional<double> least;
    for (const ConstraintResult& each : run.constraints) {
        if (!kind || each.kind == *kind) {
            least = std::min(least.value_or(each.relativeMargin), each.relativeMargin);
        }
    }
    return least ? std::optional(*least * wholePercent) : std::nullopt;
}

/// A figure of the force law or the limit of burn, which the project alone determines.
std::optional<double> ofProject(FigureName name, const Project& project) {
    switch (name) {
    case FigureName::equivalentDiameter:
        return equivalentDiameter(project.part->diameter_mm, project.wheel->diameter_mm,
                                  project.part->surface);
    case FigureName::shearCoefficient:
    case FigureName::flatCoefficient: {
        const ForceLaw law = forceLaw(project);
        if (law.threshold) {
            return std::nullopt; // no force law and no limit of burn
        }
        return name == FigureName::shearCoefficient ? law.ks : law.kr;
    }
    case FigureName::burnFreeFeed:
        return project.material->burn_rise_k ? std::optional(
                   BurnModel(project).burnFreeDepth(*project.material->burn_rise_k) * umPerMm)
                                             : std::nullopt;
    default: return std::nullopt;
    }
}

double diameterSpread_um(const SimulationResult& result) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const SectionResult& section : result.sections) {
        least = std::min(least, section.diameterDeviationMin_mm);
        most = std::max(most, section.diameterDeviationMax_mm);
    }
    return (most - least) * umPerMm;
}

std::optional<double> ofCycle(FigureName name, const FigureSource& run) {
    const SimulationResult& result = run.result;
    switch (name) {
    case FigureName::cycleTime: return result.time_s / units::secondsPerMinute;
    case FigureName::steps: return result.cycleCount;
    case FigureName::diameterSpread: return diameterSpread_um(result);
    case FigureName::cylindricity: return run.accuracy.minimumZone.deviation() * umPerMm;
    case FigureName::totalRunout: return run.accuracy.totalRunout_mm * umPerMm;
    case FigureName::taper: return run.accuracy.profile.taper_mm * umPerMm;
    case FigureName::crown: return run.accuracy.profile.crown_mm * umPerMm;
    case FigureName::peakForce: return result.peakNormalForce_n;
    case FigureName::peakPower: return result.peakPower_w / units::wPerKw;
    case FigureName::leastMargin: return leastMarginOf(run, std::nullopt);
    case FigureName::burnMargin: return leastMarginOf(run, ConstraintKind::burn);
    case FigureName::removalRate: return run.shop.cycle.removalRate_mm2_s;
    case FigureName::specificEnergy: return run.shop.cycle.energy_j_mm3;
    default: return ofProject(name, result.project);
    }
}

std::optional<double> ofStage(const Figure& figure, const FigureSource& run) {
    const auto stage = static_cast<std::size_t>(figure.stage.value_or(0)) - 1;
    if (!figure.stage || stage >= run.shop.stages.size()) {
        return std::nullopt;
    }
    const ShopColumn& column = run.shop.stages[stage];
    switch (figure.name) {
    case FigureName::stageSteps: return column.count;
    case FigureName::stageTime: return column.time_s / units::secondsPerMinute;
    case FigureName::stageDepth: return column.depth_mm.value * umPerMm;
    case FigureName::stageForce: return column.normalForce_n.value;
    case FigureName::stagePower: return column.power_w.value / units::wPerKw;
    default: return std::nullopt;
    }
}

std::optional<double> ofPlace(const Figure& figure, const FigureSource& run) {
    if (!hasPlace(run.result.project, figure.place)
        || figure.place.index() >= run.result.sections.size()) {
        return std::nullopt;
    }
    const SectionResult& section = run.result.sections[figure.place.index()];
    const double nominal_mm = run.result.project.part->diameter_mm;
    switch (figure.name) {
    case FigureName::compliance: return section.compliance_mm_per_n;
    case FigureName::deviationLeast: return section.diameterDeviationMin_mm * umPerMm;
    case FigureName::deviationMost: return section.diameterDeviationMax_mm * umPerMm;
    case FigureName::deviationMean:
        return (2 * meanOfGround(section.radii_mm) - nominal_mm) * umPerMm;
    case FigureName::radialRunout: return section.radialRunout_mm * umPerMm;
    case FigureName::roundness:
        return run.accuracy.sections[figure.place.index()].minimumZone.deviation() * umPerMm;
    case FigureName::roughness:
        return section.lastCut ? std::optional(
                   RoughnessModel(run.result.project).roughness(*section.lastCut) * umPerMm)
                               : std::nullopt;
    case FigureName::placeForce: return section.peakNormalForce_n;
    default: return std::nullopt;
    }
}

/// The passes of a double stroke or revolution at a place, or of one of its steps.
class StepPasses {
public:
    StepPasses(const Figure& figure, const FigureSource& run)
        : m_run(run.trajectory), m_radii(static_cast<std::size_t>(m_run.radii)) {
        const int count = figure.count.value_or(lastCount(figure, run));
        for (const Pass& pass : m_run.passes) {
            if (sectionOf(pass.place) != figure.place.index()) {
                continue;
            }
            const bool isMeant = pass.place.cycleCount == count
                                 && (!figure.stage || pass.place.stage == *figure.stage)
                                 && (figure.step == Step::none || pass.place.step == figure.step);
            if (isMeant) {
                m_before = m_passes.empty() ? m_last : m_before;
                m_passes.push_back(&pass);
            } else if (pass.place.cycleCount > count) {
                break;
            }
            m_last = &pass;
        }
    }

    [[nodiscard]] bool any() const { return !m_passes.empty(); }

    /// The mean of a value over the radii of the last pass.
    template <class Value>
    [[nodiscard]] double atEnd(Value value) const {
        return meanOver(*m_passes.back(), value);
    }
    /// Depth of cut, summed over the passes.
    [[nodiscard]] double actual_mm() const {
        double sum = 0;
        for (const Pass* pass : m_passes) {
            sum += meanOver(*pass, [](const Visit& visit) { return visit.actual_mm; });
        }
        return sum;
    }
    /// t_П at the end less t_П before the first of the passes.
    [[nodiscard]] double programmed_mm(double first_mm) const {
        const auto fed = [](const Visit& visit) { return visit.programmed_mm; };
        return atEnd(fed) - (m_before ? meanOver(*m_before, fed) : first_mm);
    }
    [[nodiscard]] double mostForce_n() const {
        double most = 0;
        for (const Pass* pass : m_passes) {
            for (std::size_t k = 0; k < m_radii; ++k) {
                most = std::max(most, m_run.visits[pass->firstVisit + k].normalForce_n);
            }
        }
        return most;
    }

    [[nodiscard]] double mostDepth_mm() const {
        double most = 0;
        for (const Pass* pass : m_passes) {
            for (std::size_t k = 0; k < m_radii; ++k) {
                most = std::max(most, m_run.visits[pass->firstVisit + k].actual_mm);
            }
        }
        return most;
    }
    struct Radii {
        double least_mm = std::numeric_limits<double>::infinity(), most_mm = -least_mm;
    };
    /// The radii after the last pass.
    [[nodiscard]] Radii radiiAtEnd() const {
        Radii radii;
        for (std::size_t k = 0; k < m_radii; ++k) {
            const Visit& visit = m_run.visits[m_passes.back()->firstVisit + k];
            if (!visit.isGap()) {
                radii.least_mm = std::min(radii.least_mm, visit.radius_mm);
                radii.most_mm = std::max(radii.most_mm, visit.radius_mm);
            }
        }
        return radii;
    }

private:
    /// The last count of the stage, or of the cycle.
    static int lastCount(const Figure& figure, const FigureSource& run) {
        const std::vector<int>& counts = run.result.countsByStage;
        int last = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            last += !figure.stage || static_cast<int>(i) < *figure.stage ? counts[i] : 0;
        }
        return last;
    }

    template <class Value>
    [[nodiscard]] double meanOver(const Pass& pass, Value value) const {
        double sum = 0;
        int ground = 0;
        for (std::size_t k = 0; k < m_radii; ++k) {
            const Visit& visit = m_run.visits[pass.firstVisit + k];
            sum += visit.isGap() ? 0 : value(visit);
            ground += visit.isGap() ? 0 : 1;
        }
        return ground > 0 ? sum / ground : 0;
    }

    const Trajectory& m_run;
    std::size_t m_radii; ///< K
    std::vector<const Pass*> m_passes;
    const Pass* m_before = nullptr; ///< last pass at the place before them
    const Pass* m_last = nullptr;
};

/// Burn in the passes of a step; empty where it is not limited.
std::optional<double> burnOf(FigureName name, const StepPasses& passes, const Project& project) {
    const auto& U = project.material->burn_rise_k;
    if (!U) {
        return std::nullopt;
    }
    const BurnModel model(project);
    if (name == FigureName::damagedLayer) {
        return model.damagedDepth(passes.mostDepth_mm(), *U) * umPerMm;
    }
    const bool isExternal = project.part->surface == Surface::external;
    const StepPasses::Radii radii = passes.radiiAtEnd();
    const double stock_mm = isExternal ? radii.least_mm - targetRadius(*project.part)
                                       : targetRadius(*project.part) - radii.most_mm;
    return model.limitDepth(*U, std::max(0.0, stock_mm)) * umPerMm;
}

std::optional<double> ofStep(const Figure& figure, const FigureSource& run) {
    if (run.trajectory.passes.empty() || !hasPlace(run.result.project, figure.place)) {
        return std::nullopt;
    }
    const StepPasses passes(figure, run);
    if (!passes.any()) {
        return std::nullopt;
    }
    const Part& part = *run.result.project.part;
    const double outwards = part.surface == Surface::external ? 1 : -1;
    switch (figure.name) {
    case FigureName::programmedFeed:
        return passes.programmed_mm(firstFeed(run.result.project, makeBlank(part).totalInfeed_mm))
               * umPerMm;
    case FigureName::actualFeed: return passes.actual_mm() * umPerMm;
    case FigureName::lag:
        return passes.atEnd([](const Visit& visit) {
            return visit.programmed_mm - visit.accumulated_mm;
        }) * umPerMm;
    case FigureName::accumulatedFeed:
        return passes.atEnd([](const Visit& visit) { return visit.accumulated_mm; }) * umPerMm;
    case FigureName::stockLeft:
        return (passes.atEnd([](const Visit& visit) { return visit.radius_mm; })
                - targetRadius(part))
               * outwards * umPerMm;
    case FigureName::force: return passes.mostForce_n();
    case FigureName::runoutAfter: {
        const StepPasses::Radii radii = passes.radiiAtEnd();
        return (radii.most_mm - radii.least_mm) * umPerMm;
    }
    case FigureName::damagedLayer:
    case FigureName::burnLimit: return burnOf(figure.name, passes, run.result.project);
    default: return std::nullopt;
    }
}

} // namespace

StudiedRun studyRun(const Project& project, bool recorded, const std::stop_token& stop) {
    StudiedRun run;
    run.result = simulate(project, nullptr, stop);
    if (run.result.status == RunStatus::refused || run.result.status == RunStatus::stopped) {
        return run;
    }
    if (recorded && run.result.visits <= maxRecordedVisits) {
        run.trajectory.visits.reserve(static_cast<std::size_t>(run.result.visits));
        run.result = simulateUnchecked(project, &run.trajectory, stop);
    }
    if (run.result.status != RunStatus::stopped) {
        run.accuracy = accuracyOf(run.result);
        run.constraints = evaluateConstraints(run.result, run.accuracy);
        run.shop = shopNumbers(run.result);
    }
    return run;
}

std::optional<double> figureValue(const Figure& figure, const FigureSource& run) {
    const FigureRow& row = rowOf(figure.name);
    if (run.result.sections.empty()
        || (row.ofSurface && !FinishedSurface(run.result.project).isWhole())) {
        return std::nullopt;
    }
    std::optional<double> value;
    switch (row.scope) {
    case FigureScope::cycle: value = ofCycle(figure.name, run); break;
    case FigureScope::stage: value = ofStage(figure, run); break;
    case FigureScope::place: value = ofPlace(figure, run); break;
    case FigureScope::step: value = ofStep(figure, run); break;
    case FigureScope::batch:
    case FigureScope::batchPlace: value = batchFigure(figure, run.result.project); break;
    case FigureScope::search: value = searchFigure(figure, run.result.project); break;
    }
    return value && std::isfinite(*value) ? value : std::nullopt;
}

} // namespace sparkout
