// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_desk.h"

#include "ui/chart/view.h"
#include "ui/help/help_window.h"
#include "ui/help/tour.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/row_sliders.h"
#include "ui/inputs/stage_table.h"
#include "ui/kit/help_topic.h"
#include "ui/session/program_log.h"
#include "ui/session/settings.h"
#include "ui/window/actions.h"
#include "ui/window/dialogs/about_dialog.h"
#include "ui/window/view_tabs.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QString>
#include <QToolBar>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// Commands with their keys, each pair once.
class KeyTable {
public:
    void add(const QString& command, const QList<QKeySequence>& keys) {
        QStringList shown;
        for (const QKeySequence& key : keys) {
            if (!key.isEmpty()) {
                shown += key.toString(QKeySequence::NativeText);
            }
        }
        const std::pair row{command, shown.join(QStringLiteral(", "))};
        if (!shown.isEmpty() && !command.isEmpty() && !m_rows.contains(row)) {
            m_rows += row;
        }
    }

    void add(const QAction& action) {
        QString text = action.iconText(); // without mnemonic
        add(text.remove(u'…'), action.shortcuts());
    }

    void addMenu(const QMenu& menu) {
        for (const QAction* action : menu.actions()) {
            if (const QMenu* below = action->menu()) {
                addMenu(*below);
            } else {
                add(*action);
            }
        }
    }

    [[nodiscard]] QString html(const QString& title, const char* anchor) const {
        if (m_rows.isEmpty()) {
            return {};
        }
        QString text = QStringLiteral("<h2 id=\"%1\">%2</h2><table>")
                           .arg(QString::fromLatin1(anchor), title.toHtmlEscaped());
        for (const auto& [command, keys] : m_rows) {
            text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                        .arg(keys.toHtmlEscaped(), command.toHtmlEscaped());
        }
        return text + QStringLiteral("</table>");
    }

private:
    QList<std::pair<QString, QString>> m_rows;
};

QString shortcutsTr(const char* text) {
    return QCoreApplication::translate("Help", text);
}

/// The keys of a window as HTML: those of its menus, of the pages of the inputs and of the plots,
/// with the current assignments.
QString shortcutsHtml(const QMainWindow& window) {
    KeyTable menus;
    for (const QAction* top : window.findChild<QMenuBar*>()->actions()) {
        if (const QMenu* menu = top->menu()) {
            menus.addMenu(*menu);
        }
    }
    KeyTable pages;
    if (const auto* panel = window.findChild<InputsPanel*>()) {
        for (const auto* button : panel->findChildren<QAbstractButton*>()) {
            pages.add(button->text(), {button->shortcut()});
        }
    }
    KeyTable plots;
    for (const auto* view : window.findChildren<View*>()) {
        for (const QAction* action : view->findChildren<QAction*>()) {
            plots.add(*action);
        }
    }
    return menus.html(shortcutsTr(QT_TRANSLATE_NOOP("Help", "Commands of the menus")), "menus")
           + pages.html(shortcutsTr(QT_TRANSLATE_NOOP("Help", "Pages of the inputs")), "pages")
           + plots.html(shortcutsTr(QT_TRANSLATE_NOOP("Help", "In a plot")), "plots");
}

std::function<QString()> tourText(const char* text) {
    return [text] { return QCoreApplication::translate("Tour", text); };
}

/// The area of a part of the window; empty while it is hidden or detached.
QRect placeOf(const QWidget* part) {
    if (!part || !part->isVisible() || !qobject_cast<const QMainWindow*>(part->window())) {
        return {};
    }
    return {part->mapTo(part->window(), QPoint(0, 0)), part->size()};
}

/// The last button of the tool bar, or the one for the hidden ones.
QRect placeOfLastButton(const QMainWindow& window) {
    const auto* bar = window.findChild<QToolBar*>(QStringLiteral("toolBar"));
    if (!bar || bar->actions().isEmpty()) {
        return {};
    }
    const QRect button = placeOf(bar->widgetForAction(bar->actions().back()));
    return button.isEmpty()
               ? placeOf(bar->findChild<QWidget*>(QStringLiteral("qt_toolbar_ext_button")))
               : button;
}

/// The part of the window with a name.
std::function<QRect()> namedPart(QMainWindow& window, const char* name) {
    return
        [&window, name] { return placeOf(window.findChild<QWidget*>(QString::fromLatin1(name))); };
}

void showDock(QMainWindow& window, const char* name) {
    if (auto* dock = window.findChild<QDockWidget*>(QString::fromLatin1(name))) {
        dock->show();
    }
}

StageTable* shownStages(QMainWindow& window, InputsPanel& inputs) {
    showDock(window, "inputs");
    inputs.showCycle();
    return inputs.findChild<StageTable*>();
}

QRect placeOfView(ViewTabs& tabs, const char* name) {
    const auto named = [name](const View* view) {
        return view->objectName() == QLatin1String(name);
    };
    View* view = *std::ranges::find_if(tabs.views(), named);
    tabs.attach(view);
    tabs.showView(view);
    return placeOf(view);
}

QRect placeOfHelpMenu(const QMainWindow& window) {
    auto* bar = window.findChild<QMenuBar*>();
    return bar->actionGeometry(bar->actions().back()).translated(bar->mapTo(&window, QPoint()));
}

std::vector<TourStep> tourSteps(QMainWindow& window, InputsPanel& inputs, ViewTabs& tabs) {
    return {
        {[&window] { return placeOfLastButton(window); },
         tourText(QT_TRANSLATE_NOOP("Tour", "An example to begin with")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour", "The last button of the tool bar opens the shipped examples, each as a copy: "
                     "change what you like. The first one begins a project of your own."))},
        {[&] { return placeOf(shownStages(window, inputs)); },
         tourText(QT_TRANSLATE_NOOP("Tour", "The stages of the cycle")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour", "A row is a stage: feeds, stock, spark-out, and the time it takes. Type into "
                     "a cell; everything is computed again at once. The pages above hold part, "
                     "material, wheel, machine, gauge and batch."))},
        {[&] { return placeOfView(tabs, "feeds"); },
         tourText(QT_TRANSLATE_NOOP("Tour", "Programmed feed and actual cut")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour",
             "Dashed: the feed of the program. Solid: the actual cut, zone by zone, which differs "
             "because everything yields. The first tab sums the cycle up in bars; the others show "
             "form, limits, compliance, layers, a batch and compared runs."))},
        {[&] {
             showDock(window, "verdict");
             return namedPart(window, "verdict")();
         },
         tourText(QT_TRANSLATE_NOOP("Tour", "Does it meet the drawing?")),
         tourText(QT_TRANSLATE_NOOP("Tour",
                                    "Time of the cycle and every requirement with its margin. A "
                                    "click on a row leads to the place where the value arises."))},
        {[&] { return placeOf(shownStages(window, inputs)->findChild<RowSliders*>()); },
         tourText(QT_TRANSLATE_NOOP("Tour", "Play with the feeds")),
         tourText(QT_TRANSLATE_NOOP("Tour", "Drag a slider and watch curves, time and margins "
                                            "follow. Undo reverts a whole drag."))},
        {namedPart(window, "playback"),
         tourText(QT_TRANSLATE_NOOP("Tour", "Step through the cycle")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour", "Play, or step by stage, double stroke, step E1…E5 or radius. All views "
                     "follow; the button at the right shows the formulas with their numbers."))},
        {[&] { return placeOfHelpMenu(window); }, tourText(QT_TRANSLATE_NOOP("Tour", "Help")),
         tourText(QT_TRANSLATE_NOOP("Tour", "F1 explains the field or the view in focus. This tour "
                                            "can be started again from the menu Help."))},
    };
}

} // namespace

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
