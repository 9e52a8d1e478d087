// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/optimise_text.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "words/search_words.h"

#include <QLocale>
#include <QStringList>

namespace sparkout {

namespace {

/// Texts about searches in the current language, with the numbers and names of the window.
class SearchText : public SearchWording {
protected:
    [[nodiscard]] std::string translated(const char* text) const override {
        return QCoreApplication::translate("Search", text).toStdString();
    }
    [[nodiscard]] std::string number(double value) const override {
        return printedNumber(value).toStdString();
    }
    [[nodiscard]] std::string whole(std::int64_t count) const override {
        const QLocale grouping(QLocale().language(), QLocale().territory());
        return grouping.toString(qlonglong(count)).toStdString();
    }
    [[nodiscard]] std::string fixed(double value, int decimals) const override {
        return Names::fixed(value, decimals).toStdString();
    }
    [[nodiscard]] std::string significant(double value, int digits) const override {
        return Names::significant(value, digits).toStdString();
    }
    [[nodiscard]] std::string unit(const char* unit) const override {
        return unitText(unit).toStdString();
    }
    [[nodiscard]] std::string feed(const StageFeed& feed) const override {
        return inputText(tableOf<Stage>().find(feed.key)->label).toStdString();
    }
    [[nodiscard]] std::string setting(const char* key) const override {
        return inputText(tableOf<Optimisation>().find(key)->label).toStdString();
    }
    [[nodiscard]] std::string remark(const Issue& issue) const override {
        return Names::issue(issue).toStdString();
    }
    [[nodiscard]] std::string requirement(ConstraintKind kind) const override {
        return Names::inSentence(Names::constraint(kind)).toStdString();
    }
    [[nodiscard]] std::string exceptions(const std::vector<Undecided>& undecided) const override {
        return JudgementText::exceptions(undecided).toStdString();
    }

public:
    [[nodiscard]] std::string method(SearchMethod method) const override {
        return OptimiseText::tr("“%1”").arg(OptimiseText::method(method)).toStdString();
    }
};

} // namespace

QString OptimiseText::time(double time_s) {
    constexpr int digits = 4;
    return Names::time(time_s, digits);
}

QString OptimiseText::percent(double share) {
    return QString::fromStdString(SearchText().percent(share));
}

QString OptimiseText::gridSize(std::int64_t size) {
    return QString::fromStdString(SearchText().gridSize(size));
}

QString OptimiseText::parts(const PartsHeld& held) {
    return QString::fromStdString(SearchText().parts(held));
}

QString OptimiseText::cost(double cost) {
    return QString::fromStdString(SearchText().cost(cost));
}

QString OptimiseText::method(SearchMethod method) {
    switch (method) {
    case SearchMethod::pruned: return tr("Pruned search");
    case SearchMethod::full: return tr("Full enumeration");
    case SearchMethod::published: return tr("Dynamic programming");
    case SearchMethod::labels: return tr("Label-setting method");
    }
    return {};
}

QString OptimiseText::methodHint(SearchMethod method) {
    switch (method) {
    case SearchMethod::pruned:
        return tr("Proves from few runs that no cycle of the grid is better: cycles that cannot be "
                  "fit or quicker are not run");
    case SearchMethod::full:
        return tr("Runs every cycle of the grid, and proves the same answer without pruning. A "
                  "large grid takes hours or days; for the minimum time and the maximum margin it "
                  "can be stopped and continued");
    case SearchMethod::published:
        return tr("A heuristic for plunge grinding, as published: of all paths to a level of stock "
                  "with a feed only the quickest is kept. It is quick, but proves nothing and may "
                  "find no cycle although one exists");
    case SearchMethod::labels:
        return tr("A heuristic for plunge grinding: all paths to a level of stock are kept that no "
                  "other beats in both time and stored deflection. It takes longer with many "
                  "levels, proves nothing and may find no cycle although one exists");
    }
    return {};
}

QString OptimiseText::state(const SearchState& state) {
    return QString::fromStdString(SearchText().state(state));
}

QString OptimiseText::front(const SearchOutcome& outcome) {
    return QString::fromStdString(SearchText().front(outcome));
}

QString OptimiseText::fault(const SearchOutcome& outcome) {
    if (!outcome.issues.empty()) {
        return Names::refusal(outcome.issues, 2);
    }
    const bool isOnPage = outcome.fault == GridFault::noLevels
                          || outcome.fault == GridFault::wholeRatio
                          || outcome.objectiveFault == ObjectiveFault::noRates;
    return outcome.batchIssues.empty()
               ? QString::fromStdString(SearchText().fault(outcome))
                     + (isOnPage ? u' ' + tr("See the page Search of the inputs.") : QString())
               : tr("The batch that the cycle must be fit for cannot be run:") + u'\n'
                     + Names::refusal(outcome.batchIssues, 2);
}

QString OptimiseText::notes(const SearchOutcome& outcome) {
    QStringList sentences;
    for (const std::string& each : SearchText().notes(outcome)) {
        sentences << QString::fromStdString(each);
    }
    return sentences.join(u' ');
}

QString OptimiseText::offer(SearchObjective objective) {
    return objective == SearchObjective::cost
               ? tr("“Search” finds the cycle of the grid with the minimum cost of a part, "
                    "together with the parts between dressings: it is fit for all of them.")
               : tr("“Search” finds the cycle of the grid that is fit for the most parts from one "
                    "dressing to the next, the quickest of these.");
}

QString OptimiseText::cycle(const Cycle& cycle) {
    QStringList stages;
    for (const Stage& stage : cycle.stages) {
        QStringList numbers;
        for (const std::optional<double>& feed :
             {stage.radial_feed_mm, stage.axial_feed_mm_min, stage.radial_feed_mm_min}) {
            if (feed && (*feed > 0 || stage.continuousFeed_mm_min() == 0)) {
                numbers << printedNumber(*feed);
            }
        }
        if (stage.continuousFeed_mm_min() > 0) {
            numbers << tr("S_c %1").arg(printedNumber(stage.continuousFeed_mm_min()));
        }
        if (const auto steps = stage.sparkOutSteps()) {
            numbers << tr("spark-out %1").arg(QLocale().toString(*steps));
        }
        numbers << printedNumber(stage.stock_mm);
        stages << numbers.join(QStringLiteral(" · "));
    }
    return stages.join(QStringLiteral(" → "));
}

QString OptimiseText::found(const FoundCycle& found, const Project& searched) {
    QStringList parts{cycle(found.cycle)};
    const MachineSettings own = machineSettings(searched);
    if (found.machine.work_speed_rpm != own.work_speed_rpm) {
        parts << tr("%1 rev/min").arg(printedNumber(found.machine.work_speed_rpm));
    }
    if (found.machine.dwell_entry_s != own.dwell_entry_s
        || found.machine.dwell_exit_s != own.dwell_exit_s) {
        parts << tr("dwells %1 and %2 s")
                     .arg(printedNumber(found.machine.dwell_entry_s),
                          printedNumber(found.machine.dwell_exit_s));
    }
    return parts.join(QStringLiteral("; "));
}

QString OptimiseText::cycleHint(Operation operation) {
    return operation->axial() ? tr("Of every stage: radial feed, mm per double stroke; axial feed, "
                                   "mm/min; stock per side, mm")
                              : tr("Of every stage: radial feed, mm/min; stock per side, mm");
}

} // namespace sparkout
