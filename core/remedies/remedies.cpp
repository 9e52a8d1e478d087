// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remedies/remedies.h"

#include "core/project/validate.h"
#include "core/quality/light.h"
#include "core/remedies/remedy_trials.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace sparkout {

namespace {

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
    /// The next distance to try, half as far again as the last one and at most the end; nothing
    /// beyond the end.
    [[nodiscard]] std::optional<std::int64_t> next() const {
        return m_last < m_count
                   ? std::optional(std::min(std::max(m_last + m_last / 2, m_last + 1), m_count))
                   : std::nullopt;
    }
    void tried(std::int64_t k) { m_last = k; }
    void end() { m_last = m_count; }
    [[nodiscard]] std::int64_t last() const { return m_last; }

private:
    const RemedySetting& m_setting;
    std::int64_t m_sign, m_start = 0, m_count = 0, m_last = 0;
};

/// Faults and warnings that a change brings.
bool bringsIssues(const Project& before, const Project& after) {
    const Issues known = validate(before);
    return std::ranges::any_of(validate(after), [&](const Issue& issue) {
        return std::ranges::none_of(known, [&](const Issue& other) {
            return other.code == issue.code && other.path == issue.path;
        });
    });
}

class RemedySearch {
public:
    RemedySearch(const SimulationResult& result, const std::vector<ConstraintResult>& constraints,
                 const RemedyOptions& options)
        : m_project(result.project)
        , m_time_s(result.time_s)
        , m_options(options)
        , m_trials(result, constraints, options) {
        m_found.goal = remedyGoal(result, constraints);
    }

    RemedyResult run() {
        if (m_found.goal == RemedyGoal::none) {
            return std::move(m_found);
        }
        const std::vector<RemedySetting> settings = remedySettings(m_project);
        m_found.settings = settings.size();
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
            m_found.conflict = m_trials.conflict();
        }
        return std::move(m_found);
    }

private:
    /// The nearer of both ways; at the same distance the quicker cycle.
    std::optional<Remedy> remedyOf(const RemedySetting& setting) {
        std::array ways{SettingWay(setting, false), SettingWay(setting, true)};
        std::optional<Remedy> best;
        while (!best && !m_trials.isOver() && (ways[0].next() || ways[1].next())) {
            for (SettingWay& way : ways) {
                const std::optional<std::int64_t> k = way.next();
                if (!k) {
                    continue;
                }
                std::optional<RemedyTrial> trial = m_trials.run(setting, way.value(*k));
                if (!trial) {
                    return best;
                }
                if (!trial->holds) {
                    way.tried(*k);
                    continue;
                }
                std::optional<Remedy> remedy = refined(setting, way, *k, *std::move(trial));
                if (remedy && (!best || remedy->time_s < best->time_s)) {
                    best = std::move(remedy);
                }
                way.end(); // farther on every edge is one from a value that holds
            }
        }
        return best;
    }

    /// The edge between the last distance tried and this one, which holds. Nothing when it was
    /// stopped, or what is found is no better for its new faults or warnings.
    std::optional<Remedy> refined(const RemedySetting& setting, const SettingWay& way,
                                  std::int64_t far, RemedyTrial trial) {
        std::int64_t fails = way.last(), holds = far;
        while (holds - fails > 1) {
            const std::int64_t middle = fails + (holds - fails) / 2;
            std::optional<RemedyTrial> found = m_trials.run(setting, way.value(middle));
            if (!found) {
                return {};
            }
            if (found->holds) {
                holds = middle;
                trial = *std::move(found);
            } else {
                fails = middle;
            }
        }
        Remedy remedy{setting};
        remedy.value = way.value(holds);
        if (bringsIssues(m_project, remedy.applied(m_project))) {
            return {};
        }
        bool holdsAsItIs =
            false; // a stage more is run with the value that leaves all as it is, too
        if (fails == 0 && setting.kind == RemedyKind::addFeed) {
            const std::optional<RemedyTrial> unchanged = m_trials.run(setting, setting.before);
            if (!unchanged) {
                return {};
            }
            holdsAsItIs = unchanged->holds;
        }
        remedy.failing = holdsAsItIs ? std::nullopt : std::optional(way.value(fails));
        remedy.holdsBeyond = holds < far;
        if (SettingWay beyond = way; !remedy.holdsBeyond) {
            beyond.tried(holds);
            if (const std::optional<std::int64_t> next = beyond.next()) {
                const std::optional<RemedyTrial> farther = m_trials.run(setting, way.value(*next));
                if (!farther) {
                    return {};
                }
                remedy.holdsBeyond = farther->holds;
            }
        }
        remedy.time_s = trial.time_s;
        remedy.timeChange_s = trial.time_s - m_time_s;
        remedy.requirements = std::move(trial.worst);
        return remedy;
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
    double m_time_s;
    const RemedyOptions& m_options;
    RemedyTrials m_trials;
    RemedyResult m_found;
};

} // namespace

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
