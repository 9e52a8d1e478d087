// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/playback_bar.h"

#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>

namespace sparkout {

namespace {
constexpr std::array speeds{1, 2, 5, 10, 25, 50}; ///< steps a second
constexpr int usualSpeed = 2;                     ///< index
constexpr int oneSecond_ms = 1000;
constexpr int slideSteps = 1'000'000; ///< a slider counts in int
constexpr int leastSlider = 90;       ///< width at the usual font size
constexpr int wheelSteps = 200;       ///< mouse wheel steps over the whole cycle
} // namespace

PlaybackBar::PlaybackBar(CycleCursor& cursor, QWidget* parent)
    : QWidget(parent)
    , m_cursor(cursor)
    , m_first(flatButton(this, "playFirst", u"play_first"))
    , m_previous(flatButton(this, "playPrevious", u"play_previous"))
    , m_play(flatButton(this, "play", u"play"))
    , m_next(flatButton(this, "playNext", u"play_next"))
    , m_last(flatButton(this, "playLast", u"play_last"))
    , m_unit(new QComboBox(this))
    , m_speed(new QComboBox(this))
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_place(new QLabel(this)) {
    setObjectName(QStringLiteral("playback"));
    setHelpTopic(*this, QStringLiteral("playback"));
    build();
    connectParts();
    retranslate();
}

void PlaybackBar::build() {
    m_unit->setObjectName(QStringLiteral("playUnit"));
    m_speed->setObjectName(QStringLiteral("playSpeed"));
    m_slider->setObjectName(QStringLiteral("playSlider"));
    m_place->setObjectName(QStringLiteral("playPlace"));
    m_place->setTextFormat(Qt::PlainText);
    m_place->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // any width
    m_place->installEventFilter(this);
    m_unit->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    fillUnits(CursorUnit::stroke);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        m_speed->addItem(QString());
    }
    m_speed->setCurrentIndex(usualSpeed);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(metrics::gap, 0, metrics::gap, metrics::hair);
    rows->setSpacing(0);
    m_row = new ToolRow;
    m_row->setSpacing(metrics::tight);
    for (QToolButton* button : {m_first, m_previous, m_play, m_next, m_last}) {
        m_row->addWidget(button);
    }
    m_row->addWidget(m_unit);
    m_row->addWidget(m_speed);
    setTextMinimumWidth(*m_slider, leastSlider);
    m_row->addWidget(m_slider, 1);
    rows->addLayout(m_row);
}

void PlaybackBar::addTool(QAction* action) {
    auto* const tool = flatButton(this, "playTool", u"formula");
    tool->setDefaultAction(action);
    m_row->addWidget(tool);
}

void PlaybackBar::connectParts() {
    connect(m_first, &QToolButton::clicked, this, [this] { m_cursor.setPosition(0); });
    connect(m_last, &QToolButton::clicked, this,
            [this] { m_cursor.setPosition(m_cursor.count()); });
    connect(m_previous, &QToolButton::clicked, this, [this] { m_cursor.step(unit(), -1); });
    connect(m_next, &QToolButton::clicked, this, [this] { m_cursor.step(unit(), 1); });
    connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(m_speed, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_timer.setInterval(oneSecond_ms / speeds[static_cast<std::size_t>(index)]);
    });
    m_timer.setInterval(oneSecond_ms / speeds[usualSpeed]);
    connect(&m_timer, &QTimer::timeout, this, &PlaybackBar::tick);
    connect(&m_cursor, &CycleCursor::moved, this, &PlaybackBar::follow);
    // Mouse and keys move the slider by steps of the unit, dragging to any of its ends.
    connect(m_slider, &QSlider::actionTriggered, this, [this](int action) {
        const auto by = [&](int steps) {
            m_cursor.step(unit(), steps);
            m_slider->setSliderPosition(m_slider->value());
        };
        switch (action) {
        case QAbstractSlider::SliderSingleStepAdd: by(1); break;
        case QAbstractSlider::SliderSingleStepSub: by(-1); break;
        case QAbstractSlider::SliderPageStepAdd: by(10); break;
        case QAbstractSlider::SliderPageStepSub: by(-10); break;
        case QAbstractSlider::SliderToMinimum: m_cursor.setPosition(0); break;
        case QAbstractSlider::SliderToMaximum: m_cursor.setPosition(m_cursor.count()); break;
        case QAbstractSlider::SliderMove: {
            const double share = double(m_slider->sliderPosition()) / slideSteps;
            m_cursor.setPosition(static_cast<long long>(share * double(m_cursor.count()) + 0.5));
            break;
        }
        default: break;
        }
    });
    m_slider->setRange(0, slideSteps);
    m_slider->setSingleStep(slideSteps / wheelSteps);
}

CursorUnit PlaybackBar::unit() const {
    return static_cast<CursorUnit>(m_unit->currentData().toInt());
}

void PlaybackBar::setPlaying(bool playing) {
    if (playing && m_cursor.outcome()) {
        if (m_cursor.atEnd()) {
            m_cursor.setPosition(0);
        }
        m_timer.start();
    } else {
        m_timer.stop();
    }
    showPlay();
}

void PlaybackBar::tick() {
    m_cursor.step(unit(), 1);
    if (m_cursor.atEnd()) {
        setPlaying(false);
    }
}

void PlaybackBar::follow() {
    const bool any = m_cursor.outcome() != nullptr;
    if (!any && isPlaying()) {
        setPlaying(false);
    }
    for (QWidget* part : std::initializer_list<QWidget*>{m_play, m_unit, m_speed, m_slider}) {
        part->setEnabled(any);
    }
    for (QToolButton* button : {m_first, m_previous}) {
        button->setEnabled(any && !m_cursor.atStart());
    }
    for (QToolButton* button : {m_next, m_last}) {
        button->setEnabled(any && !m_cursor.atEnd());
    }
    const bool strokes = !any || m_cursor.outcome()->result.project.operation->travels;
    if (strokes != m_strokes) {
        m_strokes = strokes;
        fillUnits(unit());
    }
    const double share = any ? double(m_cursor.position()) / double(m_cursor.count()) : 0;
    m_slider->setValue(static_cast<int>(share * slideSteps + 0.5));
    showPlace();
}

/// "Stage 1, double stroke 5, working stroke (RZ1 E3, NZ E1, RZ2 E1), radius 7, 12.34 s".
QString PlaybackBar::placeText() const {
    if (!m_cursor.outcome()) {
        return tr("Nothing to play");
    }
    const Pass* const pass = m_cursor.pass();
    if (!pass) {
        return tr("Blank, before the first touch");
    }
    const Outcome& outcome = *m_cursor.outcome();
    const bool strokes = outcome.result.project.operation->travels;
    const Place& at = pass->place;
    QStringList parts{
        (strokes ? tr("Stage %1, double stroke %2 of %3") : tr("Stage %1, revolution %2 of %3"))
            .arg(at.stage)
            .arg(at.cycleCount)
            .arg(outcome.layers.strokeCount())};
    if (strokes) {
        QStringList steps;
        const Progress done = m_cursor.progress();
        for (std::size_t i = done.open; i < done.end; ++i) {
            const Place& place = outcome.trajectory.passes[i].place;
            steps << Names::zone(place.zone) + QChar::Nbsp + Names::step(place.step);
        }
        parts << tr("%1 (%2)", "what a step is; the zones and their steps")
                     .arg(Names::stepMeaning(at.zone, at.step), steps.join(QStringLiteral(", ")));
        if (steps.size() == 1) {
            parts << tr("revolution %1").arg(at.revolution);
        }
    }
    parts << tr("radius %1").arg(m_cursor.radius())
          << tr("%1 s").arg(QLocale().toString(m_cursor.time_s(), 'f', 2));
    return parts.join(QStringLiteral(", "));
}

/// Shows as much as fits; the tool tip has the complete text.
void PlaybackBar::showPlace() {
    const QString text = placeText();
    m_place->setText(m_place->fontMetrics().elidedText(text, Qt::ElideRight, m_place->width()));
    m_place->setToolTip(text);
    m_place->setAccessibleDescription(text);
    m_slider->setAccessibleDescription(text);
}

bool PlaybackBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_place && event->type() == QEvent::Resize) {
        showPlace();
    }
    return QWidget::eventFilter(watched, event);
}

// --- texts --------------------------------------------------------------------------------------

void PlaybackBar::showPlay() {
    m_play->setIcon(themeIcon(isPlaying() ? u"pause" : u"play"));
    m_play->setAccessibleName(isPlaying() ? tr("Pause") : tr("Play"));
    m_play->setToolTip(isPlaying() ? tr("Stop the cycle here")
                                   : tr("Play the cycle, from the blank if it is at its end"));
}

/// Where revolutions are counted, stroke, step and revolution are the same.
void PlaybackBar::fillUnits(CursorUnit chosen) {
    const QSignalBlocker blocker(m_unit);
    m_unit->clear();
    const auto add = [this](CursorUnit unit, const QString& name) {
        m_unit->addItem(name, static_cast<int>(unit));
    };
    add(CursorUnit::stage, tr("by stage"));
    if (m_strokes) {
        add(CursorUnit::stroke, tr("by double stroke"));
        add(CursorUnit::step, tr("by step"));
        add(CursorUnit::revolution, tr("by revolution"));
    } else {
        add(CursorUnit::stroke, tr("by revolution"));
    }
    add(CursorUnit::radius, tr("by radius"));
    const int index = m_unit->findData(static_cast<int>(chosen));
    m_unit->setCurrentIndex(index >= 0 ? index
                                       : m_unit->findData(static_cast<int>(CursorUnit::stroke)));
}

void PlaybackBar::fillSpeeds() {
    for (int i = 0; i < m_speed->count(); ++i) {
        m_speed->setItemText(
            i, tr("%1 per second", "steps of the playback").arg(speeds[std::size_t(i)]));
    }
}

void PlaybackBar::retranslate() {
    setAccessibleName(tr("Playback of the cycle"));
    const auto tell = [](QWidget* widget, const QString& text) {
        widget->setAccessibleName(text);
        widget->setToolTip(text);
    };
    tell(m_first, tr("To the blank"));
    tell(m_previous, tr("One step back"));
    tell(m_next, tr("One step forward"));
    tell(m_last, tr("To the end of the cycle"));
    tell(m_unit, tr("Step of the playback"));
    tell(m_speed, tr("Speed of the playback, steps a second"));
    tell(m_slider, tr("Place in the cycle"));
    m_place->setAccessibleName(tr("Place in the cycle"));
    fillUnits(unit());
    fillSpeeds();
    showPlay();
    follow();
}

void PlaybackBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_place) {
        retranslate();
    }
}

} // namespace sparkout
