// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/reference_simulation.h"
#include "core/project/cycle.h"
#include "tests/core/support/reference_cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sparkout::reference {
namespace {

constexpr Real sizeTolerance = 1e-9L; // [mm] a threshold counts as reached this much early
constexpr Real noRemoval = 1e-9L;     // [mm] a pass that removes no more than this removes nothing
constexpr int idleRevolutionsAllowed =
    100; // plunge: so many in a row without removal end the cycle
constexpr long long visitLimit = 50'000'000;

// ---------------------------------------------------------------- cutting

// The wheel advances by b along the body in each revolution and stays K-th of one on each radius.
void addToStage(Sums& sums, const Cycle& c, const Body& body, Real b, Real a, Real P_y, Real P_z) {
    const Real minutes = body.length / b / c.n / c.K;
    sums.volume += pi * c.d / c.K * a * body.length;
    sums.energy += P_z * c.V_k * minutes * 60; // N · m/s · s
    sums.ground += body.length / c.K;
    sums.a = std::max(sums.a, a);
    sums.P_y = std::max(sums.P_y, P_y);
    sums.P_z = std::max(sums.P_z, P_z);
}

// Not a gauge in a free position, nor the middle of a zone that holds several sections.
bool counts(const Cycle& c, const Body& body) {
    return c.traverse ? body.counted : body.reported;
}

// A step of the cycle takes so long: the wheel grinds all the time.
void spend(Cycle& c, Real minutes) {
    c.time += minutes;
    c.sums[c.z].time += minutes;
}

// With a threshold, the force per width at which deflection and cut together make the lag: between
// 0 and what a system that cuts nothing would be pressed by, or what a rigid one would cut at.
Real pressureUnder(Real h, Real gamma, Real b, const Cycle& c) {
    if (h <= 0) {
        return 0;
    }
    Real low = 0;
    Real high = c.k_r + c.k_s * h;
    for (;;) {
        const Real p = low + (high - low) / 2;
        if (p <= low || p >= high) {
            return high;
        }
        const Real a = std::max(Real(0), p - c.k_r) / c.k_s;
        (gamma * b * p + a < h ? low : high) = p;
    }
}

// How much nearer to the work a wheel out of true stands at radius k of a pass that is due at a
// moment. The pass begins with a whole turn of the work; the speed that varies by s is
// n/(1 + s·sin(2π·turns/(n·T))).
Real waveOf(const Cycle& c, Real due, int k) {
    if (c.e == 0) {
        return 0;
    }
    const Real turns = std::ceil(due * c.n - 1e-6L) + Real(k + 1) / c.K;
    Real minutes = turns / c.n;
    if (c.speed_variation > 0) {
        const Real T = c.variation_period;
        minutes += c.speed_variation * T / (2 * pi) * (1 - std::cos(2 * pi * turns / (c.n * T)));
    }
    return c.e * std::cos(c.psi_0 + 2 * pi * c.L * c.n_k * minutes);
}

// One radius passes under the wheel, whose head has been fed to t, in a pass due at a moment.
void visit(Cycle& c, Body& body, int k, Real b, Real t, Real due) {
    ++c.visits;
    if (c.gap[k]) { // the wheel turns on without a surface under it
        if (counts(c, body)) {
            addToStage(c.sums[c.z], c, body, b, 0, 0, 0);
        }
        return;
    }
    Real& R = body.radius[k];
    const Real fed = t - c.wear + waveOf(c, due, k); // of the wheel's surface
    const Real h = c.internal ? fed - (R - c.R_min0) : fed - (c.R_max0 - R);
    const Real p = c.threshold ? pressureUnder(h, body.gamma, b, c) : 0;
    const Real a = c.threshold ? std::max(Real(0), p - c.k_r) / c.k_s
                               : depthOfCut(h, body.gamma, b, c.k_s, c.k_r);
    R = c.internal ? R + a : R - a;
    c.largest_removal = std::max(c.largest_removal, a);
    if (counts(c, body)) {
        const Real P_y = c.threshold ? b * p : b * (c.k_s * a + c.k_r * std::sqrt(a));
        const Real rubbing = c.threshold ? std::min(p / c.k_r, Real(1)) : std::sqrt(a);
        const Real P_z = b * (c.z_s * a + c.z_r * rubbing);
        c.peak_P_y = std::max(c.peak_P_y, P_y);
        c.peak_P_z = std::max(c.peak_P_z, P_z);
        addToStage(c.sums[c.z], c, body, b, a, P_y, P_z);
    }
}

Real laterStocks(const Cycle& c) {
    Real sum = 0;
    for (std::size_t j = c.z + 1; j < c.stages.size(); ++j) {
        sum += c.stages[j].stock;
    }
    return sum;
}

// The t_P at which the stage ends under position control.
Real targetInfeed(const Cycle& c) {
    const Real whole = c.internal ? c.R_t - c.R_min0 : c.R_max0 - c.R_t;
    return whole - laterStocks(c);
}

// The feed of this double stroke or revolution; position control cuts the last one of a stage
// short.
Real infeedOfThisPass(const Cycle& c) {
    const Stage& stage = c.stages[c.z];
    Real step = c.traverse ? stage.radial_feed : stage.radial_feed / c.n;
    if (c.position_control && stage.end == StageEnd::Threshold) {
        step = std::max(Real(0), std::min(step, targetInfeed(c) - c.t_P));
    }
    return step;
}

long long plungeInRevolutions(const Cycle& c, Real S_t) {
    return static_cast<long long>(std::ceil(c.n * S_t / c.S_rad - 1e-9L));
}

// t_P a while later: the continuous infeed goes on at S_c, under position control until the end of
// the stage, and never backwards.
Real fedLater(const Cycle& c, Real t, Real minutes) {
    const Stage& stage = c.stages[c.z];
    const Real later = t + stage.continuous * minutes;
    return c.position_control && stage.continuous > 0
               ? std::max(t, std::min(later, targetInfeed(c)))
               : later;
}

// All bodies of a zone, which stand under the wheel at once.
void visitZone(Cycle& c, int zone, int k, Real b, Real t) {
    for (Body& body : c.bodies) {
        if (body.zone == zone) {
            visit(c, body, k, b, t, c.clock);
        }
    }
}

void dwell(Cycle& c, int zone, Real b, long long revolutions) {
    for (long long m = 0; m < revolutions; ++m) {
        for (int k = 0; k < c.K; ++k) {
            visitZone(c, zone, k, b, fedLater(c, c.t_P, Real(k + 1) / c.K / c.n));
        }
        c.t_P = fedLater(c, c.t_P, 1 / c.n);
        c.clock += 1 / c.n;
    }
}

void plungeIn(Cycle& c, int zone, Real b, Real S) {
    const long long revolutions = plungeInRevolutions(c, S);
    for (long long m = 1; m <= revolutions; ++m) {
        for (int k = 0; k < c.K; ++k) {
            const Real turns = m - 1 + Real(k + 1) / c.K;
            // what both infeeds come to; the continuous one alone stops at the end of the stage
            const Real continuous = c.stages[c.z].continuous;
            const Real both = c.t_P + std::min(S, c.S_rad / c.n * turns) + continuous * turns / c.n;
            const bool stops = c.position_control && continuous > 0;
            const Real most = std::max(targetInfeed(c), c.t_P + S);
            visitZone(c, zone, k, b, stops ? std::min(both, most) : both);
        }
        c.clock += 1 / c.n;
    }
    c.t_P = fedLater(c, c.t_P + S, revolutions / c.n);
}

// The table runs once along the part, there or back: each radius of a zone is visited when the
// wheel's middle is nearest to that of the zone.
void stroke(Cycle& c, Real b, bool there) {
    const Real speed = c.stages[c.z].axial_feed;
    const Real first = c.B / 2 - c.o1, last = c.length + c.o2 - c.B / 2; // of the wheel's middle
    for (Body& body : c.bodies) {
        const Real middle = std::clamp(body.middle, first, last);
        const Real later = (there ? middle - first : last - middle) / speed;
        const Real t = fedLater(c, c.t_P, later);
        for (int k = 0; k < c.K; ++k) {
            visit(c, body, k, b, t, c.clock + later);
        }
    }
    c.t_P = fedLater(c, c.t_P, (last - first) / speed);
    c.clock += (last - first) / speed;
}

void doubleStroke(Cycle& c) {
    const Stage& stage = c.stages[c.z];
    const Real S_t = infeedOfThisPass(c);
    const Real S_1 = S_t * c.entry_share;
    const Real b1 = std::min(c.B - c.o1, c.B);            // plunge passes in РЗ1
    const Real b2 = std::min(c.B - c.o2, c.B);            // plunge passes in РЗ2
    const Real b = std::min(stage.axial_feed / c.n, c.B); // traverse passes
    const int rz1 = 0, rz2 = 2;

    plungeIn(c, rz1, b1, S_1);
    dwell(c, rz1, b1, c.N1);
    stroke(c, b, true);
    Real S_2 = S_t - S_1;
    if (c.position_control && stage.continuous > 0) { // it may have come to the end meanwhile
        S_2 = std::max(Real(0), std::min(S_2, targetInfeed(c) - c.t_P));
    }
    plungeIn(c, rz2, b2, S_2);
    dwell(c, rz2, b2, c.N2);
    stroke(c, b, false);
    dwell(c, rz1, b1, c.N1);

    const Real travel = c.length - c.B + c.o1 + c.o2;
    const long long plunges = plungeInRevolutions(c, S_1) + plungeInRevolutions(c, S_2);
    spend(c, (plunges + 2 * c.N1 + c.N2) / c.n + 2 * travel / stage.axial_feed);
}

void revolution(Cycle& c) {
    const Real step = infeedOfThisPass(c);
    for (Body& body : c.bodies) {
        for (int k = 0; k < c.K; ++k) {
            visit(c, body, k, c.length, c.t_P + step * Real(k + 1) / c.K, c.clock);
        }
    }
    c.t_P += step;
    c.clock += 1 / c.n;
    spend(c, 1 / c.n);
}

long long visitsOfNextPass(const Cycle& c) {
    if (!c.traverse) {
        return static_cast<long long>(c.bodies.size()) * c.K;
    }
    const Real S_t = infeedOfThisPass(c);
    const long long plunges = plungeInRevolutions(c, S_t * c.entry_share)
                              + plungeInRevolutions(c, S_t * (1 - c.entry_share));
    const long long strokes = static_cast<long long>(c.bodies.size()) * 2;
    const long long standing = c.zone_sections > 1 ? c.zone_sections + 1 : 1;
    return ((plunges + 2 * c.N1 + c.N2) * standing + strokes) * c.K;
}

// ---------------------------------------------------------------- control

// The diameters that no gap interrupts.
std::vector<Real> diameters(const Cycle& c, const Body& body) {
    std::vector<Real> D;
    for (int k = 0; k < c.K / 2; ++k) {
        if (!c.gap[k] && !c.gap[k + c.K / 2]) {
            D.push_back(body.radius[k] + body.radius[k + c.K / 2]);
        }
    }
    return D;
}

// Π_rem by the gauge [mm].
Real remainingStock(const Cycle& c) {
    const std::vector<Real> D = diameters(c, c.bodies[c.gauge]);
    const Real smallest = *std::min_element(D.begin(), D.end());
    const Real largest = *std::max_element(D.begin(), D.end());
    Real reading = std::accumulate(D.begin(), D.end(), Real(0)) / D.size();
    if (c.rule == "min") {
        reading = c.internal ? largest : smallest;
    } else if (c.rule == "max") {
        reading = c.internal ? smallest : largest;
    }
    return c.internal ? c.R_t - reading / 2 : reading / 2 - c.R_t;
}

// Π_rem as the control knows it after a pass: of the latest pass that ended so much earlier [mm].
Real knownStock(const Cycle& c, Real delay_s) {
    constexpr Real timeTolerance = 1e-9L; // [s]
    for (std::size_t i = c.readings.size(); i-- > 0;) {
        if (c.readings[i].time * 60 <= c.time * 60 - delay_s + timeTolerance) {
            return c.readings[i].stock;
        }
    }
    return std::numeric_limits<Real>::infinity();
}

bool sizeIsCommanded(const Cycle& c) {
    const bool byGauge = !c.position_control && c.stages.back().end != StageEnd::Count;
    return byGauge && knownStock(c, c.gauge_delay) <= sizeTolerance;
}

bool stageHasEnded(const Cycle& c) {
    const Stage& stage = c.stages[c.z];
    if (stage.end == StageEnd::Count) {
        return c.passes_in_stage >= stage.count;
    }
    if (stage.end == StageEnd::Threshold && c.position_control) {
        return c.t_P >= targetInfeed(c) - sizeTolerance;
    }
    const bool last = c.z + 1 == c.stages.size();
    const Real delay_s = c.gauge_delay + (last ? 0 : c.feed_change_delay);
    return knownStock(c, delay_s) <= laterStocks(c) + sizeTolerance || sizeIsCommanded(c);
}

// After a pass of a spark-out until size: has it stopped removing anything?
bool progressHasStopped(Cycle& c) {
    if (c.largest_removal > noRemoval) {
        c.idle_revolutions = 0;
        return false;
    }
    ++c.idle_revolutions;
    return c.traverse || c.idle_revolutions >= idleRevolutionsAllowed;
}

void run(Cycle& c, Result& result) {
    for (;;) {
        if (c.visits + visitsOfNextPass(c) > visitLimit) {
            result.status = "too_long";
            return;
        }
        const bool untilSize = c.stages[c.z].end == StageEnd::Size;
        c.largest_removal = 0;
        if (c.traverse) {
            doubleStroke(c);
        } else {
            revolution(c);
        }
        ++result.passes;
        ++result.passes_by_stage[c.z];
        ++c.passes_in_stage;
        c.readings.push_back({c.time, remainingStock(c)});
        while (stageHasEnded(c)) {
            ++c.z;
            c.passes_in_stage = 0;
            if (c.z == c.stages.size()) {
                result.status = "completed";
                return;
            }
        }
        const bool isAtSize = remainingStock(c) <= sizeTolerance; // the command comes later
        if (untilSize && progressHasStopped(c) && !isAtSize) {
            result.status = "cannot_reach_size";
            return;
        }
    }
}

Place measured(const Cycle& c, const Body& body) {
    if (!body.counted) { // the worst of the zone's sections, with the radii of its middle
        Body middle = body;
        middle.counted = true;
        Place place = measured(c, middle);
        bool first = true;
        for (const Body& section : c.bodies) {
            if (section.zone != body.zone || !section.counted) {
                continue;
            }
            const Place one = measured(c, section);
            const auto least = [first](double a, double b) { return first ? b : std::min(a, b); };
            const auto most = [first](double a, double b) { return first ? b : std::max(a, b); };
            place.diameter_deviation_min_um =
                least(place.diameter_deviation_min_um, one.diameter_deviation_min_um);
            place.diameter_deviation_max_um =
                most(place.diameter_deviation_max_um, one.diameter_deviation_max_um);
            place.radial_runout_um = most(place.radial_runout_um, one.radial_runout_um);
            first = false;
        }
        return place;
    }
    Place place;
    std::vector<Real> R; // of what is there
    for (int k = 0; k < c.K; ++k) {
        const Real none = std::numeric_limits<Real>::quiet_NaN();
        place.radii_um.push_back(c.gap[k] ? none : (body.radius[k] - c.d / 2) * 1000);
        if (!c.gap[k]) {
            R.push_back(body.radius[k]);
        }
    }
    const std::vector<Real> D = diameters(c, body);
    const Real smallest = *std::min_element(D.begin(), D.end());
    const Real largest = *std::max_element(D.begin(), D.end());
    const auto [lowest, highest] = std::minmax_element(R.begin(), R.end());
    place.diameter_deviation_min_um = static_cast<double>((smallest - c.d) * 1000);
    place.diameter_deviation_max_um = static_cast<double>((largest - c.d) * 1000);
    place.radial_runout_um =
        static_cast<double>((*highest - *lowest) * 1000 + c.geometric_runout_um);
    return place;
}

StageSums inDoubles(const Sums& sums, Real V_k) {
    StageSums stage;
    stage.volume_mm3 = static_cast<double>(sums.volume);
    stage.energy_j = static_cast<double>(sums.energy);
    stage.grinding_min = static_cast<double>(sums.time);
    stage.ground_mm = static_cast<double>(sums.ground);
    stage.largest_depth_mm = static_cast<double>(sums.a);
    stage.peak_normal_force_n = static_cast<double>(sums.P_y);
    stage.peak_power_w = static_cast<double>(sums.P_z * V_k);
    return stage;
}

void holdOverlaps(const Cycle& c, Result& result) {
    constexpr Real tolerance = 1e-9L;
    for (std::size_t z = 0; z < c.stages.size(); ++z) {
        const Real overlap = c.B * c.n / c.stages[z].axial_feed;
        Real least = 1;
        std::string name = "overlap";
        const bool strips = overlap < 1 - tolerance;
        if (!strips && c.least_overlap > 0) {
            name = "least_overlap";
            least = c.least_overlap;
        }
        const bool last = z + 1 == c.stages.size();
        if (!strips && last && c.least_overlap_last > 0 && c.least_overlap_last >= least) {
            name = "least_overlap_last";
            least = c.least_overlap_last;
        }
        result.practice.push_back({name, static_cast<int>(z) + 1, static_cast<double>(least),
                                   static_cast<double>(overlap),
                                   overlap >= least * (1 - tolerance)});
    }
}

void holdSteps(const Cycle& c, Result& result) {
    int fewest = -1;
    for (std::size_t z = 0; z < c.stages.size(); ++z) {
        const bool counts = c.stages[z].stock > 0 && c.stages[z].end != StageEnd::Count;
        if (counts && (fewest < 0 || result.passes_by_stage[z] < result.passes_by_stage[fewest])) {
            fewest = static_cast<int>(z);
        }
    }
    if (fewest >= 0 && c.least_steps > 0) {
        const auto steps = result.passes_by_stage[fewest];
        result.practice.push_back({"least_steps", fewest + 1, static_cast<double>(c.least_steps),
                                   static_cast<double>(steps), steps >= c.least_steps});
    }
}

} // namespace

long double depthOfCut(long double h, long double gamma, long double b, long double k_s,
                       long double k_r) {
    if (h <= 0) {
        return 0;
    }
    // The left side of the balance grows with a, is below h at a = 0 and not below h at a = h.
    long double low = 0;
    long double high = h;
    for (;;) {
        const long double a = low + (high - low) / 2;
        if (a <= low || a >= high) {
            return high; // no number lies between the two any more
        }
        const long double P_y = b * (k_s * a + k_r * std::sqrt(a));
        if (a + gamma * P_y < h) {
            low = a;
        } else {
            high = a;
        }
    }
}

Result simulate(const nlohmann::json& project) {
    Cycle c = readCycle(project);
    Result result;
    result.passes_by_stage.assign(c.stages.size(), 0);
    c.sums.resize(c.stages.size());
    run(c, result);
    if (c.traverse) {
        holdOverlaps(c, result);
    }
    holdSteps(c, result);
    for (const Sums& sums : c.sums) {
        result.stages.push_back(inDoubles(sums, c.V_k));
    }
    result.time_min = static_cast<double>(c.time);
    result.peak_normal_force_n = static_cast<double>(c.peak_P_y);
    result.peak_power_w = static_cast<double>(c.peak_P_z * c.V_k); // N · m/s
    for (const Body& body : c.bodies) {
        if (body.reported) {
            result.places.push_back(measured(c, body));
        }
    }
    return result;
}

} // namespace sparkout::reference
