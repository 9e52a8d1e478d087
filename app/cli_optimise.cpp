// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/search_watch.h"
#include "app/stop_signals.h"
#include "core/digits.h"
#include "core/file/file_system.h"
#include "core/printable.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/result.h"
#include "core/search/optimise.h"
#include "core/setup/setup.h"
#include "core/setup/setup_file.h"
#include "core/study/kept_search.h"
#include "core/study/search.h"
#include "core/study/search_outputs.h"
#include "core/units.h"
#include "words/search_words.h"

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

/// "Stepless limit, s        93.12" in the unit of displayed texts; "-" without a value.
std::string outputLine(const OutputRow& row, const OutputValue& value) {
    constexpr std::size_t labelWidth = 54;
    constexpr int digits = 4;
    const auto* const number = std::get_if<double>(&value);
    double shown = number ? *number * row.shownFactor : 0;
    std::string unit = row.unitShown();
    if (unit == "min" && shown * units::secondsPerMinute < shortTime_s) {
        unit = "s";
        shown *= units::secondsPerMinute;
    }
    std::string line = row.label + (unit.empty() ? unit : ", " + unit);
    line += std::string(line.size() < labelWidth ? labelWidth - line.size() : 1, ' ');
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return line + std::to_string(*whole) + '\n';
    }
    return line + (number ? fixed(shown, decimalsOf(shown, digits)) : "-") + '\n';
}

/// A line for each displayed output; sparse outputs only if they have a value.
template <class Owner>
std::string outputLines(std::span<const Output<Owner>> rows, const Owner& owner) {
    std::string text;
    for (const Output<Owner>& row : rows) {
        const OutputValue value = row.of(owner);
        if (*row.label && !row.detail && row.isStated(owner)
            && !(row.sparse && value.index() == 0)) {
            text += outputLine(row, value);
        }
    }
    return text;
}

std::string stageLine(const Operation& operation, const Stage& stage, std::size_t number) {
    std::string feeds;
    if (const auto steps = stage.sparkOutSteps()) {
        feeds = "spark-out, " + std::to_string(*steps)
                + (operation->travels ? " double strokes" : " revolutions");
    } else if (stage.continuousFeed_mm_min() > 0) {
        feeds = plainNumber(stage.continuousFeed_mm_min()) + " mm/min continuous";
    } else {
        const double radial = *(stage.*operation->radial().value);
        feeds = !operation->travels ? fixed(radial, 3) + " mm/min"
                                    : fixed(radial, 4) + " mm per double stroke";
    }
    if (const StageFeed* axial = operation->axial()) {
        feeds += ", " + fixed(*(stage.*axial->value), 0) + " mm/min axial";
    }
    return "  stage " + std::to_string(number) + ": " + feeds + "; stock "
           + fixed(stage.stock_mm, 4) + " mm\n";
}

std::string machineLines(const SearchOutcome& outcome) {
    std::string text;
    for (const FreeSetting& each : freeSettings(outcome.project, outcome.answer()->machine)) {
        const Field& row = *tableOf<Machine>().find(each.key);
        text +=
            std::string("  ") + row.label + ": " + plainNumber(each.value) + ' ' + row.unit + '\n';
    }
    return text;
}

/// The requirements that the file's own cycle violates.
std::string givenLines(const GivenCycle& given) {
    std::string names;
    for (const ConstraintKind kind : given.fails) {
        names += (names.empty() ? "The file's cycle does not meet: " : ", ")
                 + std::string(requirementOf(kind).key);
    }
    return given.isStopped ? "The file's cycle was not run: the search was stopped first.\n"
           : !given.time_s ? "The file's cycle does not end by itself.\n"
           : names.empty() ? ""
                           : names + ".\n";
}

/// Time against margin: a line for each cycle.
std::string frontLines(const SearchOutcome& outcome) {
    const SearchWording words;
    std::string text = words.front(outcome) + '\n';
    for (const FoundCycle* each : outcome.front()) {
        text += "  " + words.time(each->time_s) + ", margin "
                + words.percent(each->leastRelativeMargin)
                + " %, stages: " + std::to_string(each->cycle.stages.size()) + '\n';
    }
    return text;
}

/// The text of an outcome with an answer.
std::string optimiseText(const SearchOutcome& outcome) {
    std::string text;
    for (const std::string& sentence : SearchWording().answer(outcome, outcome.given.time_s)) {
        text += sentence + '\n';
    }
    text += givenLines(outcome.given);
    const Cycle& cycle = outcome.answer()->cycle;
    for (std::size_t z = 0; z < cycle.stages.size(); ++z) {
        text += stageLine(outcome.project.operation, cycle.stages[z], z + 1);
    }
    text += machineLines(outcome) + outputLines(searchOutputs(), outcome);
    return outcome.wishesFront ? text + frontLines(outcome) : text;
}

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
                          + ": a cycle in it does not belong to this search or does not take the "
                            "stated time; the search was started again\n");
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
        return usageError(
            "--resume needs the objective \"time\": the others take several searches");
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
            const char* const hint =
                project.optimisation
                    ? ""
                    : " sparkout-cli new writes a project with them; for this project use “Add a "
                      "typical search” in the window.";
            print(stderr, printable(name) + ": " + reason + hint + '\n');
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
