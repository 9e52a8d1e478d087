// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/feeds_view.h"

#include "core/process/system_compliance.h"
#include "ui/kit/font_size.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/names.h"
#include "ui/views/feeds/feeds_note.h"
#include "ui/views/feeds/feeds_overview.h"
#include "ui/views/feeds/feeds_plot.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {
constexpr int strokeGesture = 2001; ///< for PlotNavigation::gestureOf()
constexpr int wideView = 900;
} // namespace

/// All zones, or some of the sections.
std::vector<int> FeedsView::shownColumns() const {
    const Project& project = m_good->result.project;
    const auto count = static_cast<int>(m_good->feeds.columns.size());
    return project.operation->hasZones
               ? shownSections(count, 0)
               : shownSections(count, gaugeSection(project), m_wantedSection);
}

void FeedsView::showOutcome() {
    QElapsedTimer clock;
    clock.start();
    const bool ran = latest() && latest()->ran() && !latest()->trajectory.passes.empty();
    if (ran) {
        const bool same =
            m_good && m_good->result.project.operation == latest()->result.project.operation;
        m_good = latest();
        if (!same) {
            m_what = Span::whole;
            m_wantedSection.reset();
            fillAxes();
        }
        m_plot->setRun(m_good, shownColumns());
        fillSections();
        fillSpans();
        applySpan();
        showMoment();
        m_overview->showRun();
        m_tools->navigation().amendView();
    }
    m_plot->setDimmed(m_good && !ran);
    showState();
    showLegend();
    m_plot->replot();
    m_lastUpdate_ms = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    emit updated();
}

void FeedsView::showState() {
    const bool refused = latest() && !latest()->ran();
    const bool unrecorded = latest() && !refused && latest()->trajectory.passes.empty();
    QString text;
    if (unrecorded) {
        text = tr("The cycle is too long to draw: %1 visits of a radius, at most %2 are recorded. "
                  "Fewer radii or sections help; the verdict is of the whole cycle.")
                   .arg(QLocale().toString(latest()->result.visits),
                        QLocale().toString(maxRecordedVisits));
    } else if (refused) {
        text =
            (m_good ? tr("The inputs are refused; the curves are those of the last accepted ones.")
                    : tr("The inputs are refused:"))
            + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    } else if (!m_good) {
        text = tr("No result yet.");
    } else if (m_good->result.status != RunStatus::completed) {
        text = Names::status(m_good->result.status);
    }
    if (!refused && m_good && m_plot->series().dropped > 0) {
        text += QLatin1Char(' ')
                + tr("%1 values that are no numbers are not drawn.").arg(m_plot->series().dropped);
    }
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    const bool drawn = m_good != nullptr && !unrecorded;
    for (QWidget* part : std::initializer_list<QWidget*>{m_plot, m_overview, m_legend}) {
        part->setVisible(drawn);
    }
    m_values->setVisible(drawn && !m_cursors->toggle->isChecked()); // their table tells them
    for (QWidget* tool : std::initializer_list<QWidget*>{m_span, m_stroke, m_axis, m_section}) {
        tool->setEnabled(drawn);
    }
    m_tools->setEnabled(drawn);
    m_section->setVisible(m_section->count() > 0);
    showSpan();
}

void FeedsView::showLegend() {
    m_legend->setEntries(m_plot->legendEntries());
}

void FeedsView::showNote() {
    if (!m_noteDialog) {
        m_noteDialog = new FeedsNote(this);
    }
    m_noteDialog->setOperation(m_good ? m_good->result.project.operation : Operation());
    m_noteDialog->show();
    m_noteDialog->raise();
    m_noteDialog->activateWindow();
}

// --- what is in sight ---------------------------------------------------------------------------

void FeedsView::fillSpans() {
    const QSignalBlocker blocker(m_span);
    const bool strokes = !m_good || m_good->result.project.operation->countsStrokes;
    m_span->clear();
    m_span->addItem(tr("Whole cycle"), 0);
    if (m_good) {
        for (const StageSpan& stage : m_plot->series().stages) {
            m_span->addItem(tr("Stage %1").arg(stage.stage), stage.stage);
        }
    }
    m_span->addItem(strokes ? tr("One double stroke") : tr("One revolution"), -1);
    const QString number =
        strokes ? tr("Number of the double stroke") : tr("Number of the revolution");
    m_stroke->setAccessibleName(number);
    m_stroke->setToolTip(number);
    const QSignalBlocker strokeBlocker(m_stroke);
    m_stroke->setRange(1, std::max(m_plot->series().strokeCount(), 1));
    showSpan();
}

/// The tools say what is in sight.
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

/// None while all of the cycle is done.
void FeedsView::showMoment() {
    const CycleCursor* const at = cycleIn(m_good);
    m_plot->setMoment(at && !at->atEnd() ? std::optional(at->time_s()) : std::nullopt);
    m_overview->update();
}

void FeedsView::followCycle() {
    showMoment();
    if (const CycleCursor* const at = cycleIn(m_good)) {
        bringIntoSight(at->time_s());
    }
}

/// What is in sight moves on as a page is turned: to the stage or double stroke, or by its width.
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
    m_tools->navigation().amendView();
}

void FeedsView::onSpanChosen(int index) {
    const int chosen = m_span->itemData(index).toInt();
    m_what = chosen == 0 ? Span::whole : chosen > 0 ? Span::stage : Span::stroke;
    m_stage = chosen > 0 ? chosen : m_stage;
    applySpan();
    m_plot->replot();
    m_tools->navigation().noteView();
}

void FeedsView::onStrokeChosen(int) {
    m_what = Span::stroke;
    applySpan();
    m_plot->replot();
    // Stepping from stroke to stroke is one gesture: Back leads out of it.
    m_tools->navigation().noteView(m_tools->navigation().gestureOf(strokeGesture));
}

void FeedsView::showPlace(const Place& place) {
    redraw();
    if (!m_good || !m_stroke->isEnabled()) {
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

/// Shows the whole cycle; the values' axes are scaled anew.
void FeedsView::fitAll() {
    m_what = Span::whole;
    m_plot->fitValues();
    applySpan();
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
    if (m_good) {
        m_plot->setRun(m_good, shownColumns());
        m_overview->showRun();
        m_plot->replot();
    }
}

// --- texts --------------------------------------------------------------------------------------

void FeedsView::fillAxes() {
    const QSignalBlocker blocker(m_axis);
    const bool strokes = !m_good || m_good->result.project.operation->countsStrokes;
    const int before = m_axis->currentIndex() < 0 ? 0 : m_axis->currentData().toInt();
    m_axis->clear();
    m_axis->addItem(tr("Time, min"), static_cast<int>(CycleAxis::minutes));
    m_axis->addItem(tr("Time, s"), static_cast<int>(CycleAxis::seconds));
    if (strokes) {
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
    const int count = static_cast<int>(m_good ? m_good->result.sections.size() : 0);
    if (m_good && !m_good->result.project.operation->hasZones && count > 4) {
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

void FeedsView::retranslate() {
    buildLabels();
    fillAxes();
    fillSections();
    fillSpans();
    m_plot->retranslate();
    m_overview->showRun();
    m_overview->retranslate();
    m_legend->retranslate();
    m_tools->retranslate();
    m_strip->retranslate();
    if (m_noteDialog) {
        m_noteDialog->retranslate();
    }
    showState();
    showLegend();
    m_plot->replot();
}

QString FeedsView::hint() const {
    return tr("Point at a curve to read its values.");
}

/// In a narrow view the values need four lines.
void FeedsView::resizeEvent(QResizeEvent* event) {
    View::resizeEvent(event);
    const int lines = width() < wideView ? 4 : 2;
    setTextLines(*m_values, lines, 0);
}

} // namespace sparkout
