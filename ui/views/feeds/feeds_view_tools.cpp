// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the feeds view: building and connecting.
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_tools.h"
#include "ui/views/feeds/feeds_overview.h"
#include "ui/views/feeds/feeds_plot.h"
#include "ui/views/feeds/feeds_view.h"

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

namespace sparkout {

namespace {
constexpr int overviewGesture = 2002; ///< for PlotNavigation::gestureOf()
}

FeedsView::FeedsView(QWidget* parent, Settings* settings) : View(parent) {
    setObjectName(QStringLiteral("feeds"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    layout->setSpacing(metrics::tight);
    auto* bar = new QWidget(this);
    m_notice = new QLabel(this);
    m_values = new QLabel(this);
    m_legend = new LegendStrip(this);
    m_plot = new FeedsPlot(this);
    m_overview = new FeedsOverview(*m_plot, this);
    buildPlotTools(settings);
    buildToolBar(bar);
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    layout->addWidget(bar);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_overview);
    layout->addWidget(m_strip);
    layout->addWidget(m_values);
    layout->addStretch();
    connectTools();
    connectPlot();
    built();
}

void FeedsView::buildPlotTools(Settings* settings) {
    PlotSubject subject;
    subject.heading = [this] {
        QStringList heading{title()};
        if (m_good) {
            const QString project = QString::fromStdString(m_good->result.project.title);
            heading << project.simplified();
        }
        heading.removeAll(QString());
        return heading;
    };
    subject.legend = [this] { return m_plot->legendEntries(); };
    subject.table = [this] { return m_plot->table(); };
    subject.navigation.fit = [this] { fitAll(); };
    subject.navigation.state = [this] { return m_plot->sight(); };
    subject.navigation.setState = [this](const PlotHistory::State& s) { m_plot->setSight(s); };
    subject.navigation.axes = [this](QCPAxisRect& rect) { return m_plot->movedAxes(rect); };
    m_tools = new PlotTools(*m_plot, std::move(subject));
    m_tools->setSettings(settings);
    m_cursors = new PlotCursors(*m_plot, m_plot->cursorSubject());
    m_strip = new CursorStrip(*m_cursors, this);
    m_tools->addTool(m_cursors->toggle);
}

void FeedsView::buildToolBar(QWidget* bar) {
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::row); // many stand in it
    m_span = new QComboBox(bar);
    m_previous = new QToolButton(bar);
    m_stroke = new QSpinBox(bar);
    m_next = new QToolButton(bar);
    m_strokeLabel = new QLabel(bar);
    m_section = new QComboBox(bar);
    m_axis = new QComboBox(bar);
    m_note = new QToolButton(bar);
    m_previous->setArrowType(Qt::LeftArrow);
    m_next->setArrowType(Qt::RightArrow);
    m_note->setIcon(themeIcon(u"info"));
    m_note->setAutoRaise(true);
    m_strokeLabel->setTextFormat(Qt::PlainText);
    for (QToolButton* button : {m_previous, m_next, m_note}) {
        button->setFocusPolicy(Qt::TabFocus);
    }
    for (QComboBox* box : {m_span, m_section, m_axis}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }
    m_stroke->setKeyboardTracking(false);
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_span, m_strokeLabel, m_previous, m_stroke, m_next}) {
        row->addWidget(w);
    }
    row->addStretch();
    row->addWidget(m_section);
    row->addWidget(m_axis);
    for (QAction* action : {m_cursors->toggle, m_tools->back, m_tools->forward, m_tools->fit}) {
        row->addWidget(m_tools->button(action, bar));
    }
    row->addWidget(m_tools->exportButton(bar));
    row->addWidget(m_note);
    nameTools();
}

void FeedsView::nameTools() {
    m_span->setObjectName(QStringLiteral("span"));
    m_stroke->setObjectName(QStringLiteral("stroke"));
    m_previous->setObjectName(QStringLiteral("previous"));
    m_next->setObjectName(QStringLiteral("next"));
    m_axis->setObjectName(QStringLiteral("axis"));
    m_section->setObjectName(QStringLiteral("section"));
    m_note->setObjectName(QStringLiteral("note"));
    m_notice->setObjectName(QStringLiteral("notice"));
    m_values->setObjectName(QStringLiteral("values"));
}

void FeedsView::buildLabels() {
    setAccessibleName(tr("Feeds by stage"));
    m_plot->setAccessibleName(tr("Curves of the feeds by stage"));
    m_legend->setAccessibleName(tr("Legend of the curves"));
    m_notice->setAccessibleName(tr("State of the curves"));
    m_values->setAccessibleName(tr("Values under the pointer"));
    m_span->setAccessibleName(tr("Part of the cycle in sight"));
    m_span->setToolTip(tr("Part of the cycle in sight"));
    m_span->setPlaceholderText(tr("Free choice"));
    m_axis->setAccessibleName(tr("Horizontal axis"));
    m_axis->setToolTip(tr("Horizontal axis"));
    m_section->setAccessibleName(tr("Section that is also shown"));
    m_section->setToolTip(tr("Section that is also shown"));
    m_strokeLabel->setText(tr("No.", "number of the double stroke or revolution"));
    m_previous->setAccessibleName(tr("Previous"));
    m_previous->setToolTip(tr("Previous"));
    m_next->setAccessibleName(tr("Next"));
    m_next->setToolTip(tr("Next"));
    readOut();
    m_note->setAccessibleName(tr("How to read the feeds"));
    m_note->setToolTip(tr("How to read the feeds: the steps E1…E5 and the curves"));
}

void FeedsView::connectTools() {
    connect(m_cursors->toggle, &QAction::toggled, this, &FeedsView::showState);
    connect(m_span, &QComboBox::currentIndexChanged, this, &FeedsView::onSpanChosen);
    connect(m_stroke, &QSpinBox::valueChanged, this, &FeedsView::onStrokeChosen);
    connect(m_previous, &QToolButton::clicked, m_stroke, &QSpinBox::stepDown);
    connect(m_next, &QToolButton::clicked, m_stroke, &QSpinBox::stepUp);
    connect(m_section, &QComboBox::currentIndexChanged, this, &FeedsView::onSectionChosen);
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] {
        m_plot->setAxis(static_cast<CycleAxis>(m_axis->currentData().toInt()));
        m_overview->showRun();
        m_plot->replot();
    });
    connect(m_note, &QToolButton::clicked, this, &FeedsView::showNote);
    connect(m_legend, &LegendStrip::toggled, this, [this](int key) {
        m_plot->toggleCurve(key);
        m_plot->replot();
    });
    connect(m_legend, &LegendStrip::onlyAsked, this, [this](int key) {
        m_plot->showOnly(key);
        m_plot->replot();
    });
}

void FeedsView::connectPlot() {
    PlotNavigation& navigation = m_tools->navigation();
    connect(&navigation, &PlotNavigation::moved, this, &FeedsView::readSpan);
    connect(m_plot, &FeedsPlot::gridBuilt, &navigation, &PlotNavigation::forgetViews);
    connect(m_plot, &FeedsPlot::timesChanged, m_overview, &FeedsOverview::followPlot);
    connect(m_plot, &FeedsPlot::contentChanged, this, &FeedsView::showLegend);
    connect(m_plot, &FeedsPlot::pointed, this, &FeedsView::readOut);
    connect(m_plot, &FeedsPlot::timeClicked, this,
            [this](double time_s) { cycle().toTime(time_s); });
    connect(m_plot, &FeedsPlot::pointedBand, m_plot, &QWidget::setToolTip);
    connect(m_overview, &FeedsOverview::timesAsked, this, [this](double from_s, double to_s) {
        m_plot->showTimes(from_s, to_s);
        m_plot->replot(QCustomPlot::rpQueuedReplot);
        readSpan();
    });
    connect(m_overview, &FeedsOverview::dragged, this,
            [this, &navigation] { navigation.noteView(navigation.gestureOf(overviewGesture)); });
    connect(m_overview, &FeedsOverview::fitAsked, &navigation, &PlotNavigation::fit);
}

} // namespace sparkout
