// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/keyboard.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QSet>

#include <utility>

namespace sparkout {

namespace {

constexpr const char* tipProperty = "sparkoutTip"; ///< the tooltip nameShortcut() made

/// A text without its mnemonic; literal ampersands stay doubled.
QString withoutMnemonic(QString text) {
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != u'&') {
            continue;
        }
        if (text[i + 1] == u'&') {
            ++i;
        } else {
            text.remove(i, 1);
        }
    }
    return text;
}

/// The possible places of a mnemonic: first letters of words before all others.
QList<qsizetype> places(const QString& text) {
    QList<qsizetype> first;
    QList<qsizetype> other;
    for (qsizetype i = 0; i < text.size() && text[i] != u'\t'; ++i) {
        if (text[i].isLetterOrNumber()) {
            const bool starts = i == 0 || !text[i - 1].isLetterOrNumber();
            (starts ? first : other) += i;
        }
    }
    return first + other;
}

bool takesFocus(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && !widget.focusProxy()
           && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

QWidget* firstIn(QWidget& panel) {
    if (takesFocus(panel)) {
        return &panel;
    }
    for (QWidget* widget = panel.nextInFocusChain(); widget != &panel;
         widget = widget->nextInFocusChain()) {
        if (panel.isAncestorOf(widget) && takesFocus(*widget)) {
            return widget;
        }
    }
    return nullptr;
}

} // namespace

QChar mnemonicOf(const QString& text) {
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == u'&') {
            if (text[i + 1] != u'&') {
                return text[i + 1].toUpper();
            }
            ++i;
        }
    }
    return {};
}

void assignMnemonics(const QList<QAction*>& entries) {
    QSet<QChar> taken;
    QList<QAction*> without;
    for (QAction* entry : entries) {
        if (entry->isSeparator() || !entry->isVisible() || entry->text().isEmpty()) {
            continue;
        }
        const QChar wanted = mnemonicOf(entry->text());
        if (wanted.isNull() || taken.contains(wanted)) {
            without += entry;
        } else {
            taken += wanted;
        }
    }
    for (QAction* entry : without) {
        QString text = withoutMnemonic(entry->text());
        for (const qsizetype place : places(text)) {
            if (const QChar letter = text[place].toUpper(); !taken.contains(letter)) {
                taken += letter;
                entry->setText(text.insert(place, u'&'));
                break;
            }
        }
    }
}

void keepMnemonics(QWidget& window) {
    for (const QMenuBar* bar : window.findChildren<QMenuBar*>()) {
        assignMnemonics(bar->actions());
    }
    for (QMenu* menu : window.findChildren<QMenu*>()) {
        QObject::connect(menu, &QMenu::aboutToShow, menu,
                         [menu] { assignMnemonics(menu->actions()); });
    }
}

void nameShortcut(QAction& action) {
    if (action.property(tipProperty).toString() == action.toolTip()) {
        action.setToolTip(QString()); // it then falls back to the translated text
    }
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty() && !action.text().isEmpty()) {
        action.setToolTip(QStringLiteral("%1 (%2)").arg(action.toolTip(), keys));
        action.setProperty(tipProperty, action.toolTip());
    }
}

void nameShortcuts(QObject& owner) {
    for (QAction* action : owner.findChildren<QAction*>()) {
        nameShortcut(*action);
    }
}

void movePanel(const QList<QWidget*>& panels, int by) {
    const QWidget* const focus = QApplication::focusWidget();
    qsizetype at = by > 0 ? -1 : 0;
    for (qsizetype i = 0; i < panels.size(); ++i) {
        if (focus && (panels[i] == focus || panels[i]->isAncestorOf(focus))) {
            at = i;
        }
    }
    for (qsizetype step = 0; step < panels.size(); ++step) {
        at = (at + by + panels.size()) % panels.size();
        QWidget& panel = *panels[at];
        QWidget* target = panel.focusWidget();
        if (!target || !takesFocus(*target) || !panel.isAncestorOf(target)) {
            target = firstIn(panel);
        }
        if (panel.isVisible() && target) {
            panel.window()->activateWindow();
            target->setFocus(by > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
            FocusFrame::showRound(*target);
            return;
        }
    }
}

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
