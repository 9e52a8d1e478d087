// SPDX-License-Identifier: GPL-3.0-or-later
// Where the panels and views of the window stand, and how that is kept.
#include "ui/window/main_window.h"

#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/kit/font_size.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/sealed_state.h"
#include "ui/kit/theme_icon.h"
#include "ui/plot/step_sheet.h"
#include "ui/plot/view.h"
#include "ui/views/verdict/verdict_panel.h"
#include "ui/window/actions.h"
#include "ui/window/panel_widths.h"
#include "ui/window/playback_bar.h"
#include "ui/window/view_tabs.h"

#include <QDockWidget>
#include <QScreen>

namespace sparkout {

namespace {

constexpr QSize usualWindow(1366, 768);
constexpr QSize frameAllowance(8, 40);
constexpr int verdictWidth = 327;
constexpr int messagesHeight = 96;

} // namespace

QDockWidget* MainWindow::addDock(QWidget* content, const QString& name, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::buildDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_inputsDock = addDock(m_inputs, QStringLiteral("inputs"), Qt::LeftDockWidgetArea);
    m_verdictDock = addDock(m_verdict, QStringLiteral("verdict"), Qt::RightDockWidgetArea);
    m_messagesDock = addDock(m_messages, QStringLiteral("messages"), Qt::BottomDockWidgetArea);
    m_widths = new PanelWidths(*this, {m_inputsDock, m_verdictDock});
    m_sheetDock = addDock(m_sheet, QStringLiteral("step"), Qt::RightDockWidgetArea);
    QAction* const sheet = m_sheetDock->toggleViewAction();
    sheet->setIcon(themeIcon(u"formula"));
    m_playback->addTool(sheet);
    connect(sheet, &QAction::triggered, this, [this](bool shown) {
        if (shown) { // below the verdict, if it has not been moved
            resizeDocks({m_verdictDock, m_sheetDock}, {2, 3}, Qt::Vertical);
        }
    });
    m_actions->addDocks({m_inputsDock->toggleViewAction(), m_verdictDock->toggleViewAction(),
                         m_messagesDock->toggleViewAction(), sheet});
    const QList<QAction*> shows = m_actions->addViews(static_cast<int>(views().size()));
    for (int i = 0; i < shows.size(); ++i) {
        View* view = views()[std::size_t(i)];
        connect(shows[i], &QAction::triggered, this, [this, view] { m_tabs->showView(view); });
    }
}

bool MainWindow::showView(const QString& name) {
    int number = 0;
    for (View* view : views()) {
        if (name == view->objectName() || name == QString::number(++number)) {
            m_tabs->showView(view);
            return true;
        }
    }
    return false;
}

void MainWindow::resetLayout() {
    m_tabs->attachAll();
    for (QDockWidget* dock : {m_inputsDock, m_verdictDock, m_messagesDock, m_sheetDock}) {
        dock->setFloating(false);
        dock->setVisible(dock != m_sheetDock);
    }
    addDockWidget(Qt::LeftDockWidgetArea, m_inputsDock);
    addDockWidget(Qt::RightDockWidgetArea, m_verdictDock);
    addDockWidget(Qt::BottomDockWidgetArea, m_messagesDock);
    splitDockWidget(m_verdictDock, m_sheetDock, Qt::Vertical);
    fitPanels();
    resizeDocks({m_messagesDock}, {messagesHeight}, Qt::Vertical);
}

void MainWindow::fitPanels() {
    m_widths->want(m_inputsDock, 0); // as narrow as it can be, in any type and language
    m_widths->want(m_verdictDock, atFontSize(verdictWidth));
}

void MainWindow::restoreWindow() {
    // Frame and title bar need room too: on a small screen the status bar must stay in sight.
    resize(usualWindow.boundedTo(screen()->availableSize() - frameAllowance));
    resetLayout();
    if (const auto parts = unsealed(m_settings.windowGeometry(), 1)) {
        restoreGeometry(parts->front());
    }
    auto parts = unsealed(m_settings.windowState(), 3);
    if (!parts) { // of an earlier version: the widths that were wanted are not known
        parts = unsealed(m_settings.windowState(), 2);
    }
    if (parts) {
        restoreState(parts->front());
        m_tabs->restoreState(parts->at(1));
        if (parts->size() < 3 || !m_widths->restoreState(parts->back())) {
            m_widths->takeOverWhenShown();
        }
    }
}

void MainWindow::saveWindow() {
    m_settings.setWindow(sealed({saveGeometry()}),
                         sealed({saveState(), m_tabs->saveState(), m_widths->saveState()}));
}

void MainWindow::movePanel(int by) {
    QList<QWidget*> panels{m_inputs, m_tabs};
    for (const View* view : views()) {
        if (QWidget* window = m_tabs->windowOf(view)) {
            panels += window;
        }
    }
    sparkout::movePanel(panels + QList<QWidget*>{m_playback, m_verdict, m_sheet, m_messages}, by);
}

void MainWindow::toggleDetached() {
    View* view = m_tabs->currentView();
    m_tabs->isDetached(view) ? m_tabs->attach(view) : m_tabs->detach(view);
}

} // namespace sparkout
