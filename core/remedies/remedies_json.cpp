// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remedies/remedies_json.h"

#include "core/format/output_json.h"
#include "core/format/project_file.h"
#include "core/phases/sampled_phases.h"
#include "core/quality/constraints.h"
#include "core/units.h"

#include <nlohmann/json.hpp>

#include <cstdint>
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
    {{.key = "before", .hint = "its value as it is; none for a stage more or a starting cycle"},
     [](const RemedyOf& r) { return r.remedy.before(); }},
    {{.key = "value",
      .hint = "the value to apply: the middle of the interval; none for a starting cycle"},
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
      .hint = "time of the cycle less that of the cycle as it is; none where that one does not end "
              "by itself"},
     [](const RemedyOf& r) {
         const std::optional<double>& change_s = r.remedy.timeChange_s;
         return change_s ? std::optional(*change_s / units::secondsPerMinute) : std::nullopt;
     }},
    {{.key = "stock_mm",
      .unit = "mm",
      .hint = "stocks per side, for each of which it holds; none under position control, where it "
              "holds for stocks drawn at random"},
     [](const RemedyOf& r) {
         const std::optional<StockRange>& stocks = r.remedy.stocks;
         return stocks ? std::optional(Interval{stocks->from_mm, stocks->to_mm}) : std::nullopt;
     }},
    {{.key = "rank",
      .hint = "what it costs, by which remedies are ordered: the change of time as a share of the "
              "time, and how much the setting changes"},
     [](const RemedyOf& r) { return r.remedy.rank; }},
};

constexpr Output<Remedy> phasesRows[] = {
    {{.key = "tried", .hint = "stocks drawn at random that it holds for"},
     [](const Remedy& r) { return std::int64_t{r.phases}; }},
    {{.key = "candidate",
      .hint = "number of the remedy among the changes that were tried on such, from 1"},
     [](const Remedy& r) { return std::int64_t{r.candidate}; }},
    {{.key = "failing_share_at_most",
      .hint = "share of all such stocks for which it fails, at most"},
     [](const Remedy& r) { return mostFailing(r.phases, r.candidate); }},
    {{.key = "confidence", .hint = "confidence of that share"}, [](const Remedy&) { return 0.95; }},
};

constexpr Output<RemedyBatch> batchRows[] = {
    {{.key = "parts", .hint = "parts of the batch drawn at random for the remedy"},
     [](const RemedyBatch& b) { return b.parts; }},
    {{.key = "bad", .hint = "those of them that are bad"},
     [](const RemedyBatch& b) { return b.bad; }},
    {{.key = "candidate",
      .hint = "number of the remedy among the changes that were tried on such, from 1"},
     [](const RemedyBatch& b) { return std::int64_t{b.candidate}; }},
    {{.key = "bad_share_at_most", .hint = "share of all such parts that is bad, at most"}, mostBad},
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
      .hint = "the requirement that fails most; none where the cycle does not end by itself"},
     [](const RemedyConflictOf& c) { return nameOf(c.conflict.first); }},
    {{.key = "second", .hint = "the requirement that fails with the setting"},
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
      .hint = "stock per side for which the cycle fails with it; none unless the kind is stocks"},
     [](const RemedyConflictOf& c) {
         return c.conflict.kind == RemedyConflict::Kind::stocks ? std::optional(c.conflict.stock_mm)
                                                                : std::nullopt;
     }},
};

constexpr Output<RemedyResult> resultRows[] = {
    {{.key = "goal", .hint = "holds, room or none"},
     [](const RemedyResult& r) { return std::string(goalKey(r.goal)); }},
    {{.key = "fault",
      .hint = "what is not good as it is: part, as stated, stocks, another one within one infeed, "
              "batch, too many of its parts, or none"},
     [](const RemedyResult& r) { return std::string(faultKey(r.fault)); }},
    {{.key = "status", .hint = "completed or stopped"},
     [](const RemedyResult& r) { return std::string(r.isComplete() ? "completed" : "stopped"); }},
    {{.key = "settings", .hint = "settings that there are to try"},
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

} // namespace sparkout
