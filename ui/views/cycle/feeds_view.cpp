// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/feeds_view.h"

#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/measured.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"
#include "ui/views/cycle/feeds_note.h"
#include "ui/views/cycle/feeds_overview.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/traces_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sparkout {

namespace {
constexpr int strokeGesture = 2001, overviewGesture = 2002,
              traceGesture = 2003;              ///< for PlotNavigation::gestureOf()
constexpr int wideView = 900, narrowView = 430; ///< at the usual font size
} // namespace

FeedsView::FeedsView(QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("feeds"), parent, settings)
    , m_plot(new FeedsPlot(this))
    , m_traces(new TracesPlot(this))
    , m_comparer(new TraceComparer(this))
    , m_overview(new FeedsOverview(*m_plot, this)) {
    PlotSubject subject;
    subject.navigation.fit = [this] { fitAll(); };
    addPlot(*m_plot, std::move(subject));
    addCursors(*m_plot);
    buildTraces();
    QWidget* bar = buildTools();
    auto* rows = new QWidget(this);
    auto* both = new QVBoxLayout(rows);
    both->setContentsMargins(0, 0, 0, 0);
    both->setSpacing(0);
    both->addWidget(m_plot, 3);
    both->addWidget(m_traces, 1);
    QScrollArea* area = scrolled(*rows);
    area->setObjectName(QStringLiteral("feedsArea"));
    hideUntilDrawn({area, m_overview});
    disableUntilDrawn({m_span, m_stroke, m_axis, m_section});
    addColumn({bar, notice(), legend(), area, m_overview, strip(), values()}, area)->addStretch();
    connectTools();
    connectPlot();
    built();
}

QWidget* FeedsView::buildTools() {
    auto* bar = new QWidget(this);
    auto* row = rowIn<ToolRow>(bar);
    row->setSpacing(metrics::row); // it has many widgets
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
    m_stroke->setKeyboardTracking(false);
    addBoxes(*row, {m_span});
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_strokeLabel, m_previous, m_stroke, m_next}) {
        row->addWidget(w);
    }
    row->addStretch();
    addBoxes(*row, {m_section, m_axis});
    addButtons(*row, {cursors()->toggle, tools()->back, tools()->forward, tools()->fit});
    m_traceExport = m_traces->tools()->exportButton(bar);
    m_traceExport->setVisible(false);
    row->addWidget(m_traceExport);
    row->addWidget(m_note);
    nameObjects({{m_span, "span"},
                 {m_stroke, "stroke"},
                 {m_previous, "previous"},
                 {m_next, "next"},
                 {m_axis, "axis"},
                 {m_section, "section"},
                 {m_note, "note"}});
    return bar;
}

void FeedsView::connectTools() {
    connect(cursors()->toggle, &QAction::toggled, this, &FeedsView::showState);
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
}

void FeedsView::connectPlot() {
    PlotNavigation& navigation = tools()->navigation();
    connect(&navigation, &PlotNavigation::moved, this, &FeedsView::readSpan);
    connect(m_plot, &FeedsPlot::gridBuilt, &navigation, &PlotNavigation::forgetViews);
    connect(m_plot, &FeedsPlot::timesChanged, m_overview, &FeedsOverview::followPlot);
    connect(m_plot, &FeedsPlot::timeClicked, this,
            [this](double time_s) { cycle().toTime(time_s); });
    connect(m_overview, &FeedsOverview::timesAsked, this, [this](double from_s, double to_s) {
        m_plot->showTimes(from_s, to_s);
        m_plot->replot(QCustomPlot::rpQueuedReplot);
        readSpan();
    });
    connect(m_overview, &FeedsOverview::dragged, this,
            [&navigation] { navigation.noteView(navigation.gestureOf(overviewGesture)); });
    connect(m_overview, &FeedsOverview::fitAsked, &navigation, &PlotNavigation::fit);
}

// --- the traces ---------------------------------------------------------------------------------

void FeedsView::buildTraces() {
    PlotSubject subject;
    subject.name = [] { return tr("measured traces"); };
    subject.icon = u"export_length";
    addPlot(*m_traces, std::move(subject));
    m_traces->hide();
    linkCursors();
    m_plot->readBeside([this] { return m_traces->readCurves(); });
    connect(m_comparer, &TraceComparer::compared, this,
            [this](const TraceComparisonsPtr& traces, const OutcomePtr& of) {
                m_traces->setTraces(traces, of->result.project);
                showTraceTimes();
                showState();
                showLegend();
                replotAll();
                emit updated();
            });
    connect(m_plot, &FeedsPlot::timesChanged, this, &FeedsView::showTraceTimes);
    connect(m_traces, &TracesPlot::timesWanted, this, [this](double from_s, double to_s) {
        m_plot->showTimes(from_s, to_s);
        m_plot->replot(QCustomPlot::rpQueuedReplot);
        readSpan();
        PlotNavigation& navigation = tools()->navigation();
        navigation.noteView(navigation.gestureOf(traceGesture));
    });
    connect(m_traces, &TracesPlot::fitWanted, this, [this] { tools()->navigation().fit(); });
    connect(m_traces, &TracesPlot::timeClicked, this,
            [this](double time_s) { cycle().toTime(time_s); });
}

/// Both plots show the two cursors of the strip.
void FeedsView::linkCursors() {
    PlotCursors& own = m_traces->addCursors();
    PlotCursors& shared = *m_plot->cursors();
    connect(shared.toggle, &QAction::toggled, own.toggle, &QAction::setChecked);
    connect(own.toggle, &QAction::toggled, shared.toggle, &QAction::setChecked);
    const auto follow = [](const PlotCursors& from, PlotCursors& to) {
        for (std::size_t i = 0; i < PlotCursors::count; ++i) {
            if (from.at(i) && from.at(i) != to.at(i)) {
                to.moveTo(i, *from.at(i));
            }
        }
    };
    connect(&shared, &PlotCursors::moved, this, [=, &own, &shared] { follow(shared, own); });
    connect(&own, &PlotCursors::moved, this, [=, &own, &shared] { follow(own, shared); });
}

void FeedsView::compareTraces() {
    const auto& measured = good()->result.project.measured;
    if (measured && !measured->traces.empty()) {
        m_comparer->compare(good());
    } else {
        m_comparer->drop();
        if (!m_traces->isEmpty()) {
            m_traces->setTraces(nullptr, good()->result.project);
        }
    }
}

bool FeedsView::busy() const {
    return m_comparer->running();
}

/// Shows the visible times of the feeds in the traces below them.
void FeedsView::showTraceTimes() {
    if (!m_traces->isEmpty()) {
        m_traces->showTimes(m_plot->times(), m_plot->timeLabel());
        m_traces->replot(QCustomPlot::rpQueuedReplot);
    }
}

void FeedsView::showLegend() {
    LegendEntries entries = m_plot->legendEntries();
    std::ranges::move(m_traces->legendEntries(), std::back_inserter(entries));
    legend()->setEntries(std::move(entries));
}

void FeedsView::toggleCurve(int key) {
    ViewPlot* const plot =
        key >= TracesPlot::measuredKey ? static_cast<ViewPlot*>(m_traces) : m_plot;
    plot->toggleCurve(key);
}

void FeedsView::showOnly(int key) {
    ViewPlot* const plot =
        key >= TracesPlot::measuredKey ? static_cast<ViewPlot*>(m_traces) : m_plot;
    plot->showOnly(key);
}

// --- the run ------------------------------------------------------------------------------------

bool FeedsView::draws(const Outcome& outcome) const {
    return !outcome.trajectory.passes.empty();
}

bool FeedsView::isUnrecorded() const {
    return latest() && latest()->ran() && !draws(*latest());
}

bool FeedsView::drawn() const {
    return good() && !isUnrecorded();
}

bool FeedsView::countsStrokes() const {
    return !good() || good()->result.project.operation->travels;
}

/// All zones, or some of the sections.
std::vector<int> FeedsView::shownColumns() const {
    const Project& project = good()->result.project;
    const auto count = static_cast<int>(good()->feeds.columns.size());
    return project.operation->travels
               ? shownSections(count, 0)
               : shownSections(count, gaugeSection(project), m_wantedSection);
}

void FeedsView::takeOutcome(const OutcomePtr& before) {
    if (!before || before->result.project.operation != good()->result.project.operation) {
        m_what = Span::whole;
        m_wantedSection.reset();
        fillAxes();
    }
    m_plot->setRun(good(), shownColumns());
    compareTraces();
    fillSections();
    fillSpans();
    applySpan();
    showMoment();
    m_overview->showRun();
}

void FeedsView::dropOutcome() {
    m_comparer->drop();
    m_traces->setTraces(nullptr, Project());
}

QString FeedsView::noticeText() const {
    QString text = PlotView::noticeText();
    if (isUnrecorded()) {
        text = tr("The cycle is too long to draw: %1 visits of a radius, at most %2 are recorded. "
                  "Fewer radii or sections help; the verdict applies to the whole cycle.")
                   .arg(QLocale().toString(latest()->result.visits),
                        QLocale().toString(maxRecordedVisits));
    }
    if (!refused() && m_plot->series().dropped > 0) {
        text += QLatin1Char(' ')
                + tr("%1 values are not numbers and are not drawn.").arg(m_plot->series().dropped);
    }
    return text;
}

QString FeedsView::remark() const {
    const RunStatus status = good()->result.status;
    return status == RunStatus::completed ? QString() : Names::status(status);
}

void FeedsView::showState() {
    PlotView::showState();
    values()->setVisible(drawn() && !cursors()->toggle->isChecked()); // their table has the values
    m_section->setVisible(m_section->count() > 0);
    m_traces->setVisible(drawn() && !m_traces->isEmpty());
    m_traceExport->setVisible(!m_traces->isEmpty());
    m_traces->tools()->setEnabled(drawn() && !m_traces->isEmpty());
    showSpan();
}

void FeedsView::showNote() {
    if (!m_noteDialog) {
        m_noteDialog = new FeedsNote(this);
    }
    const Project shown = good() ? good()->result.project : Project();
    m_noteDialog->setOperation(shown.operation, shown.machine->reversal_infeed);
    m_noteDialog->show();
    m_noteDialog->raise();
    m_noteDialog->activateWindow();
}

// --- visible range ------------------------------------------------------------------------------

void FeedsView::fillSpans() {
    const QSignalBlocker blocker(m_span);
    m_span->clear();
    m_span->addItem(tr("Whole cycle"), 0);
    if (good()) {
        for (const StageSpan& stage : m_plot->series().stages) {
            m_span->addItem(tr("Stage %1").arg(stage.stage), stage.stage);
        }
    }
    m_span->addItem(countsStrokes() ? tr("One double stroke") : tr("One revolution"), -1);
    const QString number =
        countsStrokes() ? tr("Number of the double stroke") : tr("Number of the revolution");
    tell(*m_stroke, number);
    const QSignalBlocker strokeBlocker(m_stroke);
    m_stroke->setRange(1, std::max(m_plot->series().strokeCount(), 1));
    showSpan();
}

/// Shows the visible range in the tools.
void FeedsView::showSpan() {
    const QSignalBlocker blocker(m_span);
    const int wanted = m_what == Span::whole ? 0 : m_what == Span::stage ? m_stage : -1;
    const int index = m_what == Span::free ? -1 : m_span->findData(wanted);
    m_span->setCurrentIndex(index);
    const bool drawn = m_plot->columnCount() > 0 && m_stroke->isEnabled();
    m_previous->setEnabled(drawn && m_stroke->value() > m_stroke->minimum());
    m_next->setEnabled(drawn && m_stroke->value() < m_stroke->maximum());
}

void FeedsView::applySpan() {
    const FeedSeries& series = m_plot->series();
    const auto stage = std::ranges::find(series.stages, m_stage, &StageSpan::stage);
    if (m_what == Span::stage && stage == series.stages.end()) {
        m_what = Span::whole;
    }
    if (m_what == Span::whole) {
        m_plot->showAll();
    } else if (m_what == Span::stage) {
        m_plot->showTimes(stage->start_s, stage->end_s);
    } else if (m_what == Span::stroke && series.strokeCount() > 0) {
        const int number = std::clamp(m_stroke->value(), 1, series.strokeCount());
        m_plot->showTimes(series.strokeStart_s[static_cast<std::size_t>(number - 1)],
                          series.strokeEnd_s(number));
    }
    showSpan();
}

// --- the moment ---------------------------------------------------------------------------------

/// Shows no moment at the end of the cycle.
void FeedsView::showMoment() {
    const CycleCursor* const at = cycleIn(good());
    const auto moment_s = at && !at->atEnd() ? std::optional(at->time_s()) : std::nullopt;
    m_plot->setMoment(moment_s);
    m_traces->setMoment(moment_s);
    m_overview->update();
}

void FeedsView::followCycle() {
    showMoment();
    if (const CycleCursor* const at = cycleIn(good())) {
        bringIntoSight(at->time_s());
    }
}

/// Moves the visible range like a page: to the stage or double stroke, or by its width.
void FeedsView::bringIntoSight(double time_s) {
    const double from_s = m_plot->visibleFrom_s(), to_s = m_plot->visibleTo_s();
    const double near_s = 1e-9 * m_plot->series().end_s;
    if (time_s >= from_s - near_s && time_s <= to_s + near_s) {
        return;
    }
    if (m_what == Span::stage) {
        const Pass* const pass = cycle().pass();
        m_stage = pass ? pass->place.stage : m_plot->series().stages.front().stage;
        applySpan();
    } else if (m_what == Span::stroke) {
        const QSignalBlocker blocker(m_stroke);
        m_stroke->setValue(std::max(cycle().stroke(), 1));
        applySpan();
    } else {
        const double page_s = to_s - from_s, end_s = m_plot->series().end_s;
        const double start_s = time_s > to_s ? time_s - near_s : time_s - page_s;
        const double first_s = std::clamp(start_s, 0.0, std::max(end_s - page_s, 0.0));
        m_plot->showTimes(first_s, first_s + page_s);
        readSpan();
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    tools()->navigation().amendView();
}

void FeedsView::onSpanChosen(int index) {
    const int chosen = m_span->itemData(index).toInt();
    m_what = chosen == 0 ? Span::whole : chosen > 0 ? Span::stage : Span::stroke;
    m_stage = chosen > 0 ? chosen : m_stage;
    applySpan();
    m_plot->replot();
    tools()->navigation().noteView();
}

void FeedsView::onStrokeChosen(int) {
    m_what = Span::stroke;
    applySpan();
    m_plot->replot();
    // Stepping from stroke to stroke is one gesture, which Back reverts as a whole.
    tools()->navigation().noteView(tools()->navigation().gestureOf(strokeGesture));
}

void FeedsView::showPlace(const Place& place) {
    redraw();
    if (!good() || !m_stroke->isEnabled()) {
        return;
    }
    const int section = place.zone == Zone::section ? m_section->findData(place.section) : -1;
    if (section >= 0) {
        const QSignalBlocker blocker(m_section);
        m_section->setCurrentIndex(section);
        onSectionChosen(section);
    }
    const QSignalBlocker blocker(m_stroke);
    m_stroke->setValue(place.cycleCount);
    onStrokeChosen(place.cycleCount);
}

void FeedsView::showStage(int stage) {
    redraw();
    const int index = m_span->findData(stage);
    if (good() && m_span->isEnabled() && stage > 0 && index >= 0) {
        const QSignalBlocker blocker(m_span);
        m_span->setCurrentIndex(index);
        onSpanChosen(index);
    }
}

/// Shows the whole cycle; the values' axes are scaled anew.
void FeedsView::fitAll() {
    m_what = Span::whole;
    m_plot->fit();
    showSpan();
}

void FeedsView::readSpan() {
    const FeedSeries& series = m_plot->series();
    const double from_s = m_plot->visibleFrom_s(), to_s = m_plot->visibleTo_s();
    const auto shows = [&](double start_s, double end_s) {
        const double near = 1e-9 * series.end_s;
        return std::abs(from_s - start_s) <= near && std::abs(to_s - end_s) <= near;
    };
    m_what = shows(0, series.end_s) ? Span::whole : Span::free;
    for (const StageSpan& stage : series.stages) {
        if (m_what == Span::free && shows(stage.start_s, stage.end_s)) {
            m_what = Span::stage;
            m_stage = stage.stage;
        }
    }
    const int number = series.strokeAt((from_s + to_s) / 2);
    if (m_what == Span::free && series.strokeCount() > 0
        && shows(series.strokeStart_s[static_cast<std::size_t>(number - 1)],
                 series.strokeEnd_s(number))) {
        m_what = Span::stroke;
        const QSignalBlocker blocker(m_stroke);
        m_stroke->setValue(number);
    }
    showSpan();
}

void FeedsView::onSectionChosen(int index) {
    const int section = m_section->itemData(index).toInt();
    m_wantedSection = section < 0 ? std::nullopt : std::optional<int>(section);
    if (good()) {
        m_plot->setRun(good(), shownColumns());
        m_overview->showRun();
        m_plot->replot();
    }
}

// --- texts --------------------------------------------------------------------------------------

void FeedsView::fillAxes() {
    const QSignalBlocker blocker(m_axis);
    const int before = m_axis->currentIndex() < 0 ? 0 : m_axis->currentData().toInt();
    m_axis->clear();
    m_axis->addItem(tr("Time"), static_cast<int>(CycleAxis::time));
    if (countsStrokes()) {
        m_axis->addItem(tr("Double strokes"), static_cast<int>(CycleAxis::strokes));
    }
    m_axis->addItem(tr("Revolutions"), static_cast<int>(CycleAxis::revolutions));
    const int index = std::max(m_axis->findData(before), 0);
    m_axis->setCurrentIndex(index);
    m_plot->setAxis(static_cast<CycleAxis>(m_axis->itemData(index).toInt()));
}

void FeedsView::fillSections() {
    const QSignalBlocker blocker(m_section);
    m_section->clear();
    const int count = static_cast<int>(good() ? good()->result.sections.size() : 0);
    if (good() && !good()->result.project.operation->travels && count > 4) {
        m_section->addItem(tr("Evenly chosen"), -1);
        for (int i = 0; i < count; ++i) {
            m_section->addItem(Names::zone(Zone::section, i), i);
        }
        m_section->setCurrentIndex(std::clamp(m_wantedSection.value_or(-1) + 1, 0, count));
    }
    m_section->setVisible(m_section->count() > 0);
}

QString FeedsView::brief() const {
    return tr("Feeds", "the view's tab");
}

QString FeedsView::title() const {
    return tr("Feeds by stage");
}

void FeedsView::nameParts() {
    nameAround(tr("Legend of the curves"), tr("State of the curves"),
               tr("Values under the pointer"));
    m_plot->setAccessibleName(tr("Curves of the feeds by stage"));
    m_traces->setAccessibleName(tr("Measured traces beside the simulated curves"));
    m_traces->cursors()->retranslate();
    m_span->setPlaceholderText(tr("Free choice"));
    m_strokeLabel->setText(tr("No.", "number of the double stroke or revolution"));
    tell(*m_span, tr("Visible part of the cycle"));
    tell(*m_axis, tr("Horizontal axis"));
    tell(*m_section, tr("Section that is also shown"));
    tell(*m_previous, tr("Previous"));
    tell(*m_next, tr("Next"));
    m_note->setAccessibleName(tr("How to read the feeds"));
    m_note->setToolTip(tr("How to read the feeds: the steps E1…E5 and the curves"));
    fillAxes();
    fillSections();
    fillSpans();
    m_overview->showRun();
    m_overview->retranslate();
    if (m_noteDialog) {
        m_noteDialog->retranslate();
    }
}

QString FeedsView::hint() const {
    return tr("Point at a curve to read its values.");
}

/// The narrower the view relative to its font, the more lines the values need.
void FeedsView::makeRoomForValues() {
    const int wide = width() * usualFontSize / appliedFontSize();
    setTextLines(*values(), wide >= wideView ? 2 : wide >= narrowView ? 4 : 5, 0);
}

void FeedsView::resizeEvent(QResizeEvent* event) {
    PlotView::resizeEvent(event);
    makeRoomForValues();
}

void FeedsView::changeEvent(QEvent* event) {
    PlotView::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        makeRoomForValues();
    }
}

} // namespace sparkout
