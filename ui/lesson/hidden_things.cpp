// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/hidden_things.h"

#include "ui/session/lesson_run.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace sparkout {

void HiddenThings::add(Things with, std::function<void(bool hidden)> hide) {
    m_entries.push_back({std::move(with), std::move(hide)});
}

void HiddenThings::add(Things with, QAction* command) {
    add(std::move(with), [command](bool hidden) {
        command->setVisible(!hidden);
        command->setEnabled(!hidden); // otherwise it could still be triggered
    });
}

HiddenThings::Things HiddenThings::of(const LessonStep& step) {
    Things things;
    for (const HiddenThing& each : step.hidden) {
        things.insert(each.name);
    }
    const auto hides = [&things](std::initializer_list<Hideable> any) {
        return std::any_of(any.begin(), any.end(),
                           [&things](Hideable each) { return things.contains(each); });
    };
    if (hides({Hideable::verdict})) {
        things.insert(Hideable::remedies);
    }
    if (hides({Hideable::overview, Hideable::feeds, Hideable::profiles, Hideable::constraints,
               Hideable::compliance, Hideable::layers, Hideable::verdict, Hideable::formulas,
               Hideable::batchIndices})) {
        things.insert(Hideable::reports);
        things.insert(Hideable::exportResults);
    }
    const bool hidesInputs =
        step.others == Access::hidden
        || std::any_of(step.inputs.begin(), step.inputs.end(),
                       [](const InputAccess& each) { return each.access == Access::hidden; });
    if (hidesInputs) {
        things.insert(
            {Hideable::reports, Hideable::exportResults, Hideable::formulas, Hideable::compare});
    }
    if (hides({Hideable::keptRuns})) {
        things.insert(Hideable::compare);
    }
    if (hides({Hideable::measured})) {
        things.insert(Hideable::calibrate);
    }
    return things;
}

HiddenThings::Things HiddenThings::telling(const Figure& figure) {
    switch (rowOf(figure.name).scope) {
    case FigureScope::cycle:
        switch (figure.name) {
        case FigureName::equivalentDiameter:
        case FigureName::shearCoefficient:
        case FigureName::flatCoefficient: return {Hideable::formulas};
        case FigureName::burnFreeFeed: return {Hideable::formulas, Hideable::constraints};
        default: break;
        }
        break;
    case FigureScope::place:
        if (figure.name == FigureName::compliance) {
            return {Hideable::compliance, Hideable::formulas};
        }
        break;
    case FigureScope::stage:
        return {Hideable::feeds, Hideable::overview, Hideable::constraints, Hideable::compare,
                Hideable::sweep};
    case FigureScope::step:
        return {Hideable::feeds,    Hideable::layers,  Hideable::formulas,
                Hideable::profiles, Hideable::compare, Hideable::constraints};
    case FigureScope::batch:
    case FigureScope::batchPlace:
        switch (figure.name) {
        case FigureName::batchMeanHalf:
        case FigureName::batchPp:
        case FigureName::batchPpk:
            return {Hideable::batch, Hideable::overview, Hideable::batchIndices};
        default: return {Hideable::batch, Hideable::overview};
        }
    case FigureScope::search: return {Hideable::optimise};
    }
    return {Hideable::overview, Hideable::profiles, Hideable::constraints, Hideable::verdict,
            Hideable::compare,  Hideable::batch,    Hideable::sweep};
}

HiddenThings::Things HiddenThings::of(const LessonRun& run) {
    LessonStep step = run.current();
    // A step that reads a result waits for the predictions before it; later predictions do not hide
    // that result.
    const bool reads = step.goal.prediction && step.goal.prediction->after_run;
    const Things read = reads ? telling(*step.goal.asked()) : Things();
    for (const std::size_t open : run.openPredictions()) {
        for (const Hideable thing : telling(*run.lesson().steps[open].goal.asked())) {
            if (open < run.step() || !read.contains(thing)) {
                step.hidden.push_back({thing});
            }
        }
    }
    return of(step);
}

void HiddenThings::hide(const Things& things) {
    m_hidden = things;
    for (Entry& entry : m_entries) {
        const bool hidden = std::any_of(entry.with.begin(), entry.with.end(),
                                        [&things](Hideable each) { return things.contains(each); });
        if (hidden != entry.isHidden) {
            entry.isHidden = hidden;
            entry.hide(hidden);
        }
    }
}

} // namespace sparkout
