// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/figures.h"

#include "core/process/system_compliance.h"
#include "ui/report/plot_figure.h"
#include "ui/views/feeds_plot.h"

#include <QCoreApplication>

namespace sparkout::report {

namespace {

constexpr int feedsHeight = 420;

struct FeedsFigure {
    Q_DECLARE_TR_FUNCTIONS(FeedsFigure)
};

} // namespace

std::optional<Figure> feedsFigure(const OutcomePtr& outcome) {
    if (outcome->trajectory.passes.empty()) {
        return {};
    }
    const Project& project = outcome->result.project;
    const auto count = static_cast<int>(outcome->feeds.columns.size());
    FeedsPlot plot;
    setUpForPaper(plot, feedsHeight);
    plot.setRun(
        outcome,
        shownSections(count, project.operation == Operation::plunge ? gaugeSection(project) : 0));
    plot.restyle();
    plot.showAll();
    const QString caption = FeedsFigure::tr("Feeds by stage over the whole cycle");
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

} // namespace sparkout::report
