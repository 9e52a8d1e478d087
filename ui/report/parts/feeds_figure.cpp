// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/feeds_figure.h"

#include "core/process/system_compliance.h"
#include "ui/report/format/plot_figure.h"
#include "ui/views/feeds/feeds_plot.h"

#include <QCoreApplication>

namespace sparkout::report {

namespace {

constexpr int feedsHeight = 420;

struct FeedsFigure {
    Q_DECLARE_TR_FUNCTIONS(FeedsFigure)
};

} // namespace

std::optional<Figure> feedsFigure(const OutcomePtr& outcome) {
    return feedsFigure(outcome, 0, outcome->feeds.end_s, {},
                       FeedsFigure::tr("Feeds by stage over the whole cycle"));
}

std::optional<Figure> feedsFigure(const OutcomePtr& outcome, double from_s, double to_s,
                                  std::optional<double> moment_s, const QString& caption) {
    if (outcome->trajectory.passes.empty()) {
        return {};
    }
    const Project& project = outcome->result.project;
    const auto count = static_cast<int>(outcome->feeds.columns.size());
    FeedsPlot plot;
    setUpForPaper(plot, feedsHeight);
    plot.setRun(outcome,
                shownSections(count, project.operation->hasZones ? 0 : gaugeSection(project)));
    plot.restyle();
    plot.setMoment(moment_s);
    plot.showTimes(from_s, to_s);
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

} // namespace sparkout::report
