// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_optimise.h"

#include "app/cli_optimise_report.h"
#include "app/io/cli_io.h"
#include "app/io/cli_surfaces.h"
#include "app/io/exit_status.h"
#include "app/io/stop_signals.h"
#include "app/manual/command_line.h"
#include "app/search_watch.h"
#include "core/files/file_system.h"
#include "core/optimisation/search_names.h"
#include "core/printable.h"
#include "core/project/optimisation.h"
#include "core/setup/setup_file.h"
#include "core/study/kept_search.h"
#include "core/study/search_json.h"
#include "words/search_words.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <variant>

namespace sparkout::cli {

namespace {

struct OptimiseOptions {
    std::string file, output, surface, resume;
    bool json = false;
    SearchWish wish;
    std::vector<double> stages; ///< empty: the file's
    std::optional<double> timeLimit_s;
};

template <class Number>
std::optional<Number> numberIn(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                    : std::nullopt;
}

/// "1,2,3": numbers of stages, 1 to 5; empty where it is none.
std::vector<double> stagesIn(std::string_view text) {
    std::vector<double> stages;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const auto count = numberIn<int>(text.substr(0, comma));
        if (!count || *count < 1 || *count > 5) {
            return {};
        }
        stages.push_back(*count);
        if (comma == text.size()) {
            return stages;
        }
        text.remove_prefix(comma + 1);
    }
}

/// What an option's value may be; nothing where it has none.
const char* valueOf(const std::string& option) {
    if (option == "--method") {
        return "search, full, dp or labels";
    }
    if (option == "--stages") {
        return "numbers from 1 to 5 with commas between";
    }
    if (option == "--time-limit") {
        return "a number of seconds";
    }
    if (option == "--threads") {
        return "a number from 1 to 1024";
    }
    if (option == "--surface") {
        return "a name, a number from 1 or all";
    }
    return option == "-o" || option == "--resume" ? "a file name" : nullptr;
}

bool readValue(const std::string& option, const std::string& value, OptimiseOptions& options) {
    if (option == "--method") {
        const auto method = searchMethodNamed(value);
        options.wish.method = method.value_or(SearchMethod::pruned);
        return method.has_value();
    }
    if (option == "--stages") {
        options.stages = stagesIn(value);
        return !options.stages.empty();
    }
    if (option == "--time-limit") {
        options.timeLimit_s = numberIn<double>(value);
        return options.timeLimit_s && *options.timeLimit_s >= 0;
    }
    if (option == "--threads") {
        const auto threads = numberIn<int>(value);
        options.wish.threads = static_cast<unsigned>(threads.value_or(0));
        return threads && *threads >= 1 && *threads <= 1024;
    }
    (option == "--surface"  ? options.surface
     : option == "--resume" ? options.resume
                            : options.output) = value;
    return !value.empty();
}

int parseOptimise(const std::vector<std::string>& arguments, OptimiseOptions& options) {
    const auto* known = manual::commandNamed(manual::commandLineProgram(), "optimize");
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        const bool isOption = argument.size() > 1 && argument[0] == '-';
        if (isOption && !manual::optionNamed(known->options, argument)) {
            return usageError("unknown option " + argument);
        }
        if (argument == "--json") {
            options.json = true;
        } else if (argument == "--robust") {
            options.wish.phases = true;
        } else if (argument == "--refine") {
            options.wish.refine = true;
        } else if (argument == "--front") {
            options.wish.front = true;
        } else if (const char* value = valueOf(argument)) {
            if (++i == arguments.size() || !readValue(argument, arguments[i], options)) {
                return usageError(argument + " needs " + value);
            }
        } else if (isOption) {
            return usageError("unknown option " + argument);
        } else if (options.file.empty()) {
            options.file = argument;
        } else {
            return usageError("one file or folder too many: " + argument);
        }
    }
    if (options.file.empty()) {
        return usageError("optimize needs a file");
    }
    if (!options.resume.empty() && options.wish.method != SearchMethod::full) {
        return usageError("--resume needs --method full");
    }
    if (replacesProject(options.resume, options.file)
        || (!options.output.empty() && options.resume == options.output)) {
        return usageError("--resume would replace a project: " + options.resume);
    }
    return isSameFile(options.output, options.file)
               ? usageError("-o would replace the project that is read: " + options.output)
               : done;
}

SearchQuestion questionOf(const Project& project, const OptimiseOptions& options) {
    SearchQuestion question = searchQuestion(project, options.wish);
    for (std::size_t i = 0; i < options.stages.size(); ++i) {
        question.options +=
            (i == 0 ? " --stages " : ",") + std::to_string(static_cast<int>(options.stages[i]));
    }
    return question;
}

int openKept(KeptSearch& kept, const std::string& file) {
    kept.onFailure = [](const FileError& error) {
        print(stderr, "the progress is not kept: " + describe(error));
    };
    const auto fault = kept.open();
    if (!fault) {
        return done;
    }
    const auto* const error = std::get_if<FileError>(&*fault);
    print(stderr, error
                      ? describe(*error)
                      : printable(file) + ": "
                            + searchStateRefusal(std::get<ReadSearchState>(*fault), kept.question())
                            + '\n');
    return refused;
}

void closeKept(KeptSearch& kept, const std::string& file) {
    if (kept.journal().hasRefused()) {
        print(stderr, printable(file)
                          + ": a cycle in it is not of this search, or does not take the time "
                            "that stands there; that search was made anew\n");
    }
    kept.close();
}

/// A search that was stopped, or that ran out of rounds or ways, decided nothing.
int statusWithoutAnswer(const SearchOutcome& outcome) {
    if (outcome.search.status == SearchStatus::infeasible) {
        return nothingFeasible;
    }
    return outcome.stopped() && caughtSignal() != 0 ? interrupted + caughtSignal() : undecided;
}

/// Searches for the cycle of one surface, and puts it into the set-up.
int optimise(Project project, std::size_t surface, const std::string& name,
             const OptimiseOptions& options, Setup& answers) {
    if (!options.resume.empty() && !isResumable(project, options.wish.method)) {
        return usageError("--resume is for the objective \"time\": the others are many searches");
    }
    std::optional<KeptSearch> kept;
    if (!options.resume.empty()) {
        kept.emplace(pathFromUtf8(options.resume), questionOf(project, options));
        if (const int failed = openKept(*kept, options.resume)) {
            return failed;
        }
    }
    if (project.optimisation && !options.stages.empty()) {
        project.optimisation->stages = options.stages;
    }
    SearchWish wish = options.wish;
    wish.wear = searchWear(answers, surface); // with the cycles found before
    wish.journal = kept ? &kept->journal() : nullptr;
    const SearchOutcomePtr outcome = [&] {
        SearchWatch watch(options.timeLimit_s); // of everything that follows
        return search(project, wish, watch.token(),
                      {.note = [&watch](const SearchState& state) { watch.note(state); }});
    }();
    if (kept) {
        closeKept(*kept, options.resume);
    }
    if (!outcome->ran()) {
        printIssues(name, outcome->issues);
        printIssues(name, outcome->batchIssues);
        if (const std::string reason = searchRefusal(*outcome); !reason.empty()) {
            print(stderr, printable(name) + ": " + reason + '\n');
        }
        return refused;
    }
    const FoundCycle* const answer = outcome->answer();
    if (options.json) {
        print(stdout, searchJson(*outcome));
    } else if (answer) {
        print(stdout, optimiseText(*outcome));
    }
    if (!answer) {
        print(stderr, printable(name) + ": " + SearchWording().noAnswer(*outcome) + '\n');
        return statusWithoutAnswer(*outcome);
    }
    Project& own = answers.surfaces[surface].project;
    own = withFound(std::move(own), *answer);
    if (!options.stages.empty()) {
        own.optimisation = project.optimisation;
    }
    return done;
}

} // namespace

int runOptimise(const std::vector<std::string>& arguments) {
    OptimiseOptions options;
    if (const int failed = parseOptimise(arguments, options)) {
        return failed;
    }
    const Surfaces surfaces(options.file, options.surface);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = options.resume.empty() ? done : surfaces.oneFor("--resume")) {
        return failed;
    }
    Setup answers = surfaces.setup();
    bool isFound = false;
    const int status = surfaces.run(
        answers, // of each surface with the wheel as the cycles found leave it
        [&](Project project, std::size_t surface, const std::string& name) {
            const int one = optimise(std::move(project), surface, name, options, answers);
            isFound = isFound || one == done;
            return one;
        },
        options.json);
    const int saved = isFound && !options.output.empty() ? save(options.output, writeSetup(answers))
                                                         : static_cast<int>(done);
    return saved == done ? status : saved;
}

} // namespace sparkout::cli
