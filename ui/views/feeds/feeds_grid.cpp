// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/feeds_grid.h"

#include "ui/kit/font_size.h"
#include "ui/plot/band_layer.h"
#include "ui/plot/number_ticker.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"
#include "ui/views/feeds/feeds_chart.h"

#include <algorithm>
#include <numeric>

namespace sparkout {

namespace {

constexpr int gap = 5;      ///< beside each plot, between the columns
constexpr int labelGap = 4; ///< between the tick labels of two columns
constexpr int tickPad = 3;
constexpr int labelPad = 2;
constexpr int smallestPlot = 40;         ///< in a picture smaller than leastSize()
constexpr QSize legiblePlot(120, 80);    ///< least size for leastSize()
constexpr double leastNameType = 0.6;    ///< least size of axis names, relative to the usual
constexpr double leastNumberType = 0.75; ///< numbers beside value axes
constexpr int sidePad = 2;               ///< beside the names of the value axes
constexpr int rowGap = 4;                ///< above and below each plot
constexpr int rowSpacing = 2;
constexpr int bottomPad = 2; ///< below the tick labels
constexpr int usualTicks = 4;

/// Omits the last label where it would run into the first one of the plot to the right.
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

/// Width of the widest tick label of an axis.
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

// --- building -----------------------------------------------------------------------------------

void FeedsGrid::clear() {
    for (const Column& column : m_columns) {
        for (BandLayer* band : column.bands) {
            delete band;
        }
    }
    m_columns.clear();
    m_plot.clearGraphs();
    m_plot.plotLayout()->clear();
}

void FeedsGrid::build() {
    clear();
    m_cells = new QCPLayoutGrid;
    m_cells->setRowSpacing(rowSpacing);
    m_cells->setColumnSpacing(0);
    m_timeLabel = new QCPTextElement(&m_plot);
    QCPLayoutGrid* const whole = m_plot.plotLayout();
    whole->setRowSpacing(0);
    whole->addElement(0, 0, m_cells);
    whole->addElement(1, 0, m_timeLabel);
    whole->setRowStretchFactor(1, 0.001);
    m_columns.resize(m_chart.columnCount());
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i].header = new QCPTextElement(&m_plot);
        m_cells->addElement(0, static_cast<int>(i), m_columns[i].header);
        for (std::size_t row = 0; row < rowCount; ++row) {
            buildCell(i, row);
        }
    }
    m_cells->setRowStretchFactor(0, 0.001);
}

void FeedsGrid::buildCell(std::size_t column, std::size_t row) {
    auto* rect = new QCPAxisRect(&m_plot, true);
    m_cells->addElement(static_cast<int>(row) + 1, static_cast<int>(column), rect);
    rect->setAutoMargins(QCP::msTop | QCP::msBottom);
    const int top = row == 0 ? BandLayer::nameMargin(m_plot.font()) : rowGap;
    rect->setMinimumMargins(QMargins(0, top, 0, row + 1 < rowCount ? rowGap : 0));
    setUpAxes(*rect, column, row);
    m_columns[column].rects[row] = rect;
    m_columns[column].bands[row] = new BandLayer(rect, row == 0);
}

void FeedsGrid::setUpAxes(QCPAxisRect& rect, std::size_t column, std::size_t row) const {
    const bool last = column + 1 == m_columns.size();
    for (QCPAxis* axis : style::axesOf(rect)) {
        style::setUpAxis(*axis);
        axis->setTickLabelPadding(tickPad);
        axis->setPadding(bottomPad);
        axis->ticker()->setTickCount(usualTicks);
    }
    const bool rightValues = row == 1 || (row == 2 && m_chart.hasAxialFeed());
    QCPAxis* const top = rect.axis(QCPAxis::atTop);
    top->setVisible(true);
    top->setTicks(false);
    top->setTickLabels(false);
    QCPAxis* const right = rect.axis(QCPAxis::atRight);
    right->setVisible(true);
    right->setTicks(rightValues);
    right->setTickLabels(rightValues && last);
    right->grid()->setVisible(false);
    rect.axis(QCPAxis::atLeft)->setTickLabels(column == 0);
    QCPAxis* const times = rect.axis(QCPAxis::atBottom);
    times->setTickLabels(row + 1 == rowCount);
    if (!last) {
        times->setTicker(QSharedPointer<QCPAxisTicker>(new InnerTicker(*times)));
    }
}

void FeedsGrid::restyle() {
    if (m_columns.empty()) {
        return;
    }
    const QColor text = m_plot.palette().color(QPalette::Text);
    for (const Column& column : m_columns) {
        column.header->setTextColor(text);
        QMargins margins = column.rects[0]->minimumMargins();
        margins.setTop(BandLayer::nameMargin(m_plot.font()));
        column.rects[0]->setMinimumMargins(margins);
    }
    m_timeLabel->setTextColor(text);
    m_timeLabel->setFont(m_plot.font());
    m_leastWidth = 0; // the type may be smaller
}

// --- labels -------------------------------------------------------------------------------------

void FeedsGrid::label() {
    if (m_columns.empty()) {
        return;
    }
    m_timeLabel->setText(m_chart.timeLabel());
    m_timeLabel->setFont(m_plot.font());
    m_leastWidth = 0;
    fit();
}

void FeedsGrid::nameValueAxes(Naming naming) {
    const bool stroke = m_chart.detail() == FeedsChart::Detail::stroke;
    const bool full = naming == Naming::full;
    const QString feedInFull = !m_chart.countsStrokes() ? tr("Feed, µm\nper revolution")
                               : stroke                 ? tr("Feed, µm per\ndouble stroke")
                                                        : tr("Feed, µm\nper pass");
    QString feed = full ? feedInFull : tr("Feed, µm");
    QString sum = full ? tr("Accumulated\nfeed, µm") : tr("Σ feed,\nµm");
    QString axial = full ? tr("Axial feed,\nmm/min") : tr("Axial,\nmm/min");
    QString force = full ? tr("Normal\nforce, N") : tr("Force, N");
    QString radius = full ? tr("Radius above\ntarget, µm") : tr("Radius,\nµm");
    if (naming >= Naming::unit) {
        feed = sum = radius = tr("µm");
        axial = tr("mm/min");
        force = tr("N");
    }
    const auto& left = m_columns.front().rects;
    const auto& right = m_columns.back().rects;
    left[0]->axis(QCPAxis::atLeft)->setLabel(feed);
    left[1]->axis(QCPAxis::atLeft)->setLabel(sum);
    left[2]->axis(QCPAxis::atLeft)->setLabel(m_chart.hasAxialFeed() ? axial : force);
    right[1]->axis(QCPAxis::atRight)->setLabel(radius);
    right[2]->axis(QCPAxis::atRight)->setLabel(m_chart.hasAxialFeed() ? force : QString());
}

/// Height of the longest line of the value axes' names.
int FeedsGrid::longestAxisName() const {
    const QFontMetrics metrics(m_plot.font());
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

/// If even short names are longer than the plot's height, reduces the font, and finally omits them,
/// since the legend has them. Also limits the number of ticks to those that fit.
void FeedsGrid::fitValueAxes(int high, double largest) {
    const QFont usual = m_plot.font();
    const double times = std::min(double(high + rowGap) / std::max(longestAxisName(), 1), largest);
    const QFont own = times < 1 ? enlarged(usual, std::max(times, leastNameType)) : usual;
    for (const Column& column : m_columns) {
        for (const QCPAxisRect* rect : column.rects) {
            for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
                QCPAxis* const axis = rect->axis(side);
                axis->setLabelFont(own);
                axis->setLabel(times < leastNameType ? QString() : axis->label());
                axis->ticker()->setTickCount(
                    std::min(usualTicks, style::ticksWithRoom(high, usual)));
            }
        }
    }
}

// --- room ---------------------------------------------------------------------------------------

/// Aligns the labels of an outer column's axes; returns the width of ticks and numbers.
int FeedsGrid::alignLabels(QCPAxis::AxisType side, const Column& column) const {
    std::array<int, rowCount> widths{};
    for (std::size_t row = 0; row < rowCount; ++row) {
        const QCPAxis* axis = column.rects[row]->axis(side);
        const QFontMetrics metrics(axis->tickLabelFont());
        widths[row] = axis->tickLabels() ? tickWidth(*axis, m_plot.locale(), metrics) : 0;
    }
    const int widest = std::ranges::max(widths);
    for (std::size_t row = 0; row < rowCount; ++row) {
        column.rects[row]->axis(side)->setLabelPadding(labelPad + widest - widths[row]);
    }
    return widest + tickPad + labelPad + sidePad;
}

/// Width of the names of an outer column's axes.
int FeedsGrid::nameWidth(QCPAxis::AxisType side, const Column& column) {
    int width = 0;
    for (const QCPAxisRect* rect : column.rects) {
        const QCPAxis* axis = rect->axis(side);
        if (!axis->label().isEmpty()) {
            const int lines = 1 + static_cast<int>(axis->label().count(u'\n'));
            width = std::max(width, lines * QFontMetrics(axis->labelFont()).height());
        }
    }
    return width;
}

void FeedsGrid::setNumberType(double times) {
    for (const Column* column : {&m_columns.front(), &m_columns.back()}) {
        for (const QCPAxisRect* rect : column->rects) {
            for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
                rect->axis(side)->setTickLabelFont(enlarged(m_plot.font(), times));
            }
        }
    }
}

/// Chooses the longest names of the value axes, and the largest numbers, that leave the plots
/// legible.
void FeedsGrid::fit() {
    if (m_columns.empty()) {
        return;
    }
    const int high = fitHeights();
    int left = 0, right = 0, plot = 0;
    nameValueAxes(Naming::smallest);
    fitValueAxes(high, leastNameType);
    setNumberType(leastNumberType);
    noteLeastWidth(alignLabels(QCPAxis::atLeft, m_columns.front())
                   + alignLabels(QCPAxis::atRight, m_columns.back()));
    for (const Naming naming : {Naming::full, Naming::brief, Naming::unit, Naming::smallest}) {
        nameValueAxes(naming);
        const double type = naming == Naming::full ? 1 : leastNameType;
        if (naming < Naming::unit && longestAxisName() * type > high + rowGap) {
            continue;
        }
        fitValueAxes(high, naming == Naming::smallest ? leastNameType : 1);
        setNumberType(naming == Naming::smallest ? leastNumberType : 1);
        const Column &first = m_columns.front(), &last = m_columns.back();
        left = alignLabels(QCPAxis::atLeft, first);
        right = alignLabels(QCPAxis::atRight, last);
        left += nameWidth(QCPAxis::atLeft, first);
        right += nameWidth(QCPAxis::atRight, last);
        plot = fitWidths(left, right);
        if (plot >= legiblePlot.width()) {
            break;
        }
    }
    m_timeLabel->setMargins(QMargins(left, 0, right, 2));
    showHeaders(plot, left, right);
}

/// Computes the least width: only units beside the numbers, in the smallest font. It does not
/// depend on the current numbers, since the layout of the plots follows it.
void FeedsGrid::noteLeastWidth(int numbers) {
    const auto count = static_cast<int>(m_columns.size());
    const int units = 2 * QFontMetrics(enlarged(m_plot.font(), leastNameType)).height();
    const int width = numbers + units + 2 * gap * (count - 1) + count * legiblePlot.width();
    if (width > m_leastWidth) {
        m_leastWidth = width;
        m_plot.updateGeometry();
    }
}

QSize FeedsGrid::leastSize() const {
    const int rows = static_cast<int>(rowCount) * legiblePlot.height();
    return m_columns.empty() ? QSize(320, 240) : QSize(m_leastWidth, heightBesidePlots() + rows);
}

/// Makes the plots equally wide, though the first and the last column also contain labels.
int FeedsGrid::fitWidths(int left, int right) {
    const auto count = static_cast<int>(m_columns.size());
    const int plot =
        std::max((m_plot.width() - left - right - 2 * gap * (count - 1)) / count, smallestPlot);
    const int room = QFontMetrics(m_plot.font()).horizontalAdvance(QStringLiteral("000000"));
    for (int i = 0; i < count; ++i) {
        const int before = i == 0 ? left : gap;
        const int after = i + 1 == count ? right : gap;
        m_cells->setColumnStretchFactor(i, plot + before + after);
        for (QCPAxisRect* rect : column(i).rects) {
            rect->setMargins(
                QMargins(before, rect->margins().top(), after, rect->margins().bottom()));
            rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(std::clamp(plot / room, 2, 8));
        }
    }
    return plot;
}

/// The height of names, labels and gaps in each row.
std::array<int, FeedsGrid::rowCount> FeedsGrid::rowMargins() const {
    const int line = QFontMetrics(m_plot.font()).height();
    return {BandLayer::nameMargin(m_plot.font()) + rowGap, 2 * rowGap,
            rowGap + line + tickPad + bottomPad};
}

int FeedsGrid::heightBesidePlots() const {
    const auto margins = rowMargins();
    return std::accumulate(margins.begin(), margins.end(),
                           2 * (QFontMetrics(m_plot.font()).height() + 2)
                               + static_cast<int>(rowCount) * rowSpacing);
}

/// Makes the plots equally high, though the first and the last row contain names and labels.
int FeedsGrid::fitHeights() {
    const auto margins = rowMargins();
    const int high = std::max((m_plot.height() - heightBesidePlots()) / static_cast<int>(rowCount),
                              smallestPlot);
    for (std::size_t row = 0; row < rowCount; ++row) {
        m_cells->setRowStretchFactor(static_cast<int>(row) + 1, high + margins[row]);
    }
    return high;
}

/// Shows the full names of the zones, or short ones for all.
void FeedsGrid::showHeaders(int plotWidth, int left, int right) {
    const QFontMetrics metrics(m_plot.font());
    QStringList full, brief;
    bool fits = true;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const FeedColumn& zone = m_chart.source(i);
        const QString form = zone.gauge ? tr("%1 (gauge)") : QStringLiteral("%1");
        full << form.arg(Names::zoneFull(zone.zone, zone.section));
        brief << form.arg(Names::zone(zone.zone, zone.section));
        fits = fits && metrics.horizontalAdvance(full.back()) <= plotWidth + 2 * gap - 4;
    }
    const auto count = static_cast<int>(m_columns.size());
    for (int i = 0; i < count; ++i) {
        QCPTextElement* header = column(i).header;
        header->setText(fits ? full[i] : brief[i]);
        header->setFont(m_plot.font());
        // Centred over the plot, not over its labels.
        header->setMargins(
            QMargins(i == 0 ? left - gap : 0, 0, i + 1 == count ? right - gap : 0, 0));
    }
}

} // namespace sparkout
