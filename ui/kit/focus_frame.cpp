// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/focus_frame.h"

#include <QApplication>
#include <QEvent>
#include <QPainter>

#include <utility>

namespace sparkout {

namespace {

constexpr int thickness = 3;

/// The visible part of a widget, in window coordinates.
QRect shownPart(const QWidget& widget) {
    const QWidget* const window = widget.window();
    QRect rect(widget.mapTo(window, QPoint(0, 0)), widget.size());
    for (const QWidget* part = widget.parentWidget(); part; part = part->parentWidget()) {
        rect &= QRect(part->mapTo(window, QPoint(0, 0)), part->size());
        if (part == window) {
            break;
        }
    }
    return rect;
}

} // namespace

FocusFrame::FocusFrame(QWidget& window) : QWidget(&window) {
    setObjectName(QStringLiteral("focusFrame"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (now && now != m_widget) { // another program's window takes the focus only temporarily
            leave();
        }
    });
    hide();
}

void FocusFrame::showRound(QWidget& widget) {
    QWidget& window = *widget.window();
    auto* frame = window.findChild<FocusFrame*>(QString(), Qt::FindDirectChildrenOnly);
    if (!frame) {
        frame = new FocusFrame(window);
    }
    frame->follow(widget);
}

void FocusFrame::follow(QWidget& widget) {
    leave();
    m_widget = &widget;
    for (QWidget* part = &widget; part; part = part->isWindow() ? nullptr : part->parentWidget()) {
        part->installEventFilter(this);
        m_watched << part;
    }
    connect(&widget, &QObject::destroyed, this, &FocusFrame::leave);
    place();
}

void FocusFrame::leave() {
    for (const QPointer<QWidget>& part : std::exchange(m_watched, {})) {
        if (part) {
            part->removeEventFilter(this);
        }
    }
    if (m_widget) {
        disconnect(m_widget, &QObject::destroyed, this, nullptr);
    }
    m_widget = nullptr;
    hide();
}

/// Places the frame around the widget if its neighbours leave room, otherwise just inside it.
void FocusFrame::place() {
    const bool shown = m_widget && m_widget->isVisible() && m_widget->window() == parentWidget();
    const QRect rect =
        shown ? shownPart(*m_widget).adjusted(-1, -1, 1, 1) & parentWidget()->rect() : QRect();
    setVisible(!rect.isEmpty());
    if (rect.isEmpty()) {
        return;
    }
    setGeometry(rect);
    const QRect own(QPoint(0, 0), rect.size());
    setMask(QRegion(own)
            - QRegion(own.adjusted(thickness, thickness, -thickness, -thickness))); // a ring
    raise();
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
    case QEvent::ZOrderChange: place(); break;
    case QEvent::MouseButtonPress: leave(); break; // a mouse user sees the position anyway
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

void FocusFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Active, QPalette::Link));
}

} // namespace sparkout
