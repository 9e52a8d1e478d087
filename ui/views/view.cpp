// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/view.h"

#include <QLabel>

#include <utility>

namespace sparkout {

void View::setOutcome(OutcomePtr outcome) {
    m_latest = std::move(outcome);
    m_stale = true;
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

void View::setUpNotice(QLabel& label) {
    label.setTextFormat(Qt::PlainText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse);
    label.setWordWrap(true);
}

void View::setUpReadout(QLabel& label) {
    setUpNotice(label);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label.setFixedHeight(QFontMetrics(label.font()).lineSpacing() * 2 + 2);
}

void View::redraw() {
    if (m_stale) {
        m_stale = false;
        showOutcome();
    }
}

void View::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    redraw();
}

} // namespace sparkout
