// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panel_widths.h"

#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace sparkout {

PanelWidths::PanelWidths(QMainWindow& window, QList<QDockWidget*> panels)
    : QObject(&window), m_window(window), m_panels(std::move(panels)) {
    m_later.setSingleShot(true);
    m_later.setInterval(0);
    connect(&m_later, &QTimer::timeout, this, &PanelWidths::restore);
    m_window.installEventFilter(this);
    m_window.centralWidget()->installEventFilter(this);
    for (QDockWidget* panel : m_panels) {
        connect(panel, &QDockWidget::dockLocationChanged, this, [this, panel] {
            if (stands(*panel)) { // as wide as it has been made there
                m_wanted[panel] = std::max(m_wanted.value(panel), panel->width());
            }
        });
    }
}

bool PanelWidths::stands(const QDockWidget& panel) const {
    const Qt::DockWidgetArea area = m_window.dockWidgetArea(const_cast<QDockWidget*>(&panel));
    return panel.isVisible() && !panel.isFloating()
           && (area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea);
}

std::vector<int> PanelWidths::widths() const {
    std::vector<int> found{m_window.width(), m_window.centralWidget()->minimumSizeHint().width()};
    for (const QDockWidget* panel : m_panels) {
        found.push_back(stands(*panel) ? panel->width() : -1);
        found.push_back(m_wanted.value(panel));
    }
    return found;
}

void PanelWidths::want(QDockWidget* panel, int width) {
    m_wanted[panel] = width;
    m_window.resizeDocks({panel}, {width}, Qt::Horizontal);
    m_later.start();
}

void PanelWidths::takeOver() {
    for (const QDockWidget* panel : m_panels) {
        if (stands(*panel)) {
            m_wanted[panel] = panel->width();
        }
    }
}

void PanelWidths::takeOverWhenShown() {
    m_restored = true;
}

void PanelWidths::restore() {
    m_dragging = m_dragging && QGuiApplication::mouseButtons() != Qt::NoButton;
    if (m_dragging || !m_window.isVisible() || m_tried == widths()) {
        return;
    }
    if (std::exchange(m_restored, false)) {
        takeOver();
    }
    m_tried = widths(); // what cannot be had now is not tried again and again
    QList<QDockWidget*> narrow;
    QList<int> wanted;
    for (QDockWidget* panel : m_panels) {
        if (stands(*panel) && panel->width() < m_wanted.value(panel)) {
            narrow << panel;
            wanted << m_wanted.value(panel);
        }
    }
    if (!narrow.isEmpty()) {
        m_window.resizeDocks(narrow, wanted, Qt::Horizontal);
    }
}

bool PanelWidths::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress: // the window's own are those of its separators
        if (watched == &m_window) {
            m_dragging = true;
            m_pressed = widths();
        }
        break;
    case QEvent::MouseButtonRelease:
        if (watched == &m_window && std::exchange(m_dragging, false) && m_pressed != widths()) {
            takeOver();
        }
        break;
    case QEvent::Resize:
    case QEvent::LayoutRequest:
    case QEvent::Show: m_later.start(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace sparkout
