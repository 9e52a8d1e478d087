// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/monkey.h"

#include "tests/ui/support/setup_fixtures.h"
#include "tests/ui/support/text_checks.h"
#include "ui/chart/view.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include <iterator>

namespace sparkout {

namespace {

constexpr int patience = 12; ///< events a dialog or a menu may stay: the window is the larger …
constexpr int mostPatience = 48; ///< … or a dialog as long as something in it is new
constexpr int notesToTell = 20;  ///< of a monkey in trouble

/// Without what QtTest says where no widget wants a key: a user may press any.
QStringList ofTheProgram(QStringList warned) {
    warned.removeAll(QStringLiteral("Keyboard event not accepted by receiving widget"));
    return warned;
}

/// Which widget it is, over restarts of the window. The editors of the rows of a file that is read
/// are one for each column, and those of a list in the inputs one, however many rows it has; those
/// of a view are the same in a window of its own.
QString identityOf(const QWidget& widget) {
    static const QRegularExpression row(QStringLiteral("column-\\d+-"));
    static const QRegularExpression item(QStringLiteral("/\\d+(?=/|$)"));
    static const QRegularExpression own(
        QStringLiteral("> ViewTabs > (QStackedWidget|\\w+Window) > (?=\\w+ > )"));
    QString path = pathOf(&widget)
                       .replace(row, QStringLiteral("column-"))
                       .replace(item, QStringLiteral("/0"))
                       .replace(own, QStringLiteral("> ViewTabs > "));
    if (const QWidget* parent = widget.parentWidget(); parent && widget.objectName().isEmpty()) {
        int number = 0;
        for (const QObject* sibling : parent->children()) {
            if (sibling == &widget) {
                break;
            }
            number += sibling->metaObject() == widget.metaObject();
        }
        path += QStringLiteral(" #%1").arg(number);
    }
    return path;
}

bool usable(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && !widget.rect().isEmpty();
}

} // namespace

Monkey::Monkey(quint32 seed, int events, const QString& logFile)
    : m_random(seed), m_events(events), m_log(logFile), m_bench(QStringLiteral("en")) {
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication::setDoubleClickInterval(1); // two clicks in a row are two clicks
    for (const char* scheme : {"http", "https", "file", "mailto"}) {
        QDesktopServices::setUrlHandler(QString::fromUtf8(scheme), this, "deleteLater");
        QDesktopServices::unsetUrlHandler(QString::fromUtf8(scheme));
    }
    for (const QString& path : examplePaths()) {
        m_files += m_folder.filePath(nameOf(path) + QStringLiteral(".sparkout"));
        QFile::copy(path, m_files.back());
        QFile::setPermissions(m_files.back(), QFile::ReadOwner | QFile::WriteOwner);
    }
    m_files += m_folder.filePath(QStringLiteral("three surfaces.sparkout"));
    setup_fixtures::writeSetupFile(setup_fixtures::steppedShaft(), m_files.back());
    QFile broken(m_folder.filePath(QStringLiteral("broken.sparkout")));
    if (broken.open(QIODevice::WriteOnly)) {
        broken.write("{\"format\":\"sparkout-project\",\"version\":1,\"x\":1}");
        m_files += broken.fileName();
    }
    m_files += m_folder.filePath(QStringLiteral("not there.sparkout"));
    m_bench.settings.setLastFolder(m_folder.path());
    if (!m_log.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        qInfo("no log in %s", qPrintable(logFile));
    }
}

Monkey::~Monkey() = default;

QString Monkey::run() {
    if (!m_bench.open(m_files.front())) {
        return QStringLiteral("the first project was not opened");
    }
    later();
    while (m_done < m_events && m_trouble.isEmpty()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    if (!QTest::qWaitFor([this] { return !m_bench.window->runs().running(); }, 30'000)) {
        m_trouble = QStringLiteral("the last run does not end");
    }
    m_bench.settle();
    if (const QStringList warned = ofTheProgram(m_warnings.take());
        !warned.isEmpty() && m_trouble.isEmpty()) {
        m_trouble = QStringLiteral("after the last event: ") + warned.join(u'\n');
    }
    if (!m_trouble.isEmpty()) {
        m_trouble += QStringLiteral("\nWhat it did last:\n") + m_lastNotes.join(QString());
    }
    return m_trouble;
}

QStringList Monkey::missed() const {
    return (m_seen - m_reached).values();
}

void Monkey::note(const QString& what) {
    const QString line = QStringLiteral("%1 %2\n").arg(m_done).arg(what);
    m_log.write(line.toUtf8());
    m_log.flush(); // the last line tells what a crash came of
    m_lastNotes += line;
    if (m_lastNotes.size() > notesToTell) {
        m_lastNotes.removeFirst();
    }
}

/// A timer each time: one does not fire again while it is in a dialog's loop.
void Monkey::later() {
    QTimer::singleShot(0, this, &Monkey::step);
}

void Monkey::step() {
    if (!m_trouble.isEmpty() || m_done >= m_events) {
        QWidget* popup = QApplication::activePopupWidget();
        QWidget* open = popup ? popup : QApplication::activeModalWidget();
        if (open) {
            open->close(); // back to run()
        }
        if (open || m_depth > 0) { // what was begun last may open a dialog yet
            later();
        }
        return;
    }
    later();
    ++m_done;
    ++m_depth;
    const int number = m_done;
    act();
    --m_depth;
    if (const QStringList warned = ofTheProgram(m_warnings.take());
        !warned.isEmpty() && m_trouble.isEmpty()) {
        m_trouble = QStringLiteral("event %1 (or within its dialog, up to %2): %3")
                        .arg(number)
                        .arg(m_done)
                        .arg(warned.join(u'\n'));
    }
}

void Monkey::act() {
    if (m_depth == 1 && !m_bench.window->isVisible()) {
        openWindow();
        return;
    }
    QWidget* modal = QApplication::activeModalWidget();
    m_sinceModal = modal == m_lastModal ? m_sinceModal + 1 : 0;
    m_dialogs += modal && modal != m_lastModal;
    m_lastModal = modal;
    if (modal && answerDialog(modal)) {
        return;
    }
    QWidget* popup = QApplication::activePopupWidget();
    // The menu of a field that was disabled meanwhile takes no clicks, and QTest warns of them.
    if (popup && (!popup->isEnabled() || random(patience) == 0)) {
        closeOldPopup(popup);
        return;
    }
    const int choice = random(100);
    if (choice < 6 && !modal) {
        useMenu();
    } else if (choice < 12 && !modal) {
        shortcut();
    } else if (choice < 13 && !modal) {
        resizeWindow();
    } else if (QWidget* from = place()) {
        useWidget(pick(*from));
    }
}

/// As a second start of the program with the settings of the first.
void Monkey::openWindow() {
    note(QStringLiteral("start again"));
    ++m_restarts;
    m_bench.window = std::make_unique<MainWindow>(m_bench.settings, m_bench.language);
    m_bench.window->show();
    m_bench.window->activateWindow();
    static_cast<void>(m_bench.window->document().open(m_files[random(int(m_files.size()) - 2)]));
}

bool Monkey::answerDialog(QWidget* modal) {
    if (modal->inherits("QFileDialog")) {
        answerFileDialog(modal);
        return true;
    }
    const bool foreign = modal->inherits("QAbstractPrintDialog") || modal->inherits("QColorDialog")
                         || modal->inherits("QFontDialog");
    const bool isTired =
        m_sinceModal > mostPatience || (m_sinceModal > patience && inSight(*modal).fresh.isEmpty());
    if (foreign || isTired) {
        note(QStringLiteral("close the dialog ") + identityOf(*modal));
        modal->close();
        return true;
    }
    return false;
}

void Monkey::answerFileDialog(QWidget* modal) {
    auto* dialog = qobject_cast<QFileDialog*>(modal);
    if (random(3) == 0) {
        note(QStringLiteral("cancel the file dialog"));
        dialog->reject();
        return;
    }
    const bool saving = dialog->acceptMode() == QFileDialog::AcceptSave;
    const QString path = saving && random(2) == 0
                             ? m_folder.filePath(QStringLiteral("own %1").arg(random(5)))
                             : m_files[random(int(m_files.size()))];
    note(QStringLiteral("file dialog: ") + path);
    dialog->setDirectory(m_folder.path());
    dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
    // Not accept(), which is the dialog's own; a question it asks is a dialog again.
    QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
    if (!QFileInfo::exists(path) && !saving) {
        QMetaObject::invokeMethod(dialog, "reject", Qt::QueuedConnection);
    }
}

void Monkey::closeOldPopup(QWidget* popup) {
    note(QStringLiteral("close ") + identityOf(*popup));
    popup->close();
}

void Monkey::useMenu() {
    QList<QAction*> usable;
    for (QMenu* menu : m_bench.window->findChild<QMenuBar*>()->findChildren<QMenu*>()) {
        emit menu->aboutToShow();
        for (QAction* action : menu->actions()) {
            if (action->isEnabled() && !action->menu() && !action->isSeparator()) {
                usable += action;
            }
        }
    }
    QList<QAction*> fresh;
    for (QAction* action : usable) {
        if (!m_usedActions.contains(action->text())) {
            fresh += action;
        }
    }
    const QList<QAction*>& from = !fresh.isEmpty() && random(8) != 0 ? fresh : usable;
    QAction* action = from[random(int(from.size()))];
    m_usedActions += action->text();
    note(QStringLiteral("menu: ") + action->text());
    action->trigger();
}

/// To the view or the page of the inputs that was gone to least.
void Monkey::turnPage() {
    MainWindow& window = *m_bench.window;
    auto* const inputs = window.findChild<InputsPanel*>();
    QStringList least;
    const auto offer = [&](const QString& page) {
        const int times = m_turnedTo.value(page);
        const int few = least.isEmpty() ? times : m_turnedTo.value(least.front());
        if (times < few) {
            least.clear();
        }
        if (times <= few) {
            least += page;
        }
    };
    for (const View* view : window.views()) {
        offer(view->objectName());
    }
    for (std::size_t i = 0; inputs->isVisible() && i < inputs->pages().size(); ++i) {
        offer(QString::number(i));
    }
    const QString page = least[random(int(least.size()))];
    ++m_turnedTo[page];
    note(QStringLiteral("turn to page ") + page);
    bool isInput = false;
    const int index = page.toInt(&isInput);
    if (isInput) {
        inputs->showPage(index);
    } else {
        static_cast<void>(window.showView(page));
    }
}

void Monkey::resizeWindow() {
    const QSize size(700 + random(900), 480 + random(500));
    note(QStringLiteral("resize to %1×%2").arg(size.width()).arg(size.height()));
    m_bench.window->resize(size);
}

// --- where --------------------------------------------------------------------------------------

QWidget* Monkey::place() {
    if (QWidget* popup = QApplication::activePopupWidget()) {
        return popup;
    }
    if (QWidget* modal = QApplication::activeModalWidget()) {
        return modal;
    }
    QList<QWidget*> windows{m_bench.window.get()};
    for (const View* view : m_bench.window->views()) {
        if (QWidget* own = m_bench.window->viewTabs().windowOf(view)) {
            windows += own;
        }
    }
    QWidget* window = windows[random(int(windows.size()))];
    window->activateWindow();
    return usable(*window) ? window : nullptr;
}

Monkey::InSight Monkey::inSight(QWidget& window) {
    InSight found;
    for (QWidget* widget : interactiveWidgets(window)) {
        if (usable(*widget) && widget->window() == window.window()) {
            found.all += widget;
            const QString identity = identityOf(*widget);
            m_seen += identity;
            if (!m_reached.contains(identity)) {
                found.fresh += widget;
            }
        }
    }
    return found;
}

/// Seven times of eight one that was not used before; where there is none, as often another page
/// first.
QWidget* Monkey::pick(QWidget& from) {
    InSight found = inSight(from);
    if (found.fresh.isEmpty() && &from == m_bench.window.get() && random(8) != 0) {
        turnPage();
        found = inSight(from);
    }
    if (!found.fresh.isEmpty() && random(8) != 0) {
        return found.fresh[random(int(found.fresh.size()))];
    }
    return found.all.isEmpty() ? &from : found.all[random(int(found.all.size()))];
}

QPoint Monkey::pointIn(const QWidget& widget) {
    return {random(widget.width()), random(widget.height())};
}

// --- what ---------------------------------------------------------------------------------------

void Monkey::useWidget(QWidget* widget) {
    for (QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(parent)) {
            area->ensureWidgetVisible(widget); // one cannot click what is not in sight
        }
    }
    m_reached += identityOf(*widget);
    switch (random(8)) {
    case 0: drag(widget); break;
    case 1: wheel(widget); break;
    case 2:
    case 3:
    case 4: keys(widget); break;
    default: click(widget); break;
    }
}

/// Of an item view the events go to its viewport, as the window system would have them go.
QWidget* targetOf(QWidget* widget) {
    auto* area = qobject_cast<QAbstractScrollArea*>(widget);
    return area && area->viewport() ? area->viewport() : widget;
}

void Monkey::click(QWidget* widget) {
    QWidget* target = targetOf(widget);
    const QPoint point = random(3) == 0 ? target->rect().center() : pointIn(*target);
    const int how = random(10);
    const Qt::KeyboardModifiers with = random(12) == 0 ? Qt::ShiftModifier : Qt::NoModifier;
    note(QStringLiteral("click %1 %2 %3,%4")
             .arg(how)
             .arg(identityOf(*widget))
             .arg(point.x())
             .arg(point.y()));
    if (how == 0) {
        QTest::mouseClick(target, Qt::RightButton, with, point);
        const QPointer<QWidget> still = target;
        QContextMenuEvent event(QContextMenuEvent::Mouse, point, target->mapToGlobal(point));
        if (still) {
            QCoreApplication::sendEvent(target, &event); // QTest sends none with the button
        }
    } else if (how < 3) {
        QTest::mouseDClick(target, Qt::LeftButton, with, point);
    } else {
        QTest::mouseClick(target, Qt::LeftButton, with, point);
    }
}

void Monkey::drag(QWidget* widget) {
    QWidget* target = targetOf(widget);
    const QPoint from = pointIn(*target);
    const QPoint to = pointIn(*target);
    note(QStringLiteral("drag %1 %2,%3 to %4,%5")
             .arg(identityOf(*widget))
             .arg(from.x())
             .arg(from.y())
             .arg(to.x())
             .arg(to.y()));
    const QPointer<QWidget> still = target;
    QTest::mousePress(target, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 3 && still; ++i) {
        QTest::mouseMove(target, from + (to - from) * i / 3);
    }
    if (still) {
        QTest::mouseRelease(target, Qt::LeftButton, {}, to);
    }
}

void Monkey::wheel(QWidget* widget) {
    QWidget* target = targetOf(widget);
    const QPoint point = pointIn(*target);
    const int turns = random(2) == 0 ? 120 : -120;
    note(QStringLiteral("wheel %1 %2").arg(turns).arg(identityOf(*widget)));
    QWheelEvent event(point, target->mapToGlobal(point), QPoint(), QPoint(0, turns), Qt::NoButton,
                      random(6) == 0 ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(target, &event);
}

void Monkey::keys(QWidget* widget) {
    static constexpr Qt::Key list[] = {
        Qt::Key_Tab,    Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Escape,   Qt::Key_Space,
        Qt::Key_Up,     Qt::Key_Down,    Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Home,
        Qt::Key_End,    Qt::Key_PageUp,  Qt::Key_Delete, Qt::Key_PageDown, Qt::Key_Backspace,
        Qt::Key_Insert, Qt::Key_F2,      Qt::Key_F6,     Qt::Key_F4,
    };
    static const QString texts = QStringLiteral("0123456789.,-+eE абвzй%µ");
    widget->setFocus(Qt::MouseFocusReason);
    const QPointer<QWidget> still = widget;
    const int count = 1 + random(3);
    for (int i = 0; i < count && still; ++i) {
        if (random(2) == 0) {
            const Qt::Key key = list[random(int(std::size(list)))];
            note(QStringLiteral("key %1 %2").arg(int(key), 0, 16).arg(identityOf(*widget)));
            QTest::keyClick(widget, key);
        } else {
            const QChar sign = texts[random(int(texts.size()))];
            note(QStringLiteral("type %1 %2").arg(sign).arg(identityOf(*widget)));
            QTest::sendKeyEvent(QTest::Click, widget, Qt::Key_unknown, QString(sign),
                                Qt::NoModifier);
        }
    }
}

void Monkey::shortcut() {
    static constexpr QKeyCombination list[] = {
        Qt::CTRL | Qt::Key_Z,    Qt::CTRL | Qt::Key_Z,   Qt::CTRL | Qt::Key_Y,
        Qt::CTRL | Qt::Key_C,    Qt::CTRL | Qt::Key_V,   Qt::CTRL | Qt::Key_A,
        Qt::CTRL | Qt::Key_X,    Qt::CTRL | Qt::Key_N,   Qt::CTRL | Qt::Key_S,
        Qt::ALT | Qt::Key_1,     Qt::ALT | Qt::Key_2,    Qt::ALT | Qt::Key_3,
        Qt::ALT | Qt::Key_4,     Qt::ALT | Qt::Key_5,    Qt::ALT | Qt::Key_6,
        Qt::CTRL | Qt::Key_1,    Qt::CTRL | Qt::Key_2,   Qt::CTRL | Qt::Key_3,
        Qt::ALT | Qt::Key_F,     Qt::SHIFT | Qt::Key_F6, Qt::CTRL | Qt::Key_Up,
        Qt::CTRL | Qt::Key_Down,
    };
    QWidget* focus = QApplication::focusWidget();
    QWidget* target = focus ? focus : m_bench.window.get();
    const QKeyCombination keys = list[random(int(std::size(list)))];
    note(QStringLiteral("shortcut ") + QKeySequence(keys).toString());
    QTest::keyClick(target, keys.key(), keys.keyboardModifiers());
}

} // namespace sparkout
