// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/search_record_text.h"

#include "core/batch/state_seal.h"
#include "core/search/grid.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

/// The shortest digits that read back to the same bits; JSON has no infinities.
std::string digitsOf(double number) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() ? std::string(text.data(), end) : std::string();
}

/// Greater than any count; a thousand of them can be added without overflow.
constexpr std::int64_t mostCounted = 1'000'000'000'000'000;

/// Throws the error of a value with the expected one; caught only in this file.
[[noreturn]] void refuse(const std::string& path, const std::string& found, double least,
                         double most) {
    throw BadStateValue{path, found, digitsOf(least), digitsOf(most)};
}

/// Reads a finite number in a range, written as its digits.
double numberOf(const Json& parent, const std::string& path, const char* key, double least,
                double most) {
    const std::string place = path + '/' + key;
    const Json& digits = parent.at(key);
    double number = 0;
    if (digits.is_string()) {
        const auto& text = digits.get_ref<const std::string&>();
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc() && end == text.data() + text.size() && number >= least
            && number <= most) {
            return number;
        }
    }
    refuse(place, digits.dump(), least, most);
}

/// Reads a whole number in a range.
std::int64_t wholeNumber(const Json& value, const std::string& path, std::int64_t least,
                         std::int64_t most) {
    const bool fits = value.is_number_integer()
                      && (!value.is_number_unsigned()
                          || value.get<std::uint64_t>() <= static_cast<std::uint64_t>(most));
    const std::int64_t number = fits ? value.get<std::int64_t>() : least - 1;
    if (number < least || number > most) {
        refuse(path, value.dump(), static_cast<double>(least), static_cast<double>(most));
    }
    return number;
}

std::int64_t countOf(const Json& parent, const std::string& path, const char* key) {
    return wholeNumber(parent.at(key), path + '/' + key, 0, mostCounted);
}

std::size_t placeOf(const Json& value, const std::string& path, double most) {
    return static_cast<std::size_t>(wholeNumber(value, path, 0, std::llround(most)));
}

Json cycleJson(const GridCycle& cycle) {
    Json stages = Json::array();
    for (const GridStage& stage : cycle) {
        stages.push_back({stage.setting, stage.steps});
    }
    return stages;
}

GridCycle cycleOf(const Json& stages, const std::string& path) {
    GridCycle cycle;
    for (std::size_t z = 0; z < stages.size(); ++z) {
        const std::string place = path + '/' + std::to_string(z);
        cycle.push_back(
            {placeOf(stages.at(z).at(0), place + "/0", mostSettings),
             static_cast<int>(placeOf(stages.at(z).at(1), place + "/1", mostStockSteps))});
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

std::optional<FeasibleCycle> bestOf(const Json& best, const std::string& path) {
    if (best.is_null()) {
        return std::nullopt;
    }
    constexpr double most_s = 1e12, usPerSecond = 1e6, mostMargin = 1e12;
    FeasibleCycle cycle;
    cycle.cycle = cycleOf(best.at("cycle"), path + "/cycle");
    cycle.time_us =
        wholeNumber(best.at("time_us"), path + "/time_us", 1, std::llround(most_s * usPerSecond));
    cycle.leastRelativeMargin = numberOf(best, path, "margin", -1, mostMargin);
    cycle.variant = placeOf(best.at("variant"), path + "/variant", mostVariants);
    cycle.time_s = numberOf(best, path, "time_s", 0, most_s);
    return cycle;
}

Json checkpointJson(const SearchCheckpoint& at) {
    return {{"variant", at.variant},     {"last", cycleJson(at.last)},
            {"best", bestJson(at.best)}, {"evaluations", at.evaluations},
            {"visits", at.visits},       {"cuts", at.cuts}};
}

SearchCheckpoint checkpointOf(const Json& kept, const std::string& path) {
    SearchCheckpoint at;
    at.variant = placeOf(kept.at("variant"), path + "/variant", mostVariants);
    at.last = cycleOf(kept.at("last"), path + "/last");
    at.best = bestOf(kept.at("best"), path + "/best");
    at.evaluations = countOf(kept, path, "evaluations");
    at.visits = countOf(kept, path, "visits");
    const Json& cuts = kept.at("cuts");
    if (cuts.size() != at.cuts.size()) {
        const auto all = static_cast<double>(at.cuts.size());
        refuse(path + "/cuts/length", std::to_string(cuts.size()), all, all);
    }
    for (std::size_t kind = 0; kind < at.cuts.size(); ++kind) {
        at.cuts[kind] =
            wholeNumber(cuts.at(kind), path + "/cuts/" + std::to_string(kind), 0, mostCounted);
    }
    return at;
}

SearchStateFault read(std::string_view text, const SearchQuestion& asked, ReadSearchState& into) {
    std::optional<Json> state = parseState(text);
    if (!state) { // a truncated record begins like one
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
    const Json& finished = state->at("finished");
    for (std::size_t i = 0; i < finished.size(); ++i) {
        into.record.finished.push_back(
            checkpointOf(finished.at(i), "/finished/" + std::to_string(i)));
    }
    if (!state->at("begun").is_null()) {
        into.record.begun = checkpointOf(state->at("begun"), "/begun");
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
    } catch (const BadStateValue& value) {
        state.fault = SearchStateFault::badValue;
        state.value = value;
    } catch (const nlohmann::json::exception&) {
        state.fault = SearchStateFault::changed;
    }
    if (state.fault != SearchStateFault::none) {
        state.record = {};
    }
    return state;
}

} // namespace sparkout
