// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of sweeps: building and connecting.
#include "core/study/sweep_edits.h"
#include "ui/kit/metrics.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_pages.h"
#include "ui/views/sweep/sweep_axis_box.h"
#include "ui/views/sweep/sweep_curves.h"
#include "ui/views/sweep/sweep_map.h"
#include "ui/views/sweep/sweep_view.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int sweepSteps = 1000; ///< of the bar of progress
constexpr int valueLines = 3;
constexpr const char* usualInput = "/wheel/dullness";
} // namespace

SweepView::SweepView(QWidget* parent, Settings* settings)
    : View(parent)
    , m_axes{new SweepAxisBox(0, this), new SweepAxisBox(1, this)}
    , m_curves(new SweepCurves(this))
    , m_map(new SweepMap(this))
    , m_legend(new LegendStrip(this))
    , m_pages(new PlotPages(
          *this, *m_legend, [this] { return heading(); }, settings, PlotPages::Chosen::byView))
    , m_entry(new QComboBox(this))
    , m_side(new QComboBox(this))
    , m_point(new QSpinBox(this))
    , m_run(new QPushButton(this))
    , m_stop(new QPushButton(this))
    , m_add(new QPushButton(this))
    , m_take(new QAction(this))
    , m_takeButton(new QPushButton(this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
    , m_notice(new QLabel(this))
    , m_values(new QLabel(this))
    , m_runner(new SweepRunner(this)) {
    setObjectName(QStringLiteral("sweep"));
    build();
    connectParts();
    connectEdits();
    built();
}

void SweepView::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    setUpNotice(*m_notice);
    setUpReadout(*m_values, valueLines);
    for (SweepAxisBox* box : m_axes) {
        layout->addWidget(box);
    }
    layout->addWidget(m_toolBar = buildTools());
    layout->addWidget(m_runBar = buildRunBar());
    layout->addWidget(m_notice);
    layout->addWidget(m_add, 0, Qt::AlignLeft);
    layout->addWidget(m_legend);
    layout->addWidget(m_pages->stack(), 1);
    layout->addWidget(m_values);
    layout->addStretch(0);
    const std::pair<QWidget*, const char*> names[] = {
        {m_curves, "sweepCurves"},     {m_map, "sweepMap"},      {m_legend, "sweepLegend"},
        {m_entry, "sweepResult"},      {m_side, "sweepSide"},    {m_point, "sweepPoint"},
        {m_run, "sweepRun"},           {m_stop, "sweepStop"},    {m_add, "sweepAdd"},
        {m_takeButton, "sweepTake"},   {m_state, "sweepState"},  {m_notice, "sweepNotice"},
        {m_progress, "sweepProgress"}, {m_values, "sweepValues"}};
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

QWidget* SweepView::buildRunBar() {
    auto* bar = new QWidget(this);
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    setUpNotice(*m_state);
    m_progress->setRange(0, sweepSteps);
    m_progress->setTextVisible(true);
    m_point->setKeyboardTracking(false);
    row->addWidget(m_run);
    row->addWidget(m_stop);
    row->addWidget(m_state, 1);
    row->addWidget(m_progress, 1);
    row->addWidget(m_point);
    row->addWidget(m_takeButton);
    return bar;
}

QWidget* SweepView::buildTools() {
    for (SweepPlot* plot : plots()) {
        PlotSubject subject;
        subject.own = {m_take};
        m_pages->add(*plot, std::move(subject));
        plot->setMinimumSize(240, 120);
    }
    auto* bar = new QWidget(this);
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    m_side->addItems({QString(), QString()});
    for (QComboBox* box : {m_entry, m_side}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        row->addWidget(box);
    }
    row->addStretch(1);
    m_pages->addButtons(*row);
    return bar;
}

void SweepView::connectParts() {
    connect(m_entry, &QComboBox::currentIndexChanged, this, &SweepView::chooseEntry);
    connect(m_side, &QComboBox::currentIndexChanged, this, &SweepView::chooseEntry);
    for (SweepPlot* plot : plots()) {
        connect(plot, &SweepPlot::pointChosen, this, [this](std::size_t at) { choosePoint(at); });
        connect(plot, &SweepPlot::pointed, this, &SweepView::readOut);
    }
    connect(m_run, &QPushButton::clicked, this, &SweepView::runSweep);
    connect(m_stop, &QPushButton::clicked, m_runner, &SweepRunner::stop);
    connect(m_take, &QAction::triggered, this, &SweepView::takeValues);
    connect(m_takeButton, &QPushButton::clicked, m_take, &QAction::trigger);
    connect(m_point, &QSpinBox::valueChanged, this, [this](int number) {
        choosePoint(number > 0 ? std::optional(static_cast<std::size_t>(number - 1))
                               : std::nullopt);
    });
    connect(m_runner, &SweepRunner::progressed, this,
            [this](qint64 done, qint64 points, double left_s) {
                m_progress->setValue(
                    static_cast<int>(done * sweepSteps / std::max(points, qint64(1))));
                m_progress->setFormat(SweepText::progress(done, points, left_s));
            });
    connect(m_runner, &SweepRunner::finished, this, &SweepView::takeSweep);
}

void SweepView::connectEdits() {
    const auto choose = [this](std::size_t place, const std::string& path) {
        edit([place,
              path](Project project) { return withSweptInput(std::move(project), place, path); },
             {"Edit", QT_TRANSLATE_NOOP("Edit", "Input of the sweep")});
    };
    for (std::size_t place = 0; place < m_axes.size(); ++place) {
        connect(m_axes[place], &SweepAxisBox::inputChosen, this,
                [choose, place](const std::string& path) { choose(place, path); });
        connect(m_axes[place], &SweepAxisBox::axisEdited, this,
                [this, place](const SweepAxis& axis) {
                    edit(
                        [place, axis](Project project) {
                            return withSweepAxis(std::move(project), place, axis);
                        },
                        {"Edit", QT_TRANSLATE_NOOP("Edit", "Range of the sweep")});
                });
    }
    connect(m_add, &QPushButton::clicked, this, [choose] { choose(0, usualInput); });
}

} // namespace sparkout
