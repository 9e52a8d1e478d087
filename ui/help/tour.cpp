// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/tour.h"

#include "ui/help/tour_balloon.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPointer>
#include <QTimer>

namespace sparkout {

Tour::Tour(QWidget& window, std::vector<TourStep> steps)
    : QObject(&window), m_window(window), m_steps(std::move(steps)) {}

Tour::~Tour() = default;

void Tour::start() {
    end();
    m_balloon = std::make_unique<TourBalloon>(m_window);
    connect(m_balloon.get(), &TourBalloon::next, this, [this] { go(1); });
    connect(m_balloon.get(), &TourBalloon::back, this, [this] { go(-1); });
    connect(m_balloon.get(), &TourBalloon::ended, this, &Tour::end);
    m_step = -1;
    qApp->installEventFilter(this);
    go(1);
}

void Tour::end() {
    if (!m_balloon) {
        return;
    }
    qApp->removeEventFilter(this);
    m_balloon->disconnect(this); // a key press on its way to it has no effect
    m_balloon->hide();
    m_balloon.release()->deleteLater(); // one of its buttons may be the caller
    emit finished();
}

bool Tour::running() const {
    return m_balloon != nullptr;
}

void Tour::go(int by) {
    for (m_step += by; m_step < int(m_steps.size()); m_step += by) {
        if (m_step < 0) { // there is nothing before the first shown step
            m_step = 0;
            by = 1;
        }
        if (showStep()) {
            return;
        }
    }
    end();
}

bool Tour::showStep() {
    const TourStep& step = m_steps[std::size_t(m_step)];
    step.target(); // visible, and laid out:
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    const QRect target = step.target() & m_window.rect();
    if (target.isEmpty()) {
        return false;
    }
    m_balloon->show({step.title(), step.text(), tr("%1 of %2").arg(m_step + 1).arg(m_steps.size()),
                     m_step == 0, m_step + 1 == int(m_steps.size())},
                    target);
    return true;
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    const bool escape = event->type() == QEvent::KeyPress
                        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape
                        && QApplication::activeWindow() == &m_window && watched->isWidgetType()
                        && !QApplication::activePopupWidget();
    if (escape) {
        end();
        return true;
    }
    if (watched == &m_window && running()
        && (event->type() == QEvent::Resize || event->type() == QEvent::LanguageChange)) {
        QTimer::singleShot(0, this, [this] { // after the layout of its parts
            if (running()) {
                showStep();
            }
        });
    }
    return false;
}

} // namespace sparkout
