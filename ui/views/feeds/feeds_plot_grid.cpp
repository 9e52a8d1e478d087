// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of plots: building, linking, room and labels.
#include "ui/views/feeds/feeds_plot.h"

#include "ui/kit/font_size.h"
#include "ui/plot/band_layer.h"
#include "ui/plot/number_ticker.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr int gap = 6;      ///< beside each plot, between the columns
constexpr int labelGap = 5; ///< between the tick labels of two columns
constexpr int tickPad = 3;
constexpr int labelPad = 3;
constexpr int smallestPlot = 40;
constexpr int rowGap = 4;    ///< above and below each plot
constexpr int bottomPad = 2; ///< below the tick labels

/// Leaves the last label out where it would run into the first one of the plot to the right.
class InnerTicker : public NumberTicker {
public:
    explicit InnerTicker(const QCPAxis& axis) : m_axis(axis) {}

    void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                  QVector<double>& ticks, QVector<double>* subTicks,
                  QVector<QString>* labels) override {
        QCPAxisTicker::generate(range, locale, formatChar, precision, ticks, subTicks, labels);
        if (!labels || labels->isEmpty()) {
            return;
        }
        const QFontMetrics metrics(m_axis.tickLabelFont());
        const double after = m_axis.coordToPixel(ticks.last())
                             + metrics.horizontalAdvance(labels->last()) / 2.0
                             - m_axis.axisRect()->right();
        const double before = m_axis.axisRect()->left() - m_axis.coordToPixel(ticks.first())
                              + metrics.horizontalAdvance(labels->first()) / 2.0;
        if (after + before > 2 * gap - labelGap) {
            labels->last().clear();
        }
    }

private:
    const QCPAxis& m_axis;
};

/// Width of the widest tick label an axis will draw.
int tickWidth(const QCPAxis& axis, const QLocale& locale, const QFontMetrics& metrics) {
    QVector<double> ticks;
    QVector<QString> labels;
    axis.ticker()->generate(axis.range(), locale, QLatin1Char('g'), axis.numberPrecision(), ticks,
                            nullptr, &labels);
    int width = 0;
    for (const QString& label : labels) {
        width = std::max(width, metrics.horizontalAdvance(label));
    }
    return width;
}

} // namespace

void FeedsPlot::buildGrid(std::size_t columns) {
    for (Column& column : m_columns) {
        for (BandLayer* band : column.bands) {
            delete band;
        }
    }
    m_columns.clear();
    clearGraphs();
    plotLayout()->clear();
    m_grid = new QCPLayoutGrid;
    m_grid->setRowSpacing(2);
    m_grid->setColumnSpacing(0);
    m_timeLabel = new QCPTextElement(this);
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, m_grid);
    plotLayout()->addElement(1, 0, m_timeLabel);
    plotLayout()->setRowStretchFactor(1, 0.001);
    m_columns.resize(columns);
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i].header = new QCPTextElement(this);
        m_grid->addElement(0, static_cast<int>(i), m_columns[i].header);
        for (int row = 0; row < rowCount; ++row) {
            buildCell(m_columns[i], row, static_cast<int>(i));
        }
    }
    m_grid->setRowStretchFactor(0, 0.001);
    m_values = {};
    linkAxes();
    showCurves();
    restyle();
}

void FeedsPlot::buildCell(Column& column, int row, int index) {
    auto* rect = new QCPAxisRect(this, true);
    const auto r = static_cast<std::size_t>(row);
    const bool first = index == 0;
    const bool last = index + 1 == columnCount();
    column.rects[r] = rect;
    m_grid->addElement(row + 1, index, rect);
    rect->setAutoMargins(QCP::msTop | QCP::msBottom);
    const int top = row == 0 ? BandLayer::nameMargin(font()) : rowGap;
    rect->setMinimumMargins(QMargins(0, top, 0, row + 1 < rowCount ? rowGap : 0));
    setUpAxes(rect, row, first, last);
    column.bands[r] = new BandLayer(rect, row == 0);
    addRow(column, row);
}

void FeedsPlot::setUpAxes(QCPAxisRect* rect, int row, bool first, bool last) {
    for (QCPAxis* axis : rect->axes()) {
        style::setUpAxis(*axis);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->setTickLabelPadding(tickPad);
        axis->setPadding(bottomPad);
        axis->ticker()->setTickCount(4);
    }
    const bool rightValues = row == 1 || (row == 2 && hasAxialFeed());
    rect->axis(QCPAxis::atTop)->setVisible(true);
    rect->axis(QCPAxis::atTop)->setTicks(false);
    rect->axis(QCPAxis::atTop)->setTickLabels(false);
    rect->axis(QCPAxis::atRight)->setVisible(true);
    rect->axis(QCPAxis::atRight)->setTicks(rightValues);
    rect->axis(QCPAxis::atRight)->setTickLabels(rightValues && last);
    rect->axis(QCPAxis::atRight)->grid()->setVisible(false);
    rect->axis(QCPAxis::atLeft)->setTickLabels(first);
    QCPAxis* const times = rect->axis(QCPAxis::atBottom);
    times->setTickLabels(row + 1 == rowCount);
    if (!last) {
        times->setTicker(QSharedPointer<QCPAxisTicker>(new InnerTicker(*times)));
    }
}

void FeedsPlot::addRow(Column& column, int row) {
    QCPAxisRect* rect = column.rects[static_cast<std::size_t>(row)];
    QCPAxis* left = rect->axis(QCPAxis::atLeft);
    QCPAxis* right = rect->axis(QCPAxis::atRight);
    if (row == 0) {
        addCurves(column, Quantity::actual, left, true);
        addCurves(column, Quantity::programmed, left, false);
    } else if (row == 1) {
        addCurves(column, Quantity::came, right, true);
        addCurves(column, Quantity::left, right, true);
        addCurves(column, Quantity::actualSum, left, true);
        addCurves(column, Quantity::programmedSum, left, false);
    } else if (hasAxialFeed()) {
        addCurves(column, Quantity::force, right, true);
        addCurves(column, Quantity::axialFeed, left, false);
    } else {
        addCurves(column, Quantity::force, left, true);
    }
}

void FeedsPlot::addCurves(Column& column, Quantity quantity, QCPAxis* value, bool band) {
    QCPAxis* key = value->axisRect()->axis(QCPAxis::atBottom);
    QCPGraph* low = nullptr;
    for (Edge edge : {Edge::low, Edge::high, Edge::mean}) {
        if (edge != Edge::mean && !band) {
            continue;
        }
        QCPGraph* graph = addGraph(key, value);
        graph->removeFromLegend();
        graph->setSelectable(QCP::stNone);
        if (edge == Edge::low) {
            low = graph;
        } else if (edge == Edge::high) {
            graph->setChannelFillGraph(low);
        }
        column.curves.push_back({quantity, edge, graph});
    }
}

void FeedsPlot::linkAxes() {
    const auto changed = QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged);
    for (const Column& column : m_columns) {
        for (QCPAxisRect* rect : column.rects) {
            connect(rect->axis(QCPAxis::atBottom), changed, this, &FeedsPlot::onTimesChanged);
            for (auto type : {QCPAxis::atLeft, QCPAxis::atRight}) {
                QCPAxis* axis = rect->axis(type);
                connect(axis, changed, this,
                        [this, axis](const QCPRange& range) { onValuesChanged(axis, range); });
            }
        }
    }
}

void FeedsPlot::setTexts() {
    labelAxes();
    if (m_outcome) {
        fillBands();
    }
}

QString FeedsPlot::timeLabel() const {
    switch (m_axis) {
    case CycleAxis::minutes: return tr("Time, min");
    case CycleAxis::seconds: return tr("Time, s");
    case CycleAxis::strokes:
        return countsStrokes() ? tr("Double strokes done") : tr("Revolutions done");
    case CycleAxis::revolutions: return tr("Revolutions done");
    }
    return {};
}

void FeedsPlot::labelAxes() {
    if (m_columns.empty()) {
        return;
    }
    nameValueAxes(false);
    m_timeLabel->setText(timeLabel());
    m_timeLabel->setFont(font());
    fitColumns();
}

/// Full names in two lines, or brief ones where a plot is lower than those are long.
void FeedsPlot::nameValueAxes(bool brief) {
    const bool stroke = m_detail == Detail::stroke;
    const QString feed = brief              ? tr("Feed, µm")
                         : !countsStrokes() ? tr("Feed, µm\nper revolution")
                         : stroke           ? tr("Feed, µm per\ndouble stroke")
                                            : tr("Feed, µm\nper pass");
    const QString sum = brief ? tr("Σ feed,\nµm") : tr("Accumulated\nfeed, µm");
    const QString axial = brief ? tr("Axial,\nmm/min") : tr("Axial feed,\nmm/min");
    const QString force = brief ? tr("Force, N") : tr("Normal\nforce, N");
    const QString radius = brief ? tr("Radius,\nµm") : tr("Radius above\ntarget, µm");
    const auto& left = m_columns.front().rects;
    const auto& right = m_columns.back().rects;
    left[0]->axis(QCPAxis::atLeft)->setLabel(feed);
    left[1]->axis(QCPAxis::atLeft)->setLabel(sum);
    left[2]->axis(QCPAxis::atLeft)->setLabel(hasAxialFeed() ? axial : force);
    right[1]->axis(QCPAxis::atRight)->setLabel(radius);
    right[2]->axis(QCPAxis::atRight)->setLabel(hasAxialFeed() ? force : QString());
}

/// Height that the longest line of the value axes' names needs.
int FeedsPlot::longestAxisName() const {
    const QFontMetrics metrics(font());
    int longest = 0;
    for (const Column* column : {&m_columns.front(), &m_columns.back()}) {
        for (const QCPAxisRect* rect : column->rects) {
            for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
                for (const QString& line : rect->axis(side)->label().split(u'\n')) {
                    longest = std::max(longest, metrics.horizontalAdvance(line));
                }
            }
        }
    }
    return longest;
}

/// Where even brief names are longer than a plot is high, smaller type; at last none, the legend
/// has them. And no more numbers than have room.
void FeedsPlot::fitValueAxes(int high) {
    constexpr double least = 0.6; // of the usual size
    constexpr int usualTicks = 4;
    const double times = double(high + rowGap) / std::max(longestAxisName(), 1);
    const QFont own = times < 1 ? enlarged(font(), std::max(times, least)) : font();
    for (const Column& column : m_columns) {
        for (const QCPAxisRect* rect : column.rects) {
            for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
                QCPAxis* const axis = rect->axis(side);
                axis->setLabelFont(own);
                axis->setLabel(times < least ? QString() : axis->label());
                axis->ticker()->setTickCount(
                    std::min(usualTicks, style::ticksWithRoom(high, font())));
            }
        }
    }
}

/// Lines the labels of an outer column's axes up; the room that ticks and labels take together.
int FeedsPlot::alignLabels(QCPAxis::AxisType side, std::size_t column) const {
    const QFontMetrics metrics(font());
    std::array<int, rowCount> widths{};
    int widest = 0;
    for (std::size_t row = 0; row < rowCount; ++row) {
        const QCPAxis* axis = m_columns[column].rects[row]->axis(side);
        widths[row] = axis->tickLabels() ? tickWidth(*axis, locale(), metrics) : 0;
        widest = std::max(widest, widths[row]);
    }
    for (std::size_t row = 0; row < rowCount; ++row) {
        m_columns[column].rects[row]->axis(side)->setLabelPadding(labelPad + widest - widths[row]);
    }
    return widest + tickPad + labelPad + 2 * metrics.height() + 4;
}

/// Equal plots, though the first and the last column also hold labels.
void FeedsPlot::fitColumns() {
    if (m_columns.empty()) {
        return;
    }
    const int left = alignLabels(QCPAxis::atLeft, 0);
    const int right = alignLabels(QCPAxis::atRight, m_columns.size() - 1);
    const int count = columnCount();
    const int plot =
        std::max((width() - left - right - 2 * gap * (count - 1)) / count, smallestPlot);
    const QFontMetrics metrics(font());
    const int room = metrics.horizontalAdvance(QStringLiteral("000000"));
    for (int i = 0; i < count; ++i) {
        const int before = i == 0 ? left : gap;
        const int after = i + 1 == count ? right : gap;
        m_grid->setColumnStretchFactor(i, plot + before + after);
        for (QCPAxisRect* rect : m_columns[static_cast<std::size_t>(i)].rects) {
            rect->setMargins(
                QMargins(before, rect->margins().top(), after, rect->margins().bottom()));
            rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(std::clamp(plot / room, 2, 8));
        }
    }
    // Equally high plots too, though the first and the last row hold names and labels.
    const int heading = metrics.height() + 2;
    const int margins[rowCount] = {BandLayer::nameMargin(font()) + rowGap, 2 * rowGap,
                                   rowGap + metrics.height() + tickPad + bottomPad};
    int taken = 2 * heading;
    for (const int margin : margins) {
        taken += margin;
    }
    const int high = std::max((height() - taken) / rowCount, smallestPlot);
    nameValueAxes(false);
    nameValueAxes(longestAxisName() > high + rowGap);
    fitValueAxes(high);
    for (int row = 0; row < rowCount; ++row) {
        m_grid->setRowStretchFactor(row + 1, high + margins[row]);
    }
    m_timeLabel->setMargins(QMargins(left, 0, right, 2));
    showHeaders(plot, left, right);
}

/// The full names of the zones, or of all of them the short ones.
void FeedsPlot::showHeaders(int plotWidth, int left, int right) {
    const QFontMetrics metrics(font());
    QStringList full, brief;
    bool fits = true;
    for (int i = 0; i < columnCount(); ++i) {
        const FeedColumn& zone = source(i);
        const QString form = zone.gauge ? tr("%1 (gauge)") : QStringLiteral("%1");
        full << form.arg(Names::zoneFull(zone.zone, zone.section));
        brief << form.arg(Names::zone(zone.zone, zone.section));
        fits = fits && metrics.horizontalAdvance(full.back()) <= plotWidth + 2 * gap - 4;
    }
    for (int i = 0; i < columnCount(); ++i) {
        QCPTextElement* header = m_columns[static_cast<std::size_t>(i)].header;
        header->setText(fits ? full[i] : brief[i]);
        header->setFont(font());
        // Centred over the plot, not over its labels.
        header->setMargins(
            QMargins(i == 0 ? left - gap : 0, 0, i + 1 == columnCount() ? right - gap : 0, 0));
    }
}

} // namespace sparkout
