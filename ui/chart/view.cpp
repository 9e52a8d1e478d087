// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/view.h"

#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"

#include <QEvent>
#include <QLabel>

#include <utility>

namespace sparkout {

View::View(QWidget* parent) : QWidget(parent), m_ownCycle(new CycleCursor(this)) {
    shareCycle(m_ownCycle);
    connect(this, &QObject::objectNameChanged, this,
            [this](const QString& name) { setHelpTopic(*this, name); });
}

void View::shareCycle(CycleCursor* cycle) {
    if (m_cycle) {
        m_cycle->disconnect(this);
    }
    m_cycle = cycle;
    connect(cycle, &CycleCursor::moved, this, &View::onMoved);
}

const CycleCursor* View::cycleIn(const OutcomePtr& shown) const {
    return m_cycle && shown && m_cycle->outcome() == shown ? m_cycle.data() : nullptr;
}

void View::onMoved() {
    m_moved = true;
    if (isVisible() && !m_stale) {
        redraw();
    }
}

void View::setOutcome(OutcomePtr outcome) {
    m_latest = std::move(outcome);
    m_stale = true;
    if (m_cycle == m_ownCycle) {
        m_ownCycle->setOutcome(m_latest);
    }
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

void View::forget() {
    m_latest.reset();
    m_ofBefore = true;
    dropStudies();
}

void View::setUpNotice(QLabel& label) {
    label.setTextFormat(Qt::PlainText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse);
    label.setWordWrap(true);
}

void View::setUpReadout(QLabel& label, int lines) {
    setUpNotice(label);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTextLines(label, lines, 2);
    m_readout = &label;
}

void View::readOut(const QString& text) {
    m_readout->setText(text.isEmpty() ? hint() : text);
}

void View::built() {
    m_built = true;
    retranslate();
}

void View::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (!m_built) {
        return;
    }
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        recolour();
    }
}

void View::redraw() {
    const bool moved = std::exchange(m_moved, false);
    if (std::exchange(m_stale, false)) {
        showOutcome();
    } else if (moved) {
        followCycle();
    }
}

void View::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    redraw();
}

} // namespace sparkout
