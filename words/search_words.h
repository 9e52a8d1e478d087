// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/search_record_text.h"
#include "core/study/search.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

/// Texts about a search: its grid, its progress and its answer. The English ones are defined here.
/// The command line and Python print them; those that the window also shows are marked for
/// translation in the context "Search".
namespace sparkout {

/// Formulates texts about searches; this class in English, with the names used in files.
class SearchWording {
public:
    SearchWording() = default;
    virtual ~SearchWording() = default;
    SearchWording(const SearchWording&) = delete;
    SearchWording& operator=(const SearchWording&) = delete;

    [[nodiscard]] std::string time(double time_s) const;   ///< "43.71 s", "5.714 min"
    [[nodiscard]] std::string percent(double share) const; ///< "−70.2", without unit
    [[nodiscard]] std::string cost(double cost) const;
    [[nodiscard]] std::string gridSize(std::int64_t size) const; ///< "290304 cycles"
    /// "636", "at least 10000", "any number".
    [[nodiscard]] std::string parts(const PartsHeld& held) const;

    /// The progress: "stages: 3, best 114.1 s, none below 102.6 s, 2103 judged".
    [[nodiscard]] std::string state(const SearchState& state) const;
    /// Why the grid cannot be searched in this way; empty for an outcome that ran, and for one
    /// whose project or batch has faults of its own.
    [[nodiscard]] std::string fault(const SearchOutcome& outcome) const;
    /// The result in sentences, compared with the time of the earlier cycle if that ends by itself:
    /// in English alone, since the window shows it as a table with the notes below.
    [[nodiscard]] std::vector<std::string> answer(const SearchOutcome& outcome,
                                                  std::optional<double> before_s) const;
    /// The facts about the answer that no table shows: its binding requirements, edges of levels
    /// and remarks. Without an answer, the reason.
    [[nodiscard]] std::vector<std::string> notes(const SearchOutcome& outcome) const;
    /// Why there is no cycle, with the most frequent cuts.
    [[nodiscard]] std::string noAnswer(const SearchOutcome& outcome) const;
    /// The scope of the margins by time, or why there are none.
    [[nodiscard]] std::string front(const SearchOutcome& outcome) const;
    /// The option that selects a method: "--method search".
    [[nodiscard]] virtual std::string method(SearchMethod method) const;

protected:
    [[nodiscard]] virtual std::string translated(const char* text) const; ///< context "Search"
    [[nodiscard]] virtual std::string number(double value) const;
    [[nodiscard]] virtual std::string whole(std::int64_t count) const;
    [[nodiscard]] virtual std::string fixed(double value, int decimals) const;
    [[nodiscard]] virtual std::string significant(double value, int digits) const;
    [[nodiscard]] virtual std::string unit(const char* unit) const;
    [[nodiscard]] virtual std::string feed(const StageFeed& feed) const;
    /// A row of the search by its key.
    [[nodiscard]] virtual std::string setting(const char* key) const;
    [[nodiscard]] virtual std::string requirement(ConstraintKind kind) const;
    /// As the verdict states them.
    [[nodiscard]] virtual std::string exceptions(const std::vector<Undecided>& undecided) const;
    [[nodiscard]] virtual std::string remark(const Issue& issue) const;

private:
    /// The sentence with its placeholders %1, %2… filled.
    [[nodiscard]] std::string filled(const char* text,
                                     std::initializer_list<std::string> values) const;
    [[nodiscard]] std::string names(const std::vector<ConstraintKind>& kinds) const;
    [[nodiscard]] std::string within(const SearchOutcome& outcome) const;
    [[nodiscard]] std::string wholeRatio(const Project& project) const;
    [[nodiscard]] std::string speedsLeftOut(const Project& searched) const;
    [[nodiscard]] std::string timeAnswer(const SearchOutcome& outcome) const;
    [[nodiscard]] std::string marginAnswer(const SearchOutcome& outcome) const;
    void addIntervalAnswer(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    void addRefinement(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    void addLimit(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    /// "Met, except roughness Ra: not decided."; empty if all is decided.
    [[nodiscard]] std::string exceptionsOf(const SearchOutcome& outcome) const;
    void addBinding(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    void addLevels(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    void addSettingEdges(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    void addRemarks(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
    void addRobustness(const SearchOutcome& outcome, std::vector<std::string>& lines) const;
};

/// The text of fault() after the path of its input: "/optimisation: What is to be searched is not
/// given."; may be empty.
[[nodiscard]] std::string searchRefusal(const SearchOutcome& outcome);

/// Why a record does not continue this search, to follow the name of the file: "is the progress of
/// a search of another project"; empty if it does.
[[nodiscard]] std::string searchStateRefusal(const ReadSearchState& read,
                                             const SearchQuestion& asked);

} // namespace sparkout
