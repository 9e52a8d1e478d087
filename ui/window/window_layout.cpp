// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_layout.h"

#include "ui/chart/view.h"
#include "ui/inputs/messages_panel.h"
#include "ui/kit/font_size.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/sealed_state.h"
#include "ui/kit/theme_icon.h"
#include "ui/session/settings.h"
#include "ui/window/playback_bar.h"
#include "ui/window/view_tabs.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QDataStream>
#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>
#include <QHash>
#include <QIODevice>
#include <QList>
#include <QMainWindow>
#include <QObject>
#include <QScreen>
#include <QStatusBar>
#include <QStringList>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <utility>
#include <vector>

class QDockWidget;
class QMainWindow;

namespace sparkout {

/// Keeps the panels beside the views at their wanted widths. A wide view, a narrow window or a
/// large font may narrow them until there is space again; a large font may also widen them
/// temporarily. The wanted width is set by the program or by dragging a separator; the program may
/// set a greater one for a wide window.
class PanelWidths : public QObject {
    Q_DECLARE_TR_FUNCTIONS(sparkout::PanelWidths)
public:
    PanelWidths(QMainWindow& window, QList<QDockWidget*> panels);

    void want(QDockWidget* panel, int width); ///< now, or when there is space
    /// Sets a greater width for a wide window, until the user drags the panel.
    void wantInWideWindow(QDockWidget* panel, int width);
    /// Takes the widths of a restored layout as the wanted ones.
    void takeOverWhenShown();

    [[nodiscard]] QByteArray saveState() const;
    bool restoreState(const QByteArray& state); ///< false and unchanged if the state is invalid

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void restore();
    void takeOver(QDockWidget* panel); ///< takes its current width as the wanted one
    void takeOverDragged();
    [[nodiscard]] bool stands(const QDockWidget& panel) const; ///< visible beside the views
    [[nodiscard]] int wanted(const QDockWidget* panel) const;  ///< for the current window
    [[nodiscard]] std::vector<int> widths() const;

    QMainWindow& m_window;
    QList<QDockWidget*> m_panels;
    QHash<const QDockWidget*, int> m_wanted;
    QHash<const QDockWidget*, int> m_wantedWide; ///< 0: as in any window
    QTimer m_later;                              ///< after the layout
    QHash<const QDockWidget*, int> m_pressed;    ///< widths when the mouse button was pressed
    std::vector<int> m_tried;                    ///< result of the last attempt
    bool m_dragging = false;
    bool m_released = false; ///< the separator, after it was dragged
    bool m_restored = false; ///< layout to take over when visible
};

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

namespace {

constexpr int dragged_ms = 200; ///< interval of checking for the end of a drag
constexpr QSize usualWindow(1366, 768);
constexpr QSize frameAllowance(8, 40);
constexpr int verdictWidth = 310;
constexpr int wideVerdictWidth = 450;  ///< in a wide window: no name of a requirement wraps
constexpr int leastVerdictWidth = 292; ///< for smaller fonts: frames and gaps do not shrink
constexpr int messagesHeight = 96;

/// Names the buttons that Qt adds, which it names once in one language, or not at all.
void nameQtButtons(const QWidget& window) {
    const auto name = [&window](const char* object, const QString& text) {
        for (auto* button : window.findChildren<QAbstractButton*>(QString::fromLatin1(object))) {
            button->setAccessibleName(text);
            button->setAccessibleDescription(text);
            button->setToolTip(text);
        }
    };
    name("qt_dockwidget_floatbutton", WindowLayout::tr("Detach or attach the panel"));
    name("qt_dockwidget_closebutton", WindowLayout::tr("Close the panel"));
    name("qt_toolbar_ext_button", WindowLayout::tr("More commands"));
    name("qt_menubar_ext_button", WindowLayout::tr("More menus"));
    name("ScrollLeftButton", WindowLayout::tr("Scroll to the left"));
    name("ScrollRightButton", WindowLayout::tr("Scroll to the right"));
}

} // namespace

/// The panel of messages: it opens by itself with a new message and closes with the last one. A
/// button in the status bar shows their number.
class MessagesDock : public QObject {
    Q_DECLARE_TR_FUNCTIONS(sparkout::MessagesDock)

public:
    MessagesDock(QDockWidget& dock, MessagesPanel& panel, QStatusBar& bar);

    void showOrHide(); ///< according to the current messages
    void retranslate();

private:
    void follow(); ///< the messages are others

    QDockWidget& m_dock;
    MessagesPanel& m_panel;
    QToolButton* m_button;
    QTimer m_later;     ///< delays it during a drag
    QStringList m_seen; ///< inputs
};

MessagesDock::MessagesDock(QDockWidget& dock, MessagesPanel& panel, QStatusBar& bar)
    : QObject(&dock), m_dock(dock), m_panel(panel), m_button(new QToolButton(&bar)) {
    m_button->setObjectName(QStringLiteral("messagesButton"));
    m_button->setAutoRaise(true);
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar.addPermanentWidget(m_button);
    connect(m_button, &QToolButton::clicked, this,
            [this] { m_dock.setVisible(!m_dock.isVisible()); });
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, &MessagesDock::follow);
    connect(&m_panel, &MessagesPanel::messagesChanged, this, [this] {
        retranslate();
        m_later.start(0);
    });
}

/// The views do not resize while a slider is dragged.
void MessagesDock::follow() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        m_later.start(dragged_ms);
        return;
    }
    const QStringList paths = m_panel.paths();
    const bool isNew =
        std::ranges::any_of(paths, [this](const QString& path) { return !m_seen.contains(path); });
    if (isNew || (paths.isEmpty() && !m_seen.isEmpty())) {
        m_dock.setVisible(isNew);
    }
    m_seen = paths;
}

void MessagesDock::showOrHide() {
    m_later.stop();
    m_seen = m_panel.paths();
    m_dock.setVisible(!m_seen.isEmpty());
}

void MessagesDock::retranslate() {
    const auto count = static_cast<int>(m_panel.paths().size());
    m_button->setText(count == 0 ? tr("No messages") : tr("%n message(s)", nullptr, count));
    m_button->setIcon(markIcon(m_panel.worst()));
    m_button->setToolTip(tr("Show or hide the messages"));
    m_button->setAccessibleName(m_button->text());
}

WindowLayout::WindowLayout(QMainWindow& window, const Panels& panels, ViewTabs& tabs,
                           PlaybackBar& playback, Settings& settings)
    : QObject(&window)
    , m_window(window)
    , m_tabs(tabs)
    , m_playback(playback)
    , m_settings(settings)
    , m_inputsDock(addDock(panels.inputs, QStringLiteral("inputs"), Qt::LeftDockWidgetArea))
    , m_verdictDock(addDock(panels.verdict, QStringLiteral("verdict"), Qt::RightDockWidgetArea))
    , m_messagesDock(addDock(panels.messages, QStringLiteral("messages"), Qt::BottomDockWidgetArea))
    , m_sheetDock(addDock(panels.sheet, QStringLiteral("step"), Qt::RightDockWidgetArea))
    , m_lessonDock(addDock(panels.lesson, QStringLiteral("lesson"), Qt::RightDockWidgetArea))
    , m_widths(new PanelWidths(window, {m_inputsDock, m_verdictDock}))
    , m_messages(new MessagesDock(*m_messagesDock, *panels.messages, *window.statusBar())) {
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_lessonDock->hide();
    m_lessonDock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    m_lessonDock->toggleViewAction()->setVisible(false);
    for (QDockWidget* dock : {m_verdictDock, m_messagesDock, m_sheetDock}) {
        dock->installEventFilter(this);
    }
    QAction* const sheet = m_sheetDock->toggleViewAction();
    sheet->setIcon(themeIcon(u"formula"));
    m_playback.addTool(sheet);
    connect(sheet, &QAction::triggered, this, [this](bool shown) {
        if (shown) { // below the verdict, unless it was moved
            m_window.resizeDocks({m_verdictDock, m_sheetDock}, {2, 3}, Qt::Vertical);
        }
    });
}

WindowLayout::~WindowLayout() {
    delete m_inputsDock;
    delete m_sheetDock;
    delete m_lessonDock;
}

QDockWidget* WindowLayout::addDock(QWidget* content, const QString& name, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(&m_window);
    dock->setObjectName(name);
    setRelativeFont(*dock, 1); // its title does not follow the program's font by itself
    dock->setWidget(content);
    m_window.addDockWidget(area, dock);
    return dock;
}

QList<QAction*> WindowLayout::toggles() const {
    return {m_inputsDock->toggleViewAction(), m_verdictDock->toggleViewAction(),
            m_messagesDock->toggleViewAction(), m_sheetDock->toggleViewAction()};
}

void WindowLayout::showInputs() {
    m_inputsDock->show();
}

QDockWidget* WindowLayout::dockOf(Panel panel) const {
    return panel == Panel::verdict    ? m_verdictDock
           : panel == Panel::messages ? m_messagesDock
                                      : m_sheetDock;
}

void WindowLayout::takeAway(Panel panel, bool away) {
    QDockWidget* const dock = dockOf(panel);
    QAction* const toggle = dock->toggleViewAction();
    if (away && !m_away.contains(dock)) {
        m_away.insert(dock, !dock->isHidden());
        dock->hide();
    } else if (!away && m_away.contains(dock)) {
        const bool wasShown = m_away.take(dock);
        dock->setVisible(wasShown);
    }
    toggle->setVisible(!away);
    toggle->setEnabled(!away);
    if (panel == Panel::messages) {
        if (auto* button =
                m_window.statusBar()->findChild<QWidget*>(QStringLiteral("messagesButton"))) {
            button->setVisible(!away);
        }
    }
}

void WindowLayout::showLesson(bool shown) {
    if (shown && !m_beforeLesson) {
        m_beforeLesson = m_window.saveState();
        m_verdictDock->setFloating(false);
        m_window.addDockWidget(Qt::RightDockWidgetArea, m_verdictDock);
        m_window.tabifyDockWidget(m_verdictDock, m_lessonDock);
        m_lessonDock->setFloating(false);
        m_lessonDock->show();
        m_lessonDock->raise();
    } else if (!shown && m_beforeLesson) {
        const QByteArray before = *std::exchange(m_beforeLesson, std::nullopt);
        m_window.restoreState(before);
        m_lessonDock->hide();
    }
}

void WindowLayout::reset() {
    m_tabs.attachAll();
    for (QDockWidget* dock : {m_inputsDock, m_verdictDock, m_messagesDock, m_sheetDock}) {
        dock->setFloating(false);
        dock->setVisible(dock != m_sheetDock);
    }
    m_messages->showOrHide();
    m_window.addDockWidget(Qt::LeftDockWidgetArea, m_inputsDock);
    m_window.addDockWidget(Qt::RightDockWidgetArea, m_verdictDock);
    m_window.addDockWidget(Qt::BottomDockWidgetArea, m_messagesDock);
    m_window.splitDockWidget(m_verdictDock, m_sheetDock, Qt::Vertical);
    if (m_beforeLesson) {
        m_window.tabifyDockWidget(m_verdictDock, m_lessonDock);
        m_lessonDock->setFloating(false);
        m_lessonDock->show();
        m_lessonDock->raise();
    }
    for (auto dock = m_away.keyBegin(); dock != m_away.keyEnd(); ++dock) {
        (*dock)->hide();
    }
    fitPanels();
    m_window.resizeDocks({m_messagesDock}, {messagesHeight}, Qt::Vertical);
}

/// Keeps hidden panels hidden, whoever shows them.
bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
    auto* dock = qobject_cast<QDockWidget*>(watched);
    if (event->type() == QEvent::Show && dock && m_away.contains(dock)) {
        QMetaObject::invokeMethod(dock, &QWidget::hide, Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
}

void WindowLayout::fitPanels() {
    m_widths->want(m_inputsDock, 0); // as narrow as possible, in any font and language
    m_widths->want(m_verdictDock, std::max(atFontSize(verdictWidth), leastVerdictWidth));
    m_widths->wantInWideWindow(m_verdictDock, atFontSize(wideVerdictWidth));
}

void WindowLayout::restore() {
    // Leaves space for frame and title bar: the status bar must be visible on a small screen.
    m_window.resize(usualWindow.boundedTo(m_window.screen()->availableSize() - frameAllowance));
    reset();
    if (const auto parts = unsealed(m_settings.windowGeometry(), 1)) {
        m_window.restoreGeometry(parts->front());
    }
    auto parts = unsealed(m_settings.windowState(), 3);
    if (!parts) { // an earlier version, without wanted widths
        parts = unsealed(m_settings.windowState(), 2);
    }
    if (parts) {
        m_window.restoreState(parts->front());
        m_tabs.restoreState(parts->at(1));
        if (parts->size() < 3 || !m_widths->restoreState(parts->back())) {
            m_widths->takeOverWhenShown();
        }
    }
    m_lessonDock->hide();
    m_messages->showOrHide(); // none yet
}

void WindowLayout::save() const {
    m_settings.setWindow(sealed({m_window.saveGeometry()}),
                         sealed({m_beforeLesson.value_or(m_window.saveState()), m_tabs.saveState(),
                                 m_widths->saveState()}));
}

void WindowLayout::movePanel(int by) {
    QList<QWidget*> panels{m_inputsDock->widget(), &m_tabs};
    for (const View* view : m_tabs.views()) {
        if (QWidget* window = m_tabs.windowOf(view)) {
            panels += window;
        }
    }
    panels << &m_playback;
    for (const QDockWidget* dock : {m_lessonDock, m_verdictDock, m_sheetDock, m_messagesDock}) {
        panels << dock->widget();
    }
    sparkout::movePanel(panels, by);
}

void WindowLayout::retranslate() {
    m_inputsDock->setWindowTitle(tr("Inputs"));
    m_verdictDock->setWindowTitle(tr("Verdict"));
    m_messagesDock->setWindowTitle(tr("Messages"));
    m_sheetDock->setWindowTitle(tr("Formulas of the step"));
    m_lessonDock->setWindowTitle(tr("Laboratory work"));
    m_inputsDock->widget()->setAccessibleName(tr("Inputs"));
    m_messages->retranslate();
    nameQtButtons(m_window);
}

} // namespace sparkout
