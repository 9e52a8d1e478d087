// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/accuracy_limit.h"

#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/printed_form.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/simulation/progress.h"
#include "core/simulation/stage_control.h"
#include "core/surface/rising_root.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// √a of b·(k_s·a + k_r·√a) = P; with a threshold 0 up to it.
double rootOfForce(const ForceLaw& law, double b, double P) {
    if (law.threshold) {
        return std::sqrt(std::max(0.0, P / b - law.kr) / law.ks);
    }
    const double A = b * law.ks, C = b * law.kr;
    return P > 0 ? 2 * P / (C + std::sqrt(C * C + 4 * A * P)) : 0;
}

double forceAt(const ForceLaw& law, double b, double a) {
    return law.normal(b, std::sqrt(a));
}

/// The greatest allowed difference of the radii of two lanes at the end [mm]. A proof allows for
/// the machine's form error cancelling it; an estimate assumes that it adds.
double greatestSpread(const Project& project, SpreadOf of, AccuracyProof proof) {
    const Part& part = *project.part;
    const double sign = proof == AccuracyProof::proved ? 1 : -1;
    double s = (part.upper_deviation_um - part.lower_deviation_um) / units::umPerMm
               + sign * 4 * mostOfDiameters_mm(project);
    if (of == SpreadOf::oneOfTwo) {
        s /= 2;
    }
    if (part.tolerance.total_runout_um) {
        const double added_um = addedRunout_um(*project.machine);
        s = std::min(s, *part.tolerance.total_runout_um / units::umPerMm - added_um / units::umPerMm
                            + sign * mostPrinted_mm(project));
    }
    return s;
}

/// The machine's own runout, added or transferred, at its greatest [mm].
double greatestOwnRunout(const Machine& machine) {
    double most_um = addedRunout_um(machine);
    for (const double own_um : machine.form
                                   ? machine.form->runout_um.value_or(std::vector<double>())
                                   : std::vector<double>()) {
        most_um = std::max(most_um, own_um);
    }
    return most_um / units::umPerMm;
}

/// [δ] of the published limit, from the drawing [mm].
double publishedTolerance(const Part& part, double ownRunout_mm) {
    return part.tolerance.radial_runout_um
               ? *part.tolerance.radial_runout_um / units::umPerMm - ownRunout_mm
               : (part.upper_deviation_um - part.lower_deviation_um) / units::umPerMm;
}

double gammaOf(const Project& project, const LimitGroup& group) {
    const std::vector<CompliantPoint> points = compliantPoints(project);
    const auto place = group.zone == Zone::section ? static_cast<std::size_t>(group.section)
                                                   : static_cast<std::size_t>(group.zone);
    return points[place].gamma_mm_n;
}

/// The limit of the last cut of a cycle by roughness. With spark-out too the last cut is no greater
/// than that of the last step with infeed, since each spark-out cut of a radius is no greater than
/// the one before.
double roughnessLimit(const Project& project) {
    const auto& Ra = project.part->tolerance.roughness_ra_um;
    return Ra && isRoughnessCalibrated(project)
               ? RoughnessModel(project).mostDepth(*Ra / units::umPerMm)
               : infinite;
}

/// a* of a lane, by its difference to the stiffest lane or, plus s, by that of the most compliant
/// one; as an estimate for lanes with equal cuts.
double spreadLimit(const Project& project, const ForceLaw& law, double b, double gamma,
                   AccuracyProof proof, SpreadOf of = SpreadOf::oneOfTwo) {
    const double s = greatestSpread(project, of, proof);
    double stiffest = infinite, softest = 0;
    for (const CompliantPoint& point : compliantPoints(project)) {
        stiffest = std::min(stiffest, point.gamma_mm_n);
        softest = std::max(softest, point.gamma_mm_n);
    }
    if (!(s > 0) || !(stiffest >= 0)) {
        return infinite;
    }
    return proof == AccuracyProof::estimate
               ? steadyCutOfSpread(law, b, stiffest, softest, s)
               : std::min(lastCutOfSpread(law, b, stiffest, gamma, s),
                          lastCutOfSpread(law, b, stiffest, softest, s) + s);
}

bool isProvable(const Project& project) {
    return !project.operation->travels && !isCoupled(project) && !wheelContact(project)
           && !hasThreshold(project) && zoneBlanks(*project.part).empty() && !project.wheel->runout;
}

} // namespace

double depthBefore(const ForceLaw& law, double b, double gamma, double a) {
    const double root = rootOfForce(law, b, forceAt(law, b, a) + a / gamma);
    return root * root;
}

double depthAfter(const ForceLaw& law, double b, double gamma, double a, double infeed_mm) {
    const double A = 1 + gamma * b * law.ks, C = gamma * b * law.kr;
    const double h = gamma * forceAt(law, b, a) + infeed_mm;
    if (law.threshold) {
        return std::max(0.0, h - C) / A;
    }
    const double root = h > 0 ? 2 * h / (C + std::sqrt(C * C + 4 * A * h)) : 0;
    return root * root;
}

double lastCutOfSpread(const ForceLaw& law, double b, double stiffGamma, double compliantGamma,
                       double s) {
    if (!(compliantGamma > stiffGamma)) {
        return infinite;
    }
    // In √a the slope at 0 is finite.
    const auto excess = [&](double u) {
        const double a = u * u, both = a + s;
        const double value =
            compliantGamma * law.normal(b, u) - stiffGamma * law.normal(b, std::sqrt(both)) - s;
        const double slope = compliantGamma * b * (2 * law.ks * u + law.kr)
                             - stiffGamma * b * (2 * law.ks * u + law.kr * u / std::sqrt(both));
        return ValueAndSlope{value, slope};
    };
    double high = std::sqrt(s);
    constexpr double most = 1e3; // √mm, beyond all parts
    while (excess(high).value < 0 && high < most) {
        high *= 2;
    }
    if (excess(high).value < 0) {
        return infinite;
    }
    const double root = risingRoot(excess, 0, high);
    return root * root;
}

double lastCutsOfSpread(const ForceLaw& law, double b, double stiffGamma, double compliantGamma,
                        double s_mm, int count, const std::function<double(double)>& most) {
    constexpr int parts = 48; // parts of the range of each cut but the first
    const auto sum = [&](const auto& self, int cuts, double s, double released,
                         double after) -> double {
        if (!(s > 0)) {
            return 0;
        }
        const double highest = std::min(
            {released, most(after), lastCutOfSpread(law, b, stiffGamma, compliantGamma, s)});
        if (cuts == 1) {
            return highest;
        }
        double greatest = 0;
        for (int i = 0; i < parts; ++i) {
            const double low = highest * i / parts, high = highest * (i + 1) / parts;
            const double stiff =
                rootOfForce(law, b, (compliantGamma * forceAt(law, b, low) - s) / stiffGamma);
            const double before = self(self, cuts - 1, s + high - stiff * stiff,
                                       depthBefore(law, b, compliantGamma, high), after + high);
            greatest = std::max(greatest, high + before);
        }
        return greatest;
    };
    return sum(sum, count, s_mm, infinite, 0);
}

double steadyCutOfSpread(const ForceLaw& law, double b, double stiffGamma, double compliantGamma,
                         double s) {
    if (!(compliantGamma > stiffGamma)) {
        return infinite;
    }
    const double root = rootOfForce(law, b, s / (compliantGamma - stiffGamma));
    return root * root;
}

// Builds the curve by the last cut e, from σ(a*) to a*: a cut followed by n others is σ^(−n)(e),
// and the stock it leaves is e + σ^(−1)(e) + … of n terms.
LimitPoints releaseCurve(const ForceLaw& law, double b, double gamma, double lastCut,
                         double deepest) {
    constexpr int pointsOfPass = 4;
    constexpr std::size_t mostPoints = 4000;
    LimitPoints points{{0, lastCut}};
    const double least = depthAfter(law, b, gamma, lastCut);
    if (!(gamma > 0) || !(lastCut > 0) || !(least > 0)) {
        return points;
    }
    for (int passes = 1; points.size() < mostPoints; ++passes) {
        for (int i = 0; i <= pointsOfPass; ++i) {
            double a = least + (lastCut - least) * i / pointsOfPass, stock = 0;
            for (int n = 0; n < passes; ++n) {
                stock += a;
                a = depthBefore(law, b, gamma, a);
            }
            if (stock > points.back().stock_mm) { // depths must not fall by rounding
                points.push_back({stock, std::max(a, points.back().depth_mm)});
            }
            if (stock >= deepest) {
                const LimitPoint &from = points[points.size() - 2], &to = points.back();
                const double share = (deepest - from.stock_mm) / (to.stock_mm - from.stock_mm);
                points.back() = {deepest, from.depth_mm + share * (to.depth_mm - from.depth_mm)};
                return points;
            }
        }
    }
    return points;
}

double provedSpread_mm(const Project& project, SpreadOf of) {
    return isProvable(project) ? greatestSpread(project, of, AccuracyProof::proved) : infinite;
}

double provedLastCut_mm(const Project& project, double b, double gamma, SpreadOf of) {
    return isProvable(project) ? std::min(
               spreadLimit(project, forceLaw(project), b, gamma, AccuracyProof::proved, of),
               roughnessLimit(project))
                               : infinite;
}

std::optional<AccuracyLimit> accuracyLimit(const SimulationResult& result,
                                           const LimitSeries& series, const LimitGroup& group,
                                           AccuracyProof proof) {
    const Project& project = result.project;
    if (drawsBack(project) || group.stages.empty()
        || (proof == AccuracyProof::proved && !isProvable(project))) {
        return std::nullopt;
    }
    const ForceLaw law = forceLaw(project);
    const double b = group.stages.back().width_mm, gamma = gammaOf(project, group);
    AccuracyLimit limit;
    if (!(greatestSpread(project, SpreadOf::oneOfTwo, proof) > 0)) { // no tolerance is left
        limit.curve = {{std::min(series.least_mm, 0.0), 0}, {series.deepest_mm, 0}};
        return limit;
    }
    limit.lastCut_mm =
        std::min(spreadLimit(project, law, b, gamma, proof), roughnessLimit(project));
    if (!(gamma > 0) || !(limit.lastCut_mm > 0) || limit.lastCut_mm == infinite) {
        return std::nullopt;
    }
    limit.curve = releaseCurve(law, b, gamma, limit.lastCut_mm, series.deepest_mm);
    if (series.least_mm < 0) {
        limit.curve.insert(limit.curve.begin(), {series.least_mm, limit.lastCut_mm});
    }
    return limit;
}

LimitPoints publishedAccuracy(const SimulationResult& result, const Trajectory& trajectory,
                              const LimitSeries& series, const LimitGroup& group) {
    const Project& project = result.project;
    const Part& part = *project.part;
    const double allowed = publishedTolerance(part, greatestOwnRunout(*project.machine));
    const double gamma = gammaOf(project, group);
    LimitPoints points;
    if (!(allowed > 0) || !(gamma > 0)) {
        return points;
    }
    const ForceLaw law = forceLaw(project);
    const double sign = part.surface == Surface::external ? 1 : -1;
    const double target = targetRadius(part);
    const int number = static_cast<int>(&group - series.groups.data());
    for (const Pass& pass : trajectory.passes) {
        if (limitGroupAt(series, pass.place) != number) {
            continue;
        }
        const Visit* deepest = nullptr;
        double least = infinite, least_n = infinite;
        for (int k = 0; k < trajectory.radii; ++k) {
            const Visit& visit = trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
            if (visit.isGap()) {
                continue;
            }
            least = std::min(least, visit.actual_mm);
            least_n = std::min(least_n, visit.normalForce_n); // includes a radius that only touches
            deepest = !deepest || visit.actual_mm > deepest->actual_mm ? &visit : deepest;
        }
        if (deepest && deepest->actual_mm > 0) {
            const double b = pass.effectiveWidth_mm;
            const double leastForce_n = law.threshold ? least_n : forceAt(law, b, least);
            const double root = rootOfForce(law, b, leastForce_n + allowed / gamma);
            points.push_back(
                {sign * (deepest->radius_mm - target) + deepest->printed_mm, root * root});
        }
    }
    std::ranges::stable_sort(points, {}, &LimitPoint::stock_mm);
    const std::size_t stride = points.size() / mostLimitedCuts + 1;
    if (stride > 1) {
        LimitPoints kept;
        for (std::size_t i = 0; i < points.size(); i += stride) {
            kept.push_back(points[i]);
        }
        points = std::move(kept);
    }
    return points;
}

LimitPoints programmedSteps(const SimulationResult& result, const LimitSeries& series,
                            const LimitGroup& group) {
    const std::vector<double> feeds = infeedsOfStages(result.project);
    LimitPoints points;
    double from = series.least_mm;
    for (std::size_t i = group.stages.size(); i-- > 0;) {
        const double to = i > 0 ? group.stages[i - 1].end_mm : series.deepest_mm;
        const auto stage = static_cast<std::size_t>(group.stages[i].stage - 1);
        if (to > from && stage < feeds.size()) {
            const double feed =
                result.project.cycle->stages[stage].feeds() ? std::max(feeds[stage], 0.0) : 0;
            points.push_back({from, feed});
            points.push_back({to, feed});
            from = to;
        }
    }
    return points;
}

} // namespace sparkout
