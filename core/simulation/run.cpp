// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"

#include "core/process/coupled_sections.h"
#include "core/process/printed_form.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/simulation/plunge.h"
#include "core/simulation/simulate.h"
#include "core/simulation/traverse.h"
#include "core/units.h"
#include "core/version.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

/// Replaces a radius that is ground away, so that the form of such a part is defined.
constexpr double leastRadius_mm = 1e-3;

/// Diameters without an end in a gap; empty if there are no gaps.
std::vector<std::size_t> wholeDiameters(const Blank& blank) {
    const std::size_t half = blank.depth_mm.size() / 2;
    std::vector<std::size_t> whole;
    for (std::size_t k = 0; k < half; ++k) {
        if (!blank.isGap(k) && !blank.isGap(k + half)) {
            whole.push_back(k);
        }
    }
    return whole.size() < half ? whole : std::vector<std::size_t>();
}

/// c of every lane; null if the machine's form error is not given.
std::shared_ptr<const std::vector<double>> printedLanes(const Project& project,
                                                        std::size_t points) {
    const auto radii = static_cast<std::size_t>(project.part->radii_per_section);
    std::vector<std::vector<double>> ofPlace;
    bool prints = false;
    for (int place = 0; project.machine->form && place < placeCount(project); ++place) {
        ofPlace.push_back(printedDepths(project, static_cast<std::size_t>(place)));
        prints |= !ofPlace.back().empty();
        ofPlace.back().resize(radii);
    }
    if (!prints) {
        return nullptr;
    }
    auto all = std::make_shared<std::vector<double>>();
    for (std::size_t point = 0; point < points; ++point) {
        const std::vector<double>& own = ofPlace[placeOfPoint(project, point)];
        all->insert(all->end(), own.begin(), own.end());
    }
    return all;
}

/// Since a load is assumed to bear evenly on both sides of a steady rest, it may push a nearby
/// section towards the wheel, which then has no balance of its own.
bool isLifted(const CompliantPoint& point) {
    return point.gamma_mm_n < 0;
}

} // namespace

Run::Run(const Project& project, std::vector<CompliantPoint> points, Trajectory* trajectory,
         std::stop_token stop)
    : m_project(project)
    , m_isShaft(project.part->surface == Surface::external)
    , m_blank(makeBlank(*project.part))
    , m_sizeDepth_mm(m_blank.totalInfeed_mm + deeperAtSize_mm(project))
    , m_printed_mm(printedLanes(project, points.size()))
    , m_wave(wheelWave(project))
    , m_diameters(wholeDiameters(m_blank))
    , m_radii(project.part->radii_per_section)
    , m_points(std::move(points))
    , m_law(forceLaw(project))
    , m_lanes(m_points.size() * static_cast<std::size_t>(m_radii))
    , m_cutPass(widestPassFunction())
    , m_peakForces(m_points.size(), static_cast<std::size_t>(m_radii))
    , m_watch(project, m_blank)
    , m_trajectory(trajectory)
    , m_stop(std::move(stop))
    , m_wheelSpeed_m_s(project.machine->wheel_speed_m_s) {
    if (!isCoupled(project)) { // otherwise the contact is part of the coupled balance
        m_contact = wheelContact(project);
    }
    if (!isCoupled(project) && std::ranges::any_of(m_points, isLifted)) {
        m_result.status = RunStatus::notSolved;
    }
    if (m_law.threshold) {
        m_lanes.keepRubbing();
    }
    fed_mm = firstFeed(project, m_blank.totalInfeed_mm);
    const auto K = static_cast<std::size_t>(m_radii);
    for (std::size_t lane = 0; lane < m_lanes.depth_mm.size(); ++lane) {
        const std::size_t k = lane % K;
        m_lanes.depth_mm[lane] = m_blank.depthAt(placeOfPoint(project, lane / K))[k];
        m_lanes.share[lane] = static_cast<double>(k + 1) / m_radii;
    }
    if (m_wave) {
        m_wave->prepare(m_lanes, K);
    }
    m_watch.prepare(m_lanes);
    m_openDepth_mm = m_lanes.depth_mm;
    m_lengthBefore.assign(1, 0.0);
    for (const CompliantPoint& point : m_points) {
        m_lengthBefore.push_back(m_lengthBefore.back() + point.length_mm);
    }
    // finish() adds the project: without it, copies of the run, of which a search makes many, are
    // cheap.
    [[maybe_unused]] const Project none = std::move(m_result.project);
    m_result.timeByStage_s.assign(project.cycle->stages.size(), 0.0);
    m_result.sumsByStage.assign(project.cycle->stages.size(), {});
    if (m_trajectory) {
        m_trajectory->passes.clear(); // keeps the capacity reserved by the caller
        m_trajectory->visits.clear();
        m_trajectory->radii = m_radii;
    }
}

CutWidth Run::makeCut(double width_mm) const {
    CutWidth cut(m_lanes.depth_mm.size());
    setWidth(cut, width_mm);
    return cut;
}

void Run::setWidth(CutWidth& cut, double width_mm) const {
    cut.width_mm = width_mm;
    cut.bks = width_mm * m_law.ks;
    cut.bkr = width_mm * m_law.kr;
    const auto K = static_cast<std::size_t>(m_radii);
    for (std::size_t point = 0; point < m_points.size(); ++point) {
        cut.coefficients.set(point * K, m_points[point].gamma_mm_n, cut.bks, cut.bkr, K);
    }
}

PassFeed Run::withWave(PassFeed feed, double later_s) {
    if (m_wave) {
        const double turns = (m_result.time_s + later_s) * m_project.machine->work_speed_rpm
                             / units::secondsPerMinute;
        m_wave->put(wholeTurns(turns), feed, m_lanes, static_cast<std::size_t>(m_radii));
    }
    return feed;
}

void Run::cut(std::size_t first, std::size_t count, const CutWidth& width, const PassFeed& feed,
              const Place* places, const PassInfo& info) {
    const auto K = static_cast<std::size_t>(m_radii);
    const PassRange range{first * K, count * K, width.bks, width.bkr};
    if (m_keepsRadiiAlone) {
        places = nullptr;
    } else {
        m_peakForces.passBegins(m_lanes, range, first, count);
    }
    if (places) {
        openStage(static_cast<std::size_t>(places->stage - 1));
    }
    const double root = m_law.threshold ? cutLanes(width, feed, range)
                        : m_contact     ? m_contact->cut(m_lanes, width.coefficients, feed, range)
                                        : m_cutPass(m_lanes, width.coefficients, feed, range);
    m_result.visits += static_cast<long long>(range.count);
    m_largestRoot = std::max(m_largestRoot, root);
    if (!places) {
        return;
    }
    if (first >= m_firstCounted) {
        tally(root, first, count, width, places);
        m_watch.passDone(m_lanes, range, root, feed, places, first, count);
    }
    if (m_trajectory && (m_firstCounted == 0 || first < m_firstCounted)) {
        for (std::size_t i = 0; i < count; ++i) {
            record(first + i, width, feed, places[i], info);
        }
    }
}

/// A pass with a threshold.
double Run::cutLanes(const CutWidth& width, const PassFeed& feed, const PassRange& range) {
    return width.asGiven ? cutAsGiven(m_lanes, width.coefficients, feed, range)
           : m_contact   ? m_contact->cutWithThreshold(m_lanes, width.coefficients, feed, range)
                         : cutWithThreshold(m_lanes, width.coefficients, feed, range);
}

/// Collects the sums of this stage from the next pass on.
void Run::openStage(std::size_t stage) {
    if (stage != m_openStage) {
        closeStage();
        m_openStage = stage;
    }
}

/// Σa is the movement of the radii since the stage began; Σ√a (Σv with a threshold) was added up
/// lane by lane.
void Run::closeStage() {
    StageSums& sums = m_result.sumsByStage[m_openStage];
    const auto K = static_cast<std::size_t>(m_radii);
    for (std::size_t point = 0; point < m_points.size(); ++point) {
        double depth = 0;
        double root = 0;
        for (std::size_t lane = point * K; lane < (point + 1) * K; ++lane) {
            depth += m_lanes.depth_mm[lane] - m_openDepth_mm[lane];
            root += m_lanes.rootSum[lane];
        }
        sums.removed_mm2 += m_points[point].length_mm * depth / m_radii;
        sums.rootLength_mm15 += m_points[point].length_mm * root / m_radii;
    }
    m_openDepth_mm = m_lanes.depth_mm; // same length: copied in place
    std::fill(m_lanes.rootSum.begin(), m_lanes.rootSum.end(), 0.0);
}

void Run::tally(double root, std::size_t first, std::size_t count, const CutWidth& width,
                const Place* places) {
    StageSums& sums = m_result.sumsByStage[m_openStage];
    const double length = m_lengthBefore[first + count] - m_lengthBefore[first];
    sums.length_mm += length;
    keepPeaks(sums, root, first, count, width, places);
}

// Both forces rise with a at one width, so the pass's largest √a gives all three peaks; without a
// cut they rise with the rubbing share.
void Run::keepPeaks(StageSums& sums, double root, std::size_t first, std::size_t count,
                    const CutWidth& width, const Place* places) {
    const double depth = root * root;
    const auto K = static_cast<std::ptrdiff_t>(m_radii);
    const bool rubsAlone = m_law.threshold && !(root > 0);
    const std::vector<double>& lanes = rubsAlone ? m_lanes.rubbing : m_lanes.root;
    const auto begin = lanes.begin() + static_cast<std::ptrdiff_t>(first) * K;
    const double most =
        rubsAlone ? *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(count) * K) : root;
    const double normal =
        rubsAlone ? m_law.normalOfAll(width.width_mm, 0, most) : m_law.normal(width.width_mm, root);
    const double power = (rubsAlone ? m_law.tangentialOfAll(width.width_mm, 0, most)
                                    : m_law.tangential(width.width_mm, root))
                         * m_wheelSpeed_m_s;
    if (depth <= sums.depth_mm.value && normal <= sums.normalForce_n.value
        && power <= sums.power_w.value) {
        return;
    }
    const Place& place = places[(std::find(begin, lanes.end(), most) - begin) / K];
    const auto keep = [&place](Peak& peak, double value) {
        if (value > peak.value) {
            peak = {value, place};
        }
    };
    keep(sums.depth_mm, depth);
    keep(sums.normalForce_n, normal);
    keep(sums.power_w, power);
}

void Run::record(std::size_t point, const CutWidth& width, const PassFeed& feed, const Place& place,
                 const PassInfo& info) {
    Trajectory& trajectory = *m_trajectory;
    trajectory.passes.push_back({place, m_result.time_s, info.duration_s, width.width_mm,
                                 info.axialFeed_mm_min, info.radialFeed_mm,
                                 trajectory.visits.size()});
    const auto count = static_cast<std::size_t>(m_radii);
    const double duration_s = info.duration_s, width_mm = width.width_mm;
    const bool stroke = info.axialFeed_mm_min > 0;
    const double* const shares = m_lanes.share.data() + point * count;
    const double* const roots = m_lanes.root.data() + point * count;
    const double* const depths_mm = m_lanes.depth_mm.data() + point * count;
    const double* const blank_mm = m_blank.depthAt(placeOfPoint(m_project, point)).data();
    trajectory.visits.resize(trajectory.visits.size() + count);
    Visit* const visits = trajectory.visits.data() + trajectory.passes.back().firstVisit;
    const double* const rubbing =
        m_law.threshold ? m_lanes.rubbing.data() + point * count : nullptr;
    for (std::size_t k = 0; k < count; ++k) {
        const double share = shares[k], u = roots[k], depth_mm = depths_mm[k];
        visits[k] = {.time_s = m_result.time_s + duration_s * (stroke ? 1.0 : share),
                     .programmed_mm = feed.at(share),
                     .actual_mm = u * u,
                     .accumulated_mm = depth_mm - blank_mm[k],
                     .radius_mm = finalRadius(point * count + k),
                     .normalForce_n = rubbing ? m_law.normalOfAll(width_mm, u * u, rubbing[k])
                                              : m_law.normal(width_mm, u),
                     .printed_mm = m_printed_mm ? (*m_printed_mm)[point * count + k] : 0,
                     .wave_mm = m_lanes.waveAt(point * count + k, feed)};
    }
}

double Run::remaining(std::size_t point) const {
    const auto K = static_cast<std::size_t>(m_radii);
    std::vector<double> ofPart;
    for (std::size_t lane = point * K; m_printed_mm && lane < (point + 1) * K; ++lane) {
        ofPart.push_back(partDepth(lane));
    }
    const double* const depth_mm =
        m_printed_mm ? ofPart.data() : m_lanes.depth_mm.data() + point * K;
    const GaugeRule rule = m_project.gauge->rule;
    return m_diameters.empty()
               ? remainingStock(depth_mm, m_radii, rule, m_sizeDepth_mm)
               : remainingStock(depth_mm, m_radii, m_diameters, rule, m_sizeDepth_mm);
}

double Run::takeLargestRoot() {
    return std::exchange(m_largestRoot, 0.0);
}

bool Run::mustEnd() {
    if (m_stop.stop_requested()) {
        m_result.status = RunStatus::stopped;
        return true;
    }
    if (m_result.status == RunStatus::notSolved) {
        return true;
    }
    if (m_result.visits > maxVisits) {
        m_result.status = RunStatus::tooLong;
        return true;
    }
    return false;
}

SectionResult Run::sectionResult(std::size_t point, Zone zone) const {
    const auto K = static_cast<std::size_t>(m_radii);
    SectionResult section;
    section.zone = zone;
    section.position_mm = m_points[point].position_mm;
    section.compliance_mm_per_n = m_points[point].gamma_mm_n;
    section.radii_mm.reserve(K);
    for (std::size_t k = 0; k < K; ++k) {
        const double radius_mm = finalRadius(point * K + k);
        const bool isThere = radius_mm > leastRadius_mm || m_blank.isGap(k);
        section.radii_mm.push_back(isThere ? radius_mm : leastRadius_mm);
    }
    section.peakNormalForce_n = m_peakForces.of(m_lanes, point);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double radius : section.radii_mm) { // min and max ignore NaN, as in a gap
        low = std::min(low, radius);
        high = std::max(high, radius);
    }
    section.radialRunout_mm = high - low + addedRunout_um(*m_project.machine) / units::umPerMm;
    std::tie(section.diameterDeviationMin_mm, section.diameterDeviationMax_mm) =
        diameterDeviations(point);
    return section;
}

/// Gives each zone the worst of its sections.
void Run::foldZoneSections() {
    const std::size_t zones = m_result.sections.size();
    const std::size_t inZone = zones > 0 ? m_result.zoneSections.size() / zones : 0;
    for (std::size_t i = 0; i < m_result.zoneSections.size(); ++i) {
        const SectionResult& section = m_result.zoneSections[i];
        SectionResult& zone = m_result.sections[i / inZone];
        if (i % inZone == 0) {
            zone.diameterDeviationMin_mm = section.diameterDeviationMin_mm;
            zone.diameterDeviationMax_mm = section.diameterDeviationMax_mm;
            zone.radialRunout_mm = section.radialRunout_mm;
            zone.peakNormalForce_n = section.peakNormalForce_n;
            zone.lastCut = section.lastCut;
        }
        zone.diameterDeviationMin_mm =
            std::min(zone.diameterDeviationMin_mm, section.diameterDeviationMin_mm);
        zone.diameterDeviationMax_mm =
            std::max(zone.diameterDeviationMax_mm, section.diameterDeviationMax_mm);
        zone.radialRunout_mm = std::max(zone.radialRunout_mm, section.radialRunout_mm);
        zone.peakNormalForce_n = std::max(zone.peakNormalForce_n, section.peakNormalForce_n);
        if (section.lastCut
            && (!zone.lastCut || section.lastCut->depth_mm > zone.lastCut->depth_mm)) {
            zone.lastCut = section.lastCut;
        }
    }
}

std::pair<double, double> Run::diameterDeviations(std::size_t point) const {
    const auto K = static_cast<std::size_t>(m_radii);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    forDiameters([&](std::size_t k) {
        const std::size_t lane = point * K + k;
        const double deviation = diameterDeviation(partDepth(lane), partDepth(lane + K / 2));
        least = std::min(least, deviation);
        most = std::max(most, deviation);
    });
    return {least, most};
}

std::size_t Run::deepestLane(std::size_t point) const {
    const auto begin = m_lanes.depth_mm.begin() + static_cast<std::ptrdiff_t>(point) * m_radii;
    const auto reached = [](double a, double b) { // NaN in a gap
        return (a < beyondReach_mm ? a : -beyondReach_mm)
               < (b < beyondReach_mm ? b : -beyondReach_mm);
    };
    return static_cast<std::size_t>(std::max_element(begin, begin + m_radii, reached)
                                    - m_lanes.depth_mm.begin());
}

std::pair<std::size_t, std::size_t> Run::deepestDiameter() const {
    const auto K = static_cast<std::size_t>(m_radii);
    std::size_t deepest = 0;
    double most = -1; // lane 0 may be in a gap
    for (std::size_t point = 0; point < m_points.size(); ++point) {
        forDiameters([&](std::size_t k) {
            const std::size_t lane = point * K + k;
            const double both = m_lanes.depth_mm[lane] + m_lanes.depth_mm[lane + K / 2];
            if (both > most) {
                most = both;
                deepest = lane;
            }
        });
    }
    return {deepest, deepest + K / 2};
}

LaneBalance Run::balance(std::size_t point, double width_mm) const {
    return {m_points[point].gamma_mm_n, width_mm * m_law.ks, width_mm * m_law.kr, m_law.threshold};
}

void keepLargestPeaks(SimulationResult& result) {
    Peak force, power;
    for (const StageSums& sums : result.sumsByStage) {
        force = sums.normalForce_n.value > force.value ? sums.normalForce_n : force;
        power = sums.power_w.value > power.value ? sums.power_w : power;
    }
    result.peakNormalForce_n = force.value;
    result.peakNormalForceAt = force.at;
    result.peakPower_w = power.value;
    result.peakPowerAt = power.at;
}

SimulationResult Run::finish(const std::vector<int>& stepsByStage, std::size_t gaugePoint,
                             std::size_t reported, const std::vector<Zone>& zones) {
    m_result.project = m_project;
    m_result.project.runs.clear();
    m_result.engineVersion = version;
    closeStage();
    keepLargestPeaks(m_result);
    m_result.countsByStage = stepsByStage;
    for (const int count : m_result.countsByStage) {
        m_result.cycleCount += count;
    }
    for (std::size_t point = 0; point < reported; ++point) {
        m_result.sections.push_back(sectionResult(point, zones[std::min(point, zones.size() - 1)]));
    }
    for (std::size_t point = reported; m_firstCounted > 0 && point < m_points.size(); ++point) {
        const std::size_t inZone = (m_points.size() - reported) / reported;
        m_result.zoneSections.push_back(sectionResult(point, zones[(point - reported) / inZone]));
    }
    const auto isGone = [](const SectionResult& section) {
        return std::ranges::find(section.radii_mm, leastRadius_mm) != section.radii_mm.end();
    };
    if (m_result.status != RunStatus::stopped
        && (std::ranges::any_of(m_result.sections, isGone)
            || std::ranges::any_of(m_result.zoneSections, isGone))) {
        m_result.status = RunStatus::groundAway;
    }
    m_watch.put(m_result);
    foldZoneSections();
    m_result.remainingStock_mm = remaining(gaugePoint);
    const double side = m_isShaft ? 1 : -1;
    m_result.gaugeReading_mm = 2 * (m_blank.targetRadius_mm + side * m_result.remainingStock_mm);
    return std::move(m_result);
}

void addEvenLobes(SimulationResult& result, const std::stop_token& stop) {
    if (result.status != RunStatus::completed || !areLobesUnknown(*result.project.machine)) {
        return;
    }
    const SimulationResult even = simulateUnchecked(withEvenLobes(result.project), nullptr, stop);
    for (std::size_t i = 0; even.status == RunStatus::completed && i < even.sections.size(); ++i) {
        result.ifEven.push_back(
            {even.sections[i].diameterDeviationMin_mm, even.sections[i].diameterDeviationMax_mm});
    }
}

SimulationResult simulate(const Project& project, Trajectory* trajectory,
                          const std::stop_token& stop) {
    if (hasErrors(validate(project))) {
        SimulationResult result;
        result.project = project;
        result.project.runs.clear();
        result.engineVersion = version;
        result.status = RunStatus::refused;
        if (trajectory) {
            trajectory->radii = 0;
            trajectory->passes.clear();
            trajectory->visits.clear();
        }
        return result;
    }
    SimulationResult result = simulateUnchecked(project, trajectory, stop);
    addEvenLobes(result, stop);
    return result;
}

SimulationResult simulateUnchecked(const Project& project, Trajectory* trajectory,
                                   const std::stop_token& stop) {
    return project.operation.match(
        [&](Traverse) { return simulateTraverse(project, trajectory, stop); },
        [&](Plunge) { return simulatePlunge(project, trajectory, stop); });
}

} // namespace sparkout
