// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds_view.h"

#include "ui/views/feeds_plot.h"
#include "ui/views/legend_strip.h"
#include "ui/views/names.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>

namespace sparkout {

void FeedsView::setOutcome(OutcomePtr outcome) {
    m_latest = std::move(outcome);
    m_stale = true;
    scheduleUpdate();
}

void FeedsView::scheduleUpdate() {
    if (m_queued || !isVisible()) {
        return; // a hidden view draws when it is shown
    }
    m_queued = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_queued = false;
            redraw();
        },
        Qt::QueuedConnection);
}

void FeedsView::redraw() {
    if (m_stale) {
        m_stale = false;
        showOutcome();
    }
}

void FeedsView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    redraw();
}

FeedSeries FeedsView::currentSeries() const {
    const SimulationResult& result = m_good->result;
    std::vector<int> sections;
    if (result.project.operation == Operation::plunge) {
        sections = shownSections(static_cast<int>(result.sections.size()), gaugeSection(result),
                                 m_wantedSection);
    }
    return makeFeedSeries(result, m_good->trajectory, sections);
}

void FeedsView::showOutcome() {
    QElapsedTimer clock;
    clock.start();
    const bool ran = m_latest && m_latest->ran() && !m_latest->trajectory.passes.empty();
    if (ran) {
        const bool same =
            m_good && m_good->result.project.operation == m_latest->result.project.operation;
        m_good = m_latest;
        if (!same) {
            m_what = Span::whole;
            m_wantedSection.reset();
            fillAxes();
        }
        m_plot->setRun(m_good, currentSeries());
        fillSections();
        fillSpans();
        applySpan();
    }
    m_plot->setDimmed(m_good && !ran);
    showState();
    showLegend();
    m_plot->replot();
    m_lastUpdate_ms = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    emit updated();
}

void FeedsView::showState() {
    const bool refused = m_latest && !m_latest->ran();
    const bool unrecorded = m_latest && !refused && m_latest->trajectory.passes.empty();
    QString text;
    if (unrecorded) {
        text = tr("The cycle is too long to draw: %1 visits of a radius, at most %2 are recorded. "
                  "Fewer radii or sections help; the verdict is of the whole cycle.")
                   .arg(QLocale().toString(m_latest->result.visits),
                        QLocale().toString(maxRecordedVisits));
    } else if (refused) {
        text =
            (m_good ? tr("The inputs are refused; the curves are those of the last accepted ones.")
                    : tr("The inputs are refused:"))
            + QLatin1Char('\n') + Names::refusal(m_latest->issues, 2);
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
    m_plot->setVisible(m_good != nullptr && !unrecorded);
    m_legend->setVisible(m_good != nullptr);
    m_values->setVisible(m_good != nullptr);
    for (QWidget* tool : std::initializer_list<QWidget*>{m_span, m_stroke, m_axis, m_fit}) {
        tool->setEnabled(m_good != nullptr);
    }
    m_section->setVisible(m_section->count() > 0);
    showSpan();
}

void FeedsView::showLegend() {
    m_legend->setEntries(m_plot->legendEntries());
}

// --- what is in sight ---------------------------------------------------------------------------

void FeedsView::fillSpans() {
    const QSignalBlocker blocker(m_span);
    const bool traverse = !m_good || m_good->result.project.operation == Operation::traverse;
    m_span->clear();
    m_span->addItem(tr("Whole cycle"), 0);
    if (m_good) {
        for (const StageSpan& stage : m_plot->series().stages) {
            m_span->addItem(tr("Stage %1").arg(stage.stage), stage.stage);
        }
    }
    m_span->addItem(traverse ? tr("One double stroke") : tr("One revolution"), -1);
    const QString number =
        traverse ? tr("Number of the double stroke") : tr("Number of the revolution");
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
    m_previous->setEnabled(m_good && m_stroke->value() > m_stroke->minimum());
    m_next->setEnabled(m_good && m_stroke->value() < m_stroke->maximum());
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

void FeedsView::onSpanChosen(int index) {
    const int chosen = m_span->itemData(index).toInt();
    m_what = chosen == 0 ? Span::whole : chosen > 0 ? Span::stage : Span::stroke;
    m_stage = chosen > 0 ? chosen : m_stage;
    applySpan();
    m_plot->replot();
}

void FeedsView::onStrokeChosen(int) {
    m_what = Span::stroke;
    applySpan();
    m_plot->replot();
}

void FeedsView::onSectionChosen(int index) {
    const int section = m_section->itemData(index).toInt();
    m_wantedSection = section < 0 ? std::nullopt : std::optional<int>(section);
    if (m_good) {
        m_plot->setRun(m_good, currentSeries());
        m_plot->replot();
    }
}

// --- texts --------------------------------------------------------------------------------------

void FeedsView::fillAxes() {
    const QSignalBlocker blocker(m_axis);
    const bool traverse = !m_good || m_good->result.project.operation == Operation::traverse;
    const int before = m_axis->currentIndex() < 0 ? 0 : m_axis->currentData().toInt();
    m_axis->clear();
    m_axis->addItem(tr("Time, min"), static_cast<int>(CycleAxis::minutes));
    m_axis->addItem(tr("Time, s"), static_cast<int>(CycleAxis::seconds));
    if (traverse) {
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
    if (m_good && m_good->result.project.operation == Operation::plunge && count > 4) {
        m_section->addItem(tr("Evenly chosen"), -1);
        for (int i = 0; i < count; ++i) {
            m_section->addItem(Names::zone(Zone::section, i), i);
        }
        m_section->setCurrentIndex(std::clamp(m_wantedSection.value_or(-1) + 1, 0, count));
    }
    m_section->setVisible(m_section->count() > 0);
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
    showState();
    showLegend();
    m_plot->replot();
}

void FeedsView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (!m_plot) {
        return;
    }
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        m_plot->restyle();
        showLegend();
        m_plot->replot();
    }
}

} // namespace sparkout
