// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/state_grid_bar.h"

#include "core/file/project_file.h"
#include "core/project/gauge.h"
#include "core/study/search_edits.h"
#include "ui/chart/plot_view.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/views/study/state_grid_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int wholePlay_ms = 30'000; ///< approximate playing time of a large grid …
constexpr int leastTick_ms = 40, mostTick_ms = 500;
constexpr int leastGridSlider = 90; ///< width at the usual font size

} // namespace

StateGridBar::StateGridBar(QWidget* parent)
    : QWidget(parent)
    , m_job(new Job(this))
    , m_levels(new QSpinBox(this))
    , m_stages(new QSpinBox(this))
    , m_bar(new RunBar(QStringLiteral("stateGrid"), this, StateGridText::progress))
    , m_first(flatButton(this, "stateGridFirst", u"play_first"))
    , m_previous(flatButton(this, "stateGridPrevious", u"play_previous"))
    , m_play(flatButton(this, "stateGridPlay", u"play"))
    , m_next(flatButton(this, "stateGridNext", u"play_next"))
    , m_end(flatButton(this, "stateGridLast", u"play_last"))
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_place(new QLabel(this)) {
    m_levels->setObjectName(QStringLiteral("stateGridLevels"));
    m_stages->setObjectName(QStringLiteral("stateGridStages"));
    m_levels->setRange(1, mostStockLevels);
    for (QSpinBox* box : {m_levels, m_stages}) {
        box->setKeyboardTracking(false);
    }
    m_bar->layOut({m_levels, m_stages}, {});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addWidget(m_bar);
    column->addWidget(buildSteps());
    const auto resized = [this](std::optional<int>& own, int value) {
        own = value;
        showSize();
        fill();
        emit changed();
    };
    connect(m_levels, &QSpinBox::valueChanged, this,
            [this, resized](int value) { resized(m_ownLevels, value); });
    connect(m_stages, &QSpinBox::valueChanged, this,
            [this, resized](int value) { resized(m_ownStages, value); });
    m_bar->follow(*m_job);
    connect(m_bar->run(), &QPushButton::clicked, this, [this] {
        m_stale || !m_outcome ? run() : prove();
        emit changed();
    });
    connectSteps();
}

QWidget* StateGridBar::buildSteps() {
    auto* steps = new QWidget(this);
    auto* row = new QHBoxLayout(steps);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    for (QToolButton* each : {m_first, m_previous, m_play, m_next, m_end}) {
        row->addWidget(each);
    }
    m_slider->setObjectName(QStringLiteral("stateGridSlider"));
    m_place->setObjectName(QStringLiteral("stateGridPlace"));
    m_place->setTextFormat(Qt::PlainText);
    setTextMinimumWidth(*m_slider, leastGridSlider);
    row->addWidget(m_slider, 1);
    row->addWidget(m_place);
    return steps;
}

void StateGridBar::connectSteps() {
    const auto go = [this](auto where) {
        return [this, where] {
            setPlaying(false);
            setMoment(where());
        };
    };
    connect(m_first, &QToolButton::clicked, this, go([] { return 0; }));
    connect(m_previous, &QToolButton::clicked, this, go([this] { return moment() - 1; }));
    connect(m_next, &QToolButton::clicked, this, go([this] { return moment() + 1; }));
    connect(m_end, &QToolButton::clicked, this, go([this] { return last(); }));
    connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(m_slider, &QSlider::valueChanged, this, [this](int number) {
        showMoment();
        emit moved(number);
    });
    connect(m_slider, &QSlider::sliderPressed, this, [this] { setPlaying(false); });
    connect(&m_timer, &QTimer::timeout, this, &StateGridBar::playOn);
}

// --- filling ------------------------------------------------------------------------------------

StateGridSize StateGridBar::size() const {
    StateGridSize size = usualStateGrid(*m_project);
    size.levels = m_ownLevels.value_or(size.levels);
    size.stages = m_ownStages.value_or(size.stages);
    return withinReach(size, *m_project);
}

bool StateGridBar::canRun() const {
    return m_project && stateGridFault(*m_project) == StateGridFault::none;
}

void StateGridBar::follow(const Project& project) {
    m_project = project;
    showSize();
    fill();
    emit changed();
}

void StateGridBar::forget() {
    m_job->drop();
    setPlaying(false);
    m_project.reset();
    m_ownLevels.reset();
    m_ownStages.reset();
    m_outcome.reset();
    m_stale = true;
    showMoment();
    emit changed();
}

void StateGridBar::noteStale() {
    m_stale =
        !m_outcome || m_outcome->grid.size != size() || !sameSearch(m_outcome->project, *m_project);
}

void StateGridBar::fill() {
    if (!m_project) {
        return;
    }
    if (!canRun()) {
        m_job->drop();
        m_outcome.reset();
        m_stale = true;
        showMoment();
        return;
    }
    noteStale();
    const bool runs = m_job->running() && m_running && m_running->grid.size == size()
                      && sameSearch(m_running->project, *m_project);
    if (m_stale && !runs) {
        run();
    }
}

void StateGridBar::run() {
    m_running = StateGridOutcome{*m_project, {}, std::nullopt};
    m_running->grid.size = size();
    m_bar->showProgress(0, size().levels);
    m_job->start(
        size().levels,
        [project = *m_project, of = size()](const Job::Means& means) {
            return filledGrid(project, of, means);
        },
        [this](const StateGridOutcomePtr& outcome) { take(outcome); });
}

void StateGridBar::prove() {
    m_bar->showProgress(0, gridProofParts);
    m_job->start(
        gridProofParts,
        [filled = m_outcome](const Job::Means& means) { return provenGrid(*filled, means); },
        [this](const StateGridOutcomePtr& outcome) { takeProof(outcome); });
}

void StateGridBar::take(const StateGridOutcomePtr& outcome) {
    if (outcome) {
        m_outcome = outcome;
        setPlaying(false);
        noteStale();
        {
            const QSignalBlocker blocker(m_slider);
            m_slider->setRange(0, last());
            m_slider->setPageStep(static_cast<int>(m_outcome->grid.feeds.size()));
            m_slider->setValue(last());
        }
        showMoment();
        prove();
    }
    emit changed();
}

void StateGridBar::takeProof(const StateGridOutcomePtr& outcome) {
    m_outcome = outcome;
    noteStale();
    emit changed();
}

// --- stepping -----------------------------------------------------------------------------------

int StateGridBar::last() const {
    return m_outcome ? momentCount(m_outcome->grid) : 0;
}

int StateGridBar::moment() const {
    return m_slider->value();
}

void StateGridBar::setMoment(int number) {
    m_slider->setValue(std::clamp(number, 0, last()));
}

void StateGridBar::setPlaying(bool playing) {
    if (playing && m_outcome) {
        if (moment() >= last()) {
            setMoment(0);
        }
        m_timer.start(std::clamp(wholePlay_ms / std::max(1, last()), leastTick_ms, mostTick_ms));
    } else {
        m_timer.stop();
    }
    showMoment();
}

void StateGridBar::playOn() {
    if (moment() >= last()) {
        setPlaying(false);
    } else {
        setMoment(moment() + 1);
    }
}

void StateGridBar::showMoment() {
    m_place->setText(m_outcome ? tr("%1 of %2").arg(moment()).arg(last()) : QString());
    m_play->setIcon(isPlaying() ? themeIcon(u"pause") : themeIcon(u"play"));
    const QString play = isPlaying() ? tr("Pause") : tr("Play the filling of the grid");
    m_play->setToolTip(play);
    m_play->setAccessibleName(play);
    m_first->setEnabled(m_outcome && moment() > 0);
    m_previous->setEnabled(m_outcome && moment() > 0);
    m_next->setEnabled(m_outcome && moment() < last());
    m_end->setEnabled(m_outcome && moment() < last());
    m_play->setEnabled(m_outcome != nullptr);
    m_slider->setEnabled(m_outcome != nullptr);
}

// --- showing ------------------------------------------------------------------------------------

void StateGridBar::showSize() {
    const StateGridSize now = size();
    const QSignalBlocker levels(m_levels), stages(m_stages);
    m_stages->setRange(1, std::max(1, m_project->gauge->commands));
    m_levels->setValue(now.levels);
    m_stages->setValue(now.stages);
}

QString StateGridBar::remark() const {
    if (!m_project) {
        return {};
    }
    const QString fault = StateGridText::fault(stateGridFault(*m_project));
    if (!fault.isEmpty()) {
        return fault;
    }
    if (m_outcome && !m_stale) {
        return StateGridText::answer(m_outcome->grid, m_outcome->exact);
    }
    if (busy()) {
        return m_outcome ? StudyView::staleText(true, {}) : QString();
    }
    return m_outcome ? StudyView::staleText(false, m_bar->run()->text())
                     : tr("Stopped before the grid was filled. Press “Run”.");
}

void StateGridBar::showState(bool accepted) {
    const bool can = accepted && canRun();
    m_levels->setEnabled(can);
    m_stages->setEnabled(can);
    const bool isDone = m_outcome && !m_stale && m_outcome->exact && m_outcome->exact->isProved();
    m_bar->showRunning(busy(), can && !isDone);
    m_bar->state()->setText(m_outcome ? StateGridText::size(m_outcome->grid) : QString());
    showMoment();
}

void StateGridBar::retranslate() {
    const auto name = [](QWidget& widget, const QString& text) {
        widget.setAccessibleName(text);
        widget.setToolTip(text);
    };
    m_levels->setPrefix(tr("levels "));
    m_stages->setPrefix(tr("stages ≤ "));
    name(*m_levels, tr("Number of levels of the stock"));
    name(*m_stages, tr("Stages that a cycle of the grid may have, within the gauge's commands"));
    m_bar->run()->setText(tr("Run"));
    name(*m_bar->run(),
         tr("Fill the grid and prove the answer; this also starts by itself after an edit"));
    m_bar->stop()->setText(tr("Stop"));
    name(*m_bar->stop(), tr("Stop the run; the results so far are kept"));
    m_bar->state()->setAccessibleName(tr("State of the filling"));
    m_bar->progress()->setAccessibleName(tr("Progress of the grid and its proof"));
    name(*m_first, tr("To the blank"));
    name(*m_previous, tr("One state back"));
    name(*m_next, tr("The next state"));
    name(*m_end, tr("To the end of the backtracking"));
    name(*m_slider, tr("State shown"));
    m_place->setAccessibleName(tr("Number of the state shown"));
    showMoment();
}

} // namespace sparkout
