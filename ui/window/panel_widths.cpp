// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_widths.h"

#include <QDataStream>
#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>
#include <QIODevice>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {
constexpr int wideWindow = 1900; ///< fills a screen of 1920 pixels
constexpr int leastViews = 700;  ///< width of the views beside a wide panel
} // namespace

PanelWidths::PanelWidths(QMainWindow& window, QList<QDockWidget*> panels)
    : QObject(&window), m_window(window), m_panels(std::move(panels)) {
    m_later.setSingleShot(true);
    m_later.setInterval(0);
    connect(&m_later, &QTimer::timeout, this, &PanelWidths::restore);
    m_window.installEventFilter(this);
    m_window.centralWidget()->installEventFilter(this);
    for (QDockWidget* panel : m_panels) {
        connect(panel, &QDockWidget::dockLocationChanged, this, [this, panel] {
            if (stands(*panel) && panel->width() > wanted(panel)) {
                // its width there
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
        found.push_back(wanted(panel));
        found.push_back(panel->minimumSizeHint().width());
    }
    return found;
}

void PanelWidths::want(QDockWidget* panel, int width) {
    m_wanted[panel] = width;
    m_window.resizeDocks({panel}, {std::max(width, panel->minimumSizeHint().width())},
                         Qt::Horizontal);
    m_later.start();
}

void PanelWidths::wantInWideWindow(QDockWidget* panel, int width) {
    m_wantedWide[panel] = width;
    m_later.start();
}

/// A panel is wide if the others and the views have enough space: with a large font this may need a
/// wider window.
int PanelWidths::wanted(const QDockWidget* panel) const {
    const int wide = m_wantedWide.value(panel);
    int views = m_window.width() - wide;
    for (const QDockWidget* other : m_panels) {
        if (other != panel && stands(*other)) {
            views -= std::max(m_wanted.value(other), other->minimumSizeHint().width());
        }
    }
    const bool isWide = m_window.width() >= wideWindow && views >= leastViews;
    return std::max(m_wanted.value(panel), isWide ? wide : 0);
}

void PanelWidths::takeOver(QDockWidget* panel) {
    if (stands(*panel)) {
        m_wanted[panel] = panel->width();
    }
}

/// A panel that is still as narrow as before keeps its wanted width.
void PanelWidths::takeOverDragged() {
    for (QDockWidget* panel : m_panels) {
        if (m_pressed.value(panel) != panel->width()) {
            takeOver(panel);
            m_wantedWide[panel] = 0;
        }
    }
}

void PanelWidths::takeOverWhenShown() {
    m_restored = true;
}

QByteArray PanelWidths::saveState() const {
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_0);
    for (const QDockWidget* panel : m_panels) {
        stream << qint32(m_wanted.value(panel)) << qint32(m_wantedWide.value(panel));
    }
    return state;
}

bool PanelWidths::restoreState(const QByteArray& state) {
    QDataStream stream(state);
    stream.setVersion(QDataStream::Qt_6_0);
    QHash<const QDockWidget*, int> wanted, wantedWide;
    for (const QDockWidget* panel : m_panels) {
        qint32 width = 0, wide = 0;
        stream >> width >> wide;
        if (stream.status() != QDataStream::Ok || width < 0 || width > QWIDGETSIZE_MAX || wide < 0
            || wide > QWIDGETSIZE_MAX) {
            return false;
        }
        wanted[panel] = width;
        wantedWide[panel] = wide > 0 ? m_wantedWide.value(panel) : 0; // otherwise it was dragged
    }
    m_wanted = wanted;
    m_wantedWide = wantedWide;
    m_later.start();
    return true;
}

void PanelWidths::restore() {
    m_dragging = m_dragging && QGuiApplication::mouseButtons() != Qt::NoButton;
    if (std::exchange(m_released, false)) { // the last mouse move has been processed
        takeOverDragged();
    }
    if (m_dragging || !m_window.isVisible() || m_tried == this->widths()) {
        return;
    }
    if (std::exchange(m_restored, false)) {
        std::ranges::for_each(m_panels, [this](QDockWidget* panel) { takeOver(panel); });
    }
    m_tried = this->widths(); // do not repeat an impossible request
    const QWidget& middle = *m_window.centralWidget();
    int room = middle.width() - middle.minimumSizeHint().width(); // none is taken from each other
    QList<QDockWidget*> changed;
    QList<int> widths;
    const auto change = [&](QDockWidget* panel, int width) {
        changed << panel;
        widths << width;
        room -= width - panel->width();
    };
    for (QDockWidget* panel : m_panels) {
        const int most = std::max(wanted(panel), panel->minimumSizeHint().width());
        if (stands(*panel) && panel->width() > most) {
            change(panel, most);
        }
    }
    for (QDockWidget* panel : m_panels) {
        const int missing = stands(*panel) ? wanted(panel) - panel->width() : 0;
        if (missing > 0 && room > 0) {
            change(panel, panel->width() + std::min(missing, room));
        }
    }
    if (!changed.isEmpty()) {
        m_window.resizeDocks(changed, widths, Qt::Horizontal);
    }
}

bool PanelWidths::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress: // events of the window itself belong to its separators
        if (watched == &m_window) {
            m_dragging = true;
            for (const QDockWidget* panel : m_panels) {
                m_pressed[panel] = panel->width();
            }
        }
        break;
    case QEvent::MouseButtonRelease:
        if (watched == &m_window && std::exchange(m_dragging, false)) {
            m_released = true;
            m_later.start();
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
