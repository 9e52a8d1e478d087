// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_plot.h"

#include "core/project/sweep.h"
#include "ui/plot/number_ticker.h"
#include "ui/text/shown_scale.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

using style::Drawn;

SweepPlot::SweepPlot(QWidget* parent) : ViewPlot(parent), m_rect(addRect()) {
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        if (style::fitValueAxes(*m_rect, font())) {
            replot(rpQueuedReplot);
        }
    });
    const auto choose = [this](const QPointF& at) {
        if (const auto point = pointAt(at)) {
            emit pointChosen(*point);
        }
    };
    onClick(choose);
    connect(this, &QCustomPlot::mousePress, this, [choose](QMouseEvent* event) {
        if (event->button() == Qt::RightButton) { // its menu is about this point
            choose(event->position());
        }
    });
}

void SweepPlot::setSweep(SweepResultPtr sweep, SweepEntry entry, bool margins) {
    m_sweep = std::move(sweep);
    m_entry = std::move(entry);
    m_margins = margins;
    for (std::size_t i = 0; m_sweep && i < m_sweep->inputs.size() && i < 2; ++i) {
        (i == 0 ? across() : up())
            ->setTicker(QSharedPointer<QCPAxisTicker>(i == 0 || m_sweep->inputs.size() == 2
                                                          ? new SweepTicker(scaleOf(i))
                                                          : new NumberTicker));
    }
    fill();
    fillMarks();
    contentSet();
}

void SweepPlot::setPresent(std::vector<std::optional<double>> values) {
    if (m_present != values) {
        m_present = std::move(values);
        fillMarks();
        showChoice();
        emit contentChanged();
    }
}

void SweepPlot::setChosen(std::optional<std::size_t> point) {
    m_chosen = point;
    fillMarks();
    showChoice();
    emit contentChanged(); // the legend names it
}

// --- what it is about ---------------------------------------------------------------------------

SweepScale SweepPlot::scaleOf(std::size_t input) const {
    const SweepAxis& axis = sweep().inputs[input].axis;
    return {axis.spacing == SweepSpacing::logarithmic, ShownScale::at(axis.input)};
}

std::optional<double> SweepPlot::presentPlace(std::size_t input) const {
    if (input >= m_present.size() || !m_present[input]) {
        return std::nullopt;
    }
    const double place = scaleOf(input).at(*m_present[input]);
    return std::isfinite(place) ? std::optional(place) : std::nullopt;
}

double SweepPlot::shownAt(std::size_t point, std::size_t quantity) const {
    const SweepPoint& at = sweep().points[point];
    if (at.values.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return m_margins ? at.values[quantity].margin : at.values[quantity].value;
}

bool SweepPlot::any(SweepStatus status) const {
    return std::ranges::find(sweep().points, status, &SweepPoint::status) != sweep().points.end();
}

std::vector<double> SweepPlot::placesOf(std::size_t input) const {
    std::vector<double> places;
    for (const double value : sweep().inputs[input].values) {
        places.push_back(scaleOf(input).at(value));
    }
    return places;
}

QCPGraph* SweepPlot::addMarks(QCPAxis* value) {
    QCPGraph* const graph = addGraph(across(), value);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setAdaptiveSampling(false);
    return graph;
}

void SweepPlot::addStatusMarks(QCPAxis* value, double size) {
    m_refused = addMarks(value);
    m_notReached = addMarks(value);
    m_signSize = size;
    setKeyed(refusedKey, {m_refused});
    setKeyed(notReachedKey, {m_notReached});
}

void SweepPlot::clearStatusMarks() {
    m_refused->data()->clear();
    m_notReached->data()->clear();
}

void SweepPlot::fillStatusMarks(const std::function<double(std::size_t)>& height) {
    for (std::size_t i = 0; i < sweep().points.size(); ++i) {
        const SweepStatus status = sweep().points[i].status;
        if (status == SweepStatus::refused || status == SweepStatus::notReached) {
            (status == SweepStatus::refused ? m_refused : m_notReached)
                ->addData(scaleOf(0).at(sweep().valuesAt(i)[0]), height(i));
        }
    }
}

void SweepPlot::addStatusEntries(LegendEntries& entries) const {
    const auto add = [&](SweepStatus status, Drawn what, const QString& text, int key) {
        if (any(status)) {
            entries.push_back(areaEntry(key, toned(what), text));
        }
    };
    add(SweepStatus::refused, Drawn::refused, tr("refused (×)"), refusedKey);
    add(SweepStatus::notReached, Drawn::sizeNotReached, tr("does not reach size (▲)"),
        notReachedKey);
}

// --- the mouse ----------------------------------------------------------------------------------

std::optional<std::size_t> SweepPlot::pointAt(const QPointF& pixel) const {
    if (empty() || !m_rect->rect().contains(pixel.toPoint())) {
        return std::nullopt;
    }
    const auto nearest = [this](std::size_t input, const QCPAxis& axis, double at) {
        const std::vector<double>& values = sweep().inputs[input].values;
        const SweepScale scale = scaleOf(input);
        const auto away = [&](double value) {
            return std::abs(axis.coordToPixel(scale.at(value)) - at);
        };
        return static_cast<std::size_t>(std::ranges::min_element(values, {}, away)
                                        - values.begin());
    };
    const std::size_t first = nearest(0, *across(), pixel.x());
    return sweep().index(first, sweep().inputs.size() > 1 ? nearest(1, *up(), pixel.y()) : 0);
}

QPointF SweepPlot::pixelOf(std::size_t point) const {
    const std::vector<double> values = sweep().valuesAt(point);
    const double x = across()->coordToPixel(scaleOf(0).at(values[0]));
    return {x, values.size() > 1 ? up()->coordToPixel(scaleOf(1).at(values[1]))
                                 : m_rect->center().y()};
}

QString SweepPlot::valuesAt(const QPointF& at) const {
    const auto point = pointAt(at);
    return point ? SweepText::point(sweep(), *point, m_entry) : QString();
}

// --- table, look and words ----------------------------------------------------------------------

CsvTable SweepPlot::table() const {
    if (empty()) {
        return {};
    }
    return tableOf(sweep(), m_entry.quantities, [this](std::size_t point) {
        const std::vector<double> values = sweep().valuesAt(point);
        return across()->range().contains(scaleOf(0).at(values[0]))
               && (values.size() < 2 || up()->range().contains(scaleOf(1).at(values[1])));
    });
}

CsvTable SweepPlot::tableOf(const SweepResult& sweep, const std::vector<std::size_t>& quantities,
                            const std::function<bool(std::size_t)>& wanted) {
    CsvTable table;
    for (const SweptInput& input : sweep.inputs) {
        table.header << SweepText::inputAxis(input);
    }
    table.header << tr("State");
    for (const std::size_t q : quantities) {
        const QString name = SweepText::column(sweep.quantities[q]);
        table.header << name << tr("%1: lower limit").arg(name) << tr("%1: upper limit").arg(name)
                     << tr("%1: margin").arg(name);
    }
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const SweepPoint& point = sweep.points[i];
        if (point.status == SweepStatus::pending || !wanted(i)) {
            continue;
        }
        const std::vector<double> values = sweep.valuesAt(i);
        std::vector<CsvCell> row;
        for (std::size_t of = 0; of < values.size(); ++of) {
            row.emplace_back(ShownScale::at(sweep.inputs[of].axis.input).shown(values[of]));
        }
        row.emplace_back(SweepText::status(point));
        for (const std::size_t q : quantities) {
            const SweepValue value = point.values.empty() ? SweepValue{} : point.values[q];
            row.insert(row.end(), {value.value, value.low, value.high, value.margin});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

void SweepPlot::restyle() {
    ViewPlot::restyle();
    m_refused->setScatterStyle(QCPScatterStyle(
        QCPScatterStyle::ssCross, QPen(toned(Drawn::refused), 2), Qt::NoBrush, m_signSize));
    const QColor stuck = toned(Drawn::sizeNotReached);
    m_notReached->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssTriangle, QPen(stuck), stuck, m_signSize));
    colour();
}

void SweepPlot::setTexts() {
    if (!empty()) {
        across()->setLabel(SweepText::inputAxis(sweep().inputs[0]));
        label();
    }
}

} // namespace sparkout
