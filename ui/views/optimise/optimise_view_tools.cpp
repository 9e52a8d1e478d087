// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of the search: building, connecting and naming.
#include "core/study/search_edits.h"
#include "ui/charts/compare_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/views/optimise/found_model.h"
#include "ui/views/optimise/optimise_text.h"
#include "ui/views/optimise/optimise_view.h"
#include "ui/views/optimise/stage_count_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int plotShare = 260, foundShare = 140; ///< of the height at first
constexpr int progressSteps = 1000;
} // namespace

OptimiseView::OptimiseView(QWidget* parent, Settings* settings)
    : View(parent)
    , m_curves(new ComparePlot(this))
    , m_times(new StageCountPlot(this))
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_legend(new LegendStrip(this))
    , m_pages(new PlotPages(
          *this, *m_legend, [this] { return heading(); }, settings))
    , m_found(new FoundModel(this))
    , m_zone(new QComboBox(this))
    , m_run(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_take(new QPushButton(this))
    , m_add(new QPushButton(this))
    , m_phases(new QCheckBox(this))
    , m_refine(new QCheckBox(this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this))
    , m_runner(new SearchRunner(this))
    , m_trials(new RunController(this)) {
    setObjectName(QStringLiteral("optimise"));
    build(settings);
    connectParts();
    built();
    chooseContent();
}

void OptimiseView::build(Settings* settings) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    QWidget* tools = buildTools();
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    for (const PlotPages::Page& page : m_pages->all()) {
        page.plot->setMinimumSize(240, 120);
    }
    m_splitter->addWidget(m_pages->stack());
    m_splitter->addWidget(buildTable());
    m_table->setSaving([this] { return m_found->table(); }, [this] { return heading().value(1); },
                       settings);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setSizes({plotShare, foundShare});
    m_splitter->setStretchFactor(0, plotShare);
    m_splitter->setStretchFactor(1, foundShare);
    layout->addWidget(buildRunBar());
    layout->addWidget(m_notice);
    layout->addWidget(m_add, 0, Qt::AlignLeft);
    layout->addWidget(tools);
    layout->addWidget(m_legend);
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_values);
    layout->addStretch(0);
    const std::pair<QWidget*, const char*> names[] = {
        {m_curves, "optimiseCurves"}, {m_times, "optimiseTimes"},
        {m_legend, "optimiseLegend"}, {m_pages->content(), "optimiseContent"},
        {m_zone, "optimiseZone"},     {m_run, "optimiseRun"},
        {m_stop, "optimiseStop"},     {m_take, "optimiseTake"},
        {m_add, "optimiseAdd"},       {m_phases, "optimisePhases"},
        {m_refine, "optimiseRefine"}, {m_progress, "optimiseProgress"},
        {m_state, "optimiseState"},   {m_notice, "optimiseNotice"},
        {m_values, "optimiseValues"}, {m_table, "optimiseFound"},
    };
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

QWidget* OptimiseView::buildRunBar() {
    auto* bar = new QWidget(this);
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    m_state->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(true);
    row->addWidget(m_run);
    row->addWidget(m_stop);
    row->addWidget(m_phases);
    row->addWidget(m_refine);
    row->addWidget(m_state, 1);
    row->addWidget(m_progress, 1);
    row->addWidget(m_take);
    return bar;
}

QWidget* OptimiseView::buildTools() {
    PlotSubject curves;
    curves.navigation.axes = [this](QCPAxisRect& rect) { return m_curves->movedAxes(rect); };
    m_pages->add(*m_curves, std::move(curves));
    m_pages->add(*m_times);
    for (QComboBox* box : {m_pages->content(), m_zone}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_pages->content());
    row->addWidget(m_zone);
    row->addStretch(1);
    m_pages->addButtons(*row);
    return bar;
}

QWidget* OptimiseView::buildTable() {
    m_table = new CopyTable([this] { return tabSeparated(m_found->table(), QLocale()); }, this);
    m_table->setModel(m_found);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    return m_table;
}

void OptimiseView::connectParts() {
    connect(m_pages->content(), &QComboBox::currentIndexChanged, this,
            &OptimiseView::chooseContent);
    connect(m_zone, &QComboBox::currentIndexChanged, this, &OptimiseView::chooseZone);
    connect(m_run, &QPushButton::clicked, this, &OptimiseView::runSearch);
    connect(m_stop, &QPushButton::clicked, m_runner, &SearchRunner::stop);
    connect(m_take, &QPushButton::clicked, this, &OptimiseView::takeCycle);
    connect(m_table, &CopyTable::rowEntered, this, &OptimiseView::takeCycle);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &OptimiseView::tryCycle);
    connect(m_add, &QPushButton::clicked, this, [this] {
        // The view is of the inputs that were accepted last; those of now may have a grid.
        emit editWanted(
            [](Project project) {
                return project.optimisation ? project : withUsualSearch(std::move(project));
            },
            {"Edit", QT_TRANSLATE_NOOP("Edit", "Add a search")});
    });
    connect(m_curves, &ComparePlot::pointed, this, &OptimiseView::readOut);
    connect(m_times, &StageCountPlot::pointed, this, &OptimiseView::readOut);
    connect(m_runner, &SearchRunner::progressed, this, [this](const SearchState& state) {
        const double share = state.best_s ? std::clamp(state.bound_s / *state.best_s, 0.0, 1.0) : 0;
        m_progress->setValue(static_cast<int>(share * progressSteps));
        m_progress->setFormat(OptimiseText::state(state));
        m_progress->setToolTip(m_progress->format());
    });
    connect(m_runner, &SearchRunner::finished, this, &OptimiseView::takeSearch);
    connect(m_trials, &RunController::finished, this, &OptimiseView::takeTrial);
}

void OptimiseView::nameParts() {
    setAccessibleName(title());
    m_curves->setAccessibleName(tr("Feeds and radii of your cycle and of the one found"));
    m_times->setAccessibleName(tr("Machining time over the number of stages"));
    m_legend->setAccessibleName(tr("Legend of the search"));
    m_notice->setAccessibleName(tr("What the search found"));
    m_state->setAccessibleName(tr("Size of the grid"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_progress->setAccessibleName(tr("Progress of the search"));
    m_table->setAccessibleName(tr("The best cycles found"));
    m_pages->content()->setItemText(0, tr("Before and after"));
    m_pages->content()->setItemText(1, tr("Time by stages"));
    m_pages->content()->setAccessibleName(tr("What is shown of the search"));
    m_pages->content()->setToolTip(m_pages->content()->accessibleName());
    m_zone->setAccessibleName(tr("Zone or section of the curves"));
    m_zone->setToolTip(m_zone->accessibleName());
    const auto name = [](QAbstractButton& button, const QString& text, const QString& tip) {
        button.setText(text);
        button.setAccessibleName(text);
        button.setAccessibleDescription(tip);
        button.setToolTip(tip);
    };
    name(*m_run, tr("Search"),
         tr("Find the quickest cycle of the grid that holds every requirement"));
    name(*m_stop, tr("Stop"), tr("End the search; the best so far is kept and shown"));
    name(*m_take, tr("Take this cycle"),
         tr("Put the chosen cycle in the place of the present one; undo brings yours back"));
    name(*m_phases, tr("In every phase of the stock"),
         tr("The cycle must hold for stocks spread over one feed step of every stage too: where "
            "the last step falls decides on the size"));
    name(*m_refine, tr("Between levels"),
         tr("Go on from the quickest cycle between the levels of the grid, in the machine's steps: "
            "every cycle is run in full, but that none is quicker is not proved"));
    name(*m_add, tr("Add a usual search"),
         tr("A dozen levels of each feed about the present cycle, and steps of stock; can be "
            "undone and changed on the page Search"));
}

} // namespace sparkout
