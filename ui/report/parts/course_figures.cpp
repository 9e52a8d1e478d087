// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the hand-out that the cycle card has not.
#include "ui/report/parts/course_figures.h"

#include "core/quality/limit_series.h"
#include "core/simulation/feed_series.h"
#include "ui/report/format/plot_figure.h"
#include "ui/text/names.h"
#include "ui/views/constraints/constraints_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"

#include <QCoreApplication>

namespace sparkout::report {

namespace {

constexpr int profilesHeight = 400, limitsHeight = 380;

struct CourseFigure {
    Q_DECLARE_TR_FUNCTIONS(CourseFigure)
};

} // namespace

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
                      CourseFigure::tr("Cross-sections at the end of the cycle"),
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
    const QString caption =
        CourseFigure::tr("%1: actual feed over the stock left, under its limits")
            .arg(Names::zoneFull(at.zone, at.section));
    return plotFigure(plot, plot.legendEntries(), caption, caption);
}

} // namespace sparkout::report
