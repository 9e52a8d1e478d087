// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the accuracy passport.
#include "ui/report/documents/passport_parts.h"

#include "core/simulation/feed_series.h"
#include "ui/report/format/plot_figure.h"
#include "ui/report/parts/report_values.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/batch/histogram_plot.h"
#include "ui/views/profiles/longitudinal_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"

#include <QPainter>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr int histogramHeight = 240, alongHeight = 300, acrossHeight = 320;
constexpr std::size_t mostCharted = 24; ///< rows of the capability chart
constexpr std::size_t mostAcross = 4;   ///< cross-sections beside each other
constexpr double customaryPpk = 1.33;
constexpr double narrowBar = 0.8; ///< at least so wide
// Of the capability chart, on paper.
constexpr QColor chartInk(0, 0, 0), chartMark(40, 40, 40), chartGrid(190, 190, 190),
    chartGood(20, 90, 160), chartPoor(190, 60, 20);

LegendEntries profileLegend(const QPalette& palette, std::initializer_list<ProfileLine> lines) {
    LegendEntries entries;
    for (const ProfileLine of : lines) {
        const bool swatch = of == ProfileLine::spread || of == ProfileLine::field;
        const QPen pen = ProfileLook::pen(of, palette);
        entries.push_back({swatch ? ProfileLook::fill(of, palette) : pen.color(),
                           swatch ? Qt::NoPen : pen.style(), ProfileLook::name(of)});
    }
    return entries;
}

std::vector<int> allOf(const ProfileSeries& series) {
    std::vector<int> all;
    for (std::size_t i = 0; i < series.profiles.size(); ++i) {
        all.push_back(static_cast<int>(i));
    }
    return all;
}

/// Ppk with its bounds, a row a characteristic.
class CapabilityDrawing {
public:
    explicit CapabilityDrawing(std::vector<CharacteristicSummary> rows) : m_rows(std::move(rows)) {
        for (const CharacteristicSummary& of : m_rows) {
            m_lowest = of.ppk->interval.low < 0 ? -1 : m_lowest;
        }
        for (const double end : {2.0, 3.0, 5.0, 10.0}) {
            m_highest = end;
            if (end >= 1.2 * m_rows.front().ppk->interval.high) {
                break;
            }
        }
    }

    [[nodiscard]] QSizeF size() const {
        return {double(figureWidth), top + rowHeight * double(m_rows.size()) + bottom};
    }

    void paint(QPainter& painter) const {
        QFont font;
        font.setPixelSize(fontPixels);
        painter.setFont(font);
        paintScale(painter);
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            paintRow(painter, m_rows[i], top + rowHeight * (double(i) + 0.5));
        }
    }

private:
    static constexpr double left = 270, right = 670, top = 6, bottom = 26, rowHeight = 20;
    static constexpr int fontPixels = 12;

    [[nodiscard]] double x(double ppk) const {
        return left
               + (right - left) * (std::clamp(ppk, m_lowest, m_highest) - m_lowest)
                     / (m_highest - m_lowest);
    }

    void paintScale(QPainter& painter) const {
        const double end = top + rowHeight * double(m_rows.size());
        std::vector<QRectF> taken; // the marks' numbers come first, and no other stands in them
        for (const double value : {1.0, customaryPpk, 0.0, 10.0, 5.0, 3.0, 2.0, -1.0}) {
            if (value < m_lowest || value > m_highest) {
                continue;
            }
            const bool mark = value == customaryPpk || value == 1;
            painter.setPen(
                QPen(mark ? chartMark : chartGrid, 1, mark ? Qt::DashLine : Qt::SolidLine));
            painter.drawLine(QPointF(x(value), top), QPointF(x(value), end));
            const QString name = plainNumber(value);
            const double width = QFontMetricsF(painter.font()).horizontalAdvance(name);
            constexpr double reach = 3; // the two marks stand close: their numbers keep apart
            const double from = value == 1              ? x(value) + reach - width
                                : value == customaryPpk ? x(value) - reach
                                                        : x(value) - width / 2;
            const QRectF box(from - reach, end, width + 2 * reach, bottom);
            const auto meets = [&box](const QRectF& other) { return box.intersects(other); };
            if (mark || std::ranges::none_of(taken, meets)) {
                painter.setPen(chartInk);
                painter.drawText(QPointF(from, end + 16), name);
                taken.push_back(box);
            }
        }
    }

    void paintRow(QPainter& painter, const CharacteristicSummary& of, double y) const {
        const Capability& ppk = *of.ppk;
        const QFontMetricsF metrics(painter.font());
        const double base = y + metrics.ascent() / 2 - 1;
        painter.setPen(chartInk);
        painter.drawText(QPointF(2, base), metrics.elidedText(BatchText::full(of.characteristic),
                                                              Qt::ElideRight, left - 12));
        painter.drawText(QPointF(right + 10, base), BatchText::capability(of.ppk));
        const QColor colour = ppk.value < 1 ? chartPoor : chartGood;
        painter.setPen(QPen(colour, 2));
        painter.drawLine(QPointF(x(ppk.interval.low), y), QPointF(x(ppk.interval.high), y));
        painter.setBrush(colour);
        if (ppk.value <= m_highest) {
            painter.drawEllipse(QPointF(x(ppk.value), y), 4, 4);
        } else { // beyond the scale
            painter.drawPolygon(QPolygonF{QPointF(right - 7, y - 5), QPointF(right + 1, y),
                                          QPointF(right - 7, y + 5)});
        }
    }

    std::vector<CharacteristicSummary> m_rows; ///< the least Ppk first
    double m_lowest = 0, m_highest = 3;        ///< of the scale; what is beyond is cut
};

} // namespace

Figure Passport::histograms(const BatchSummary& summary, const std::string& name) {
    std::vector<CharacteristicSummary> shown;
    QStringList told;
    for (const std::size_t i : drawnPlacesOf(summary, name)) {
        shown.push_back(summary.characteristics[i]);
        const CharacteristicSummary& of = shown.back();
        if (of.count > 0) {
            told << tr("%1: %2", "zone, range of values")
                        .arg(BatchText::where(of.characteristic),
                             BatchText::range({of.least.value, of.most.value}, of.characteristic));
        }
    }
    const QString axis = BatchText::axis(shown.front().characteristic);
    const QString caption = placesOf(summary, name).size() > shown.size()
                                ? tr("%1: number of parts, where the Ppk is least").arg(axis)
                                : tr("%1: number of parts").arg(axis);
    HistogramPlot plot;
    setUpForPaper(plot, histogramHeight);
    plot.setSummaries(std::move(shown));
    for (int i = 0; i < plot.cellCount(); ++i) { // a white edge would leave nothing of a narrow bar
        plot.bars(i)->setPen(QPen(plot.bars(i)->brush().color(), narrowBar));
    }
    return plotFigure(plot, plot.legendEntries(), caption, told.join(QStringLiteral("; ")));
}

std::optional<Figure> Passport::capabilityChart(const BatchSummary& summary) {
    std::vector<CharacteristicSummary> rows;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.ppk) {
            rows.push_back(of);
        }
    }
    if (rows.empty()) {
        return {};
    }
    std::ranges::stable_sort(rows, {}, [](const auto& of) { return of.ppk->value; });
    rows.resize(std::min(rows.size(), mostCharted));
    QStringList told;
    for (const CharacteristicSummary& of : rows) {
        told << QStringLiteral("%1: %2").arg(BatchText::full(of.characteristic),
                                             BatchText::capability(of.ppk));
    }
    const CapabilityDrawing drawing(std::move(rows));
    return Figure{tr("Ppk with its 95 % bounds, the least first; dashed: 1 and %1")
                      .arg(plainNumber(customaryPpk)),
                  told.join(QStringLiteral("; ")), drawing.size(),
                  [drawing](QPainter& painter) { drawing.paint(painter); }};
}

Figure Passport::alongThePart(const Outcome& outcome) {
    using enum ProfileLine;
    const ProfileSeries series = makeProfileSeries(outcome.result, outcome.trajectory);
    LongitudinalPlot plot;
    setUpForPaper(plot, alongHeight);
    plot.setDiameters(true);
    plot.setHidden({blank});
    plot.setSeries(series, shaftSteps(outcome.result.project), {});
    plot.fit();
    const LegendEntries legend =
        profileLegend(plot.palette(), {profile, spread, target, field, gauge});
    return plotFigure(plot, legend, tr("Diameter along the part against the tolerance field"),
                      ProfilesText::summary(series, allOf(series)));
}

Figure Passport::crossSections(const Outcome& outcome) {
    using enum ProfileLine;
    const ProfileSeries series = makeProfileSeries(outcome.result, outcome.trajectory);
    std::vector<int> shown = allOf(series);
    if (shown.size() > mostAcross) {
        shown = shownSections(static_cast<int>(shown.size()), gaugeProfile(outcome.result));
    }
    ProfilesPlot plot;
    setUpForPaper(plot, acrossHeight);
    plot.setHidden({blank});
    plot.setSeries(series, shown);
    plot.fit();
    const LegendEntries legend =
        profileLegend(plot.palette(), {profile, target, leastSquares, field});
    return plotFigure(plot, legend, tr("Cross-sections, deviations magnified"),
                      ProfilesText::summary(series, shown));
}

} // namespace sparkout::report
