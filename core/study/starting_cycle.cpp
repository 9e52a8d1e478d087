// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/starting_cycle.h"

#include "core/process/force.h"
#include "core/process/pass_kernel.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/power.h"
#include "core/search/time_bound.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/study/starting_numbers.h"
#include "core/surface/burn.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout {

namespace {

constexpr double mwPerKw = 1e6;

// --- classes ------------------------------------------------------------------------------------

bool isInternal(const Project& project) {
    return project.part->surface == Surface::internal;
}

/// The class of the roughness of the work.
std::size_t roughnessClass(const Project& project) {
    const double Ra = workRoughness_um(*project.part);
    return Ra >= starting::coarseRoughness ? 2 : Ra >= starting::middleRoughness ? 1 : 0;
}

/// T, width of the tolerance of the diameter [mm].
double fieldWidth_mm(const Part& part) {
    return (part.upper_deviation_um - part.lower_deviation_um) / units::umPerMm;
}

bool isEntryFree(const Machine& machine, const StartingEnds& ends) {
    return machine.entry_side == EntrySide::headstock ? ends.freeAtHeadstock : ends.freeAtTailstock;
}
bool isExitFree(const Machine& machine, const StartingEnds& ends) {
    return machine.entry_side == EntrySide::headstock ? ends.freeAtTailstock : ends.freeAtHeadstock;
}

// --- steps of the machine -----------------------------------------------------------------------

enum class Rounding { down, nearest };

/// The possible values of a setting: from the lowest to the highest in steps.
struct Settings {
    double low = 0, high = std::numeric_limits<double>::infinity(), step = 1;

    Settings(const std::optional<std::vector<double>>& range, double usualStep)
        : low(usualStep), step(usualStep) {
        if (range && range->size() == 3) {
            low = (*range)[0];
            high = (*range)[1];
            step = (*range)[2] > 0 ? (*range)[2] : usualStep;
        }
    }

    [[nodiscard]] double at(double value, Rounding rounding) const {
        constexpr double slack = 1e-9, digits = 1e6;
        const double steps = (value - low) / step;
        const double whole =
            rounding == Rounding::down ? std::floor(steps + slack) : std::round(steps);
        return std::round(std::clamp(low + whole * step, low, high) * digits) / digits;
    }
};

Settings workSpeeds(const Project& project) {
    return {project.machine->limits.work_speed_rpm, starting::speedStep};
}
Settings plungeFeeds(const Project& project) {
    return {project.machine->limits.plunge_feed_mm_min, starting::plungeStep};
}
Settings infeeds(const Project& project) {
    return {project.machine->limits.radial_feed_mm, starting::infeedStep};
}
Settings axialFeeds(const Project& project) {
    return {project.machine->limits.axial_feed_mm_min, starting::axialStep};
}

// --- work speed ---------------------------------------------------------------------------------

/// V [m/min], increased by a factor against burning.
double peripheralSpeed(const Project& project, double rise) {
    const Material& material = *project.material;
    const bool isSoft =
        isIron(material)
        || (material.hardness_hrc && *material.hardness_hrc < starting::softSpeedBelow);
    const bool isTool = material.hardness_hrc.value_or(0) >= starting::toolSpeedFrom;
    double speed = isSoft   ? starting::softSpeed
                   : isTool ? starting::toolSpeed
                            : starting::hardSpeed;
    if (isInternal(project)) {
        speed = std::min<double>(starting::boreSpeed * speed, starting::greatestBoreSpeed);
    }
    return std::min<double>(starting::greatestSpeed, rise * speed);
}

/// The distance of n_k/n from a fraction at which the wheel's waves stay in place.
double unrest(double ratio) {
    const double part = ratio - std::floor(ratio);
    double least = 1;
    for (const double each : starting::restfulParts) {
        least = std::min(least, std::abs(part - each));
    }
    return least <= starting::restfulReach ? 0 : least;
}

/// n [rev/min] near that of V, in steps of the machine, where n_k/n is not near a ratio of small
/// whole numbers.
double usualWorkSpeed(const Project& project, double rise) {
    const Settings settings = workSpeeds(project);
    const double around = std::numbers::pi * project.part->diameter_mm;
    const double wanted = std::clamp(units::mmPerM * peripheralSpeed(project, rise) / around,
                                     settings.low, settings.high);
    const double wheel_rpm = units::secondsPerMinute * units::mmPerM
                             * project.machine->wheel_speed_m_s
                             / (std::numbers::pi * project.wheel->diameter_mm);
    double best = settings.at(wanted, Rounding::nearest);
    auto bestScore = std::pair(std::numeric_limits<double>::infinity(), 0.0);
    constexpr double mostTries = 1000; // for a nearly stepless machine
    const double reach = starting::speedReach * wanted;
    const double step = settings.step * std::max(std::ceil(reach / settings.step / mostTries), 1.0);
    double n = settings.at(std::max(wanted - reach, settings.low), Rounding::down);
    for (; n <= std::min(wanted + reach, settings.high); n += step) {
        const double away = std::abs(n / wanted - 1);
        const auto score = std::pair(unrest(wheel_rpm / n), away);
        if (away <= starting::speedReach && score < bestScore) {
            bestScore = score;
            best = settings.at(n, Rounding::nearest);
        }
    }
    return best;
}

// --- deflection ---------------------------------------------------------------------------------

/// The least and the greatest γ of a part [mm/N].
struct Compliances {
    double least = std::numeric_limits<double>::infinity(), greatest = 0;

    void add(double gamma) {
        least = std::min(least, gamma);
        greatest = std::max(greatest, gamma);
    }
};

/// Those at the ends, the quarters and the middle of the ground length, or if given those of the
/// zones or sections.
Compliances compliancesOf(const Project& project) {
    Compliances found;
    if (!std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n)) {
        for (const CompliantPoint& point : compliantPoints(project)) {
            found.add(point.gamma_mm_n);
        }
        return found;
    }
    const double length = project.part->length_mm;
    for (const double place : {0.0, length / 4, length / 2, 3 * length / 4, length}) {
        found.add(influenceRows(project, {place}, {place}).front());
    }
    return found;
}

/// How far the gauge's target is beyond the middle of the field, as a radius that is not cut [mm].
double targetBeyondMiddle_mm(const Part& part) {
    const double middle_mm =
        part.diameter_mm + (part.upper_deviation_um + part.lower_deviation_um) / 2 / units::umPerMm;
    const double beyond_mm = (part.target_diameter_mm.value_or(middle_mm) - middle_mm) / 2;
    return part.surface == Surface::external ? beyond_mm : -beyond_mm;
}

/// The lag of a radius behind the wheel, step by step, with one pass per step or, in a double
/// stroke, two.
class Lag {
public:
    Lag(const ForceLaw& law, double gamma, double width_mm, int passes)
        : m_balance(gamma, width_mm * law.ks, width_mm * law.kr, law.threshold), m_passes(passes) {}

    /// The lag after a step [mm].
    [[nodiscard]] double after(double lag_mm) const {
        for (int pass = 0; pass < m_passes; ++pass) {
            const double root = m_balance.root(lag_mm);
            lag_mm -= root * root;
        }
        return lag_mm;
    }
    /// The steady lag after many steps of this infeed [mm].
    [[nodiscard]] double steady(double infeed_mm) const {
        constexpr int mostSteps = 400;
        constexpr double nearEnough_mm = 1e-9;
        double lag_mm = 0;
        for (int step = 0; step < mostSteps; ++step) {
            const double next_mm = after(lag_mm + infeed_mm);
            if (std::abs(next_mm - lag_mm) < nearEnough_mm) {
                break;
            }
            lag_mm = next_mm;
        }
        return lag_mm;
    }
    /// The removal of a number of steps without infeed from a lag [mm].
    [[nodiscard]] double removed(double lag_mm, int steps) const {
        double left_mm = lag_mm;
        for (int step = 0; step < steps; ++step) {
            left_mm = after(left_mm);
        }
        return lag_mm - left_mm;
    }

private:
    LaneBalance m_balance;
    int m_passes;
};

/// The greatest depth of cut at which a rising value does not exceed a limit [mm].
template <class Rising>
double greatestDepth(const Rising& rising, double most) {
    constexpr double deepest_mm = 0.05;
    constexpr int halvings = 60;
    double low = 0, high = deepest_mm;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (rising(middle) <= most ? low : high) = middle;
    }
    return low;
}

// --- stages -------------------------------------------------------------------------------------

/// A depth of cut and its bound.
struct BoundDepth {
    double depth_mm;
    RoughBound bound = RoughBound::table;
    bool isExceeded = false; ///< the machine's lowest feed exceeds the bound

    void keepTo(double most_mm, RoughBound by) {
        if (most_mm < depth_mm) {
            depth_mm = most_mm;
            bound = by;
        }
    }
    /// The feed for a depth, with its value per depth [1/min, or 1 for an infeed itself], in the
    /// machine's steps.
    [[nodiscard]] double feedIn(const Settings& settings, double perDepth) {
        const double wanted = depth_mm * perDepth;
        const double feed = settings.at(wanted, Rounding::down);
        const double slack = settings.step * 1e-6;
        isExceeded = wanted < settings.low - slack;
        if (wanted > settings.high + slack) {
            bound = RoughBound::range;
        }
        depth_mm = feed / perDepth;
        return feed;
    }
};

struct Trial {
    StartingCycle cycle;
    double removal = 0; ///< for comparison within one project
};

/// The rule on a machine as it is set.
class Rule {
public:
    /// Where both compliances differ, finishing keeps the part even.
    Rule(Project project, const Compliances& gamma)
        : m_project(std::move(project)), m_gamma(gamma.greatest), m_leastGamma(gamma.least) {
        m_worn = m_project;
        const double dullness = starting::wornDullness * dullnessOf(*m_worn.wheel);
        setDullness(*m_worn.wheel, std::min(dullness, 1.0));
        m_worn.material->flow_stress_mpa *= starting::wornStress;
        m_law = forceLaw(m_project);
        m_wornLaw = forceLaw(m_worn);
    }

    [[nodiscard]] Trial plunge() const;
    [[nodiscard]] Trial traverse(double axialShare) const;

private:
    [[nodiscard]] std::optional<double> burnLimit(double stock_mm) const;
    void limitRough(BoundDepth& depth, double width_mm, int passes) const;
    [[nodiscard]] double finishBelowBurn(double depth_mm) const;
    [[nodiscard]] double sparkOutStock(double removed_mm, double infeed_mm, int late,
                                       double uneven_mm = 0) const;
    [[nodiscard]] double unevenness(const ForceLaw& law, double infeed_mm, double width_mm,
                                    int strokes) const;
    void keepEven(double infeed_mm, Stage& finish, int& strokes) const;
    [[nodiscard]] double finishStock(double wanted_mm) const;
    [[nodiscard]] Trial made(const BoundDepth& depth, Stage rough, Stage finish,
                             Stage sparkOut) const;

    Project m_project, m_worn;
    double m_gamma, m_leastGamma;
    ForceLaw m_law, m_wornLaw;
};

/// The greatest depth with a worn wheel whose damaged layer is not deeper than this [mm]; empty if
/// burning is not known.
std::optional<double> Rule::burnLimit(double stock_mm) const {
    const auto& rise_k = m_worn.material->burn_rise_k;
    if (!rise_k || m_wornLaw.threshold) {
        return std::nullopt;
    }
    return BurnModel(m_worn).limitDepth(*rise_k, stock_mm);
}

void Rule::limitRough(BoundDepth& depth, double width_mm, int passes) const {
    if (const auto& drive_kw = m_worn.machine->wheel_drive_kw) {
        const double power = starting::powerShare * *drive_kw * mwPerKw;
        depth.keepTo(PowerModel(m_worn).wheelLimitDepth(width_mm, power), RoughBound::power);
    }
    // With one pass per step the remaining lag is the deflection of the cut: γ·P(a).
    const Lag lag(m_law, m_gamma, width_mm, passes);
    const auto deflection = [&](double a) {
        return passes == 1 ? m_gamma * m_law.normal(width_mm, std::sqrt(a)) : lag.steady(a);
    };
    const double most_mm =
        std::max<double>(starting::lagShare * m_project.part->stock_mm, starting::leastLag);
    depth.keepTo(greatestDepth(deflection, most_mm), RoughBound::deflection);
    if (const auto burn_mm = burnLimit(starting::damagedDepth)) {
        depth.keepTo(*burn_mm, RoughBound::burn);
    }
}

/// A depth of finishing, reduced to a share of the burning depth [mm].
double Rule::finishBelowBurn(double depth_mm) const {
    const auto burn_mm = burnLimit(0);
    return burn_mm ? std::min(depth_mm, starting::finishOfBurn * *burn_mm) : depth_mm;
}

/// The stock of a spark-out [mm]: its removal, plus the infeed of finishing beyond the reading that
/// ends it, and half a step, by which that end is uncertain; at most a quarter of a small stock.
/// The middle of the part's sizes is that of the field, whatever the gauge's target.
double Rule::sparkOutStock(double removed_mm, double infeed_mm, int late, double uneven_mm) const {
    const double step = starting::stockStep, beyond_mm = targetBeyondMiddle_mm(*m_project.part);
    const double fed_mm = (late + 0.5) * infeed_mm;
    const double wanted_mm = removed_mm + fed_mm + uneven_mm / 2 - beyond_mm;
    const double stock_mm = std::max(beyond_mm > 0 ? 0 : step, std::round(wanted_mm / step) * step);
    return std::min(stock_mm, m_project.part->stock_mm / 4);
}

/// The difference of the lags behind a spark-out between the places that yield most and least [mm].
double Rule::unevenness(const ForceLaw& law, double infeed_mm, double width_mm, int strokes) const {
    constexpr int passes = 2; // of a double stroke
    const auto left_mm = [&](double gamma) {
        const Lag lag(law, gamma, width_mm, passes);
        const double steady_mm = lag.steady(infeed_mm);
        return steady_mm - lag.removed(steady_mm, strokes);
    };
    return left_mm(m_gamma) - left_mm(m_leastGamma);
}

/// Adds spark-outs, then reduces S_ax, until the part becomes even.
void Rule::keepEven(double infeed_mm, Stage& finish, int& strokes) const {
    const double n = m_project.machine->work_speed_rpm, width = m_project.wheel->width_mm;
    const double most_mm = starting::unevenLag * fieldWidth_mm(*m_project.part);
    const int usual = strokes;
    std::vector<double> feeds{*finish.axial_feed_mm_min};
    for (const double share : starting::evenShares) {
        const double feed = axialFeeds(m_project).at(share * width * n, Rounding::down);
        if (feed < feeds.back()) {
            feeds.push_back(feed);
        }
    }
    for (const double feed : feeds) {
        finish.axial_feed_mm_min = feed;
        for (strokes = usual; strokes <= starting::evenStrokes; ++strokes) {
            if (unevenness(m_wornLaw, infeed_mm, std::min(feed / n, width), strokes) <= most_mm) {
                return;
            }
        }
    }
    --strokes;
}

double Rule::finishStock(double wanted_mm) const {
    constexpr double slack = 1e-6;
    const double step = starting::finishStockStep, fine = starting::stockStep;
    const double most =
        std::floor(starting::greatestFinishStock * m_project.part->stock_mm / fine + slack) * fine;
    return std::min(std::ceil(wanted_mm / step - slack) * step, most);
}

/// The three stages, whose stocks add up to the part's.
Trial Rule::made(const BoundDepth& depth, Stage rough, Stage finish, Stage sparkOut) const {
    constexpr double digits = 1e6, sumDigits = 1e9; // the first one gets the remainder
    const auto rounded = [](double value, double to) { return std::round(value * to) / to; };
    finish.stock_mm = rounded(finish.stock_mm, digits);
    sparkOut.stock_mm = rounded(sparkOut.stock_mm, digits);
    rough.stock_mm =
        rounded(m_project.part->stock_mm - finish.stock_mm - sparkOut.stock_mm, sumDigits);
    Trial trial{{.project = m_project,
                 .bound = depth.bound,
                 .isExceeded = depth.isExceeded,
                 .roughDepth_mm = depth.depth_mm}};
    trial.cycle.project.cycle->stages = {std::move(rough), std::move(finish), std::move(sparkOut)};
    return trial;
}

Trial Rule::plunge() const {
    const Part& part = *m_project.part;
    const double n = m_project.machine->work_speed_rpm, width = part.length_mm,
                 T = fieldWidth_mm(part);
    const bool hard = isHardened(*m_project.material), bore = isInternal(m_project);
    const std::size_t roughness = roughnessClass(m_project);
    const Settings feeds = plungeFeeds(m_project);

    const double removal =
        (hard ? starting::hardRemoval : starting::softRemoval) * (bore ? starting::boreShare : 1);
    const double table =
        removal * units::secondsPerMinute / (std::numbers::pi * part.diameter_mm) / n;
    BoundDepth depth{table};
    depth.keepTo((hard ? starting::greatestHardFeed : starting::greatestSoftFeed) / n,
                 RoughBound::table);
    const double usual = depth.depth_mm;
    limitRough(depth, width, 1);
    const double reached = depth.depth_mm;
    Stage rough;
    rough.radial_feed_mm_min = depth.feedIn(feeds, n);

    const Lag lag(m_law, m_gamma, width, 1), wornLag(m_wornLaw, m_gamma, width, 1);
    const double finest =
        std::clamp<double>(finishBelowBurn(starting::plungeFinish * T) * n,
                           starting::leastPlungeFinish, starting::plungeFinishMost[roughness]);
    const double share = bore ? starting::finishOfRoughBore : starting::finishOfRough;
    double feed = feeds.at(std::min(finest, share * *rough.radial_feed_mm_min), Rounding::down);
    while (feed > starting::leastFinish && lag.steady(feed / n) > starting::finishLag * T) {
        const double less = feeds.at(feed - starting::lessFinish, Rounding::down);
        if (less >= feed) {
            break;
        }
        feed = less;
    }
    Stage finish;
    finish.radial_feed_mm_min = feed;

    const double infeed = feed / n, left = lag.steady(infeed);
    const int least = static_cast<int>(starting::leastRevolutions);
    int revolutions = std::max(least, static_cast<int>(std::ceil(starting::sparkOutTime[roughness]
                                                                 * n / units::secondsPerMinute)));
    while (revolutions > least && lag.removed(left, revolutions) > starting::sparkOutRemoval * T) {
        --revolutions;
    }
    Stage sparkOut;
    sparkOut.sparkOutFor(revolutions);
    const int late = lateSteps(m_project, units::secondsPerMinute / n);
    sparkOut.stock_mm = sparkOutStock(lag.removed(left, revolutions), infeed, late);
    finish.stock_mm = finishStock(
        std::max<double>(starting::leastFinishStock,
                         starting::plungeLagStock * wornLag.steady(depth.depth_mm)
                             + starting::plungeStepsStock * infeed + late * depth.depth_mm));

    Trial trial = made(depth, std::move(rough), std::move(finish), std::move(sparkOut));
    trial.cycle.usualDepth_mm = usual;
    trial.cycle.tableShare = reached / table;
    trial.removal = depth.depth_mm * n;
    return trial;
}

Trial Rule::traverse(double axialShare) const {
    const Part& part = *m_project.part;
    const double n = m_project.machine->work_speed_rpm, width = m_project.wheel->width_mm;
    const double T = fieldWidth_mm(part);
    const bool hard = isHardened(*m_project.material), bore = isInternal(m_project);
    const std::size_t roughness = roughnessClass(m_project);
    const Settings feeds = infeeds(m_project), axials = axialFeeds(m_project);
    const auto axialFeed = [&](double share) {
        return axials.at(share * width * n, Rounding::down);
    };
    const auto cutWidth = [&](double axial) { return std::min(axial / n, width); };

    const double roughShare =
        hard || bore ? std::min<double>(axialShare, starting::hardAxialShare) : axialShare;
    const double finishShare = std::min<double>(starting::axialFinish[roughness], roughShare);
    Stage rough, finish, sparkOut;
    rough.axial_feed_mm_min = axialFeed(roughShare);
    finish.axial_feed_mm_min = axialFeed(finishShare);
    const double roughWidth = cutWidth(*rough.axial_feed_mm_min);

    const double table =
        (hard ? starting::hardInfeed : starting::softInfeed) * (bore ? starting::boreShare : 1);
    BoundDepth depth{table};
    constexpr int passes = 2; // of a double stroke
    limitRough(depth, roughWidth, passes);
    rough.radial_feed_mm = depth.feedIn(feeds, 1);
    const double infeed =
        feeds.at(finishBelowBurn(std::min(
                     {starting::strokeFinish * T, starting::greatestStrokeFinish,
                      std::max(starting::strokeFinishOfRough * depth.depth_mm, feeds.low)})),
                 Rounding::down);
    finish.radial_feed_mm = infeed;

    const Lag usualLag(m_law, m_gamma, cutWidth(*finish.axial_feed_mm_min), passes);
    const Lag wornLag(m_wornLaw, m_gamma, roughWidth, passes);
    int strokes = static_cast<int>(starting::sparkOutStrokes[roughness]);
    while (strokes > starting::leastStrokes
           && usualLag.removed(usualLag.steady(infeed), strokes) > starting::sparkOutRemoval * T) {
        --strokes;
    }
    keepEven(infeed, finish, strokes);
    sparkOut.axial_feed_mm_min = finish.axial_feed_mm_min;
    sparkOut.sparkOutFor(strokes);
    const double finishWidth = cutWidth(*finish.axial_feed_mm_min);
    const double uneven_mm = (unevenness(m_law, infeed, finishWidth, strokes)
                              + unevenness(m_wornLaw, infeed, finishWidth, strokes))
                             / 2;
    const Lag lag(m_law, m_gamma, finishWidth, passes);
    const double left = lag.steady(infeed);
    const auto late = [this](const Stage& stage) {
        return lateSteps(m_project, strokesAndDwells_s(m_project, *stage.axial_feed_mm_min));
    };
    sparkOut.stock_mm = sparkOutStock(lag.removed(left, strokes), infeed, late(finish), uneven_mm);
    finish.stock_mm = finishStock(
        std::max<double>(starting::leastFinishStock,
                         starting::strokeLagStock * wornLag.steady(depth.depth_mm)
                             + starting::strokeStepsStock * infeed
                             + (starting::strokeRoughStock + late(rough)) * depth.depth_mm));

    const double removal = depth.depth_mm * *rough.axial_feed_mm_min;
    Trial trial = made(depth, std::move(rough), std::move(finish), std::move(sparkOut));
    trial.cycle.usualDepth_mm = table;
    trial.cycle.tableShare = depth.depth_mm / table;
    trial.removal = removal;
    return trial;
}

// --- choice among speeds and shares
// ---------------------------------------------------------------

/// Whether a smaller axial feed allows a deeper cut.
bool isOfWidth(RoughBound bound) {
    return bound == RoughBound::power || bound == RoughBound::deflection;
}

/// With one revolution of dwell where the wheel cannot overrun the end, to the millisecond.
Project withDwells(Project project, const StartingEnds& ends) {
    Machine& machine = *project.machine;
    const auto dwell_s = [&](bool isFree) {
        const double whole =
            starting::shoulderDwell * units::secondsPerMinute / machine.work_speed_rpm;
        return isFree ? 0 : std::round(whole * 1e3) / 1e3;
    };
    if (project.operation->travels) {
        machine.dwell_entry_s = dwell_s(isEntryFree(machine, ends));
        machine.dwell_exit_s = dwell_s(isExitFree(machine, ends));
    }
    return project;
}

Trial bestOn(const Project& project, const Compliances& gamma) {
    const Rule rule(project, gamma);
    if (!project.operation->travels) {
        return rule.plunge();
    }
    Trial best = rule.traverse(starting::axialShares.front());
    for (std::size_t i = 1; i < starting::axialShares.size() && isOfWidth(best.cycle.bound); ++i) {
        Trial next = rule.traverse(starting::axialShares[i]);
        const bool isLast = !isOfWidth(next.cycle.bound);
        if (next.removal > starting::worthAShare * best.removal) {
            best = std::move(next);
        }
        if (isLast) {
            break;
        }
    }
    return best;
}

Trial bestAt(Project project, const StartingEnds& ends, const Compliances& gamma, double rise) {
    project.machine->work_speed_rpm = usualWorkSpeed(project, rise);
    return bestOn(withDwells(std::move(project), ends), gamma);
}

} // namespace

const char* roughBoundKey(RoughBound bound) {
    switch (bound) {
    case RoughBound::power: return "power";
    case RoughBound::deflection: return "deflection";
    case RoughBound::burn: return "burn";
    case RoughBound::range: return "range";
    case RoughBound::table: break;
    }
    return "table";
}

const char* roughBoundText(RoughBound bound) {
    switch (bound) {
    case RoughBound::power: return SPARKOUT_NOOP("StartingCycle", "the wheel drive's power");
    case RoughBound::deflection:
        return SPARKOUT_NOOP("StartingCycle", "the deflection of machine and part");
    case RoughBound::burn: return SPARKOUT_NOOP("StartingCycle", "the depth of the burnt layer");
    case RoughBound::range: return SPARKOUT_NOOP("StartingCycle", "the machine's highest feed");
    case RoughBound::table: break;
    }
    return SPARKOUT_NOOP("StartingCycle", "the usual depth of cut");
}

bool isIron(const Material& material) {
    return material.grade.starts_with("СЧ") || material.grade.starts_with("ВЧ")
           || material.grade.starts_with("КЧ");
}

bool isHardened(const Material& material) {
    return !isIron(material)
           && material.hardness_hrc.value_or(starting::hardFrom) >= starting::hardFrom;
}

double workRoughness_um(const Part& part) {
    return part.tolerance.roughness_ra_um.value_or(
        std::max<double>(starting::middleRoughness,
                         starting::roughnessOfField * fieldWidth_mm(part) * units::umPerMm));
}

double freeOverrun_mm(double width_mm, double length_mm, const StartingEnds& ends) {
    constexpr double perMm = 10; // rounded to a tenth of a millimetre
    const bool isShort = length_mm < starting::shortPart * width_mm;
    const double usual = isShort ? starting::shortOverrun : starting::overrun;
    const bool isWithoutZone =
        length_mm > width_mm && length_mm <= (2 - usual * ends.freeCount()) * width_mm;
    const double share = isWithoutZone ? starting::longestOverrun : usual;
    return std::round(share * width_mm * perMm) / perMm;
}

Project withStartingEnds(Project project, const StartingEnds& ends) {
    Machine& machine = *project.machine;
    const Wheel& wheel = *project.wheel;
    machine.wheel_speed_m_s =
        std::min(machine.wheel_speed_m_s, wheel.max_speed_m_s.value_or(machine.wheel_speed_m_s));
    machine.plunge_feed_mm_min = plungeFeeds(project).at(starting::reversalFeed, Rounding::nearest);
    project.least_steps = project.operation->usualLeastSteps;
    if (!project.operation->travels) {
        return project;
    }
    const double free_mm = freeOverrun_mm(wheel.width_mm, project.part->length_mm, ends);
    const auto overrun_mm = [free_mm](bool isFree) { return isFree ? free_mm : 0; };
    machine.overrun_entry_mm = overrun_mm(isEntryFree(machine, ends));
    machine.overrun_exit_mm = overrun_mm(isExitFree(machine, ends));
    project.least_overlap = starting::leastOverlap;
    project.least_overlap_last = starting::leastOverlapLast;
    return project;
}

Cycle startingStages(const Project& project) {
    const auto best = bestOn(project, compliancesOf(project));
    return *best.cycle.project.cycle;
}

StartingCycle startingCycle(Project project, const StartingEnds& ends) {
    project = withStartingEnds(std::move(project), ends);
    Compliances gamma = compliancesOf(project);
    gamma.least = gamma.greatest; // how evenly it is cut is left to the decision on all stocks
    Trial best = bestAt(project, ends, gamma, 1);
    for (const double rise : starting::speedRises) {
        if (best.cycle.bound != RoughBound::burn || best.cycle.tableShare >= starting::burntShare) {
            break;
        }
        Trial faster = bestAt(project, ends, gamma, rise);
        if (faster.removal <= starting::worthASpeed * best.removal) {
            break;
        }
        best = std::move(faster);
    }
    return std::move(best.cycle);
}

} // namespace sparkout
