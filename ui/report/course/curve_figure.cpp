// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/curve_figure.h"

#include "ui/plot/plot_style.h"
#include "ui/report/course/goal_words.h"
#include "ui/report/format/plot_figure.h"

#include <qcustomplot.h>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr int curveHeight = 340, blankHeight = 420, gridLines = 10;
constexpr double lineWidth = 2, roomAbove = 0.1;
constexpr QColor saidColour(0xd5, 0x5e, 0x00), engineColour(0x00, 0x72, 0xb2),
    gridColour(0x96, 0x96, 0x96);

/// Axes with their names, for a curve prediction.
void setUpAxes(QCustomPlot& plot, const CurvePrediction& goal, const Project& project) {
    sparkout::Figure figure = goal.figure;
    plot.xAxis->setLabel(GoalWords::along(goal, project));
    plot.yAxis->setLabel(GoalWords::withUnit(GoalWords::quantity(figure, project), figure));
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        style::setUpAxis(*axis);
    }
    if (goal.along == CurveAlong::place) {
        const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
        for (const double at : goal.at) {
            names->addTick(at, GoalWords::alongAt(goal, at, project));
        }
        plot.xAxis->setTicker(names);
    }
    style::applyPalette(plot, plot.palette());
}

QCPGraph* addGraph(QCustomPlot& plot, const QColor& colour, Qt::PenStyle pen) {
    QCPGraph* graph = plot.addGraph();
    graph->setPen(QPen(colour, lineWidth, pen));
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, 7));
    return graph;
}

} // namespace

Figure CurveFigure::compared(const CurvePrediction& goal, const Project& project,
                             const GoalResult& result, const NumberRows& said) {
    QCustomPlot plot;
    setUpForPaper(plot, curveHeight);
    setUpAxes(plot, goal, project);
    QCPGraph* const engine = addGraph(plot, engineColour, Qt::SolidLine);
    QCPGraph* const predicted = addGraph(plot, saidColour, Qt::DashLine);
    double left = goal.at.empty() ? 0 : goal.at.front(), right = left, top = 0, bottom = 0;
    const auto add = [&](QCPGraph* graph, double x, double y) {
        graph->addData(x, y);
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::max(top, y);
        bottom = std::min(bottom, y);
    };
    for (const ComparedPoint& point : result.curve) {
        add(engine, point.at, point.value);
    }
    for (const auto& point : said.value_or(std::vector<std::vector<double>>())) {
        if (point.size() == 2) {
            add(predicted, point[0], point[1]);
        }
    }
    style::setSafeRange(*plot.xAxis, left, right);
    const double room = roomAbove * (top - bottom);
    style::setSafeRange(*plot.yAxis, bottom < 0 ? bottom - room : 0, top + room);
    const LegendEntries legend{{.colour = saidColour, .pen = Qt::DashLine, .text = tr("Predicted")},
                               {.colour = engineColour, .text = tr("By the engine")}};
    const QString caption = GoalWords::quantity(goal.figure, project);
    return plotFigure(plot, legend, caption,
                      tr("%1: what was predicted beside what the engine computes").arg(caption));
}

Figure CurveFigure::blank(const CurvePrediction& goal, const Project& project) {
    QCustomPlot plot;
    setUpForPaper(plot, blankHeight);
    setUpAxes(plot, goal, project);
    const auto [least, most] = std::ranges::minmax_element(goal.at);
    if (least != goal.at.end()) {
        style::setSafeRange(*plot.xAxis, *least, *most);
    }
    // The student scales the values: a scale would reveal their size.
    plot.yAxis->setTickLabels(false);
    style::setSafeRange(*plot.yAxis, 0, gridLines);
    const QSharedPointer<QCPAxisTickerFixed> lines(new QCPAxisTickerFixed);
    lines->setTickStep(1);
    plot.yAxis->setTicker(lines);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->grid()->setPen(QPen(gridColour, 1));
        axis->grid()->setSubGridVisible(axis == plot.xAxis);
        axis->grid()->setSubGridPen(QPen(gridColour, 0.5, Qt::DotLine));
    }
    const QString caption = GoalWords::quantity(goal.figure, project);
    return plotFigure(plot, {}, caption, tr("A grid to draw on: %1").arg(caption));
}

} // namespace sparkout::report
