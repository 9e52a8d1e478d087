// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of the batch: building and connecting.
#include "core/study/batch_edits.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/views/batch/batch_figures.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/batch/batch_view.h"
#include "ui/views/batch/histogram_plot.h"
#include "ui/views/batch/pareto_plot.h"
#include "ui/views/batch/part_rows.h"
#include "ui/views/batch/scatter_plot.h"
#include "ui/views/batch/sensitivity_plot.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int histogramShare = 200, figuresShare = 220; ///< of the height at first
constexpr int progressSteps = 1000;
constexpr int stateLetters = 36; ///< wide, the text on the run at least
} // namespace

BatchView::BatchView(QWidget* parent, Settings* settings)
    : View(parent)
    , m_histograms(new HistogramPlot(this))
    , m_sensitivity(new SensitivityPlot(this))
    , m_scatter(new ScatterPlot(this))
    , m_pareto(new ParetoPlot(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_legend(new LegendStrip(this))
    , m_pages(new PlotPages(
          *this, *m_legend, [this] { return heading(); }, settings))
    , m_figures(new BatchFigures(this))
    , m_name(new QComboBox(this))
    , m_weights(new QComboBox(this))
    , m_across(new QComboBox(this))
    , m_up(new QComboBox(this))
    , m_run(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_worst(new QPushButton(this))
    , m_rows(new QPushButton(this))
    , m_add(new QPushButton(this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this))
    , m_settings(settings)
    , m_runner(new BatchRunner(this))
    , m_indexRunner(new BatchRunner(this)) {
    setObjectName(QStringLiteral("batch"));
    build(settings);
    connectParts();
    built();
    chooseContent();
}

void BatchView::build(Settings* settings) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    buildTools(bar);
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    for (const PlotPages::Page& page : m_pages->all()) {
        page.plot->setMinimumSize(240, 120);
    }
    m_splitter->addWidget(m_pages->stack());
    m_splitter->addWidget(buildFigures());
    m_table->setSaving(
        [this] { return m_batch ? batchFiguresTable(m_batch->summary) : CsvTable(); },
        [this] { return heading().value(1); }, settings);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setSizes({histogramShare, figuresShare});
    m_splitter->setStretchFactor(0, histogramShare);
    m_splitter->setStretchFactor(1, figuresShare);
    layout->addWidget(bar);
    layout->addWidget(m_runBar = buildRunBar());
    layout->addWidget(m_notice);
    layout->addWidget(m_add, 0, Qt::AlignLeft);
    layout->addWidget(m_legend);
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_values);
    layout->addStretch(0);
    const std::pair<QWidget*, const char*> names[] = {
        {m_histograms, "batchHistograms"},
        {m_legend, "batchLegend"},
        {m_pages->content(), "batchContent"},
        {m_name, "batchCharacteristic"},
        {m_run, "batchRun"},
        {m_stop, "batchStop"},
        {m_worst, "batchWorst"},
        {m_rows, "batchRows"},
        {m_add, "batchAdd"},
        {m_progress, "batchProgress"},
        {m_state, "batchState"},
        {m_notice, "batchNotice"},
        {m_values, "batchValues"},
        {m_table, "batchFigures"},
        {m_sensitivity, "batchSensitivity"},
        {m_scatter, "batchScatter"},
        {m_pareto, "batchPareto"},
        {m_weights, "batchWeights"},
        {m_across, "batchAcross"},
        {m_up, "batchUp"},
    };
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

QWidget* BatchView::buildRunBar() {
    auto* bar = new QWidget(this);
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    setUpNotice(*m_state);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(true);
    row->addWidget(m_run);
    row->addWidget(m_stop);
    row->addWidget(m_worst);
    row->addWidget(m_rows);
    row->addText(m_state, stateLetters, 1);
    row->addWidget(m_progress, 1);
    return bar;
}

void BatchView::buildTools(QWidget* bar) {
    m_pages->add(*m_histograms);
    m_pages->add(*m_sensitivity);
    m_pages->add(*m_scatter);
    m_pages->add(*m_pareto);
    m_weights->addItems({QString(), QString()});
    for (QComboBox* box : {m_name, m_weights, m_across, m_up}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_pages->content());
    row->addWidget(m_name);
    row->addWidget(m_weights);
    row->addWidget(m_across);
    row->addWidget(m_up);
    row->addStretch(1);
    m_pages->addButtons(*row);
}

QWidget* BatchView::buildFigures() {
    m_table = new CopyTable(
        [this] {
            return m_batch ? tabSeparated(batchFiguresTable(m_batch->summary), QLocale())
                           : QString();
        },
        this);
    m_table->setModel(m_figures);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->verticalHeader()->setHighlightSections(false);
    return m_table;
}

/// A menu of the two kinds of CSV.
void BatchView::nameRows() {
    if (!m_rows->menu()) {
        auto* menu = new QMenu(m_rows);
        for (const TableFormat format : {TableFormat::csvRussian, TableFormat::csvEnglish}) {
            connect(menu->addAction(QString()), &QAction::triggered, this, [this, format] {
                const BatchOutcomePtr batch = m_batch; // may be another one by the end
                (void)savePartRows(window(), m_settings, batch->result.project, format);
            });
        }
        m_rows->setMenu(menu);
    }
    m_rows->menu()->actions()[0]->setText(tableFormatText(TableFormat::csvRussian));
    m_rows->menu()->actions()[1]->setText(tableFormatText(TableFormat::csvEnglish));
    m_rows->setText(tr("All parts as CSV"));
    m_rows->setAccessibleName(m_rows->text());
    m_rows->setToolTip(tr("Run the batch again and save a row for every part: its factors, every "
                          "quantity, every requirement held or not"));
    m_rows->setAccessibleDescription(m_rows->toolTip());
}

void BatchView::connectParts() {
    connect(m_pages->content(), &QComboBox::currentIndexChanged, this, &BatchView::chooseContent);
    connect(m_name, &QComboBox::currentIndexChanged, this, &BatchView::chooseName);
    connect(m_run, &QPushButton::clicked, this, &BatchView::runBatch);
    connect(m_stop, &QPushButton::clicked, this, [this] {
        m_runner->stop();
        m_indexRunner->stop();
    });
    connect(m_weights, &QComboBox::currentIndexChanged, this, &BatchView::chooseWeights);
    for (QComboBox* box : {m_across, m_up}) {
        connect(box, &QComboBox::currentIndexChanged, this, &BatchView::chooseQuantities);
    }
    connect(m_worst, &QPushButton::clicked, this, &BatchView::takeWorst);
    connect(m_add, &QPushButton::clicked, this, [this] {
        // The view is of the inputs that were accepted last; those of now may have a batch.
        emit editWanted(
            [](Project project) {
                return project.batch ? project : withUsualBatch(std::move(project));
            },
            {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a batch")});
    });
    connect(m_histograms, &HistogramPlot::pointed, this, &BatchView::readOut);
    connect(m_sensitivity, &SensitivityPlot::pointed, this, &BatchView::readOut);
    connect(m_scatter, &ScatterPlot::pointed, this, &BatchView::readOut);
    connect(m_pareto, &ParetoPlot::pointed, this, &BatchView::readOut);
    for (BatchRunner* runner : {m_runner, m_indexRunner}) {
        connect(runner, &BatchRunner::progressed, this,
                [this](qint64 done, qint64 parts, double left_s) {
                    m_progress->setValue(
                        static_cast<int>(done * progressSteps / std::max(parts, qint64(1))));
                    m_progress->setFormat(BatchText::progress(done, parts, left_s));
                });
    }
    connect(m_indexRunner, &BatchRunner::indicesFound, this, &BatchView::takeIndices);
    connect(m_runner, &BatchRunner::finished, this, &BatchView::takeBatch);
}

} // namespace sparkout
