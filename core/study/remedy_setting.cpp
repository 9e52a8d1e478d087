// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/remedy_setting.h"

#include "core/process/profile.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/study/stage_edits.h"
#include "core/study/starting_project.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace sparkout {

namespace {

// For a decade: 1.00 to 1.99, then 2.0 to 9.9.
constexpr std::int64_t fineDivisor = 100, perDecade = 180;

/// Relative difference below which two values count as equal.
constexpr double lastBits = 1e-9;

/// The double nearest to m·10^exponent.
double decimal(std::int64_t m, std::int64_t exponent) {
    const double power = std::pow(10.0, static_cast<double>(std::abs(exponent)));
    const auto mantissa = static_cast<double>(m);
    return exponent < 0 ? mantissa / power : mantissa * power;
}

double slackAt(double value) {
    return lastBits * std::max(std::abs(value), 1e-9);
}

} // namespace

SettingScale SettingScale::steps(double base, double step) {
    return {Kind::steps, base, step};
}

SettingScale SettingScale::digits() {
    return {Kind::digits, 0, 0};
}

SettingScale SettingScale::revolutions(double speed_rpm) {
    return {Kind::revolutions, 0, units::secondsPerMinute / speed_rpm};
}

double SettingScale::at(std::int64_t place) const {
    if (m_kind == Kind::digits) {
        const std::int64_t rest = (place % perDecade + perDecade) % perDecade;
        const std::int64_t decade = (place - rest) / perDecade;
        return rest < fineDivisor ? decimal(fineDivisor + rest, decade - 2)
                                  : decimal(20 + rest - fineDivisor, decade - 1);
    }
    const double value = m_base + static_cast<double>(place) * m_step;
    const double decimals = m_kind == Kind::revolutions ? 1e3 : 1e10;
    return std::round(value * decimals) / decimals;
}

std::int64_t SettingScale::about(double value) const {
    if (m_kind != Kind::digits) {
        return std::llround((value - m_base) / m_step);
    }
    const double decade = std::floor(std::log10(value));
    const double leading = value / std::pow(10.0, decade);
    const double rest = leading < 2 ? (leading - 1) * 100 : 100 + (leading - 2) * 10;
    return static_cast<std::int64_t>(decade) * perDecade + std::llround(rest);
}

std::int64_t SettingScale::lastBelow(double value) const {
    std::int64_t place = about(value) + 1;
    while (at(place) >= value - slackAt(value)) {
        --place;
    }
    return place;
}

std::int64_t SettingScale::firstAbove(double value) const {
    std::int64_t place = about(value) - 1;
    while (at(place) <= value + slackAt(value)) {
        ++place;
    }
    return place;
}

namespace {

// Limits of a setting relative to its current value.
constexpr double slowestFeed = 1.0 / 20, fastestFeed = 10;
constexpr double slowestSpeed = 1.0 / 4, fastestSpeed = 4;
constexpr double mostStrokes = 64, mostRevolutions = 512;

/// Shares of the first stage's feed to try with the finishing stock.
constexpr std::array feedsWithStock{0.7, 0.5, 0.35};

/// Step of stocks [mm]; a tenth of it for two stages with little stock.
constexpr double stockStep_mm = 1e-3, littleStock_mm = 0.02;

/// Step of the target diameter [mm]: that of a gauge's setting.
constexpr double targetStep_mm = 1e-3;

constexpr std::string_view inStages = "/cycle/stages/";

std::string pathOfStage(std::size_t stage) {
    return std::string(inStages) + std::to_string(stage);
}

/// Takes the cycle and the machine settings of a starting cycle. These exclude the wheel speed,
/// which for a part of a batch may be that of a worn wheel.
Project withCycleOf(Project project, const Project& other) {
    project.cycle->stages = other.cycle->stages;
    Machine& machine = *project.machine;
    const Machine& from = *other.machine;
    machine.work_speed_rpm = from.work_speed_rpm;
    resolveWaves(project);
    if (!project.operation->travels) {
        return project;
    }
    machine.plunge_feed_mm_min = from.plunge_feed_mm_min;
    machine.overrun_entry_mm = from.overrun_entry_mm;
    machine.overrun_exit_mm = from.overrun_exit_mm;
    machine.dwell_entry_s = from.dwell_entry_s;
    machine.dwell_exit_s = from.dwell_exit_s;
    return project;
}

/// The machine's step, or a power of ten of it that is still fine for such a value.
double stepFor(double value, double step) {
    constexpr double fineEnough = 500;
    while (step * 10 * fineEnough <= std::abs(value)) {
        step *= 10;
    }
    return step;
}

/// Lists the settings of a project.
class SettingList {
public:
    explicit SettingList(const Project& project) : m_project(project) {}

    std::vector<RemedySetting> list() {
        const std::vector<Stage>& stages = m_project.cycle->stages;
        add({RemedyKind::startingCycle}, {1, 1}, SettingScale::steps(0, 1));
        for (std::size_t z = stages.size(); z-- > 0;) {
            addStage(z);
        }
        addStageMore();
        if (m_project.operation->travels) {
            addDwell(RemedyKind::dwellEntry, m_project.machine->dwell_entry_s);
            addDwell(RemedyKind::dwellExit, m_project.machine->dwell_exit_s);
            addRate({RemedyKind::plungeFeed, 0, 0, m_project.machine->plunge_feed_mm_min},
                    m_project.machine->limits.plunge_feed_mm_min, slowestFeed, fastestFeed);
        }
        addRate({RemedyKind::workSpeed, 0, 0, m_project.machine->work_speed_rpm},
                m_project.machine->limits.work_speed_rpm, slowestSpeed, fastestSpeed);
        addTarget();
        addPairs();
        return std::move(m_found);
    }

private:
    using Limits = std::optional<std::vector<double>>;

    struct Target {
        RemedyKind kind;
        std::size_t stage = 0, other = 0;
        double before = 0;
    };

    /// The usual part of the allowed range, extended to the current value.
    [[nodiscard]] Range rangeOf(const Target& target) const {
        const RemedySetting setting = with(target, SettingScale::digits());
        const ConstMember member = findMember(m_project, setting.rowPath(m_project));
        const Range& allowed = member.field->allowed(m_project, member.owner);
        const Range& usual = member.field->soft;
        return {std::max(allowed.low, std::min(usual.low, target.before)),
                std::min(allowed.high, std::max(usual.high, target.before))};
    }

    [[nodiscard]] static RemedySetting with(const Target& target, const SettingScale& scale) {
        return {target.kind, target.stage, target.other, target.before, 0, 0, scale};
    }

    void add(const Target& target, const Range& range, const SettingScale& scale) {
        RemedySetting setting = with(target, scale);
        setting.low = range.low;
        setting.high = range.high;
        if (setting.low <= setting.high) {
            m_found.push_back(setting);
        }
    }

    /// A feed or speed: between these shares of it, within the machine's range, in its steps.
    void addRate(const Target& target, const Limits& limits, double least, double most,
                 double highest = std::numeric_limits<double>::infinity()) {
        Range range = rangeOf(target);
        SettingScale scale = SettingScale::digits();
        double from = target.before;
        if (limits && limits->size() == 3) {
            constexpr double finest = 1e-8;
            const double low = (*limits)[0], high = (*limits)[1], step = (*limits)[2];
            from = std::clamp(from, low, high);
            range = {std::max(range.low, low), std::min(range.high, high)};
            if (step >= finest) {
                scale = SettingScale::steps(low, stepFor(from, step));
            }
        }
        range.low = std::max(range.low, from * least);
        range.high = std::min({range.high, from * most, highest});
        if (range.low > 0) {
            add(target, range, scale);
        }
    }

    void addStage(std::size_t z) {
        const Stage& stage = m_project.cycle->stages[z];
        const StageFeed& radial = m_project.operation->radial();
        if (stage.feeds() && (stage.*radial.value).value_or(0) > 0) { // not for a retraction
            addRate({RemedyKind::radialFeed, z, 0, *(stage.*radial.value)},
                    m_project.machine->limits.*radial.range, slowestFeed, fastestFeed);
        }
        if (const std::optional<int> steps = stage.sparkOutSteps()) {
            addCount({RemedyKind::sparkOut, z, 0, static_cast<double>(*steps)}, *steps);
        }
        if (const StageFeed* axial = m_project.operation->axial();
            axial && (stage.*axial->value).value_or(0) > 0) {
            addRate({RemedyKind::axialFeed, z, 0, *(stage.*axial->value)},
                    m_project.machine->limits.*axial->range, slowestFeed, fastestFeed);
        }
        if (z > 0) {
            addStock(z);
        }
    }

    /// Moves stock between the stage and the one before; a feeding stage keeps some.
    void addStock(std::size_t z) {
        const Stage& stage = m_project.cycle->stages[z];
        const double both_mm = stage.stock_mm + m_project.cycle->stages[z - 1].stock_mm;
        const double step_mm = both_mm > littleStock_mm ? stockStep_mm : stockStep_mm / 10;
        add({RemedyKind::stock, z, z - 1, stage.stock_mm},
            {stage.feeds() ? step_mm : 0, both_mm - step_mm}, SettingScale::steps(0, step_mm));
    }

    /// Adds the stock of the last feeding stage with slower feeds of the first: if the former is
    /// too little for the lag of the latter, neither may suffice alone.
    void addPairs() {
        const auto isOf = [](const RemedySetting& setting, RemedyKind kind, std::size_t stage) {
            return setting.kind == kind && setting.stage == stage;
        };
        std::size_t last = m_project.cycle->stages.size();
        while (last > 0 && !m_project.cycle->stages[last - 1].feeds()) {
            --last;
        }
        const auto stock = std::ranges::find_if(m_found, [&](const RemedySetting& each) {
            return last > 1 && isOf(each, RemedyKind::stock, last - 1);
        });
        const auto feed = std::ranges::find_if(m_found, [&](const RemedySetting& each) {
            return isOf(each, RemedyKind::radialFeed, 0);
        });
        if (stock == m_found.end() || feed == m_found.end()) {
            return;
        }
        RemedySetting pair = *stock;
        pair.kind = RemedyKind::stockWithFeed;
        pair.feedBefore = feed->before;
        std::vector<RemedySetting> pairs;
        for (const double share : feedsWithStock) {
            const SettingScale& scale = feed->scale;
            const double value = scale.at(scale.lastUpTo(share * feed->before));
            const bool isOther = pairs.empty() || pairs.back().feed != value;
            if (isOther && value >= feed->low && value < feed->before) {
                pairs.push_back(pair);
                pairs.back().feed = value;
            }
        }
        m_found.insert(m_found.end(), pairs.begin(), pairs.end());
    }

    void addCount(const Target& target, int present) {
        const double most = m_project.operation->travels ? mostStrokes : mostRevolutions;
        add(target, {1, most + present}, SettingScale::steps(0, 1));
    }

    void addDwell(RemedyKind kind, double dwell_s) {
        const Target target{kind, 0, 0, dwell_s};
        add(target, rangeOf(target), SettingScale::revolutions(m_project.machine->work_speed_rpm));
    }

    /// The target diameter, anywhere in the field: where sizes are off its middle, they follow it.
    void addTarget() {
        const Part& part = *m_project.part;
        constexpr double digits = 1e9; // removes binary rounding
        const double now_mm = std::round(2 * targetRadius(part) * digits) / digits;
        const auto limit_mm = [&part](double deviation_um) {
            return part.diameter_mm + deviation_um / units::umPerMm;
        };
        add({RemedyKind::targetDiameter, 0, 0, now_mm},
            {limit_mm(part.lower_deviation_um), limit_mm(part.upper_deviation_um)},
            SettingScale::steps(0, targetStep_mm));
    }

    void addStageMore() {
        const std::vector<Stage>& stages = m_project.cycle->stages;
        const StageFeed& radial = m_project.operation->radial();
        std::size_t last = stages.size();
        while (last > 0 && !stages[last - 1].feeds()) {
            --last;
        }
        const double feed = last > 0 ? (stages[last - 1].*radial.value).value_or(0) : 0;
        if (feed > 0 && stages[last - 1].stock_mm > 0) {
            addRate({RemedyKind::addFeed, last - 1, 0, feed},
                    m_project.machine->limits.*radial.range, slowestFeed, 1, feed);
        }
        if (last == stages.size()) {
            addCount({RemedyKind::addSparkOut, last - 1, 0, 0}, 0);
        }
    }

    const Project& m_project;
    std::vector<RemedySetting> m_found;
};

} // namespace

const char* remedyKindKey(RemedyKind kind) {
    return kind == RemedyKind::startingCycle   ? "starting_cycle"
           : kind == RemedyKind::stockWithFeed ? "pair"
                                               : "setting";
}

Project RemedySetting::applied(Project project, double value) const {
    auto& stages = project.cycle->stages;
    const StageFeed& radial = project.operation->radial();
    switch (kind) {
    case RemedyKind::radialFeed: stages[stage].*radial.value = value; break;
    case RemedyKind::axialFeed: stages[stage].*project.operation->axial()->value = value; break;
    case RemedyKind::stock: return withStock(std::move(project), stage, value, other);
    case RemedyKind::sparkOut: stages[stage].sparkOutFor(static_cast<int>(value)); break;
    case RemedyKind::dwellEntry: project.machine->dwell_entry_s = value; break;
    case RemedyKind::dwellExit: project.machine->dwell_exit_s = value; break;
    case RemedyKind::workSpeed:
        project.machine->work_speed_rpm = value;
        resolveWaves(project);
        break;
    case RemedyKind::plungeFeed: project.machine->plunge_feed_mm_min = value; break;
    case RemedyKind::targetDiameter: project.part->target_diameter_mm = value; break;
    case RemedyKind::addFeed:
        project = withStageAfter(std::move(project), stage);
        project.cycle->stages[stage + 1].*radial.value = value;
        break;
    case RemedyKind::addSparkOut:
        return withSparkOutAfter(std::move(project), static_cast<int>(value));
    case RemedyKind::stockWithFeed:
        stages.front().*radial.value = feed;
        return withStock(std::move(project), stage, value, other);
    case RemedyKind::startingCycle: {
        if (made) {
            return withCycleOf(std::move(project), *made);
        }
        // requirements do not change
        const Project changed = withCycleOf(project, withStartingCycle(project));
        return hasErrors(validate(changed)) ? project : changed;
    }
    }
    return project;
}

void RemedySetting::make(const Project& project) {
    if (isWholeCycle()) {
        made = std::make_shared<const Project>(applied(project, 1));
    }
}

std::string RemedySetting::path(const Project& project) const {
    return addsStage()      ? pathOfStage(stage + 1)
           : isWholeCycle() ? pathOfStage(0)
                            : rowPath(project);
}

std::string RemedySetting::rowPath(const Project& project) const {
    const std::string inStage = pathOfStage(stage) + '/';
    switch (kind) {
    case RemedyKind::radialFeed:
    case RemedyKind::addFeed: return inStage + project.operation->radial().key;
    case RemedyKind::axialFeed: return inStage + project.operation->axial()->key;
    case RemedyKind::stock:
    case RemedyKind::stockWithFeed:
    case RemedyKind::startingCycle: return inStage + "stock_mm";
    case RemedyKind::sparkOut:
    case RemedyKind::addSparkOut: return inStage + Stage::sparkOutKey;
    case RemedyKind::dwellEntry: return "/machine/dwell_entry_s";
    case RemedyKind::dwellExit: return "/machine/dwell_exit_s";
    case RemedyKind::workSpeed: return "/machine/work_speed_rpm";
    case RemedyKind::plungeFeed: return "/machine/plunge_feed_mm_min";
    case RemedyKind::targetDiameter: return "/part/target_diameter_mm";
    }
    return {};
}

std::string RemedySetting::pathAfter(const std::string& path) const {
    if (!addsStage() || !path.starts_with(inStages)) {
        return path;
    }
    std::size_t number = 0;
    const char* const end = path.data() + path.size();
    const auto [rest, error] = std::from_chars(path.data() + inStages.size(), end, number);
    return error != std::errc{} || number <= stage
               ? path
               : pathOfStage(number + 1) + std::string(rest, end);
}

std::vector<RemedySetting> remedySettings(const Project& project) {
    return SettingList(project).list();
}

} // namespace sparkout
