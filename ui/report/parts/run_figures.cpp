// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/run_figures.h"

#include "core/process/system_compliance.h"
#include "core/quality/limit_series.h"
#include "core/simulation/feed_series.h"
#include "ui/report/format/plot_figure.h"
#include "ui/text/names.h"
#include "ui/views/constraints/constraints_plot.h"
#include "ui/views/feeds/feeds_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"

#include <QCoreApplication>

namespace sparkout::report {

namespace {

constexpr int feedsHeight = 420, profilesHeight = 400, limitsHeight = 380;

struct RunFigures {
    Q_DECLARE_TR_FUNCTIONS(RunFigures)
};

} // namespace

std::optional<Figure> feedsFigure(const OutcomePtr& outcome) {
    return feedsFigure(outcome, 0, outcome->feeds.end_s, {},
                       RunFigures::tr("Feeds by stage over the whole cycle"));
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
                shownSections(count, project.operation->travels ? 0 : gaugeSection(project)));
    plot.restyle();
    plot.setMoment(moment_s);
    plot.showTimes(from_s, to_s);
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

Figure profilesFigure(const OutcomePtr& outcome) {
    const SimulationResult& result = outcome->result;
    const std::vector<int> shown =
        shownSections(static_cast<int>(result.sections.size()), gaugeProfile(result));
    ProfilesPlot plot;
    setUpForPaper(plot, profilesHeight);
    plot.setHidden({ProfileLine::blank});
    plot.setSeries(makeProfileSeries(result, outcome->trajectory), shown);
    plot.restyle();
    plot.fit();
    using enum ProfileLine;
    return plotFigure(plot, plot.entriesOf({profile, target, leastSquares, field}),
                      RunFigures::tr("Cross-sections at the end of the cycle"),
                      ProfilesText::summary(plot.series(), plot.shown()));
}

std::optional<Figure> limitsFigure(const OutcomePtr& outcome, const Place& at) {
    const int group = limitGroupAt(outcome->limits, at);
    if (group < 0) {
        return {};
    }
    ConstraintsPlot plot;
    setUpForPaper(plot, limitsHeight);
    plot.setRun(outcome, group);
    plot.restyle();
    plot.fit();
    if (plot.limits().cuts()->cuts.empty()) {
        return {};
    }
    const QString caption = RunFigures::tr("%1: actual feed over the stock left, under its limits")
                                .arg(Names::zoneFull(at.zone, at.section));
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

} // namespace sparkout::report
