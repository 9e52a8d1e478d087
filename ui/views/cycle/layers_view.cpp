// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/layers_view.h"

#include "core/units.h"
#include "ui/chart/legend.h"
#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/cycle/layers_surface.h"
#include "ui/views/cycle/side_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>
#include <array>
#include <functional>

namespace sparkout {

namespace {
constexpr float everyOther = 0.62F; ///< opacity
constexpr int uncutAlpha = 46, bandAlpha = 28;
} // namespace

QColor LayersLook::stage(int stage, const QPalette& palette) {
    const auto index = static_cast<std::size_t>(stage > 0 ? stage - 1 : 0);
    return tone(style::oneOfSeries(index), palette);
}

QColor LayersLook::layer(const LayerSeries& series, std::size_t span, const QPalette& palette) {
    QColor colour = stage(series.spans[span].stage, palette);
    if (span % 2 == 1) {
        colour.setAlphaF(everyOther);
    }
    return colour;
}

std::vector<Band> LayersLook::zoneBands(const LayerSeries& series) {
    std::vector<Band> bands;
    for (const LayerColumn& column : series.columns) {
        bands.push_back(zoneBand(column.zone, column.section, column.stretch.from_mm,
                                 column.stretch.to_mm, bandAlpha));
    }
    std::ranges::sort(bands, {}, &Band::from);
    return bands;
}

QColor LayersLook::uncut(const QPalette& palette) {
    return style::thinned(palette.color(QPalette::Text), uncutAlpha);
}

LegendEntries LayersLook::stages(const LayerSeries& series, const CurveChoice& choice,
                                 const QPalette& palette) {
    LegendEntries entries;
    int last = 0;
    for (const LayerSpan& span : series.spans) {
        if (span.stage != last) {
            last = span.stage;
            entries.push_back({stage(last, palette), Qt::NoPen, tr("stage %1").arg(last), last,
                               choice.shows(last)});
        }
    }
    return entries;
}

QString LayersLook::spanName(const LayerSeries& series, std::size_t span) {
    const LayerSpan& of = series.spans[span];
    const bool strokes = series.operation->travels;
    if (of.first == of.last) {
        return (strokes ? tr("Double stroke %1, stage %2") : tr("Revolution %1, stage %2"))
            .arg(of.first)
            .arg(of.stage);
    }
    return (strokes ? tr("Double strokes %1…%2, stage %3") : tr("Revolutions %1…%2, stage %3"))
        .arg(of.first)
        .arg(of.last)
        .arg(of.stage);
}

QString LayersLook::values(const LayerSeries& series, const LayersDone& done, std::size_t column,
                           std::size_t span) {
    const LayerColumn& of = series.columns[column];
    const double before = sumDone_mm(series, done, column, span);
    const double after = sumDone_mm(series, done, column, span + 1);
    const auto um = [](double value_mm) { return Names::micrometres(value_mm * units::umPerMm); };
    const QString radius = Names::signedMicrometres(
        (of.blank_mm - series.removalSign * after - series.target_mm) * units::umPerMm);
    return tr("%1, %2: removes %3 µm, %4 µm so far, radius %5 µm from target")
        .arg(spanName(series, span), Names::within(Names::zone(of.zone, of.section)),
             um(after - before), um(after), radius);
}

namespace {
constexpr double tooth = 4;      ///< size of the break line's teeth
constexpr double besideName = 5; ///< beside the name of the axis [px]
constexpr int breakAlpha = 150;
constexpr int rightMargin = 14; ///< half of a number [px]
constexpr int tickOut = 4;      ///< [px]
} // namespace

LineChart PartPlot::partChart() const {
    LineChart chart;
    chart.isFramed = true;
    chart.across.label = tr("From the headstock end of the ground length, mm");
    chart.up.label = tr("Radius from\ntarget, µm");
    chart.across.room = chart.up.room = 0;
    chart.bands = LayersLook::zoneBands(zones());
    chart.namesBands = true;
    return chart;
}

void PartPlot::restyle() {
    ChartPlot::restyle();
    across().setOffset(stripHeight());
    cell().setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), rightMargin, 0));
}

void PartPlot::setTexts() {
    ChartPlot::setTexts();
    across().setTickLength(0, tickOut); // the axis is named above them
}

QRect PartPlot::painted() const {
    return cell().rect().adjusted(0, 0, 0, stripHeight());
}

int PartPlot::stripHeight() const {
    return static_cast<int>(tooth) + 1 + QFontMetrics(font()).height();
}

void PartPlot::drawPartAxis(QCPPainter& painter) const {
    const QRectF strip(cell().left(), cell().bottom() + 1.0, cell().width(), stripHeight());
    const double middle = strip.top() + (tooth + 1 + strip.height()) / 2;
    const QColor edge = style::thinned(palette().color(QPalette::Text), breakAlpha);
    painter.setPen(QPen(edge, 1));
    QPolygonF teeth;
    for (double at = strip.left(); at <= strip.right() + tooth; at += tooth) {
        teeth << QPointF(at, strip.top() + (teeth.size() % 2 == 0 ? 0 : tooth));
    }
    painter.drawPolyline(teeth);
    painter.setPen(QPen(edge, 1, Qt::DashDotLine));
    painter.drawLine(QPointF(strip.left(), middle), QPointF(strip.right(), middle));
    const QString name = tr("axis of rotation");
    const double width = QFontMetrics(font()).horizontalAdvance(name) + 2 * besideName;
    const QRectF text(strip.right() - width, strip.top() + tooth + 1, width,
                      strip.height() - tooth - 1);
    painter.setFont(font());
    painter.fillRect(text, palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(text, Qt::AlignCenter, name);
}

namespace {

/// Paints the layers of a LayersPlot, the metal below them, and the axis of rotation.
class LayerStack : public PaintedLayer {
public:
    explicit LayerStack(LayersPlot& plot);

protected:
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    void drawMetal(QCPPainter& painter) const;
    void drawLayers(QCPPainter& painter) const;

    const LayersPlot& m_plot;
};

constexpr int bodyAlpha = 30, edgeAlpha = 150;
constexpr double outlined = 4; ///< layers lower than this have no outline [px]

LayerStack::LayerStack(LayersPlot& plot)
    : PaintedLayer(plot.cell(), QStringLiteral("bands"), Edges::sharp), m_plot(plot) {}

QRect LayerStack::clipRect() const {
    return m_plot.painted();
}

void LayerStack::draw(QCPPainter* painter) {
    if (m_plot.series().columns.empty()) {
        return;
    }
    drawMetal(*painter);
    drawLayers(*painter);
    m_plot.drawPartAxis(*painter);
}

/// Draws the finished part, and the stock still to be removed.
void LayerStack::drawMetal(QCPPainter& painter) const {
    const LayerSeries& series = m_plot.series();
    const QPalette palette = mParentPlot->palette();
    const QCPAxis* const x = m_rect->axis(QCPAxis::atBottom);
    const QCPAxis* const y = m_rect->axis(QCPAxis::atLeft);
    const bool bore = series.removalSign < 0;
    const auto pixel = [&](double radius_mm) {
        return y->coordToPixel((radius_mm - series.target_mm) * units::umPerMm);
    };
    for (std::size_t j = 0; j < series.columns.size(); ++j) {
        const LayerColumn& column = series.columns[j];
        const double left = x->coordToPixel(column.stretch.from_mm);
        const double right = x->coordToPixel(column.stretch.to_mm);
        const auto fill = [&](double from, double to, const QColor& colour) {
            painter.fillRect(
                QRectF(QPointF(left, std::min(from, to)), QPointF(right, std::max(from, to))),
                colour);
        };
        const double last = pixel(series.radiusAfter_mm(column, series.spans.size()));
        const double foot = bore ? m_rect->top() : m_rect->bottom() + 1.0;
        if (bore ? last > foot : last < foot) {
            fill(last, foot, style::thinned(palette.color(QPalette::Text), bodyAlpha));
        }
        fill(pixel(m_plot.radiusAfter_mm(j, m_plot.done().count)), last,
             LayersLook::uncut(palette));
    }
}

void LayerStack::drawLayers(QCPPainter& painter) const {
    const LayerSeries& series = m_plot.series();
    const QPalette palette = mParentPlot->palette();
    const std::size_t done = m_plot.done().count;
    const QPen edge(style::thinned(palette.color(QPalette::Text), edgeAlpha), 0);
    const QPen newestEdge(style::thinned(palette.color(QPalette::Text), 255), 2);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < done; ++i) {
        const QColor colour =
            style::dimmed(LayersLook::layer(series, i, palette), m_plot.isDimmed());
        const bool newest = i + 1 == done && i + 1 < series.spans.size();
        painter.setPen(newest ? newestEdge : edge);
        for (std::size_t j = 0; j < series.columns.size(); ++j) {
            const QRectF rect = m_plot.layerRect(j, i);
            if (rect.isEmpty()) {
                continue;
            }
            painter.fillRect(rect, colour);
            if (newest || rect.height() >= outlined) {
                painter.drawRect(rect);
            }
        }
    }
}

using style::Drawn;
using units::umPerMm;

constexpr double roomAbove = 0.06, roomBelow = 0.08; ///< margins, as shares of the heights
constexpr int fieldAlpha = 60;

} // namespace

LayersPlot::LayersPlot(QWidget* parent) : PartPlot(parent) {
    new LayerStack(*this);
    setChart([this] { return made(); });
    onClick([this](const QPointF& at) {
        if (const std::optional<Hit> hit = layerAt(at)) {
            emit strokeClicked(m_series.spans[hit->span].last);
        }
    });
    built();
}

void LayersPlot::setSeries(LayerSeries series) {
    const auto blank = [](const LayerSeries& s) {
        return s.columns.empty() ? 0 : s.columns.front().blank_mm;
    };
    const bool same = series.length_mm == m_series.length_mm
                      && series.target_mm == m_series.target_mm && blank(series) == blank(m_series);
    m_series = std::move(series);
    m_done = allLayers(m_series);
    remake();
    if (!same) {
        fit();
    }
}

void LayersPlot::setDone(LayersDone done) {
    m_done = std::move(done);
}

double LayersPlot::radiusAfter_mm(std::size_t column, std::size_t count) const {
    return m_series.columns[column].blank_mm
           - m_series.removalSign * sumDone_mm(m_series, m_done, column, count);
}

double LayersPlot::above_um(double radius_mm) const {
    return (radius_mm - m_series.target_mm) * umPerMm;
}

// --- displayed layers ---------------------------------------------------------------------------

LineChart LayersPlot::made() const {
    LineChart chart = partChart();
    if (m_series.columns.empty()) {
        return chart;
    }
    std::vector<LayerColumn> columns = m_series.columns;
    std::ranges::sort(columns, {},
                      [](const LayerColumn& column) { return column.stretch.from_mm; });
    ChartSpan span;
    // A height held over each stretch, with a step to the next.
    const auto heights = [&](const auto& radiusOf) {
        std::vector<XY> line;
        for (const LayerColumn& column : columns) {
            const double height_um = above_um(std::invoke(radiusOf, column));
            line.insert(line.end(),
                        {{column.stretch.from_mm, height_um}, {column.stretch.to_mm, height_um}});
            span.add(height_um);
        }
        return line;
    };
    const auto upper = heights([this](const auto&) { return m_series.upperLimit_mm; });
    const auto lower = heights([this](const auto&) { return m_series.lowerLimit_mm; });
    const auto target = heights([this](const auto&) { return m_series.target_mm; });
    const ChartSeries edge{.key = fieldKey, .colour = Drawn::toleranceField, .pen = linePen(1)};
    chart.series.assign(2, edge);
    chart.series[0].points = upper;
    chart.series[1].points = lower;
    using enum ChartSeries::Kind; // the paths are drawn above the target
    chart.series.push_back({.key = blankKey,
                            .name = tr("initial radius"),
                            .kind = path,
                            .pen = linePen(1.5, Qt::DashLine),
                            .points = heights(&LayerColumn::blank_mm)});
    chart.series.push_back({.key = finalKey,
                            .name = tr("final radius"),
                            .kind = path,
                            .pen = linePen(2),
                            .points = heights(&LayerColumn::final_mm)});
    chart.series.push_back({.key = targetKey,
                            .name = tr("target"),
                            .colour = Drawn::toleranceField,
                            .pen = linePen(1.5, Qt::DashLine),
                            .points = target});
    chart.series.push_back({.key = fieldKey,
                            .name = tr("tolerance band"),
                            .kind = band,
                            .colour = Drawn::toleranceField,
                            .points = upper,
                            .lower = lower,
                            .alpha = fieldAlpha});
    chart.across.range = {0, m_series.length_mm};
    chart.up.range = {span.low - roomBelow * span.size(), span.high + roomAbove * span.size()};
    chart.table = [this] { return doneTable(); };
    return chart;
}

LegendEntries LayersPlot::legendEntries() const {
    LegendEntries entries = LayersLook::stages(m_series, choice(), palette());
    for (const LegendEntry& entry : PartPlot::legendEntries()) {
        entries.push_back(entry);
    }
    return entries;
}

QRectF LayersPlot::layerRect(std::size_t column, std::size_t span) const {
    if (span >= m_done.count || !shows(m_series.spans[span].stage)) {
        return {};
    }
    const LayerColumn& of = m_series.columns[column];
    const auto corner = [this](double length_mm, double radius_mm) {
        return pixelOf({length_mm, above_um(radius_mm)});
    };
    return QRectF(corner(of.stretch.from_mm, radiusAfter_mm(column, span)),
                  corner(of.stretch.to_mm, radiusAfter_mm(column, span + 1)))
        .normalized();
}

// --- mouse --------------------------------------------------------------------------------------

std::optional<LayersPlot::Hit> LayersPlot::layerAt(const QPointF& at) const {
    if (!cell().rect().contains(at.toPoint())) {
        return {};
    }
    for (std::size_t j = 0; j < m_series.columns.size(); ++j) {
        for (std::size_t i = 0; i < m_done.count; ++i) {
            if (layerRect(j, i).contains(at)) {
                return Hit{j, i};
            }
        }
    }
    return {};
}

QString LayersPlot::valuesAt(const QPointF& at) const {
    const std::optional<Hit> hit = layerAt(at);
    return hit ? LayersLook::values(m_series, m_done, hit->column, hit->span) : QString();
}

ChartTable LayersPlot::doneTable() const {
    ChartTable whole;
    CsvTable& table = whole.cells;
    table.header << tr("Stage") << tr("From double stroke or revolution")
                 << tr("To double stroke or revolution");
    for (const LayerColumn& column : m_series.columns) {
        const QString name = Names::zone(column.zone, column.section);
        table.header << tr("%1, removed, µm").arg(name) << tr("%1, so far, µm").arg(name);
    }
    for (std::size_t i = 0; i < m_done.count; ++i) {
        const LayerSpan& span = m_series.spans[i];
        std::vector<CsvCell> row{double(span.stage), double(span.first), double(span.last)};
        for (std::size_t j = 0; j < m_series.columns.size(); ++j) {
            const double before = sumDone_mm(m_series, m_done, j, i);
            const double after = sumDone_mm(m_series, m_done, j, i + 1);
            row.emplace_back((after - before) * umPerMm);
            row.emplace_back(after * umPerMm);
        }
        table.rows.push_back(std::move(row));
        whole.places.push_back({.key = span.stage});
    }
    return whole;
}

LayersView::LayersView(QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("layers"), parent, settings)
    , m_plot(new LayersPlot(this))
    , m_surface(new LayersSurface(this))
    , m_side(new SidePlot(this))
    , m_radius(new QComboBox(this))
    , m_summary(new QLabel(this)) {
    for (ViewPlot* plot : std::initializer_list<ViewPlot*>{m_plot, m_surface, m_side}) {
        plot->setMinimumSize(240, 140);
        addPage(*plot);
    }
    setUpNotice(*m_summary);
    hideUntilDrawn({m_summary});
    addColumn({pageTools<ToolRow>({m_radius}), m_summary, notice(), legend(), pages(), values()},
              pages())
        ->addStretch();
    disableUntilDrawn({content(), m_radius});
    nameObjects({{m_plot, "layersPlot"},
                 {m_surface, "layersSurface"},
                 {m_side, "layersSide"},
                 {m_radius, "layersRadius"},
                 {m_summary, "layersSummary"}});
    connectTools();
    built();
    chooseContent();
}

void LayersView::connectTools() {
    connect(m_plot, &LayersPlot::strokeClicked, this,
            [this](int stroke) { cycle().toStroke(stroke); });
    connect(content(), &QComboBox::currentIndexChanged, this, &LayersView::chooseContent);
    connect(m_radius, &QComboBox::activated, this, [this](int index) {
        m_wanted = index > 0 ? std::optional(index - 1) : std::nullopt;
        setSeries();
        showState();
        replotFront();
    });
}

QString LayersView::title() const {
    return tr("Layers");
}

void LayersView::chooseContent() {
    showPage(static_cast<std::size_t>(content()->currentIndex()));
    m_radius->setVisible(&front() != m_side); // it shows the radius that faces the wheel
    showState();
    replotFront();
}

// --- the run ------------------------------------------------------------------------------------

void LayersView::takeOutcome(const OutcomePtr&) {
    fillRadii();
    m_side->setRun(good());
    setSeries();
}

void LayersView::setSeries() {
    if (!good()) {
        return;
    }
    const int index = m_radius->currentIndex();
    const LayerSeries series =
        index > 0 ? makeLayerSeries(good()->result, good()->trajectory, index - 1) : good()->layers;
    m_plot->setSeries(series);
    m_surface->setSeries(series);
    showDone();
}

void LayersView::fillRadii() {
    const QSignalBlocker blocker(m_radius);
    const int radii = good() ? good()->trajectory.radii : 0;
    m_radius->clear();
    QStringList names{tr("Mean of the radii")};
    for (int k = 0; k < radii; ++k) {
        names << tr("Radius %1, %2°").arg(k).arg(QLocale().toString(360.0 * k / radii, 'g', 4));
    }
    m_radius->addItems(names);
    m_radius->setCurrentIndex(m_wanted && *m_wanted < radii ? *m_wanted + 1 : 0);
}

// --- the moment ---------------------------------------------------------------------------------

void LayersView::followCycle() {
    showDone();
    showState();
    replotFront();
}

/// If the cycle's cursor is in another run, all layers are shown.
void LayersView::showDone() {
    const LayerSeries& series = m_plot->series();
    const CycleCursor* const at = cycleIn(good());
    const LayersDone done = at && !at->atEnd()
                                ? layersDone(series, good()->trajectory, at->progress())
                                : allLayers(series);
    m_plot->setDone(done);
    m_surface->setDone(done);
    if (good()) {
        m_side->setScene(
            grindingScene(good()->result, good()->trajectory, at ? at->progress() : Progress{}));
    }
}

// --- texts --------------------------------------------------------------------------------------

bool LayersView::drawn() const {
    return good() && !good()->layers.columns.empty();
}

void LayersView::showState() {
    PlotView::showState();
    m_summary->setText(summary());
    readOut();
    m_plot->setAccessibleDescription(m_summary->text());
    m_surface->setAccessibleDescription(m_summary->text());
    m_side->setAccessibleDescription(m_side->values());
}

QString LayersView::hint() const {
    if (&front() == m_side) {
        return m_side->values();
    }
    return &front() == m_surface
               ? tr("Drag or press the arrow keys to turn the surface; the wheel zooms.")
               : tr("Point at a layer to read the values.");
}

QString LayersView::keptText() const {
    return tr("The inputs are refused; the layers are those of the last valid inputs.");
}

QString LayersView::remark() const {
    if (!drawn()) {
        return tr("The cycle is too long to be recorded: its layers are not drawn. Fewer radii or "
                  "sections help.");
    }
    QStringList lines{Names::uncutStrips(good()->result.project)};
    if (good()->result.status != RunStatus::completed) {
        lines.prepend(Names::status(good()->result.status));
    }
    return joined(lines, QStringLiteral("\n"));
}

/// The stock removed at each place up to the cursor.
QString LayersView::summary() const {
    const LayerSeries& series = m_plot->series();
    if (series.columns.empty()) {
        return {};
    }
    const LayersDone& done = m_plot->done();
    const auto [least, most] = std::ranges::minmax_element(done.sum_mm);
    const CycleCursor* const at = cycleIn(good());
    const QString when = Names::moment(series.operation, at ? at->stroke() : series.strokeCount(),
                                       series.strokeCount(), !at || at->strokeDone());
    if (done.count == 0) {
        return when;
    }
    const auto um = [](double sum_mm) { return Names::micrometres(sum_mm * units::umPerMm); };
    if (*least == *most) {
        return tr("%1: %2 µm off everywhere.").arg(when, um(*most));
    }
    const auto zone = [&](auto sum) {
        const LayerColumn& of = series.columns[static_cast<std::size_t>(sum - done.sum_mm.begin())];
        return Names::within(Names::zone(of.zone, of.section));
    };
    return tr("%1: most off %2, %3 µm; least off %4, %5 µm.")
        .arg(when, zone(most), um(*most), zone(least), um(*least));
}

QStringList LayersView::subheading() const {
    return {m_radius->currentText(), summary(), Names::uncutStrips(good()->result.project)};
}

void LayersView::nameParts() {
    nameAround(tr("Legend of the layers"), tr("State of the layers"), tr("Values under the mouse"));
    m_plot->setAccessibleName(tr("Layers of the stock along the part"));
    m_surface->setAccessibleName(tr("Accumulated actual feed over length and number"));
    m_side->setAccessibleName(tr("Wheel and part from the side, heights exaggerated"));
    m_side->setToolTip(tr("Heights are exaggerated. As in the model, a zone is ground during the "
                          "whole stroke; the whole deflection is drawn at the part."));
    m_summary->setAccessibleName(tr("Accumulated removal"));
    fillChoice(*content(), {tr("Stacked layers"), tr("Surface"), tr("Wheel and part")});
    tell(*content(), tr("How the layers are drawn"));
    tell(*m_radius, tr("Radius whose layers are drawn"));
    fillRadii();
}

} // namespace sparkout
