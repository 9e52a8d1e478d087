// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/limit_series.h"

#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/constraints.h"
#include "core/simulation/stage_control.h"
#include "core/surface/burn.h"
#include "core/surface/burn_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace sparkout {

std::vector<DepthLimit> depthLimits(const Project& project, double b, double stock) {
    std::vector<DepthLimit> limits;
    for (const Requirement& row : requirementRows) {
        const auto depth = row.depthLimit ? row.depthLimit(project, b, stock) : std::nullopt;
        if (depth) {
            limits.push_back({row.kind, *depth});
        }
    }
    return limits;
}

std::vector<ConstraintKind> depthLimitKinds() {
    std::vector<ConstraintKind> kinds;
    for (const bool everyPass : {true, false}) {
        for (const Requirement& row : requirementRows) {
            if (row.depthLimit && row.bindsEveryPass() == everyPass) {
                kinds.push_back(row.kind);
            }
        }
    }
    return kinds;
}

bool wheelStands(const Place& place) {
    switch (place.zone) {
    case Zone::rz1:
        return place.step == Step::e1 || place.step == Step::e2 || place.step == Step::e5;
    case Zone::rz2: return place.step == Step::e2 || place.step == Step::e4;
    case Zone::nz:
    case Zone::section: break;
    }
    return false;
}

double effectiveWidth(const Project& project, const Place& place) {
    const StageFeed* const axial = project.operation->axial();
    if (!axial) {
        return project.part->length_mm;
    }
    if (wheelStands(place)) {
        const ZoneLengths lengths = zoneLengths(project);
        return plungeWidth(project, place.zone == Zone::rz1 ? lengths.rz1 : lengths.rz2);
    }
    const Stage& stage = project.cycle->stages[static_cast<std::size_t>(place.stage - 1)];
    return std::min((stage.*axial->value).value_or(0) / project.machine->work_speed_rpm,
                    project.wheel->width_mm);
}

const DepthLimit* bindingOf(const std::vector<DepthLimit>& limits) {
    const DepthLimit* least = nullptr;
    for (const DepthLimit& limit : limits) {
        if (requirementOf(limit.kind).bindsEveryPass()
            && (!least || limit.depth_mm < least->depth_mm)) {
            least = &limit;
        }
    }
    return least;
}

const char* limitBoundKey(LimitBound bound, ConstraintKind kind) {
    switch (bound) {
    case LimitBound::feed: return "machine_feed";
    case LimitBound::accuracy: return "accuracy";
    case LimitBound::requirement: return requirementOf(kind).key;
    case LimitBound::stock: break;
    }
    return "stock";
}

std::optional<double> greatestInfeed_mm(const Project& project) {
    const auto& range = project.machine->limits.*project.operation->radial().range;
    if (!range || range->size() != 3 || isCoupled(project) || wheelContact(project)
        || feedsContinuously(project)) {
        return std::nullopt;
    }
    return project.operation.infeed_mm((*range)[1], project.machine->work_speed_rpm);
}

namespace {

constexpr int burnPoints = 161;
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The least of the limits on every cut; infinite without any.
double leastOf(const std::vector<DepthLimit>& limits) {
    double least = unlimited;
    for (const DepthLimit& limit : limits) {
        if (requirementOf(limit.kind).bindsEveryPass()) {
            least = std::min(least, limit.depth_mm);
        }
    }
    return least;
}

bool isWorseCut(const LimitedCut& a, const LimitedCut& b) {
    return std::pair(a.usage, a.depth_mm) > std::pair(b.usage, b.depth_mm);
}

class LimitSeriesBuilder {
public:
    LimitSeriesBuilder(const SimulationResult& result, const Trajectory& trajectory)
        : m_project(result.project), m_trajectory(trajectory), m_blank(makeBlank(*m_project.part)) {
        m_series.deepest_mm = depthAtEnd_mm(m_project, m_blank.totalInfeed_mm);
        m_beyondTarget_mm = m_series.deepest_mm - m_blank.totalInfeed_mm;
        if (const auto& U = m_project.material->burn_rise_k) {
            m_burn.emplace(BurnModel(m_project), *U, m_series.deepest_mm);
        }
    }

    LimitSeries build() {
        for (const DepthLimit& limit : depthLimits(m_project, m_project.part->length_mm, 0)) {
            m_series.on.push_back(limit.kind);
        }
        for (const Pass& pass : m_trajectory.passes) {
            addPass(pass);
        }
        for (LimitGroup& group : m_series.groups) {
            placeStages(group);
            thin(group);
        }
        std::ranges::stable_sort(m_series.groups, {}, [](const LimitGroup& group) {
            return std::tuple(group.zone, group.section, !group.standing);
        });
        addBurn();
        return std::move(m_series);
    }

private:
    void addPass(const Pass& pass) {
        LimitGroup& group = groupOf(pass.place);
        const double fixed = leastOf(stageOf(group, pass).fixed);
        LimitedCut worst{pass.place, 0, 0, 0, pass.effectiveWidth_mm, -1};
        for (int k = 0; k < m_trajectory.radii; ++k) {
            const Visit& visit = m_trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
            const double a = visit.actual_mm;
            if (!(a > 0) || !std::isfinite(a) || !std::isfinite(visit.radius_mm)) {
                continue;
            }
            const double stock = m_sign * (visit.radius_mm - m_blank.targetRadius_mm)
                                 + visit.printed_mm + m_beyondTarget_mm;
            double usage = fixed > 0 ? a / fixed : unlimited;
            if (m_burn) {
                const double root = m_burn->usage(std::sqrt(a), stock);
                usage = std::max(usage, root * root);
            }
            const LimitedCut cut{pass.place, k, stock, a, pass.effectiveWidth_mm, usage};
            worst = isWorseCut(cut, worst) ? cut : worst;
        }
        if (worst.depth_mm > 0) {
            m_series.least_mm = std::min(m_series.least_mm, worst.stock_mm);
            group.worst = isWorseCut(worst, group.worst) ? worst : group.worst;
            group.cuts.push_back(worst);
        }
    }

    LimitGroup& groupOf(const Place& place) {
        const int found = limitGroupAt(m_series, place);
        if (found >= 0) {
            return m_series.groups[static_cast<std::size_t>(found)];
        }
        LimitGroup group;
        group.zone = place.zone;
        group.section = place.zone == Zone::section ? place.section : 0;
        group.standing = wheelStands(place);
        m_series.groups.push_back(std::move(group));
        return m_series.groups.back();
    }

    LimitedStage& stageOf(LimitGroup& group, const Pass& pass) {
        if (group.stages.empty() || group.stages.back().stage != pass.place.stage) {
            LimitedStage stage{pass.place.stage, pass.effectiveWidth_mm, m_series.deepest_mm, {}};
            const bool coupled = isCoupled(m_project);
            for (const DepthLimit& limit : depthLimits(m_project, stage.width_mm, 0)) {
                if (limit.kind != ConstraintKind::burn
                    && !(coupled && requirementOf(limit.kind).sharedBySections)) {
                    stage.fixed.push_back(limit);
                }
            }
            group.stages.push_back(std::move(stage));
        }
        return group.stages.back();
    }

    /// Ends each stage at the least stock of its cuts, and not before the stage ahead of it.
    static void placeStages(LimitGroup& group) {
        double end = unlimited;
        for (LimitedStage& stage : group.stages) {
            for (const LimitedCut& cut : group.cuts) {
                end = cut.place.stage == stage.stage ? std::min(end, cut.stock_mm) : end;
            }
            stage.end_mm = std::min(end, stage.end_mm);
        }
    }

    static void thin(LimitGroup& group) {
        const std::size_t count = group.cuts.size();
        if (count <= mostLimitedCuts) {
            return;
        }
        std::vector<LimitedCut> kept;
        for (std::size_t i = 0; i < mostLimitedCuts; ++i) {
            const auto first =
                group.cuts.begin() + static_cast<std::ptrdiff_t>(i * count / mostLimitedCuts);
            const auto last =
                group.cuts.begin() + static_cast<std::ptrdiff_t>((i + 1) * count / mostLimitedCuts);
            kept.push_back(*std::min_element(first, last, isWorseCut));
        }
        group.cuts = std::move(kept);
    }

    /// Denser towards the target, where the limit rises fastest; constant below it.
    void addBurn() {
        const auto& U = m_project.material->burn_rise_k;
        if (!U) {
            return;
        }
        const BurnModel model(m_project);
        const double free = model.limitDepth(*U, 0);
        if (m_series.least_mm < 0) {
            m_series.burn.push_back({m_series.least_mm, free});
        }
        for (int i = 0; i < burnPoints; ++i) {
            const double share = static_cast<double>(i) / (burnPoints - 1);
            const double stock = m_series.deepest_mm * share * share;
            m_series.burn.push_back({stock, model.limitDepth(*U, stock)});
        }
    }

    const Project& m_project;
    const Trajectory& m_trajectory;
    Blank m_blank;
    double m_beyondTarget_mm = 0; ///< overcut of a gauge that reads wrong at the end of the cycle
    double m_sign = m_project.part->surface == Surface::external ? 1 : -1;
    std::optional<BurnTable> m_burn;
    LimitSeries m_series;
};

/// The limit of each stage from its first to its last stock, by rising stock.
template <typename AddStage>
LimitPoints overStages(const LimitSeries& series, const LimitGroup& group, AddStage addStage) {
    LimitPoints points;
    double from = series.least_mm;
    for (std::size_t i = group.stages.size(); i-- > 0;) {
        const double to = i > 0 ? group.stages[i - 1].end_mm : series.deepest_mm;
        if (to > from) {
            addStage(points, group.stages[i], from, to);
            from = to;
        }
    }
    return points;
}

double burnAt(const LimitPoints& burn, double stock) {
    const auto after = std::ranges::upper_bound(burn, stock, {}, &LimitPoint::stock_mm);
    if (after == burn.begin() || after == burn.end()) {
        return after == burn.begin() ? burn.front().depth_mm : burn.back().depth_mm;
    }
    const LimitPoint &a = *(after - 1), &b = *after;
    return a.depth_mm
           + (stock - a.stock_mm) / (b.stock_mm - a.stock_mm) * (b.depth_mm - a.depth_mm);
}

/// The lower of burn and a constant between two stocks, with the corner between them.
void addLower(LimitPoints& points, const LimitPoints& burn, double fixed, double from, double to) {
    if (burn.empty()) {
        points.insert(points.end(), {{from, fixed}, {to, fixed}});
        return;
    }
    LimitPoints inside{{from, burnAt(burn, from)}};
    for (const LimitPoint& point : burn) {
        if (point.stock_mm > from && point.stock_mm < to) {
            inside.push_back(point);
        }
    }
    inside.push_back({to, burnAt(burn, to)});
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const LimitPoint& b = inside[i];
        if (i > 0 && inside[i - 1].depth_mm < fixed && b.depth_mm > fixed) {
            const LimitPoint& a = inside[i - 1];
            const double share = (fixed - a.depth_mm) / (b.depth_mm - a.depth_mm);
            points.push_back({a.stock_mm + share * (b.stock_mm - a.stock_mm), fixed});
        }
        points.push_back({b.stock_mm, std::min(b.depth_mm, fixed)});
    }
}

} // namespace

LimitSeries makeLimitSeries(const SimulationResult& result, const Trajectory& trajectory) {
    return LimitSeriesBuilder(result, trajectory).build();
}

int limitGroupAt(const LimitSeries& series, const Place& place) {
    const bool standing = wheelStands(place);
    for (std::size_t i = 0; i < series.groups.size(); ++i) {
        const LimitGroup& group = series.groups[i];
        if (group.zone == place.zone && group.standing == standing
            && (place.zone != Zone::section || group.section == place.section)) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

std::optional<LimitedCut> limitedCutOf(const SimulationResult& result, const Trajectory& trajectory,
                                       const ConstraintResult& requirement) {
    if (!requirement.at) {
        return std::nullopt;
    }
    const Place& at = *requirement.at;
    const auto isIt = [&at](const Pass& pass) {
        const Place& p = pass.place;
        return p.zone == at.zone && (p.zone != Zone::section || p.section == at.section)
               && p.cycleCount == at.cycleCount && p.step == at.step
               && p.revolution == at.revolution;
    };
    const auto pass = std::ranges::find_if(trajectory.passes, isIt);
    if (pass == trajectory.passes.end()) {
        return std::nullopt;
    }
    const auto first = trajectory.visits.begin() + static_cast<std::ptrdiff_t>(pass->firstVisit);
    auto visit =
        std::max_element(first, first + trajectory.radii,
                         [](const Visit& a, const Visit& b) { return a.actual_mm < b.actual_mm; });
    if (requirement.kind == ConstraintKind::burn && result.burn) {
        visit = first + result.burn->radius;
    }
    const Part& part = *result.project.part;
    const double over = visit->radius_mm - targetRadius(part);
    return LimitedCut{pass->place,
                      static_cast<int>(visit - first),
                      (part.surface == Surface::external ? over : -over) + visit->printed_mm,
                      visit->actual_mm,
                      pass->effectiveWidth_mm,
                      1 - requirement.relativeMargin};
}

LimitPoints limitCurve(const LimitSeries& series, const LimitGroup& group, ConstraintKind kind) {
    if (kind == ConstraintKind::burn) {
        return series.burn;
    }
    return overStages(
        series, group,
        [kind](LimitPoints& points, const LimitedStage& stage, double from, double to) {
            for (const DepthLimit& limit : stage.fixed) {
                if (limit.kind == kind) {
                    points.push_back({from, limit.depth_mm});
                    points.push_back({to, limit.depth_mm});
                }
            }
        });
}

LimitPoints steplessLimit(const LimitSeries& series, const LimitGroup& group) {
    return overStages(
        series, group,
        [&series](LimitPoints& points, const LimitedStage& stage, double from, double to) {
            const double fixed = leastOf(stage.fixed);
            if (!series.burn.empty() || fixed < unlimited) {
                addLower(points, series.burn, fixed, from, to);
            }
        });
}

namespace {

/// A curve between two adjacent stocks of all curves' points.
struct BoundLine {
    const BoundCurve* curve = nullptr;
    double from_mm = 0, to_mm = 0; ///< depths
    [[nodiscard]] double at(double share) const { return from_mm + share * (to_mm - from_mm); }
};

/// Empty where the curve has no depth there.
std::optional<BoundLine> lineBetween(const BoundCurve& curve, double from, double to) {
    const LimitPoints& points = curve.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const LimitPoint &a = points[i - 1], &b = points[i];
        if (a.stock_mm <= from && b.stock_mm >= to && a.stock_mm < b.stock_mm) {
            const double slope = (b.depth_mm - a.depth_mm) / (b.stock_mm - a.stock_mm);
            return BoundLine{&curve, a.depth_mm + slope * (from - a.stock_mm),
                             a.depth_mm + slope * (to - a.stock_mm)};
        }
    }
    return std::nullopt;
}

class Envelope {
public:
    void addBetween(const std::vector<BoundLine>& lines, double from, double to) {
        double share = 0, begin = from;
        const BoundLine* least = nullptr;
        for (const BoundLine& line : lines) {
            if (!least || line.from_mm < least->from_mm
                || (line.from_mm == least->from_mm && line.to_mm < least->to_mm)) {
                least = &line;
            }
        }
        while (least) {
            double until = 1, most = 0;
            const BoundLine* next = nullptr;
            for (const BoundLine& line : lines) { // lines that fall below it
                const double gain = (least->to_mm - least->from_mm) - (line.to_mm - line.from_mm);
                const double crosses = gain > 0 ? (line.from_mm - least->from_mm) / gain : 1;
                if (crosses > share
                    && (crosses < until || (next && crosses == until && gain > most))) {
                    until = crosses;
                    most = gain;
                    next = &line;
                }
            }
            const double end = until < 1 ? from + until * (to - from) : to; // exact to the last bit
            add(*least->curve, {begin, least->at(share)}, {end, least->at(until)});
            begin = end;
            share = until;
            least = next;
        }
    }

    std::vector<BoundCurve> take() { return std::move(m_pieces); }

private:
    void add(const BoundCurve& curve, LimitPoint a, LimitPoint b) {
        const bool goesOn = !m_pieces.empty() && m_pieces.back().bound == curve.bound
                            && m_pieces.back().kind == curve.kind
                            && m_pieces.back().points.back().stock_mm == a.stock_mm;
        if (!goesOn) {
            m_pieces.push_back({curve.bound, curve.kind, {a}});
        } else if (m_pieces.back().points.back().depth_mm != a.depth_mm) {
            m_pieces.back().points.push_back(a);
        }
        m_pieces.back().points.push_back(b);
    }

    std::vector<BoundCurve> m_pieces;
};

} // namespace

std::vector<BoundCurve> envelopeOf(const std::vector<BoundCurve>& curves) {
    std::vector<double> stocks;
    for (const BoundCurve& curve : curves) {
        for (const LimitPoint& point : curve.points) {
            stocks.push_back(point.stock_mm);
        }
    }
    std::ranges::sort(stocks);
    stocks.erase(std::unique(stocks.begin(), stocks.end()), stocks.end());
    Envelope envelope;
    for (std::size_t i = 1; i < stocks.size(); ++i) {
        std::vector<BoundLine> lines;
        for (const BoundCurve& curve : curves) {
            if (const auto line = lineBetween(curve, stocks[i - 1], stocks[i])) {
                lines.push_back(*line);
            }
        }
        envelope.addBetween(lines, stocks[i - 1], stocks[i]);
    }
    return envelope.take();
}

bool limitsFeed(const LimitSeries& series) {
    return std::ranges::any_of(
        series.on, [](ConstraintKind kind) { return requirementOf(kind).bindsEveryPass(); });
}

bool limitsGroups(const LimitSeries& series, const Project& project) {
    const bool coupled = isCoupled(project);
    return std::ranges::any_of(series.on, [coupled](ConstraintKind kind) {
        const Requirement& row = requirementOf(kind);
        return row.bindsEveryPass() && !(coupled && row.sharedBySections);
    });
}

std::optional<double> stockAt(const LimitSeries& series, const LayerSeries& layers,
                              const Trajectory& trajectory, int group, const Progress& moment) {
    for (std::size_t i = moment.end; i-- > 0;) {
        const Pass& pass = trajectory.passes[i];
        if (limitGroupAt(series, pass.place) != group) {
            continue;
        }
        const int radii = i < moment.open ? trajectory.radii : moment.radius + 1;
        const auto first = trajectory.visits.begin() + static_cast<std::ptrdiff_t>(pass.firstVisit);
        const auto deepest = std::ranges::max_element(first, first + radii, {}, &Visit::actual_mm);
        if (deepest->actual_mm > 0) {
            return layers.removalSign * (deepest->radius_mm - layers.target_mm)
                   + deepest->printed_mm;
        }
    }
    return std::nullopt;
}

} // namespace sparkout
