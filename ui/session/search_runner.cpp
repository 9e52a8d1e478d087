// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/search_runner.h"

#include "core/batch/batch_check.h"
#include "core/optimisation/binding.h"
#include "core/optimisation/judge.h"
#include "core/optimisation/limit.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace sparkout {

namespace {

double seconds(std::int64_t time_us) {
    return static_cast<double>(time_us) * 1e-6;
}

/// Searches number of stages by number, and gathers what it comes upon.
class Search {
public:
    using Note = std::function<void(const SearchState&)>;

    Search(const Project& project, bool phases, std::stop_token stop, Note note)
        : m_outcome(std::make_shared<SearchOutcome>())
        , m_variants(project)
        , m_stop(std::move(stop))
        , m_note(std::move(note)) {
        m_outcome->project = project;
        m_outcome->fault = m_variants.fault();
        if (m_outcome->fault == GridFault::none) {
            const bool asked = project.optimisation->scenarios != OptimisationScenarios::nominal;
            m_outcome->robust = phases || asked;
            if (asked) {
                m_outcome->batchIssues = checkBatch(project);
            }
        }
    }

    SearchOutcomePtr run() {
        if (m_outcome->ran()) {
            for (const double stages : m_outcome->project.optimisation->stages) {
                if (m_stop.stop_requested()) {
                    m_outcome->stopped = true;
                    break;
                }
                searchNumber(static_cast<int>(stages));
            }
            finish();
        }
        return m_outcome;
    }

private:
    void searchNumber(int stages) {
        Project project = m_outcome->project;
        project.optimisation->stages = {static_cast<double>(stages)};
        if (Variants(project).fault() != GridFault::none) {
            return; // the stock cannot be divided so often
        }
        SearchOptions options;
        options.stop = m_stop;
        options.onProgress = [this, stages](const SearchProgress& progress) {
            if (progress.best && !m_outcome->robust) {
                addFound(*progress.best);
            }
            tell(stages, progress.bound_s, progress.evaluations);
        };
        SearchedNumber number{.stages = stages};
        if (m_outcome->robust) {
            RobustSummary robust =
                optimiseRobustly(project, scenariosAskedFor(project), {.search = options});
            number.scenariosAdded = static_cast<int>(robust.added.size());
            number.holds = robust.holdsInSample;
            std::ranges::move(robust.added, std::back_inserter(m_scenarios));
            number.search = std::move(robust.search);
        } else {
            number.search = optimise(project, options);
        }
        if (number.search.status == SearchStatus::stopped) {
            m_outcome->stopped = true;
        }
        if (number.search.best && number.holds) {
            addFound(*number.search.best);
        }
        m_outcome->numbers.push_back(std::move(number));
    }

    /// A cycle is noted once.
    void addFound(const FeasibleCycle& cycle) {
        const bool known = std::ranges::any_of(m_found, [&cycle](const FeasibleCycle& each) {
            return each.variant == cycle.variant && each.cycle == cycle.cycle;
        });
        if (!known) {
            m_found.push_back(cycle);
        }
    }

    void tell(int stages, double bound_s, long long evaluations) const {
        SearchState state{.stages = stages, .bound_s = bound_s, .evaluations = evaluations};
        for (const FeasibleCycle& each : m_found) {
            state.best_s =
                std::min(state.best_s.value_or(seconds(each.time_us)), seconds(each.time_us));
        }
        m_note(state);
    }

    void finish() {
        std::ranges::sort(m_found, [this](const FeasibleCycle& a, const FeasibleCycle& b) {
            return isBetter(a, b, m_variants.grid(a.variant));
        });
        std::vector<std::size_t> numbers; // of stages, met already
        for (const FeasibleCycle& each : m_found) {
            const bool first = std::ranges::find(numbers, each.cycle.size()) == numbers.end();
            m_outcome->found.push_back(
                {.cycle = m_variants.grid(each.variant).cycle(each.cycle),
                 .machine = machineSettings(m_variants.project(each.variant)),
                 .time_s = seconds(each.time_us),
                 .leastRelativeMargin = each.leastRelativeMargin,
                 .isBest = numbers.empty(),
                 .isBestOfItsNumber = first});
            if (first) {
                numbers.push_back(each.cycle.size());
            }
        }
        m_outcome->limit_s = steplessLimit_s(m_outcome->project);
        m_outcome->bound_s = bound();
        if (!m_found.empty() && !m_outcome->stopped) { // it takes cycles run to their ends
            m_outcome->binding =
                bindingRequirements(m_outcome->project, m_found.front(), m_scenarios);
        }
    }

    /// Of the whole grid: the least of those of the numbers of stages, if all were searched.
    [[nodiscard]] double bound() const {
        if (m_outcome->numbers.empty()
            || m_outcome->numbers.size() < m_outcome->project.optimisation->stages.size()) {
            return m_outcome->limit_s;
        }
        double least = std::numeric_limits<double>::infinity();
        for (const SearchedNumber& number : m_outcome->numbers) {
            const bool none = number.search.status == SearchStatus::infeasible;
            least = none ? least : std::min(least, number.search.bound_s);
        }
        return std::max(least, m_outcome->limit_s);
    }

    std::shared_ptr<SearchOutcome> m_outcome;
    Variants m_variants;
    std::stop_token m_stop;
    Note m_note;
    std::vector<FeasibleCycle> m_found;
    std::vector<Project> m_scenarios;
};

} // namespace

std::array<long long, constraintKinds> SearchOutcome::cuts() const {
    std::array<long long, constraintKinds> sum{};
    for (const SearchedNumber& number : numbers) {
        for (std::size_t kind = 0; kind < sum.size(); ++kind) {
            sum[kind] += number.search.cuts[kind];
        }
    }
    return sum;
}

bool SearchOutcome::unresolved() const {
    return std::ranges::any_of(numbers, [this](const SearchedNumber& number) {
        return !number.holds && number.search.best
               && (!best() || seconds(number.search.best->time_us) < best()->time_s);
    });
}

SearchRunner::SearchRunner(QObject* parent) : QObject(parent) {
    constexpr int tick_ms = 100;
    m_progress.setInterval(tick_ms);
    connect(&m_progress, &QTimer::timeout, this, &SearchRunner::tell);
}

void SearchRunner::start(const Project& project, bool phases) {
    drop();
    m_stop = std::stop_source();
    m_shared = std::make_shared<Shared>();
    m_took.start();
    m_progress.start();
    m_job.start([this, project, phases, shared = m_shared,
                 wanted = m_stop](const std::stop_token& newer, const NewestJob::Post& post) {
        std::stop_source either = wanted; // the two share one state
        const std::stop_callback dropped(newer, [&either] { either.request_stop(); });
        Search search(project, phases, either.get_token(), [&shared](const SearchState& state) {
            const std::lock_guard lock(shared->mutex);
            shared->state = state;
        });
        post([this, outcome = search.run()] {
            m_progress.stop();
            emit finished(outcome);
        });
    });
}

void SearchRunner::stop() {
    m_stop.request_stop();
}

void SearchRunner::drop() {
    m_progress.stop();
    m_job.stop();
}

void SearchRunner::tell() {
    SearchState state;
    {
        const std::lock_guard lock(m_shared->mutex);
        state = m_shared->state;
    }
    state.took_s = static_cast<double>(m_took.elapsed()) / 1000;
    emit progressed(state);
}

} // namespace sparkout
