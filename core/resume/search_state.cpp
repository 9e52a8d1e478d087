// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resume/search_state.h"

#include "core/batch/state_seal.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cstdint>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

/// What is no record: thrown and caught here alone.
struct NoRecord {};

/// Its shortest digits that read back to the same bits; JSON has no infinities.
std::string digitsOf(double number) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() ? std::string(text.data(), end) : std::string();
}

double numberOf(const Json& digits) {
    const auto& text = digits.get_ref<const std::string&>();
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw NoRecord();
    }
    return number;
}

template <class Number>
Number wholeNumber(const Json& value) {
    if (!value.is_number_integer()) {
        throw NoRecord();
    }
    return value.get<Number>();
}

Json cycleJson(const GridCycle& cycle) {
    Json stages = Json::array();
    for (const GridStage& stage : cycle) {
        stages.push_back({stage.setting, stage.steps});
    }
    return stages;
}

GridCycle cycleOf(const Json& stages) {
    GridCycle cycle;
    for (const Json& stage : stages) {
        cycle.push_back({wholeNumber<std::size_t>(stage.at(0)), wholeNumber<int>(stage.at(1))});
    }
    return cycle;
}

Json bestJson(const std::optional<FeasibleCycle>& best) {
    return best ? Json{{"variant", best->variant},
                       {"cycle", cycleJson(best->cycle)},
                       {"time_us", best->time_us},
                       {"time_s", digitsOf(best->time_s)},
                       {"margin", digitsOf(best->leastRelativeMargin)}}
                : Json(nullptr);
}

std::optional<FeasibleCycle> bestOf(const Json& best) {
    if (best.is_null()) {
        return std::nullopt;
    }
    FeasibleCycle cycle;
    cycle.cycle = cycleOf(best.at("cycle"));
    cycle.time_us = wholeNumber<std::int64_t>(best.at("time_us"));
    cycle.leastRelativeMargin = numberOf(best.at("margin"));
    cycle.variant = wholeNumber<std::size_t>(best.at("variant"));
    cycle.time_s = numberOf(best.at("time_s"));
    return cycle;
}

Json checkpointJson(const SearchCheckpoint& at) {
    return {{"variant", at.variant},     {"last", cycleJson(at.last)},
            {"best", bestJson(at.best)}, {"evaluations", at.evaluations},
            {"visits", at.visits},       {"cuts", at.cuts}};
}

SearchCheckpoint checkpointOf(const Json& kept) {
    SearchCheckpoint at;
    at.variant = wholeNumber<std::size_t>(kept.at("variant"));
    at.last = cycleOf(kept.at("last"));
    at.best = bestOf(kept.at("best"));
    at.evaluations = wholeNumber<long long>(kept.at("evaluations"));
    at.visits = wholeNumber<long long>(kept.at("visits"));
    const Json& cuts = kept.at("cuts");
    if (cuts.size() != at.cuts.size()) {
        throw NoRecord();
    }
    for (std::size_t kind = 0; kind < at.cuts.size(); ++kind) {
        at.cuts[kind] = wholeNumber<long long>(cuts.at(kind));
    }
    return at;
}

SearchStateFault read(std::string_view text, const SearchQuestion& asked, ReadSearchState& into) {
    std::optional<Json> state = parseState(text);
    if (!state) { // a record that was cut off begins as one
        const std::string begin = R"({"format":")" + std::string(searchStateFormat);
        return text.starts_with(begin) ? SearchStateFault::changed : SearchStateFault::otherFormat;
    }
    if (state->value("format", Json()) != searchStateFormat) {
        return SearchStateFault::otherFormat;
    }
    if (state->value("version", Json()) != searchStateVersion) {
        return SearchStateFault::otherVersion;
    }
    if (!unseal(*state)) {
        return SearchStateFault::changed;
    }
    into.question = {state->at("engine").get<std::string>(),
                     state->at("project").get<std::string>(),
                     state->at("options").get<std::string>()};
    if (into.question.project != asked.project) {
        return SearchStateFault::otherProject;
    }
    if (into.question.options != asked.options) {
        return SearchStateFault::otherOptions;
    }
    if (into.question.engine != asked.engine) {
        return SearchStateFault::otherEngine;
    }
    for (const Json& each : state->at("finished")) {
        into.record.finished.push_back(checkpointOf(each));
    }
    if (!state->at("begun").is_null()) {
        into.record.begun = checkpointOf(state->at("begun"));
    }
    return SearchStateFault::none;
}

} // namespace

std::string writeSearchState(const SearchQuestion& question, const SearchRecord& record) {
    Json finished = Json::array();
    for (const SearchCheckpoint& each : record.finished) {
        finished.push_back(checkpointJson(each));
    }
    return sealed({{"format", searchStateFormat},
                   {"version", searchStateVersion},
                   {"engine", question.engine},
                   {"project", question.project},
                   {"options", question.options},
                   {"finished", std::move(finished)},
                   {"begun", record.begun ? checkpointJson(*record.begun) : Json(nullptr)}});
}

ReadSearchState readSearchState(std::string_view text, const SearchQuestion& asked) {
    ReadSearchState state;
    try {
        state.fault = read(text, asked, state);
    } catch (const NoRecord&) {
        state.fault = SearchStateFault::changed;
    } catch (const nlohmann::json::exception&) {
        state.fault = SearchStateFault::changed;
    }
    if (state.fault != SearchStateFault::none) {
        state.record = {};
    }
    return state;
}

} // namespace sparkout
