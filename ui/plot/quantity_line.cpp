// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/quantity_line.h"

#include <algorithm>
#include <array>

namespace sparkout::style {

namespace {

struct Line {
    Qt::PenStyle dash = Qt::SolidLine;
    double weight = 1.5;
};

struct LineRow {
    Drawn what;
    Line line;
};

constexpr LineRow lines[] = {
    {Drawn::programmedFeed, {Qt::DashLine, 1.5}},
    {Drawn::actualFeed, {Qt::SolidLine, 1.5}},
    {Drawn::radiusBefore, {Qt::DotLine, 1.5}},
    {Drawn::radiusAfter, {Qt::DashDotLine, 1.8}},
    {Drawn::axialFeed, {Qt::DashDotDotLine, 1.8}},
    {Drawn::force, {Qt::SolidLine, 2.5}},
    {Drawn::measuredValue, {Qt::SolidLine, 1.2}},
    {Drawn::simulatedValue, {Qt::DashLine, 1.8}},
    {Drawn::measuredDifference, {Qt::DotLine, 1.5}},
    {Drawn::profile, {Qt::SolidLine, 1.9}},
    {Drawn::blank, {Qt::DotLine, 1.4}},
    {Drawn::target, {Qt::DashLine, 1.3}},
    {Drawn::referenceCircle, {Qt::DashDotDotLine, 1.3}},
    {Drawn::toleranceField, {Qt::SolidLine, 1}},
    {Drawn::gauge, {Qt::DashDotLine, 1.2}},
    {Drawn::independentSections, {Qt::SolidLine, 2}},
    {Drawn::coupledSections, {Qt::DashLine, 2}},
    {Drawn::couplingDifference, {Qt::DotLine, 2}},
    {Drawn::limit, {Qt::DashLine, 1.5}},
};

constexpr std::array depthLimitLines{Line{Qt::DashLine, 1.6}, Line{Qt::DashDotLine, 1.6},
                                     Line{Qt::DashLine, 2.6}, Line{Qt::DashDotDotLine, 1.6},
                                     Line{Qt::DotLine, 1.6}};

QPen penOf(const Line& line, const QColor& colour) {
    return {colour, line.weight, line.dash};
}

} // namespace

QPen line(Drawn what, const QColor& colour) {
    const auto* const found = std::ranges::find(lines, what, &LineRow::what);
    return penOf(found == std::end(lines) ? Line() : found->line, colour);
}

QPen lineOfDepthLimit(std::size_t index, const QColor& colour) {
    return penOf(depthLimitLines[std::min(index, depthLimitLines.size() - 1)], colour);
}

} // namespace sparkout::style
