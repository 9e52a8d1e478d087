// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/handout_figures.h"

#include "ui/report/parts/course_figures.h"
#include "ui/report/parts/feeds_figure.h"

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr int revolutionsAround = 3; ///< number of steps shown on each side of a plunge's step

} // namespace

std::optional<Figure> HandoutFigures::feedsAround(const OutcomePtr& outcome,
                                                  const HandoutStep& step) {
    const Pass& pass = outcome->trajectory.passes[step.pass];
    const FeedSeries& feeds = outcome->feeds;
    const bool strokes = feeds.operation->countsStrokes;
    const int around = strokes ? 0 : revolutionsAround;
    const int first = std::max(1, pass.place.cycleCount - around);
    const int last = std::min(feeds.strokeCount(), pass.place.cycleCount + around);
    const double start_s = feeds.strokeStart_s.at(static_cast<std::size_t>(first - 1));
    const double moment_s =
        pass.start_s + pass.duration_s * (step.radius + 1) / std::max(1, outcome->trajectory.radii);
    const QString caption =
        strokes
            ? tr("Feeds in double stroke %1; the line marks the step").arg(pass.place.cycleCount)
            : tr("Feeds around revolution %1; the line marks the step").arg(pass.place.cycleCount);
    return feedsFigure(outcome, start_s, feeds.strokeEnd_s(last), moment_s, caption);
}

std::vector<Block> HandoutFigures::figures(const OutcomePtr& outcome,
                                           const std::optional<HandoutStep>& step,
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

} // namespace sparkout::report
