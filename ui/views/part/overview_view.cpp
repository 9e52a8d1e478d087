// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/overview_view.h"

#include "core/quality/run_summary.h"
#include "core/study/batch_edits.h"
#include "core/study/run_comparison.h"
#include "core/units.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/session/kept_runs.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace sparkout {

OverviewTile::OverviewTile(const QString& name, QWidget* parent)
    : QFrame(parent)
    , m_title(new QLabel(this))
    , m_enlarge(new QToolButton(this))
    , m_legend(new LegendStrip(this))
    , m_plot(new BarPlot(this))
    , m_remark(new QLabel(this))
    , m_empty(new QLabel(this))
    , m_step(new QPushButton(this)) {
    setObjectName(name);
    m_enlarge->setObjectName(name + QStringLiteral("Enlarge"));
    m_legend->setObjectName(name + QStringLiteral("Legend"));
    m_plot->setObjectName(name + QStringLiteral("Plot"));
    m_step->setObjectName(name + QStringLiteral("Step"));
    setFrameShape(QFrame::StyledPanel);
    setRelativeFont(*m_title, 1, true);
    for (QLabel* label : {m_title, m_remark, m_empty}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    m_enlarge->setIcon(themeIcon(u"enlarge"));
    m_enlarge->setAutoRaise(true);
    m_enlarge->setFocusPolicy(Qt::TabFocus);
    m_plot->setLeads(true);
    m_plot->setMinimumWidth(160);
    auto* head = new QHBoxLayout;
    head->setSpacing(metrics::hair);
    head->addWidget(m_title, 1);
    head->addWidget(m_enlarge);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::gap, metrics::tight, metrics::gap, metrics::tight);
    column->setSpacing(metrics::tight);
    column->addLayout(head);
    column->addWidget(m_legend);
    column->addWidget(m_plot, 1);
    column->addWidget(m_remark);
    column->addStretch();
    column->addWidget(m_empty);
    column->addWidget(m_step, 0, Qt::AlignLeft);
    column->addStretch();
    connect(m_enlarge, &QToolButton::clicked, this, &OverviewTile::enlargeAsked);
    connect(m_step, &QPushButton::clicked, this, &OverviewTile::stepAsked);
    connect(m_plot, &ViewPlot::contentChanged, this, &OverviewTile::showLegend);
    connect(m_legend, &LegendStrip::toggled, m_plot, &BarPlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &BarPlot::showOnly);
    showParts();
}

void OverviewTile::addExport() {
    auto* head = static_cast<QHBoxLayout*>(layout()->itemAt(0)->layout());
    head->addWidget(m_plot->tools()->exportButton(this));
}

void OverviewTile::setTitle(const QString& title) {
    m_title->setText(title);
    m_plot->setAccessibleName(title);
    nameStep();
}

QString OverviewTile::title() const {
    return m_title->text();
}

bool OverviewTile::isEmpty() const {
    return m_plot->chart().empty();
}

QString OverviewTile::emptyText() const {
    return isEmpty() ? m_empty->text() : QString();
}

void OverviewTile::setChart(BarChart chart) {
    if (!chart.empty()) { // the texts are those of an empty tile, in the language of their time
        m_empty->clear();
        m_step->setText({});
    }
    m_remark->setText(chart.remark);
    m_plot->setChart(std::move(chart));
    m_plot->setAccessibleDescription(m_plot->chart().description());
    showParts();
}

void OverviewTile::setEmpty(const QString& text, const QString& step) {
    m_empty->setText(text);
    m_step->setText(step);
    nameStep();
    setChart({});
}

void OverviewTile::nameStep() {
    m_step->setAccessibleName(m_step->text().isEmpty() ? title() : m_step->text());
}

void OverviewTile::showParts() {
    const bool drawn = !isEmpty();
    m_plot->setVisible(drawn);
    m_remark->setVisible(drawn && !m_remark->text().isEmpty());
    m_empty->setVisible(!drawn);
    m_step->setVisible(!drawn && !m_step->text().isEmpty());
    if (m_plot->tools()) {
        m_plot->tools()->setEnabled(drawn);
    }
    m_enlarge->setEnabled(drawn || m_isAlone);
    fitHeight();
    showLegend();
}

void OverviewTile::fitHeight() {
    m_plot->setMinimumHeight(BarDrawing::leastHeight(m_plot->chart(), m_plot->font()));
}

void OverviewTile::showLegend() {
    const LegendEntries entries = m_plot->legendEntries();
    m_legend->setVisible(!isEmpty() && !entries.empty());
    m_legend->setEntries(entries);
}

void OverviewTile::setAlone(bool isAlone) {
    m_isAlone = isAlone;
    m_enlarge->setIcon(themeIcon(isAlone ? u"reduce" : u"enlarge"));
    m_enlarge->setEnabled(isAlone || !isEmpty());
    retranslate();
}

void OverviewTile::retranslate() {
    const QString text = m_isAlone ? tr("Back to all charts") : tr("Enlarge: %1").arg(title());
    m_enlarge->setAccessibleName(text);
    m_enlarge->setToolTip(m_isAlone ? tr("Back to all charts (Esc)")
                                    : tr("Enlarge this chart to the whole page"));
    m_legend->retranslate();
    m_legend->setAccessibleName(tr("Legend: %1").arg(title()));
}

namespace {

using enum OverviewChart;

constexpr int columnWidth = 300; ///< least width at the usual font size
constexpr int mostColumns = 3;
constexpr std::array tileNames{"overviewTimes",        "overviewStock", "overviewDiameters",
                               "overviewRequirements", "overviewBoxes", "overviewParts",
                               "overviewRuns"};
static_assert(tileNames.size() == allOverviewCharts.size());

} // namespace

OverviewView::OverviewView(const KeptRuns& kept, QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("overview"), parent, settings)
    , m_kept(kept)
    , m_scroll(new QScrollArea(this)) {
    build();
    connect(&m_kept, &KeptRuns::changed, this, [this] {
        m_runsChanged = true;
        if (isVisible()) {
            showRuns();
        }
    });
    built();
}

void OverviewView::build() {
    auto* page = new QWidget(m_scroll);
    m_grid = new QGridLayout(page);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(metrics::gap);
    for (const OverviewChart chart : allOverviewCharts) {
        const auto index = static_cast<std::size_t>(chart);
        auto* tile = new OverviewTile(QLatin1String(tileNames[index]), page);
        m_tiles[index] = tile;
        PlotSubject subject;
        subject.name = [chart] { return OverviewCharts::title(chart); };
        subject.heading = [this, chart] { return headingOf(chart); };
        addPlot(*tile->plot(), std::move(subject));
        tile->addExport();
        connect(tile, &OverviewTile::enlargeAsked, this, [this, chart] { enlarge(chart); });
        connect(tile, &OverviewTile::stepAsked, this, [this, chart] {
            chart == runs ? emit keepAsked() : emit viewAsked(QStringLiteral("batch"));
        });
        connect(tile->plot(), &BarPlot::entered, this,
                [this, chart](std::size_t series, std::size_t category) {
                    follow(chart, series, category);
                });
    }
    m_scroll->setObjectName(QStringLiteral("overviewPage"));
    m_scroll->setWidget(page);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    hideUntilDrawn({m_scroll});
    addColumn({notice(), m_scroll, values()}, m_scroll)->addStretch();
    arrange();
}

// --- the page -----------------------------------------------------------------------------------

/// Uses its own width, since that of the page is updated later.
int OverviewView::columnsWithRoom() const {
    const int room = width() - 2 * metrics::gap - m_scroll->verticalScrollBar()->sizeHint().width();
    return std::clamp(room / atFontSize(columnWidth), 1, mostColumns);
}

/// Arranges the tiles; the last one takes the rest of its row, an enlarged one the whole page.
void OverviewView::arrange() {
    m_columns = columnsWithRoom();
    while (m_grid->count() > 0) {
        delete m_grid->takeAt(0); // its tile is kept
    }
    for (int i = 0; i < mostColumns; ++i) {
        m_grid->setColumnStretch(i, i < m_columns ? 1 : 0);
    }
    int place = 0;
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        const bool isShown = !m_alone || static_cast<std::size_t>(*m_alone) == i;
        m_tiles[i]->setVisible(isShown);
        m_tiles[i]->setAlone(m_alone && isShown);
        if (!isShown) {
            continue;
        }
        const bool isLast = m_alone || i + 1 == m_tiles.size();
        const int column = place % m_columns;
        m_grid->addWidget(m_tiles[i], place / m_columns, column, 1,
                          isLast ? m_columns - column : 1);
        ++place;
    }
    for (int row = 0; row < static_cast<int>(m_tiles.size()); ++row) {
        m_grid->setRowStretch(row, row * m_columns < place ? 1 : 0);
    }
}

void OverviewView::enlarge(OverviewChart chart) {
    const bool back = m_alone.has_value();
    m_alone = back ? std::nullopt : std::optional(chart);
    arrange();
    if (back) {
        m_scroll->ensureWidgetVisible(tile(chart));
    } else {
        m_scroll->verticalScrollBar()->setValue(0);
    }
    replotAll();
}

void OverviewView::resizeEvent(QResizeEvent* event) {
    PlotView::resizeEvent(event);
    if (columnsWithRoom() != m_columns) {
        arrange();
    }
}

void OverviewView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_alone) {
        enlarge(*m_alone);
    } else {
        PlotView::keyPressEvent(event);
    }
}

/// A new font needs other heights, and possibly fewer columns.
void OverviewView::recolour() {
    for (OverviewTile* tile : m_tiles) {
        tile->fitHeight();
    }
    arrange();
}

// --- displayed charts ---------------------------------------------------------------------------

void OverviewView::takeOutcome(const OutcomePtr&) {
    showCycle();
    showBatch();
    showRuns();
}

void OverviewView::showCycle() {
    tile(times)->setChart(OverviewCharts::times(*good()));
    tile(diameters)->setChart(OverviewCharts::diameters(*good()));
    tile(requirements)->setChart(OverviewCharts::requirements(*good()));
    BarChart removed = OverviewCharts::stock(*good());
    if (removed.empty()) {
        tile(stock)->setEmpty(tr("The cycle is too long to be recorded step by step: fewer radii "
                                 "or sections help."));
    } else {
        tile(stock)->setChart(std::move(removed));
    }
}

void OverviewView::setBatch(BatchOutcomePtr batch) {
    if (m_batch == batch) {
        return;
    }
    m_batch = std::move(batch);
    m_batchChanged = true;
    if (isVisible()) {
        showBatch();
        showState();
        replotAll();
    }
}

bool OverviewView::isBatchStale() const {
    return !m_batch || !good() || !sameBatch(m_batch->result.project, good()->result.project);
}

void OverviewView::showBatch() {
    if (!good()) {
        return;
    }
    m_batchChanged = false;
    QString text, step;
    if (!good()->result.project.batch) {
        text = tr(
            "This project describes no batch. With a batch of parts whose stock, runout and wheel "
            "scatter, the scatter of the sizes and the number of good parts are shown here.");
        step = tr("Add a batch…");
    } else if (!m_batch || !m_batch->ran()) {
        text = tr("The batch has not been run. The scatter of its sizes and the number of good "
                  "parts will be shown here.");
        step = tr("Run the batch…");
    } else {
        tile(parts)->setChart(OverviewCharts::parts(*m_batch));
        BarChart scatter =
            OverviewCharts::boxes(*m_batch, statisticsOfMeasured(good()->result.project));
        if (scatter.empty()) {
            tile(boxes)->setEmpty(m_batch->summary.isSample
                                      ? tr("No part of the batch has a size to show.")
                                      : tr("The batch consists of corner parts: they are not a "
                                           "sample and have no quartiles."),
                                  tr("To the batch…"));
        } else {
            tile(boxes)->setChart(std::move(scatter));
        }
        return;
    }
    tile(boxes)->setEmpty(text, step);
    tile(parts)->setEmpty(text, step);
}

/// The current run, then the newest kept ones.
std::vector<RunBars> OverviewView::shownRuns() const {
    const RunSummary present = summarise(good()->result, good()->accuracy, good()->constraints);
    std::vector<RunBars> shown{{tr("current", "run"), present.cycle_time_min,
                                leastMargin(present, &good()->result.project)}};
    for (int run = std::max(m_kept.count() - OverviewCharts::mostRuns, 0); run < m_kept.count();
         ++run) {
        const KeptRun& kept = m_kept.all()[static_cast<std::size_t>(run)];
        RunBars bars{printableText(runName(kept.name))};
        if (const ReadSummary* const read = m_kept.summary(run)) {
            bars.least = leastMargin(read->summary, m_kept.inputs(run));
            if (!read->missing.contains("/cycle_time_min")) {
                bars.time_min = read->summary.cycle_time_min;
            }
        }
        shown.push_back(std::move(bars));
    }
    return shown;
}

void OverviewView::offerKeeping(bool offers) {
    m_offersKeeping = offers;
    showRuns();
}

void OverviewView::showRuns() {
    if (!good()) {
        return;
    }
    m_runsChanged = false;
    if (m_kept.count() == 0) {
        tile(runs)->setEmpty(tr("No run is kept yet. Its time and margin will be shown here beside "
                                "those of the current run."),
                             m_offersKeeping ? tr("Keep this run") : QString());
    } else {
        tile(runs)->setChart(OverviewCharts::runs(shownRuns(), m_kept.count()));
        tile(runs)->plot()->setAccessibleDescription({}); // names are the user's own texts
        tile(runs)->plot()->replot(QCustomPlot::rpQueuedReplot);
    }
}

void OverviewView::showEvent(QShowEvent* event) {
    PlotView::showEvent(event);
    if (m_runsChanged) {
        showRuns();
    }
    if (m_batchChanged) {
        showBatch();
        showState();
    }
}

void OverviewView::dropStudies() {
    m_batch.reset();
    m_alone.reset();
    arrange();
    showBatch();
}

bool OverviewView::isFaint(const ViewPlot& plot) const {
    const bool ofBatch = &plot == tile(boxes)->plot() || &plot == tile(parts)->plot();
    return faint() || (ofBatch && isBatchStale());
}

void OverviewView::showState() {
    PlotView::showState();
    legend()->hide(); // each tile has its own
    for (OverviewTile* tile : m_tiles) {
        if (tile && tile->isEmpty() && tile->plot()->tools()) {
            tile->plot()->tools()->setEnabled(false);
        }
    }
}

/// Requests the view with the details.
void OverviewView::follow(OverviewChart chart, std::size_t, std::size_t category) {
    if (!good()) {
        return;
    }
    const auto at = [category](const auto& of) { return of.at(category); };
    switch (chart) {
    case times:
        emit stageAsked(static_cast<int>(at(OverviewCharts::stagesShown(*good()))) + 1);
        break;
    case stock: emit viewAsked(QStringLiteral("layers")); break;
    case diameters: emit sectionAsked(at(OverviewCharts::sectionsOfDiameters(*good()))); break;
    case requirements: emit requirementAsked(at(OverviewCharts::requirementsShown(*good()))); break;
    case boxes:
    case parts: emit viewAsked(QStringLiteral("batch")); break;
    case runs: emit viewAsked(QStringLiteral("compare")); break;
    }
}

// --- words --------------------------------------------------------------------------------------

QString OverviewView::title() const {
    return tr("Overview");
}

QString OverviewView::hint() const {
    return tr("Point at a bar to read its value; a click leads to its view. By keyboard: "
              "arrows, Enter.");
}

QString OverviewView::remark() const {
    QStringList texts;
    if (const RunStatus status = good()->result.status; status != RunStatus::completed) {
        texts << Names::status(status);
    }
    texts << Names::uncutStrips(good()->result.project);
    if (good()->result.project.batch && m_batch && isBatchStale()) {
        texts << tr("The inputs have changed since the batch was run.");
    }
    texts.removeAll(QString());
    return texts.join(u'\n');
}

QStringList OverviewView::headingOf(OverviewChart chart) const {
    QStringList lines = heading();
    lines[0] = tr("%1: %2", "view, chart").arg(title(), OverviewCharts::title(chart));
    lines << tile(chart)->plot()->chart().remark;
    lines.removeAll(QString());
    return lines;
}

void OverviewView::nameParts() {
    nameAround(tr("Legend of the overview"), tr("State of the overview"),
               tr("Values under the mouse"));
    m_scroll->setAccessibleName(tr("Charts of the overview"));
    for (const OverviewChart chart : allOverviewCharts) {
        tile(chart)->setTitle(OverviewCharts::title(chart));
        tile(chart)->retranslate();
    }
    if (good()) {
        takeOutcome(good());
    }
}

} // namespace sparkout
