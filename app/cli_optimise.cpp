// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_optimise.h"

#include "app/cli_optimise_report.h"
#include "app/io/cli_io.h"
#include "app/io/cli_surfaces.h"
#include "app/io/exit_status.h"
#include "app/io/stop_signals.h"
#include "app/search_watch.h"
#include "core/files/file_system.h"
#include "core/optimisation/search_names.h"
#include "core/printable.h"
#include "core/project/optimisation.h"
#include "core/setup/setup_file.h"
#include "core/setup/shared_members.h"
#include "core/study/kept_search.h"
#include "core/study/search_outputs.h"
#include "words/search_words.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

SearchWish wishOf(const manual::Given& given) {
    SearchWish wish;
    wish.phases = given.has("--robust");
    wish.refine = given.has("--refine");
    wish.front = given.has("--front");
    wish.method = searchMethodNamed(given.text("--method")).value_or(SearchMethod::pruned);
    wish.threads = static_cast<unsigned>(given.integer("--threads").value_or(0));
    return wish;
}

/// Reports options that contradict each other; returns the exit status.
int checkTogether(const manual::Given& given) {
    const std::string &file = given.operands.front(), &output = given.text("-o"),
                      &resume = given.text("--resume");
    if (!resume.empty() && wishOf(given).method != SearchMethod::full) {
        return usageError("--resume needs --method full");
    }
    if (replacesProject(resume, file) || (!output.empty() && resume == output)) {
        return usageError("--resume would replace a project: " + resume);
    }
    return isSameFile(output, file)
               ? usageError("-o would replace the project that is read: " + output)
               : done;
}

SearchQuestion questionOf(const Project& project, const manual::Given& given) {
    SearchQuestion question = searchQuestion(project, wishOf(given));
    const std::vector<int> stages = given.integers("--stages");
    for (std::size_t i = 0; i < stages.size(); ++i) {
        question.options += (i == 0 ? " --stages " : ",") + std::to_string(stages[i]);
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

/// The exit status of a search without an answer; one that was stopped, or that ran out of rounds
/// or methods, decided nothing.
int statusWithoutAnswer(const SearchOutcome& outcome) {
    if (outcome.search.status == SearchStatus::infeasible) {
        return nothingFeasible;
    }
    return outcome.stopped() && caughtSignal() != 0 ? interrupted + caughtSignal() : undecided;
}

/// Searches the cycle of one surface and puts it into the set-up.
int optimise(Project project, std::size_t surface, const std::string& name,
             const manual::Given& given, Setup& answers) {
    const std::string& resume = given.text("--resume");
    const std::vector<int> stages = given.integers("--stages");
    SearchWish wish = wishOf(given);
    if (!resume.empty() && !isResumable(project, wish.method)) {
        return usageError("--resume is for the objective \"time\": the others are many searches");
    }
    std::optional<KeptSearch> kept;
    if (!resume.empty()) {
        kept.emplace(pathFromUtf8(resume), questionOf(project, given));
        if (const int failed = openKept(*kept, resume)) {
            return failed;
        }
    }
    if (project.optimisation && !stages.empty()) {
        project.optimisation->stages.assign(stages.begin(), stages.end());
    }
    wish.wear = searchWear(answers, surface); // with the cycles found for the earlier surfaces
    wish.journal = kept ? &kept->journal() : nullptr;
    const SearchOutcomePtr outcome = [&] {
        SearchWatch watch(given.number("--time-limit")); // of everything that follows
        return search(project, wish, watch.token(),
                      {.note = [&watch](const SearchState& state) { watch.note(state); }});
    }();
    if (kept) {
        closeKept(*kept, resume);
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
    if (given.has("--json")) {
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
    if (!stages.empty()) {
        own.optimisation = project.optimisation;
    }
    return done;
}

} // namespace

int runOptimise(const manual::Given& given) {
    if (const int failed = checkTogether(given)) {
        return failed;
    }
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = surfaces.oneFor({"--resume"})) {
        return failed;
    }
    Setup answers = surfaces.setup();
    shareMeasuredRa(answers); // it was measured with the given cycles, not with those found
    bool isFound = false;
    const int status =
        surfaces.run(answers, // each surface with the wheel as the cycles found leave it
                     [&](Project project, std::size_t surface, const std::string& name) {
                         const int one =
                             optimise(std::move(project), surface, name, given, answers);
                         isFound = isFound || one == done;
                         return one;
                     });
    const int saved = isFound && given.has("-o") ? save(given.text("-o"), writeSetup(answers))
                                                 : static_cast<int>(done);
    return saved == done ? status : saved;
}

} // namespace sparkout::cli
