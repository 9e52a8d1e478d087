// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_desk.h"

#include "ui/help/help_window.h"
#include "ui/help/tour.h"
#include "ui/kit/help_topic.h"
#include "ui/plot/view.h"
#include "ui/session/program_log.h"
#include "ui/session/settings.h"
#include "ui/window/actions.h"
#include "ui/window/dialogs/about_dialog.h"
#include "ui/window/dialogs/log_dialog.h"
#include "ui/window/help_shortcuts.h"
#include "ui/window/tour_steps.h"
#include "ui/window/view_tabs.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QPointer>

namespace sparkout {

HelpDesk::HelpDesk(QMainWindow& window, Settings& settings, InputsPanel& inputs, ViewTabs& tabs,
                   Actions& actions)
    : QObject(&window)
    , m_window(window)
    , m_settings(settings)
    , m_tabs(tabs)
    , m_tour(new Tour(window, tourSteps(window, inputs, tabs))) {
    connectActions(actions);
    qApp->installEventFilter(this);
}

HelpDesk::~HelpDesk() = default;

void HelpDesk::connectActions(Actions& actions) {
    connect(actions.help, &QAction::triggered, this,
            [this] { open(topicAt(QApplication::focusWidget())); });
    connect(actions.helpContents, &QAction::triggered, this,
            [this] { open(QStringLiteral("start")); });
    connect(actions.helpShortcuts, &QAction::triggered, this,
            [this] { open(QStringLiteral("shortcuts")); });
    connect(actions.tour, &QAction::triggered, this, &HelpDesk::startTour);
    connect(actions.log, &QAction::triggered, this, &HelpDesk::showLog);
    connect(actions.about, &QAction::triggered, this, [this] { AboutDialog(&m_window).exec(); });
}

void HelpDesk::startTour() {
    m_settings.setTourSeen();
    m_tour->start();
}

void HelpDesk::offerTour() {
    const bool kept = !m_settings.folder().isEmpty(); // otherwise it would appear at every start
    if (kept && !m_settings.tourSeen() && !QApplication::activeModalWidget()) {
        startTour();
    }
}

void HelpDesk::showLog() {
    auto* dialog = m_window.findChild<LogDialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (!dialog) {
        dialog = new LogDialog(ProgramLog::current(), &m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

HelpWindow* HelpDesk::make(QWidget* parent) {
    return new HelpWindow([this] { return shortcutsHtml(m_window); }, parent);
}

QString HelpDesk::topicAt(const QWidget* widget) const {
    const QString topic = helpTopicOf(widget);
    if (!topic.isEmpty()) {
        return topic;
    }
    const View* view = m_tabs.currentView();
    return view ? view->objectName() : QStringLiteral("start");
}

void HelpDesk::open(const QString& topic) {
    if (!m_help) {
        m_help.reset(make(nullptr));
    }
    m_help->openTopic(topic);
    m_help->showFront();
}

/// F1 in a modal dialog: the help becomes a window of the dialog, so that both can be used.
bool HelpDesk::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType()
        || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1) {
        return false;
    }
    QWidget* const dialog = QApplication::activeModalWidget();
    if (!dialog || !dialog->isAncestorOf(static_cast<QWidget*>(watched))) {
        return false;
    }
    const QString topic = helpTopicOf(QApplication::focusWidget());
    auto* help = dialog->findChild<HelpWindow*>(QString(), Qt::FindDirectChildrenOnly);
    if (!help) {
        help = make(dialog);
    }
    help->openTopic(topic.isEmpty() ? QStringLiteral("start") : topic);
    help->showFront();
    return true;
}

} // namespace sparkout
