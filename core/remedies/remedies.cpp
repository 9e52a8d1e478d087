// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remedies/remedies.h"

#include "core/project/validate.h"
#include "core/quality/light.h"
#include "core/remedies/remedy_trials.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace sparkout {

namespace {

/// So many values are tried one by one.
constexpr std::int64_t fewValues = 24;

/// One way from the present value: its k-th value is k places off; at 0 nothing is changed.
class SettingWay {
public:
    SettingWay(const RemedySetting& setting, bool upwards)
        : m_setting(setting), m_sign(upwards ? 1 : -1) {
        const SettingScale& scale = setting.scale;
        const std::int64_t low = scale.firstFrom(setting.low), high = scale.lastUpTo(setting.high);
        m_start = upwards ? std::max(scale.firstAbove(setting.before), low)
                          : std::min(scale.lastBelow(setting.before), high);
        m_count = upwards ? high - m_start + 1 : m_start - low + 1;
    }

    [[nodiscard]] double value(std::int64_t k) const {
        return k == 0 ? m_setting.before : m_setting.scale.at(m_start + m_sign * (k - 1));
    }
    /// The next distance to try; nothing beyond the end. Where there are few values each is tried,
    /// and of a count the nearest ones: a cycle may hold within a narrow range alone. Farther off
    /// it is half as far again as the last one and at most the end.
    [[nodiscard]] std::optional<std::int64_t> next() const {
        if (m_last >= m_count) {
            return {};
        }
        const bool each = m_count <= fewValues || (m_setting.isCount() && m_last < fewValues);
        return each ? m_last + 1 : std::min(std::max(m_last + m_last / 2, m_last + 1), m_count);
    }
    void tried(std::int64_t k, bool fails) {
        m_last = k;
        m_lastFails = fails;
    }
    void end() { m_last = m_count; }
    [[nodiscard]] std::int64_t last() const { return m_last; }
    [[nodiscard]] bool lastFails() const { return m_lastFails; }

private:
    const RemedySetting& m_setting;
    std::int64_t m_sign, m_start = 0, m_count = 0, m_last = 0;
    bool m_lastFails = true;
};

class RemedySearch {
public:
    RemedySearch(const SimulationResult& result, const std::vector<ConstraintResult>& constraints,
                 const RemedyOptions& options)
        : m_project(result.project), m_options(options), m_trials(result, constraints, options) {
        m_found.goal = remedyGoal(result, constraints);
        if (result.status == RunStatus::completed) {
            m_time_s = result.time_s;
        }
    }

    RemedyResult run() {
        if (m_found.goal == RemedyGoal::none) {
            return std::move(m_found);
        }
        const std::vector<RemedySetting> settings = remedySettings(m_project);
        m_found.settings = settings.size();
        m_issues = validate(m_project);
        for (const RemedySetting& setting : settings) {
            if (std::optional<Remedy> remedy = remedyOf(setting)) {
                keep(*std::move(remedy));
            }
            m_found.runs = m_trials.runs();
            if (m_trials.isOver()) {
                m_found.stopped = m_trials.isStopped();
                m_found.outOfTime = !m_found.stopped;
                return std::move(m_found);
            }
            ++m_found.tried;
            if (m_options.progress) {
                m_options.progress(m_found);
            }
        }
        if (m_found.found == 0) {
            m_found.conflict = conflict();
        }
        return std::move(m_found);
    }

private:
    /// Faults and warnings that a change brings.
    [[nodiscard]] bool bringsIssues(const RemedySetting& setting, double value) const {
        return std::ranges::any_of(
            validate(setting.applied(m_project, value)), [&](const Issue& issue) {
                return std::ranges::none_of(m_issues, [&](const Issue& known) {
                    return known.code == issue.code && setting.pathAfter(known.path) == issue.path;
                });
            });
    }

    /// A cycle that holds is offered unless its setting brings a fault or warning.
    [[nodiscard]] bool isOffered(const RemedySetting& setting, double value,
                                 const RemedyTrial& trial) {
        if (!trial.holds) {
            return false;
        }
        const bool warned = bringsIssues(setting, value);
        if (warned && !m_warned) {
            m_warned.emplace(setting, value);
        }
        return !warned;
    }

    [[nodiscard]] RemedyConflict conflict() const {
        RemedyConflict found = m_trials.conflict();
        if (m_warned) {
            found.kind = RemedyConflict::Kind::warned;
            found.second.reset();
            found.setting = m_warned->first;
            found.value = m_warned->second;
        }
        return found;
    }

    /// The nearer of both ways, as far as they were tried; at the same distance the quicker cycle.
    std::optional<Remedy> remedyOf(const RemedySetting& setting) {
        std::array ways{SettingWay(setting, false), SettingWay(setting, true)};
        std::optional<Remedy> best;
        while (!best && !m_trials.isOver()) {
            const std::optional<std::int64_t> k = nearest(ways[0].next(), ways[1].next());
            if (!k) {
                break;
            }
            for (SettingWay& way : ways) {
                if (way.next() != k) {
                    continue;
                }
                std::optional<RemedyTrial> trial = m_trials.run(setting, way.value(*k));
                if (!trial) {
                    return best;
                }
                if (!isOffered(setting, way.value(*k), *trial)) {
                    way.tried(*k, !trial->holds);
                    continue;
                }
                std::optional<Remedy> remedy = refined(setting, way, *k, *std::move(trial));
                if (!remedy) { // refused on stocks drawn for it; farther ones may hold
                    way.tried(*k, true);
                    continue;
                }
                if (!best || remedy->time_s < best->time_s) {
                    best = std::move(remedy);
                }
                way.end(); // farther on every edge is one from a value that holds
            }
        }
        return best;
    }

    [[nodiscard]] static std::optional<std::int64_t> nearest(std::optional<std::int64_t> a,
                                                             std::optional<std::int64_t> b) {
        return a && b ? std::min(a, b) : a ? a : b;
    }

    /// The edge between the last distance tried and this one, which is offered. Nothing when it was
    /// stopped.
    std::optional<Remedy> refined(const RemedySetting& setting, const SettingWay& way,
                                  std::int64_t far, RemedyTrial trial) {
        std::int64_t near = way.last(), offered = far;
        bool nearFails = way.lastFails();
        while (offered - near > 1) {
            const std::int64_t middle = near + (offered - near) / 2;
            std::optional<RemedyTrial> found = m_trials.run(setting, way.value(middle));
            if (!found) {
                return {};
            }
            if (isOffered(setting, way.value(middle), *found)) {
                offered = middle;
                trial = *std::move(found);
            } else {
                near = middle;
                nearFails = !found->holds;
            }
        }
        Remedy remedy{setting};
        remedy.value = way.value(offered);
        if (near == 0 && setting.kind == RemedyKind::addFeed) { // run with the present feed, too
            const std::optional<RemedyTrial> unchanged = m_trials.run(setting, setting.before);
            if (!unchanged) {
                return {};
            }
            nearFails = !unchanged->holds;
        }
        remedy.failing = nearFails ? std::optional(way.value(near)) : std::nullopt;
        remedy.holdsBeyond = offered < far;
        if (SettingWay beyond = way; !remedy.holdsBeyond) {
            beyond.tried(offered, false);
            if (const std::optional<std::int64_t> next = beyond.next()) {
                const double value = way.value(*next);
                const std::optional<RemedyTrial> farther = m_trials.run(setting, value);
                if (!farther) {
                    return {};
                }
                remedy.holdsBeyond = isOffered(setting, value, *farther);
            }
        }
        remedy.time_s = trial.time_s;
        if (m_time_s) {
            remedy.timeChange_s = trial.time_s - *m_time_s;
        }
        remedy.requirements = std::move(trial.worst);
        return m_trials.confirm(remedy) ? std::optional(std::move(remedy)) : std::nullopt;
    }

    void keep(Remedy remedy) {
        ++m_found.found;
        auto& all = m_found.remedies;
        const auto after = std::ranges::upper_bound(all, remedy.time_s, {}, &Remedy::time_s);
        all.insert(after, std::move(remedy));
        if (all.size() > RemedyResult::most) {
            all.pop_back();
        }
    }

    const Project& m_project;
    std::optional<double> m_time_s; ///< nothing: the cycle does not end by itself
    Issues m_issues;                ///< as it is
    const RemedyOptions& m_options;
    RemedyTrials m_trials;
    std::optional<std::pair<RemedySetting, double>> m_warned; ///< the first that brings a warning
    RemedyResult m_found;
};

} // namespace

const char* goalKey(RemedyGoal goal) {
    constexpr std::array keys{"none", "holds", "room"};
    return keys[static_cast<std::size_t>(goal)];
}

const char* conflictKey(RemedyConflict::Kind kind) {
    constexpr std::array keys{"stocks", "warned", "idle", "opposed", "several", "unmended"};
    return keys[static_cast<std::size_t>(kind)];
}

RemedyGoal remedyGoal(const SimulationResult& result,
                      const std::vector<ConstraintResult>& constraints) {
    if (result.status == RunStatus::refused || result.status == RunStatus::stopped) {
        return RemedyGoal::none;
    }
    if (result.status != RunStatus::completed
        || !std::ranges::all_of(constraints, &ConstraintResult::holds)) {
        return RemedyGoal::holds;
    }
    return std::ranges::any_of(constraints, isClose) ? RemedyGoal::room : RemedyGoal::none;
}

RemedyResult findRemedies(const SimulationResult& result,
                          const std::vector<ConstraintResult>& constraints,
                          const RemedyOptions& options) {
    return RemedySearch(result, constraints, options).run();
}

} // namespace sparkout
