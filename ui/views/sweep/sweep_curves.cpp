// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_curves.h"

#include "ui/plot/run_dash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double dotSize = 5, footSize = 9, chosenSize = 12; ///< [px]
constexpr double foot = 0.03; ///< of the height, where points without numbers stand
constexpr double sweepRoom = 0.05;

} // namespace

SweepCurves::SweepCurves(QWidget* parent) : SweepPlot(parent), m_present(addRule(*cell(), 0)) {
    QCPAxis* const beside = cell()->axis(QCPAxis::atRight);
    beside->setRange(0, 1);
    addStatusMarks(beside, footSize);
    m_chosenFoot = addMarks(beside);
    m_chosenMarks = addMarks(up());
    m_present->setVisible(false);
    built();
}

/// Of too many sections those that come nearest to a limit anywhere.
void SweepCurves::chooseQuantities() {
    m_quantities = entry().quantities;
    if (m_quantities.size() <= mostCurves) {
        return;
    }
    const auto least = [this](std::size_t q) {
        double margin = std::numeric_limits<double>::max();
        for (const SweepPoint& point : sweep().points) {
            if (!point.values.empty() && point.values[q].margin < margin) {
                margin = point.values[q].margin;
            }
        }
        return margin;
    };
    std::ranges::stable_sort(m_quantities, {}, least);
    m_quantities.resize(mostCurves);
    std::ranges::sort(m_quantities);
}

void SweepCurves::fill() {
    for (std::vector<QCPGraph*>* graphs : {&m_curves, &m_limits}) {
        for (QCPGraph* graph : *graphs) {
            removeGraph(graph);
        }
        graphs->clear();
    }
    for (QCPItemRect* band : m_bands) {
        removeItem(band);
    }
    m_bands.clear();
    clearStatusMarks();
    m_quantities.clear();
    if (empty()) {
        return;
    }
    chooseQuantities();
    const std::vector<double> places = placesOf(0);
    for (const std::size_t q : m_quantities) {
        QCPGraph* const curve = ViewPlot::addLine(*cell());
        curve->setAdaptiveSampling(false);
        for (std::size_t i = 0; i < places.size(); ++i) {
            curve->addData(places[i], shownAt(i, q));
        }
        setKeyed(static_cast<int>(m_curves.size()), {curve});
        m_curves.push_back(curve);
    }
    addLimits();
    addBands();
    fillStatusMarks([](std::size_t) { return foot; });
}

/// They may move with the input; those of several zones that are the same are one line.
void SweepCurves::addLimits() {
    const std::vector<double> places = placesOf(0);
    std::vector<std::vector<double>> drawn;
    const auto addLine = [&](const std::vector<double>& line) {
        const bool none = std::ranges::all_of(line, [](double y) { return std::isnan(y); });
        const auto same = [&line](const std::vector<double>& other) {
            return std::ranges::equal(line, other, [](double a, double b) {
                return a == b || (std::isnan(a) && std::isnan(b));
            });
        };
        if (none || std::ranges::any_of(drawn, same)) {
            return;
        }
        QCPGraph* const graph = ViewPlot::addLine(*cell());
        for (std::size_t i = 0; i < places.size(); ++i) {
            graph->addData(places[i], line[i]);
        }
        m_limits.push_back(graph);
        setKeyed(limitKey, {graph});
        drawn.push_back(line);
    };
    for (const std::size_t q : m_quantities) {
        for (const bool high : {false, true}) {
            std::vector<double> line;
            for (const SweepPoint& point : sweep().points) {
                const SweepValue value = point.values.empty() ? SweepValue{} : point.values[q];
                const double limit = high ? value.high : value.low;
                line.push_back(margins() && !std::isnan(value.margin) ? 0 : limit);
            }
            addLine(line);
        }
    }
}

std::vector<QCPRange> SweepCurves::holding() const {
    std::vector<QCPRange> ranges;
    if (empty()) {
        return ranges;
    }
    const std::vector<double>& values = sweep().inputs[0].values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!sweep().points[i].good) {
            continue;
        }
        if (i > 0 && sweep().points[i - 1].good) {
            ranges.back().upper = values[i];
        } else {
            ranges.emplace_back(values[i], values[i]);
        }
    }
    return ranges;
}

void SweepCurves::addBands() {
    for (const QCPRange& range : holding()) {
        auto* const band = new QCPItemRect(this);
        band->setLayer(QStringLiteral("background"));
        band->setClipAxisRect(cell());
        anchor({band->topLeft, band->bottomRight}, *cell());
        band->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
        band->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
        band->topLeft->setCoords(scaleOf(0).at(range.lower), 0);
        band->bottomRight->setCoords(scaleOf(0).at(range.upper), 1);
        m_bands.push_back(band);
        setKeyed(holdsKey, {band});
    }
}

void SweepCurves::fillMarks() {
    m_chosenMarks->data()->clear();
    m_chosenFoot->data()->clear();
    m_hasPresent = false;
    if (empty()) {
        return;
    }
    if (const auto place = presentPlace(0)) {
        m_hasPresent = true;
        m_present->point1->setCoords(*place, 0);
        m_present->point2->setCoords(*place, 1);
    }
    if (chosen()) {
        const double x = scaleOf(0).at(sweep().valuesAt(*chosen())[0]);
        m_chosenFoot->addData(x, foot);
        for (const std::size_t q : m_quantities) {
            m_chosenMarks->addData(x, shownAt(*chosen(), q));
        }
    }
}

/// All points; limits where they are near, or they would squeeze the curves.
void SweepCurves::fit() {
    if (empty()) {
        return;
    }
    const auto range = [](double& low, double& high, double value) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    };
    constexpr double none = std::numeric_limits<double>::infinity();
    double low = none, high = -none;
    for (std::size_t i = 0; i < sweep().points.size(); ++i) {
        for (const std::size_t q : m_quantities) {
            range(low, high, shownAt(i, q));
        }
    }
    const double size = high - low;
    for (const QCPGraph* limit : m_limits) {
        for (const QCPGraphData& at : *limit->data()) {
            if (at.value > low - size && at.value < high + size) {
                range(low, high, at.value);
            }
        }
    }
    if (low <= high) {
        style::setRoomyRange(*up(), low, high, sweepRoom, 1e-2);
    }
    const std::vector<double>& values = sweep().inputs[0].values;
    const double from = scaleOf(0).at(values.front()), to = scaleOf(0).at(values.back());
    const double beside = sweepRoom / 2 * (to - from);
    style::setSafeRange(*across(), from - beside, to + beside);
}

// --- look and words -----------------------------------------------------------------------------

void SweepCurves::colour() {
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const QColor of = toned(style::oneOfSeries(i));
        m_curves[i]->setPen(runPen(static_cast<int>(i), of));
        m_curves[i]->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(of), of, dotSize));
    }
    for (QCPGraph* limit : m_limits) {
        limit->setPen(QPen(toned(Drawn::limit), 1.5, Qt::DashLine));
    }
    for (QCPItemRect* band : m_bands) {
        QColor of = toned(Drawn::everyRequirementHolds);
        of.setAlphaF(of.alphaF() * 0.18F);
        band->setPen(Qt::NoPen);
        band->setBrush(of);
    }
    const QColor text = ink();
    m_present->setPen(QPen(text, 1.5, Qt::DotLine));
    for (QCPGraph* marks : {m_chosenMarks, m_chosenFoot}) {
        marks->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 2), Qt::NoBrush, chosenSize));
    }
}

void SweepCurves::label() {
    up()->setLabel(SweepText::axis(sweep(), entry(), margins()));
}

void SweepCurves::showChoice() {
    SweepPlot::showChoice();
    m_present->setVisible(m_hasPresent && shows(presentKey));
}

LegendEntries SweepCurves::legendEntries() const {
    LegendEntries entries;
    if (empty()) {
        return entries;
    }
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const SweepQuantity& quantity = sweep().quantities[m_quantities[i]];
        entries.push_back(lineEntry(static_cast<int>(i), m_curves[i]->pen(),
                                    quantity.section < 0 ? SweepText::name(quantity)
                                                         : SweepText::where(quantity)));
    }
    if (!m_limits.empty()) {
        entries.push_back(lineEntry(limitKey, m_limits.front()->pen(), tr("limit")));
    }
    if (!m_bands.empty()) {
        entries.push_back(
            areaEntry(holdsKey, m_bands.front()->brush().color(), tr("requirements met")));
    }
    if (m_hasPresent) {
        entries.push_back(lineEntry(presentKey, m_present->pen(), tr("current value")));
    }
    addStatusEntries(entries);
    return entries;
}

} // namespace sparkout
