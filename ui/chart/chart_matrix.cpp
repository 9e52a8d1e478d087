// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/chart_matrix.h"

#include "ui/chart/chart_plot.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/view_plot.h"
#include "ui/kit/font_size.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr int gap = 5;      ///< beside each plot, between the columns
constexpr int labelGap = 4; ///< between the tick labels of two columns
constexpr int tickPad = 3;
constexpr int labelPad = 2;
constexpr int smallestPlot = 40;         ///< in a picture smaller than leastSize()
constexpr QSize legibleCell(120, 80);    ///< least size for leastSize()
constexpr double leastNameType = 0.6;    ///< least size of axis names, relative to the usual
constexpr double leastNumberType = 0.75; ///< numbers beside value axes
constexpr int sidePad = 2;               ///< beside the names of the value axes
constexpr int leastSide = 16;            ///< beside the outer columns, for half of a number
constexpr int rowGap = 4;                ///< above and below each plot
constexpr int rowSpacing = 2;
constexpr int bottomPad = 2; ///< below the tick labels
constexpr int usualTicks = 4;

/// Omits the last label where it would run into the first one of the plot to the right.
template <typename Ticker>
class InnerTicker : public Ticker {
public:
    explicit InnerTicker(const QCPAxis& axis) : m_axis(axis) {}

    void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
                  QVector<double>& ticks, QVector<double>* subTicks,
                  QVector<QString>* labels) override {
        Ticker::generate(range, locale, formatChar, precision, ticks, subTicks, labels);
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

std::size_t ChartMatrix::columns() const {
    return m_plot.columns();
}

std::size_t ChartMatrix::rows() const {
    return m_plot.cellCount() / columns();
}

QCPAxisRect& ChartMatrix::rect(std::size_t column, std::size_t row) const {
    return m_plot.cell(row * columns() + column);
}

std::vector<QCPAxis*> ChartMatrix::outerAxes(QCPAxis::AxisType side) const {
    std::vector<QCPAxis*> axes;
    for (std::size_t row = 0; row < rows(); ++row) {
        axes.push_back(rect(side == QCPAxis::atLeft ? 0 : columns() - 1, row).axis(side));
    }
    return axes;
}

std::vector<QCPAxis*> ChartMatrix::outerAxes() const {
    std::vector<QCPAxis*> axes = outerAxes(QCPAxis::atLeft);
    const std::vector<QCPAxis*> right = outerAxes(QCPAxis::atRight);
    axes.insert(axes.end(), right.begin(), right.end());
    return axes;
}

// --- the axes -----------------------------------------------------------------------------------

void ChartMatrix::setUp() {
    QCPLayoutGrid& layout = *qobject_cast<QCPLayoutGrid*>(m_plot.cell().layout());
    layout.setRowSpacing(rowSpacing);
    layout.setColumnSpacing(0);
    for (std::size_t row = 0; row < rows(); ++row) {
        for (std::size_t column = 0; column < columns(); ++column) {
            setUpAxes(column, row);
        }
    }
    if (m_named != m_plot.chart().up.label) {
        m_named = m_plot.chart().up.label;
        m_leastWidth = 0;
    }
}

void ChartMatrix::setUpAxes(std::size_t column, std::size_t row) {
    QCPAxisRect& of = rect(column, row);
    of.setAutoMargins(QCP::msTop | QCP::msBottom);
    of.setMinimumMargins(QMargins(0, topMargin(row), 0, row + 1 < rows() ? rowGap : 0));
    const bool isLast = column + 1 == columns();
    for (QCPAxis* axis : style::axesOf(of)) {
        axis->setTickLabelPadding(tickPad);
        axis->setPadding(bottomPad);
        axis->ticker()->setTickCount(usualTicks);
    }
    QCPAxis* const right = of.axis(QCPAxis::atRight);
    right->setTickLabels(right->ticks() && isLast);
    right->setLabel({});
    of.axis(QCPAxis::atLeft)->setTickLabels(column == 0);
    of.axis(QCPAxis::atLeft)->setLabel({});
    QCPAxis* const places = of.axis(QCPAxis::atBottom);
    places->setTickLabels(row + 1 == rows());
    places->setLabel({});
    if (!isLast && m_plot.chart(column).across.isCounted) {
        places->setTicker(QSharedPointer<QCPAxisTicker>(new InnerTicker<WholeTicker>(*places)));
    } else if (!isLast) {
        places->setTicker(QSharedPointer<QCPAxisTicker>(new InnerTicker<NumberTicker>(*places)));
    }
}

void ChartMatrix::restyle() {
    m_leastWidth = 0; // the type may be smaller
    for (std::size_t i = 0; i < m_plot.cellCount(); ++i) {
        QMargins margins = m_plot.cell(i).minimumMargins();
        margins.setTop(topMargin(i / columns()));
        m_plot.cell(i).setMinimumMargins(margins);
    }
    fit();
}

void ChartMatrix::nameValueAxes(Naming naming) {
    const auto name = [naming](QCPAxis& axis, const ChartAxis& of) {
        const auto index = std::min<qsizetype>(static_cast<int>(naming), of.shorter.size());
        axis.setLabel(index == 0 ? of.label : of.shorter[index - 1]);
    };
    for (std::size_t row = 0; row < rows(); ++row) {
        const std::size_t first = row * columns(), last = first + columns() - 1;
        name(m_plot.up(first), m_plot.chart(first).up);
        name(m_plot.second(last), m_plot.chart(last).second);
    }
}

/// Height of the longest line of the value axes' names.
int ChartMatrix::longestAxisName() const {
    const QFontMetrics metrics(m_plot.font());
    int longest = 0;
    for (const QCPAxis* axis : outerAxes()) {
        for (const QString& line : axis->label().split(u'\n')) {
            longest = std::max(longest, metrics.horizontalAdvance(line));
        }
    }
    return longest;
}

/// If even short names are longer than the plot's height, reduces the font, and finally omits them,
/// since the legend has them. Also limits the number of ticks to those that fit.
void ChartMatrix::fitValueAxes(int high, double largest) {
    const QFont usual = m_plot.font();
    const double times = std::min(double(high + rowGap) / std::max(longestAxisName(), 1), largest);
    const QFont own = times < 1 ? enlarged(usual, std::max(times, leastNameType)) : usual;
    for (QCPAxis* axis : outerAxes()) {
        axis->setLabelFont(own);
        axis->setLabel(times < leastNameType ? QString() : axis->label());
    }
    for (std::size_t i = 0; i < m_plot.cellCount(); ++i) {
        for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
            m_plot.cell(i).axis(side)->ticker()->setTickCount(
                std::min(usualTicks, style::ticksWithRoom(high, usual)));
        }
    }
}

// --- room ---------------------------------------------------------------------------------------

/// Aligns the labels of an outer column's axes; returns the width of ticks and numbers.
int ChartMatrix::alignLabels(QCPAxis::AxisType side) const {
    const std::vector<QCPAxis*> axes = outerAxes(side);
    std::vector<int> widths;
    for (const QCPAxis* axis : axes) {
        const QFontMetrics metrics(axis->tickLabelFont());
        widths.push_back(axis->tickLabels() ? tickWidth(*axis, m_plot.locale(), metrics) : 0);
    }
    const int widest = std::ranges::max(widths);
    for (std::size_t row = 0; row < axes.size(); ++row) {
        axes[row]->setLabelPadding(labelPad + widest - widths[row]);
    }
    return std::max(widest + tickPad + labelPad + sidePad, leastSide);
}

/// Width of the names of an outer column's axes.
int ChartMatrix::nameWidth(QCPAxis::AxisType side) const {
    int width = 0;
    for (const QCPAxis* axis : outerAxes(side)) {
        if (!axis->label().isEmpty()) {
            const int lines = 1 + static_cast<int>(axis->label().count(u'\n'));
            width = std::max(width, lines * QFontMetrics(axis->labelFont()).height());
        }
    }
    return width;
}

void ChartMatrix::setNumberType(double times) {
    for (QCPAxis* axis : outerAxes()) {
        axis->setTickLabelFont(enlarged(m_plot.font(), times));
    }
}

/// Chooses the longest names of the value axes, and the largest numbers, that leave the plots
/// legible.
void ChartMatrix::fit() {
    const int high = fitHeights();
    int left = 0, right = 0, plot = 0;
    nameValueAxes(Naming::smallest);
    fitValueAxes(high, leastNameType);
    setNumberType(leastNumberType);
    noteLeastWidth(alignLabels(QCPAxis::atLeft) + alignLabels(QCPAxis::atRight));
    for (const Naming naming : {Naming::full, Naming::brief, Naming::unit, Naming::smallest}) {
        nameValueAxes(naming);
        const double type = naming == Naming::full ? 1 : leastNameType;
        if (naming < Naming::unit && longestAxisName() * type > high + rowGap) {
            continue;
        }
        fitValueAxes(high, naming == Naming::smallest ? leastNameType : 1);
        setNumberType(naming == Naming::smallest ? leastNumberType : 1);
        left = alignLabels(QCPAxis::atLeft) + nameWidth(QCPAxis::atLeft);
        right = alignLabels(QCPAxis::atRight) + nameWidth(QCPAxis::atRight);
        plot = fitWidths(left, right);
        if (plot >= legibleCell.width()) {
            break;
        }
    }
    if (QCPTextElement* const caption = m_plot.caption()) {
        caption->setMargins(QMargins(left, 0, right, 2));
    }
    showHeaders(plot, left, right);
}

/// Computes the least width: only units beside the numbers, in the smallest font. It does not
/// depend on the current numbers, since the layout of the plots follows it.
void ChartMatrix::noteLeastWidth(int numbers) {
    const auto count = static_cast<int>(columns());
    const int units = 2 * QFontMetrics(enlarged(m_plot.font(), leastNameType)).height();
    const int width = numbers + units + 2 * gap * (count - 1) + count * legibleCell.width();
    if (width > m_leastWidth) {
        m_leastWidth = width;
        m_plot.updateGeometry();
    }
}

QSize ChartMatrix::leastSize() const {
    return {m_leastWidth, heightBesidePlots() + static_cast<int>(rows()) * legibleCell.height()};
}

/// Makes the plots equally wide, though the first and the last column also contain labels.
int ChartMatrix::fitWidths(int left, int right) {
    const auto count = static_cast<int>(columns());
    const int plot =
        std::max((m_plot.width() - left - right - 2 * gap * (count - 1)) / count, smallestPlot);
    const int room = QFontMetrics(m_plot.font()).horizontalAdvance(QStringLiteral("000000"));
    QCPLayoutGrid& layout = *qobject_cast<QCPLayoutGrid*>(m_plot.cell().layout());
    for (std::size_t i = 0; i < columns(); ++i) {
        const int before = i == 0 ? left : gap;
        const int after = i + 1 == columns() ? right : gap;
        layout.setColumnStretchFactor(static_cast<int>(i), plot + before + after);
        for (std::size_t row = 0; row < rows(); ++row) {
            QCPAxisRect& of = rect(i, row);
            of.setMargins(QMargins(before, of.margins().top(), after, of.margins().bottom()));
            of.axis(QCPAxis::atBottom)->ticker()->setTickCount(std::clamp(plot / room, 2, 8));
        }
    }
    return plot;
}

/// The height above a row of plots: the names of its bands, or a gap; half of a number where no
/// headings are above.
int ChartMatrix::topMargin(std::size_t row) const {
    return m_plot.chart(row * columns()).namesBands ? BandLayer::nameMargin(m_plot.font())
           : m_plot.heading(0)                      ? rowGap
                               : std::max(rowGap, QFontMetrics(m_plot.font()).height() / 2);
}

/// The height below it: the numbers of the last row, or a gap.
int ChartMatrix::bottomMargin(std::size_t row) const {
    return row + 1 < rows() ? rowGap : QFontMetrics(m_plot.font()).height() + tickPad + bottomPad;
}

int ChartMatrix::heightBesidePlots() const {
    const int texts = (m_plot.heading(0) ? 1 : 0) + (m_plot.caption() ? 1 : 0);
    int height = texts * (QFontMetrics(m_plot.font()).height() + 2);
    for (std::size_t row = 0; row < rows(); ++row) {
        height += topMargin(row) + bottomMargin(row) + rowSpacing;
    }
    return height;
}

/// Makes the plots equally high, though the first and the last row contain names and labels.
int ChartMatrix::fitHeights() {
    const int high =
        std::max((m_plot.height() - heightBesidePlots()) / static_cast<int>(rows()), smallestPlot);
    QCPLayoutGrid& layout = *qobject_cast<QCPLayoutGrid*>(m_plot.cell().layout());
    const int headers = m_plot.heading(0) ? 1 : 0;
    for (std::size_t row = 0; row < rows(); ++row) {
        layout.setRowStretchFactor(static_cast<int>(row) + headers,
                                   high + topMargin(row) + bottomMargin(row));
    }
    return high;
}

/// Shows the longest headings that fit above all columns, otherwise the shortest ones.
void ChartMatrix::showHeaders(int plotWidth, int left, int right) {
    const QFontMetrics metrics(m_plot.font());
    const auto heading = [this](std::size_t column, qsizetype rank) {
        const QStringList& all = m_plot.chart(column).headings;
        return all.value(std::min(rank, all.size() - 1));
    };
    const auto haveRoom = [&](qsizetype rank) {
        int widest = 0;
        for (std::size_t i = 0; i < columns(); ++i) {
            widest = std::max(widest, metrics.horizontalAdvance(heading(i, rank)));
        }
        return widest <= plotWidth + 2 * gap - 4;
    };
    qsizetype last = 0, shown = 0;
    for (std::size_t i = 0; i < columns(); ++i) {
        last = std::max(last, m_plot.chart(i).headings.size() - 1);
    }
    while (shown < last && !haveRoom(shown)) {
        ++shown;
    }
    for (std::size_t i = 0; i < columns(); ++i) {
        if (QCPTextElement* const header = m_plot.heading(i)) {
            header->setText(heading(i, shown));
            // Centred over the plot, not over its labels.
            header->setMargins(
                QMargins(i == 0 ? left - gap : 0, 0, i + 1 == columns() ? right - gap : 0, 0));
        }
    }
}

} // namespace sparkout
