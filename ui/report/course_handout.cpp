// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course_handout.h"

#include "core/study/search_edits.h"
#include "ui/report/exercises.h"
#include "ui/report/operation_setup.h"
#include "ui/report/run_figures.h"
#include "ui/report/worked_step.h"
#include "ui/text/number_text.h"
#include "ui/views/study/state_grid_plot.h"
#include "ui/views/study/state_grid_text.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace sparkout::report {

namespace {

struct WishMark {
    const char* letter; ///< prefix of its number
    std::optional<int> StepWish::*member;
};
constexpr WishMark wishMarks[] = {{"", &StepWish::count},   {"z", &StepWish::stage},
                                  {"e", &StepWish::step},   {"r", &StepWish::revolution},
                                  {"k", &StepWish::radius}, {"s", &StepWish::section}};
constexpr std::pair<const char*, Zone> wishZones[] = {
    {"rz1", Zone::rz1}, {"nz", Zone::nz}, {"rz2", Zone::rz2}};

bool readZone(const QString& word, StepWish& wish) {
    for (const auto& [name, zone] : wishZones) {
        if (word == QLatin1StringView(name)) {
            const bool first = !wish.zone;
            wish.zone = zone;
            return first;
        }
    }
    return false;
}

bool readMark(const QString& word, StepWish& wish) {
    for (const auto& [letter, member] : wishMarks) {
        const QLatin1StringView begin(letter);
        bool read = false;
        const int number = word.startsWith(begin) ? word.mid(begin.size()).toInt(&read) : 0;
        if (read && number >= 0 && word.back().isDigit()) {
            const bool first = !(wish.*member);
            wish.*member = number;
            return first;
        }
    }
    return false;
}

bool fits(const Place& at, const StepWish& wish) {
    const auto is = [](const std::optional<int>& wanted, int value) {
        return !wanted || *wanted == value;
    };
    return (!wish.zone || *wish.zone == at.zone)
           && (!wish.section || (at.zone == Zone::section && *wish.section == at.section))
           && is(wish.stage, at.stage) && is(wish.count, at.cycleCount)
           && is(wish.step, static_cast<int>(at.step)) && is(wish.revolution, at.revolution);
}

} // namespace

std::optional<StepWish> readStepWish(const QString& text) {
    StepWish wish;
    for (const QString& word : text.toLower().split(u',')) {
        const QString trimmed = word.trimmed();
        if (!readZone(trimmed, wish) && !readMark(trimmed, wish)) {
            return {};
        }
    }
    return wish;
}

std::optional<HandoutStep> findStep(const Trajectory& trajectory, const StepWish& wish) {
    std::optional<HandoutStep> found;
    double deepest = -1;
    for (std::size_t i = 0; i < trajectory.passes.size(); ++i) {
        if (!fits(trajectory.passes[i].place, wish)) {
            continue;
        }
        for (int k = 0; k < trajectory.radii; ++k) {
            const double a = visitAt(trajectory, {i, k})->actual_mm;
            if ((!wish.radius || *wish.radius == k) && a > deepest) {
                deepest = a;
                found = HandoutStep{i, k};
            }
        }
    }
    return found;
}

namespace {

constexpr std::array viewRows{
    HandoutViewRow{HandoutView::feeds, "feeds",
                   QT_TRANSLATE_NOOP("HandoutView", "Feeds around the step, with E1…E5")},
    HandoutViewRow{HandoutView::cycle, "cycle",
                   QT_TRANSLATE_NOOP("HandoutView", "Feeds over the whole cycle")},
    HandoutViewRow{HandoutView::profiles, "profiles",
                   QT_TRANSLATE_NOOP("HandoutView", "Zone profiles at the end")},
    HandoutViewRow{HandoutView::limits, "limits",
                   QT_TRANSLATE_NOOP("HandoutView", "Actual feed under its limits")},
    HandoutViewRow{HandoutView::grid, "grid",
                   QT_TRANSLATE_NOOP("HandoutView", "Grid of dynamic programming")},
};

} // namespace

std::span<const HandoutViewRow> handoutViews() {
    return viewRows;
}

std::optional<std::set<HandoutView>> readHandoutViews(const QString& text) {
    std::set<HandoutView> views;
    for (const QString& word : text.split(u',', Qt::SkipEmptyParts)) {
        const auto row = std::ranges::find_if(viewRows, [&](const HandoutViewRow& r) {
            return word.trimmed() == QLatin1StringView(r.key);
        });
        if (row == viewRows.end()) {
            return {};
        }
        views.insert(row->view);
    }
    return views;
}

QString handoutViewText(const std::set<HandoutView>& views) {
    QStringList keys;
    for (const HandoutViewRow& row : viewRows) {
        if (views.contains(row.view)) {
            keys << QString::fromLatin1(row.key);
        }
    }
    return keys.join(u',');
}

namespace {

struct HandoutFigures {
    Q_DECLARE_TR_FUNCTIONS(HandoutFigures)
};

constexpr int revolutionsAround = 3; ///< number of steps shown on each side of a plunge's step

/// The double stroke of the step, or the revolutions around it.
std::optional<Figure> feedsAround(const OutcomePtr& outcome, const HandoutStep& step) {
    const Pass& pass = outcome->trajectory.passes[step.pass];
    const FeedSeries& feeds = outcome->feeds;
    const bool strokes = feeds.operation->travels;
    const int around = strokes ? 0 : revolutionsAround;
    const int first = std::max(1, pass.place.cycleCount - around);
    const int last = std::min(feeds.strokeCount(), pass.place.cycleCount + around);
    const double start_s = feeds.strokeStart_s.at(static_cast<std::size_t>(first - 1));
    const double moment_s =
        pass.start_s + pass.duration_s * (step.radius + 1) / std::max(1, outcome->trajectory.radii);
    const QString caption =
        strokes ? HandoutFigures::tr("Feeds in double stroke %1; the line marks the step")
                      .arg(pass.place.cycleCount)
                : HandoutFigures::tr("Feeds around revolution %1; the line marks the step")
                      .arg(pass.place.cycleCount);
    return feedsFigure(outcome, start_s, feeds.strokeEnd_s(last), moment_s, caption);
}

/// The figures of the hand-out, drawn in the window's thread.
std::vector<Block> handoutFigures(const OutcomePtr& outcome, const std::optional<HandoutStep>& step,
                                  const std::set<HandoutView>& views,
                                  const std::function<void()>& breathe) {
    std::vector<Block> blocks;
    const auto add = [&](std::optional<Figure> figure) {
        breathe();
        if (figure) {
            blocks.emplace_back(std::move(*figure));
        }
    };
    if (views.contains(HandoutView::feeds) && step) {
        add(feedsAround(outcome, *step));
    }
    if (views.contains(HandoutView::cycle)) {
        add(feedsFigure(outcome));
    }
    if (views.contains(HandoutView::profiles)) {
        add(profilesFigure(outcome));
    }
    if (views.contains(HandoutView::limits) && step) {
        add(limitsFigure(outcome, outcome->trajectory.passes[step->pass].place));
    }
    return blocks;
}

struct StateGridSheet {
    Q_DECLARE_TR_FUNCTIONS(StateGridSheet)
};

constexpr int gridHeight = 470;
constexpr qint64 longestProof_ms = 10'000;
constexpr int sheetDigits = 4;

QString orDash(const QString& text) {
    return text.isEmpty() ? QStringLiteral("–") : text;
}

StateGridOutcomePtr filledGrid(const Project& project, const std::function<void()>& breathe) {
    auto outcome = std::make_shared<StateGridOutcome>();
    outcome->project = project;
    auto grid = fillStateGrid(project, usualStateGrid(project), {}, [&breathe](int) { breathe(); });
    outcome->grid = std::move(*grid); // not stopped
    std::stop_source stop;
    QElapsedTimer timer;
    timer.start();
    outcome->exact = exactAnswer(outcome->grid, stop.get_token(), [&](const SearchProgress&) {
        breathe();
        if (timer.hasExpired(longestProof_ms)) {
            stop.request_stop();
        }
    });
    return outcome;
}

Table wayBackTable(const StateGrid& grid) {
    Table table;
    const TimeUnit unit = StateGridText::unit(grid);
    table.head = QStringList{StateGridSheet::tr("State"), StateGridSheet::tr("Stock left, mm"),
                             StateGridSheet::tr("Feed"),  unit.titled(QStringLiteral("T")),
                             QStringLiteral("m*"),        StateGridSheet::tr("Moves struck out")};
    table.texts = {true, false, false, false, false, true};
    for (int n = grid.size.levels; n >= 1; --n) {
        const std::size_t feed = grid.path[static_cast<std::size_t>(n - 1)];
        const GridState& state = grid.state(n, feed);
        const QString out = StateGridText::struckOut(state);
        table.rows.push_back(
            {StateGridText::state(n, feed),
             printedNumber(grid.stock_mm[static_cast<std::size_t>(n)], sheetDigits),
             StateGridText::feed(grid.feeds[feed], grid.project.operation),
             StateGridText::amount(*state.time_s, unit),
             orDash(n > 1 ? QString::number(state.from + 1) : QString()), orDash(out)});
    }
    return table;
}

Table wrongStatesTable(const ExactAnswer& exact) {
    Table table;
    table.head = QStringList{StateGridSheet::tr("State"),
                             StateGridSheet::tr("States in which the rule is wrong")};
    table.texts = {true, true};
    for (const StateDifference& fault : exact.faults) {
        table.rows.push_back(
            {StateGridText::state(fault.level, fault.feed), StateGridText::wrong(fault)});
    }
    return table;
}

/// The grid of dynamic programming in the hand-out: the rule, the grid, both answers, the path back
/// state by state. A project without a search uses a usual one. Must run in the window's thread;
/// `breathe` is called during the proof, which is abandoned after some seconds.
std::vector<Block> stateGridBlocks(const OutcomePtr& outcome,
                                   const std::function<void()>& breathe) {
    Project project = outcome->result.project;
    if (!project.optimisation) {
        project = withUsualSearch(std::move(project));
    }
    project = withSearchFor(std::move(project));
    const QString fault = StateGridText::fault(stateGridFault(project));
    if (!fault.isEmpty()) {
        return {Paragraph{fault}};
    }
    const StateGridOutcomePtr filled = filledGrid(project, breathe);
    const StateGrid& grid = filled->grid;
    std::vector<Block> blocks{Paragraph{StateGridSheet::tr(
        "A cell [n, m] holds the minimum time T[n,m] in which n levels of stock are removed, the "
        "last with feed m, and m*, the feed before it: T[n,m] = min over m' of (T[n−1,m'] + τ), "
        "T[0,0] = 0, over the moves that break no requirement. The minimum time of the last level "
        "is that of the cycle; its feeds are read back along m*.")}};
    StateGridPlot plot;
    setUpForPaper(plot, gridHeight);
    plot.setGrid(filled);
    plot.restyle();
    plot.fit();
    const QString caption = StateGridSheet::tr("The grid of dynamic programming: T, %1, and m*")
                                .arg(StateGridText::unit(grid).text());
    blocks.emplace_back(plotFigure(plot, plot.legendEntries(), caption,
                                   StateGridText::answer(grid, filled->exact)));
    for (const QString& line : StateGridText::answer(grid, filled->exact).split(u'\n')) {
        blocks.emplace_back(Paragraph{line});
    }
    if (!grid.path.empty()) {
        blocks.emplace_back(wayBackTable(grid));
    }
    if (!filled->exact->faults.empty()) {
        blocks.emplace_back(wrongStatesTable(*filled->exact));
    }
    return blocks;
}

class HandoutWriter {
    Q_DECLARE_TR_FUNCTIONS(CourseHandout)
public:
    HandoutWriter(const OutcomePtr& outcome, const HandoutOptions& options,
                  const std::function<void()>& breathe)
        : m_outcome(outcome), m_options(options), m_breathe(breathe) {}

    Report write(const QString& file, const QDate& date) {
        const Project& project = m_outcome->result.project;
        m_report = begunReport(tr("Course hand-out"), project, file, date);
        std::optional<HandoutStep> step = findStep(m_outcome->trajectory, m_options.step);
        if (!step) {
            step = findStep(m_outcome->trajectory); // roughing ended before it began
        }
        const std::vector<Exercise> exercises = makeExercises(*m_outcome, step, m_breathe);
        add(HandoutTask::header(project, file, date));
        heading(tr("The task"));
        add(Paragraph{HandoutTask::task(*m_outcome)});
        add(partSketch(m_outcome));
        heading(tr("Stages of the cycle"));
        add(OperationSetup::stages(*m_outcome));
        Citations citations;
        const StepBlocks worked =
            step ? WorkedStep::formulas(*m_outcome, *step, citations) : StepBlocks();
        Table inputs = HandoutTask::inputs(*m_outcome, step, worked.symbols, citations);
        heading(tr("Sources"));
        add(citations.table());
        heading(tr("Inputs of the formulas"));
        add(std::move(inputs));
        addStep(step, worked.blocks);
        addFigures(step);
        if (m_options.views.contains(HandoutView::grid)) {
            heading(tr("Dynamic programming"));
            add(stateGridBlocks(m_outcome, m_breathe));
        }
        if (!exercises.empty()) {
            heading(tr("Questions"));
            add(exerciseQuestions(exercises));
        }
        if (m_options.answers && !exercises.empty()) {
            add(PageBreak{});
            heading(tr("Answers"));
            add(exerciseAnswers(exercises, project.operation));
        }
        return std::move(m_report);
    }

private:
    void heading(const QString& text) { m_report.blocks.emplace_back(Heading{text}); }
    void add(Block block) { m_report.blocks.push_back(std::move(block)); }
    void add(std::vector<Block> blocks) {
        std::ranges::move(blocks, std::back_inserter(m_report.blocks));
    }

    void addStep(const std::optional<HandoutStep>& step, const std::vector<Block>& formulas) {
        heading(tr("The step worked out"));
        if (!step) {
            add(Paragraph{
                tr("The cycle is too long to be recorded, so no step of it can be worked out.")});
            return;
        }
        add(WorkedStep::facts(*m_outcome, *step));
        add(Paragraph{tr("Every formula is printed in symbols, then with its numbers, then with "
                         "its result. Numbers have as many digits as the printed result needs.")});
        add(formulas);
    }

    void addFigures(const std::optional<HandoutStep>& step) {
        auto figures = handoutFigures(m_outcome, step, m_options.views, m_breathe);
        if (!figures.empty()) {
            heading(tr("Charts"));
            add(std::move(figures));
        }
    }

    const OutcomePtr& m_outcome;
    const HandoutOptions& m_options;
    const std::function<void()>& m_breathe;
    Report m_report;
};

} // namespace

Report courseHandout(const OutcomePtr& outcome, const QString& file, const QDate& date,
                     const HandoutOptions& options, const std::function<void()>& breathe) {
    return HandoutWriter(outcome, options, breathe).write(file, date);
}

} // namespace sparkout::report
