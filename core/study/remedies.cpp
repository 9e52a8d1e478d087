// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/remedies.h"

#include "core/file/output_json.h"
#include "core/file/project_file.h"
#include "core/phases/sampled_phases.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/quality/verdict.h"
#include "core/statistics/intervals.h"
#include "core/study/remedy_trials.h"
#include "core/units.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

/// Omitted for a starting cycle, which the patch contains.
template <class Value>
std::optional<Value> ofSetting(const Remedy& remedy, const Value& value) {
    return remedy.setting.isWholeCycle() ? std::nullopt : std::optional(value);
}

constexpr Output<RemedyOf> remedyRows[] = {
    {{.key = "kind",
      .hint = "setting; pair, the stock of finishing with a feed of the first stage; or "
              "starting_cycle"},
     [](const RemedyOf& r) { return std::string(remedyKindKey(r.remedy.setting.kind)); }},
    {{.key = "path",
      .hint = "JSON pointer of the input; of a stage more, the stage; of a starting cycle, its "
              "first stage"},
     [](const RemedyOf& r) { return r.remedy.setting.path(r.project); }},
    {{.key = "before", .hint = "current value; none for one more stage or a starting cycle"},
     [](const RemedyOf& r) { return r.remedy.before(); }},
    {{.key = "value",
      .hint = "value to apply: the middle of the interval; none for a starting cycle"},
     [](const RemedyOf& r) { return ofSetting(r.remedy, r.remedy.value); }},
    {{.key = "with_value",
      .hint = "of a pair: the radial feed of the first stage that goes with it"},
     [](const RemedyOf& r) {
         const RemedySetting& setting = r.remedy.setting;
         return setting.isPair() ? std::optional(setting.feed) : std::nullopt;
     }},
    {{.key = "interval",
      .hint = "every value in it that can be set was run and helps; none for a starting cycle"},
     [](const RemedyOf& r) { return ofSetting(r.remedy, r.remedy.interval); }},
    {{.key = "values", .hint = "number of the values in the interval"},
     [](const RemedyOf& r) { return std::int64_t{r.remedy.values}; }},
    {{.key = "failing",
      .hint =
          "the next value towards the current one before the interval, which was run and fails"},
     [](const RemedyOf& r) { return r.remedy.failing; }},
    {{.key = "holds_beyond", .hint = "whether the next value behind the interval helps, too"},
     [](const RemedyOf& r) { return r.remedy.holdsBeyond; }},
    {{.key = "time_min", .unit = "min", .hint = "time of the cycle"},
     [](const RemedyOf& r) { return r.remedy.time_s / units::secondsPerMinute; }},
    {{.key = "time_change_min",
      .unit = "min",
      .hint = "time of the cycle minus that of the unchanged cycle; none if that one does not end "
              "by itself"},
     [](const RemedyOf& r) {
         const std::optional<double>& change_s = r.remedy.timeChange_s;
         return change_s ? std::optional(*change_s / units::secondsPerMinute) : std::nullopt;
     }},
    {{.key = "stock_mm",
      .unit = "mm",
      .hint = "stocks per side for each of which the cycle is fit; none under position control, "
              "where stocks are drawn at random"},
     [](const RemedyOf& r) {
         const std::optional<StockRange>& stocks = r.remedy.stocks;
         return stocks ? std::optional(Interval{stocks->from_mm, stocks->to_mm}) : std::nullopt;
     }},
    {{.key = "rank",
      .hint = "cost by which remedies are ordered: the change of time as a share of the time, and "
              "the change of the setting"},
     [](const RemedyOf& r) { return r.remedy.rank; }},
};

constexpr Output<Remedy> phasesRows[] = {
    {{.key = "tried", .hint = "number of random stocks for which the cycle is fit"},
     [](const Remedy& r) { return std::int64_t{r.phases}; }},
    {{.key = "candidate",
      .hint = "number of the remedy among the changes that were tried on such, from 1"},
     [](const Remedy& r) { return std::int64_t{r.candidate}; }},
    {{.key = "failing_share_at_most",
      .hint = "upper bound of the share of stocks for which the cycle is unfit"},
     [](const Remedy& r) { return mostFailing(r.phases, r.candidate); }},
    {{.key = "confidence", .hint = "confidence of that share"}, [](const Remedy&) { return 0.95; }},
};

constexpr Output<RemedyBatch> batchRows[] = {
    {{.key = "parts", .hint = "parts of the batch drawn at random for the remedy"},
     [](const RemedyBatch& b) { return b.parts; }},
    {{.key = "bad", .hint = "rejected parts among them"},
     [](const RemedyBatch& b) { return b.bad; }},
    {{.key = "candidate",
      .hint = "number of the remedy among the changes that were tried on such, from 1"},
     [](const RemedyBatch& b) { return std::int64_t{b.candidate}; }},
    {{.key = "bad_share_at_most", .hint = "upper bound of the share of rejected parts"}, mostBad},
    {{.key = "confidence", .hint = "confidence of that share"},
     [](const RemedyBatch&) { return 0.95; }},
};

std::optional<std::string> nameOf(const std::optional<ConstraintResult>& requirement) {
    return requirement ? std::optional<std::string>(requirementOf(requirement->kind).key)
                       : std::nullopt;
}

constexpr Output<RemedyConflictOf> conflictRows[] = {
    {{.key = "kind", .hint = "narrow, batch, stocks, warned, idle, opposed, several or unmended"},
     [](const RemedyConflictOf& c) { return std::string(conflictKey(c.conflict.kind)); }},
    {{.key = "first",
      .hint = "requirement violated most; none if the cycle does not end by itself"},
     [](const RemedyConflictOf& c) { return nameOf(c.conflict.first); }},
    {{.key = "second", .hint = "requirement not met with the setting"},
     [](const RemedyConflictOf& c) { return nameOf(c.conflict.second); }},
    {{.key = "path", .hint = "JSON pointer of the setting that comes nearest"},
     [](const RemedyConflictOf& c) {
         const std::optional<RemedySetting>& setting = c.conflict.setting;
         return setting ? std::optional(setting->path(c.project)) : std::nullopt;
     }},
    {{.key = "value", .hint = "value of that setting"},
     [](const RemedyConflictOf& c) {
         return c.conflict.setting ? std::optional(c.conflict.value) : std::nullopt;
     }},
    {{.key = "stock_mm",
      .unit = "mm",
      .hint =
          "stock per side for which the cycle is unfit with it; none unless the kind is stocks"},
     [](const RemedyConflictOf& c) {
         return c.conflict.kind == RemedyConflict::Kind::stocks ? std::optional(c.conflict.stock_mm)
                                                                : std::nullopt;
     }},
};

constexpr Output<RemedyResult> resultRows[] = {
    {{.key = "goal", .hint = "holds, room or none"},
     [](const RemedyResult& r) { return std::string(goalKey(r.goal)); }},
    {{.key = "fault",
      .hint = "fault of the unchanged project: part (as stated), stocks (another stock within one "
              "infeed), batch (too many rejected parts) or none"},
     [](const RemedyResult& r) { return std::string(faultKey(r.fault)); }},
    {{.key = "status", .hint = "completed or stopped"},
     [](const RemedyResult& r) { return std::string(r.isComplete() ? "completed" : "stopped"); }},
    {{.key = "settings", .hint = "settings to try"},
     [](const RemedyResult& r) { return std::int64_t(r.settings); }},
    {{.key = "tried", .hint = "settings that were tried"},
     [](const RemedyResult& r) { return std::int64_t(r.tried); }},
    {{.key = "runs", .hint = "cycles that were run"},
     [](const RemedyResult& r) { return std::int64_t{r.runs}; }},
    {{.key = "found", .hint = "settings that help"},
     [](const RemedyResult& r) { return std::int64_t(r.found); }},
};

/// The change of the project file by RFC 6902.
ordered_json patchOf(const Project& before, const Project& after) {
    return ordered_json::parse(nlohmann::json::diff(nlohmann::json::parse(writeProject(before)),
                                                    nlohmann::json::parse(writeProject(after)))
                                   .dump());
}

ordered_json remedyJson(const Project& project, const Remedy& remedy) {
    ordered_json json = outputsJson(remedyOutputs(), RemedyOf{project, remedy});
    json["phases"] =
        outputsJson(remedyPhasesOutputs(), remedy.stocks ? std::nullopt : std::optional(remedy));
    json["batch"] = outputsJson(remedyBatchOutputs(), remedy.batch);
    json["patch"] = patchOf(project, remedy.applied(project));
    json["requirements"] = outputsJsonOfEach(requirementOutputs(), remedy.requirements);
    return json;
}

} // namespace

std::span<const Output<RemedyOf>> remedyOutputs() {
    return remedyRows;
}

std::span<const Output<Remedy>> remedyPhasesOutputs() {
    return phasesRows;
}

std::span<const Output<RemedyBatch>> remedyBatchOutputs() {
    return batchRows;
}

std::span<const Output<RemedyConflictOf>> remedyConflictOutputs() {
    return conflictRows;
}

std::span<const Output<RemedyResult>> remedyResultOutputs() {
    return resultRows;
}

std::string remediesJson(const Project& project, const RemedyResult& found) {
    ordered_json json = outputsJson(remedyResultOutputs(), found);
    json["remedies"] = ordered_json::array();
    for (const Remedy& remedy : found.remedies) {
        json["remedies"].push_back(remedyJson(project, remedy));
    }
    json["conflict"] = found.conflict ? outputsJson(remedyConflictOutputs(),
                                                    RemedyConflictOf{project, *found.conflict})
                                      : ordered_json();
    return json.dump(2) + '\n';
}

namespace {

/// Up to this number of values all are tried.
constexpr std::int64_t fewValues = 24;

/// A value that was run.
struct TriedValue {
    RemedyTrial trial;
    bool isOffered = false; ///< it is good, and adds no fault or warning
};

/// One direction from the current value: its k-th value is k places away; 0 changes nothing.
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
    /// The next distance to try; empty beyond the end. If there are few values, and near the
    /// current one of a count, each is tried, since only a narrow range may be good. Farther away
    /// each distance is half as far again as the last one, up to the end.
    [[nodiscard]] std::optional<std::int64_t> next() const {
        if (m_last >= m_count) {
            return {};
        }
        const bool each = m_count <= fewValues || (m_setting.isCount() && m_last < fewValues);
        return each ? m_last + 1 : std::min(std::max(m_last + m_last / 2, m_last + 1), m_count);
    }
    /// Continues after this one.
    void pass(std::int64_t k) { m_last = std::max(m_last, k); }
    void end() { m_last = m_count; }
    [[nodiscard]] std::int64_t last() const { return m_last; }
    [[nodiscard]] std::int64_t count() const { return m_count; }

    [[nodiscard]] const TriedValue* known(std::int64_t k) const {
        const auto found = m_known.find(k);
        return found == m_known.end() ? nullptr : &found->second;
    }
    const TriedValue* keep(std::int64_t k, TriedValue value) {
        return &m_known.insert_or_assign(k, std::move(value)).first->second;
    }

private:
    const RemedySetting& m_setting;
    std::int64_t m_sign, m_start = 0, m_count = 0, m_last = 0;
    std::map<std::int64_t, TriedValue> m_known; ///< by distance
};

/// Adjacent values in a direction, all of which are offered.
struct ValueRun {
    std::int64_t first = 0, last = 0; ///< distances
    [[nodiscard]] std::int64_t count() const { return last - first + 1; }
    [[nodiscard]] std::int64_t middle() const { return first + count() / 2; }
};

/// The relative change of a setting.
double changeOf(const Remedy& remedy) {
    constexpr double newOne = 0.3, ofCount = 0.1, ofRatio = 0.5;
    constexpr double newCycle = 0.6;
    const RemedySetting& setting = remedy.setting;
    if (setting.isWholeCycle()) {
        return newCycle;
    }
    if (setting.addsStage()) {
        return newOne;
    }
    if (setting.isCount() || setting.isDwell()) {
        const std::int64_t places =
            setting.scale.firstFrom(remedy.value) - setting.scale.firstFrom(setting.before);
        return ofCount * std::abs(static_cast<double>(places));
    }
    if (setting.kind == RemedyKind::targetDiameter) { // the field is its range
        return std::abs(remedy.value - setting.before) / (setting.high - setting.low);
    }
    const double own = setting.before > 0 && remedy.value > 0
                           ? ofRatio * std::abs(std::log(remedy.value / setting.before))
                           : newOne;
    return setting.isPair() ? own + ofRatio * std::abs(std::log(setting.feed / setting.feedBefore))
                            : own;
}

class RemedySearch {
public:
    RemedySearch(const SimulationResult& result, const std::vector<ConstraintResult>& constraints,
                 const RemedyOptions& options)
        : m_project(result.project), m_options(options), m_trials(result, constraints, options) {
        m_found.goal = remedyGoal(result, constraints);
        m_isRun = result.status != RunStatus::refused && result.status != RunStatus::stopped;
        if (result.status == RunStatus::completed) {
            m_time_s = result.time_s;
        }
    }

    RemedyResult run() {
        if (!m_isRun) {
            return std::move(m_found);
        }
        const std::optional<RemedyFault> fault = m_trials.fault();
        m_found.fault = fault.value_or(RemedyFault::none);
        if (m_found.fault != RemedyFault::none) {
            m_found.goal = RemedyGoal::holds;
        }
        if (fault && m_found.goal == RemedyGoal::none) {
            return std::move(m_found);
        }
        std::vector<RemedySetting> settings = remedySettings(m_project);
        m_found.settings = settings.size();
        m_issues = validate(m_project);
        for (RemedySetting& setting : settings) {
            setting.make(m_project);
            if (std::optional<Remedy> remedy =
                    canHelp(setting) ? remedyOf(setting) : std::nullopt) {
                m_singleHelps |= setting.isSingle();
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
        if (m_all.empty()) {
            m_found.conflict = conflict();
        }
        return std::move(m_found);
    }

private:
    /// Whether a setting is tried: a pair if no single one helps, a target if a size is lost.
    [[nodiscard]] bool canHelp(const RemedySetting& setting) const {
        return setting.isPair() ? !m_singleHelps
                                : setting.kind != RemedyKind::targetDiameter || m_trials.isOfSize();
    }

    /// Faults and warnings that a change brings.
    [[nodiscard]] bool bringsIssues(const RemedySetting& setting, double value) const {
        return std::ranges::any_of(
            validate(setting.applied(m_project, value)), [&](const Issue& issue) {
                return std::ranges::none_of(m_issues, [&](const Issue& known) {
                    return known.code == issue.code && setting.pathAfter(known.path) == issue.path;
                });
            });
    }

    /// A good value is offered unless it adds a fault or warning.
    [[nodiscard]] bool isOffered(const RemedySetting& setting, double value,
                                 const RemedyTrial& trial) {
        if (!trial.holds) {
            return false;
        }
        const bool warned = bringsIssues(setting, value);
        if (warned && !m_warned && setting.isSingle()) {
            m_warned.emplace(setting, value);
        }
        return !warned;
    }

    [[nodiscard]] RemedyConflict conflict() const {
        RemedyConflict found = m_trials.conflict();
        for (const auto& [what, kind] : {std::pair(&m_narrow, RemedyConflict::Kind::narrow),
                                         std::pair(&m_warned, RemedyConflict::Kind::warned)}) {
            if (*what) {
                found.kind = kind;
                found.second.reset();
                found.setting = (*what)->first;
                found.value = (*what)->second;
                break;
            }
        }
        return found;
    }

    /// The value k places away, run on the first request; null if the search is over.
    const TriedValue* at(const RemedySetting& setting, SettingWay& way, std::int64_t k) {
        if (const TriedValue* known = way.known(k)) {
            return known;
        }
        std::optional<RemedyTrial> trial = m_trials.run(setting, way.value(k));
        if (!trial) {
            return nullptr;
        }
        const bool offered = isOffered(setting, way.value(k), *trial);
        return way.keep(k, {*std::move(trial), offered});
    }

    /// The nearer remedy of both directions, as far as they were tried; at equal distance the
    /// quicker cycle.
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
                const TriedValue* const tried = at(setting, way, *k);
                if (!tried) {
                    return best;
                }
                std::optional<Remedy> remedy =
                    tried->isOffered ? refined(setting, way, *k) : std::nullopt;
                if (!remedy) { // farther ones may work
                    way.pass(*k);
                    continue;
                }
                if (!best || remedy->time_s < best->time_s) {
                    best = std::move(remedy);
                }
                way.end(); // beyond here every edge follows a good value
            }
        }
        return best;
    }

    [[nodiscard]] static std::optional<std::int64_t> nearest(std::optional<std::int64_t> a,
                                                             std::optional<std::int64_t> b) {
        return a && b ? std::min(a, b) : a ? a : b;
    }

    /// The nearest offered value whose neighbour towards the current value is not offered, by
    /// bisection from the last distance tried to this one, which is offered. Empty if the search is
    /// over.
    std::optional<std::int64_t> edge(const RemedySetting& setting, SettingWay& way,
                                     std::int64_t far) {
        std::int64_t near = way.last(), offered = far;
        while (offered - near > 1) {
            const std::int64_t middle = near + (offered - near) / 2;
            const TriedValue* const tried = at(setting, way, middle);
            if (!tried) {
                return std::nullopt;
            }
            (tried->isOffered ? offered : near) = middle;
        }
        return offered;
    }

    /// The values around an offered one, first towards the current value. Empty if the search is
    /// over.
    std::optional<ValueRun> valuesAbout(const RemedySetting& setting, SettingWay& way,
                                        std::int64_t k) {
        ValueRun run{k, k};
        const auto grow = [&](std::int64_t& end, std::int64_t step, std::int64_t limit) {
            while (run.count() < Remedy::mostValues && end != limit) {
                const TriedValue* const tried = at(setting, way, end + step);
                if (!tried || !tried->isOffered) {
                    return tried != nullptr;
                }
                end += step;
            }
            return true;
        };
        const bool isKnown = grow(run.first, -1, 1) && grow(run.last, 1, way.count());
        return isKnown ? std::optional(run) : std::nullopt;
    }

    /// The remedy at the edge between the last distance tried and this one, which is offered, or
    /// else around this one. Empty if there are too few values, if the last test refuses it, or if
    /// the search is over.
    std::optional<Remedy> refined(const RemedySetting& setting, SettingWay& way, std::int64_t far) {
        const std::int64_t least = setting.leastValues();
        const std::optional<std::int64_t> near = edge(setting, way, far);
        std::optional<ValueRun> run = near ? valuesAbout(setting, way, *near) : std::nullopt;
        if (run && run->count() < least && run->last < far) {
            run = valuesAbout(setting, way, far);
        }
        if (!run) {
            return std::nullopt;
        }
        way.pass(run->last);
        if (run->count() < least) {
            if (!m_narrow && setting.isSingle()) {
                m_narrow.emplace(setting, way.value(run->middle()));
            }
            return std::nullopt;
        }
        return remedyWith(setting, way, *run);
    }

    std::optional<Remedy> remedyWith(const RemedySetting& setting, SettingWay& way,
                                     const ValueRun& run) {
        Remedy remedy{setting};
        remedy.value = way.value(run.middle());
        const double first = way.value(run.first), last = way.value(run.last);
        remedy.interval = {std::min(first, last), std::max(first, last)};
        remedy.values = static_cast<int>(run.count());
        if (run.first > 1) {
            const TriedValue* const nearer = way.known(run.first - 1);
            if (nearer && !nearer->trial.holds) {
                remedy.failing = way.value(run.first - 1);
            }
        } else if (!setting.isSingle()) {
            remedy.failing.reset(); // the additional changes were not run alone
        } else if (setting.kind != RemedyKind::addFeed) {
            remedy.failing = setting.before;
        } else { // also run with the current feed
            const TriedValue* const unchanged = at(setting, way, 0);
            if (!unchanged) {
                return std::nullopt;
            }
            remedy.failing = unchanged->trial.holds ? std::nullopt : std::optional(setting.before);
        }
        if (run.last < way.count()) {
            const TriedValue* const farther = at(setting, way, run.last + 1);
            if (!farther) {
                return std::nullopt;
            }
            remedy.holdsBeyond = farther->isOffered;
        }
        const RemedyTrial& trial = way.known(run.middle())->trial;
        remedy.time_s = trial.time_s;
        if (m_time_s) {
            remedy.timeChange_s = trial.time_s - *m_time_s;
        }
        remedy.requirements = trial.worst;
        return m_trials.confirm(remedy) ? std::optional(std::move(remedy)) : std::nullopt;
    }

    /// Its rank: the relative change of time, and the change of the setting. For a cycle that does
    /// not end by itself the time is that of the quickest remedy.
    [[nodiscard]] double rankOf(const Remedy& remedy) const {
        double usual_s = m_time_s.value_or(remedy.time_s);
        for (const Remedy& each : m_all) {
            usual_s = m_time_s ? usual_s : std::min(usual_s, each.time_s);
        }
        return remedy.time_s / usual_s - 1 + changeOf(remedy);
    }

    void keep(Remedy remedy) {
        m_all.push_back(std::move(remedy));
        for (Remedy& each : m_all) {
            each.rank = rankOf(each);
        }
        std::ranges::stable_sort(m_all, {}, &Remedy::rank);
        m_found.found = m_all.size();
        const auto shown = std::min(m_all.size(), RemedyResult::most);
        m_found.remedies.assign(m_all.begin(), m_all.begin() + static_cast<std::ptrdiff_t>(shown));
    }

    const Project& m_project;
    bool m_isRun = false;
    std::optional<double> m_time_s; ///< empty: the cycle does not end by itself
    Issues m_issues;                ///< issues of the unchanged project
    bool m_singleHelps = false;     ///< one setting alone helps
    const RemedyOptions& m_options;
    RemedyTrials m_trials;
    std::optional<std::pair<RemedySetting, double>> m_warned; ///< the first that brings a warning
    std::optional<std::pair<RemedySetting, double>> m_narrow; ///< the first with too few neighbours
    std::vector<Remedy> m_all;                                ///< in the order of their ranks
    RemedyResult m_found;
};

} // namespace

const char* goalKey(RemedyGoal goal) {
    constexpr std::array keys{"none", "holds", "room"};
    return keys[static_cast<std::size_t>(goal)];
}

const char* faultKey(RemedyFault fault) {
    constexpr std::array keys{"none", "part", "stocks", "batch"};
    return keys[static_cast<std::size_t>(fault)];
}

const char* conflictKey(RemedyConflict::Kind kind) {
    constexpr std::array keys{"narrow", "batch",   "stocks",  "warned",
                              "idle",   "opposed", "several", "unmended"};
    return keys[static_cast<std::size_t>(kind)];
}

double mostBad(const RemedyBatch& batch) {
    constexpr double risk = 0.05;
    const double k = batch.candidate;
    return clopperPearson(batch.bad, batch.parts, 1 - 2 * risk / (k * (k + 1))).high;
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
