// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/view_tabs.h"

#include "ui/chart/view.h"
#include "ui/inputs/form_metrics.h"
#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDataStream>
#include <QFontMetrics>
#include <QMenu>
#include <QStyle>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

/// The window of a detached view, in which the commands of the main window work.
class ViewTabs::Window : public QWidget {
public:
    Window(ViewTabs& tabs, View* view) : QWidget(&tabs, Qt::Window), m_tabs(tabs), m_view(view) {
        setObjectName(view->objectName() + QStringLiteral("Window"));
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(view);
        for (QAction* action : tabs.window()->findChildren<QAction*>()) {
            if (!action->shortcut().isEmpty() && action->shortcutContext() == Qt::WindowShortcut) {
                addAction(action);
            }
        }
    }

    [[nodiscard]] View* view() const { return m_view; }

protected:
    void closeEvent(QCloseEvent* event) override {
        event->accept();
        m_tabs.attach(m_view);
    }

private:
    ViewTabs& m_tabs;
    View* m_view;
};

ViewTabs::ViewTabs(QWidget* parent) : QTabWidget(parent), m_tear(new QToolButton(this)) {
    setDocumentMode(true);
    setRelativeFont(*tabBar(), noteType); // eleven of them fit side by side
    m_tear->setObjectName(QStringLiteral("tear"));
    m_tear->setIcon(themeIcon(u"detach"));
    m_tear->setAutoRaise(true);
    m_tear->setFocusPolicy(Qt::TabFocus);
    setCornerWidget(m_tear);
    tabBar()->setContextMenuPolicy(Qt::CustomContextMenu);
    const auto detachAt = [this](int index) { detach(qobject_cast<View*>(widget(index))); };
    connect(m_tear, &QToolButton::clicked, this, [this, detachAt] { detachAt(currentIndex()); });
    connect(this, &QTabWidget::tabBarDoubleClicked, this, detachAt);
    connect(tabBar(), &QWidget::customContextMenuRequested, this, &ViewTabs::openMenu);
}

/// Uses a condensed font if not all tabs are visible, instead of changing their texts.
void ViewTabs::fitTabs() {
    constexpr int narrow = 90; // per cent
    const QTabBar& bar = *tabBar();
    QFont wide = bar.font();
    wide.setStretch(QFont::AnyStretch);
    const auto around = [this](const QWidget* tabs) {
        return style()->pixelMetric(QStyle::PM_TabBarTabHSpace, nullptr, tabs);
    };
    int need = count() * (around(nullptr) - around(&bar)); // in the normal font
    for (int i = 0; i < count(); ++i) {
        const QString text = tabText(i);
        need += bar.tabRect(i).width() + QFontMetrics(wide).horizontalAdvance(text)
                - bar.fontMetrics().horizontalAdvance(text);
    }
    const int room = width() - (cornerWidget() ? cornerWidget()->sizeHint().width() : 0);
    QFont font = wide;
    if (need > room) {
        font.setStretch(narrow);
    }
    if (bar.font() != font) {
        tabBar()->setFont(font);
    }
}

bool ViewTabs::event(QEvent* event) {
    const bool done = QTabWidget::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) {
        fitTabs();
    }
    return done;
}

ViewTabs::~ViewTabs() {
    for (Window* window : m_windows) {
        delete window;
    }
}

void ViewTabs::addView(View* view) {
    m_views.push_back(view);
    addTab(view, QString());
    showTexts();
}

ViewTabs::Window* ViewTabs::findWindow(const View* view) const {
    const auto found = std::ranges::find(m_windows, view, &Window::view);
    return found == m_windows.end() ? nullptr : *found;
}

QWidget* ViewTabs::windowOf(const View* view) const {
    return findWindow(view);
}

bool ViewTabs::isDetached(const View* view) const {
    return findWindow(view) != nullptr;
}

View* ViewTabs::currentView() const {
    for (const Window* window : m_windows) {
        if (window->isActiveWindow()) {
            return window->view();
        }
    }
    return qobject_cast<View*>(currentWidget());
}

void ViewTabs::showView(View* view) {
    if (isAway(view)) {
        return;
    }
    if (Window* window = findWindow(view)) {
        window->showNormal();
        window->raise();
        window->activateWindow();
    } else {
        setCurrentWidget(view);
        this->window()->activateWindow();
    }
}

void ViewTabs::detach(View* view) {
    if (!view || isDetached(view) || isAway(view) || !canDetach()) {
        return;
    }
    const QSize size = view->size();
    removeTab(indexOf(view));
    auto* window = new Window(*this, view);
    m_windows.push_back(window);
    showTexts();
    window->resize(size);
    view->show(); // a tab's page that is not current is hidden
    window->show();
    emit detachableChanged();
}

void ViewTabs::attach(View* view) {
    Window* window = findWindow(view);
    if (!window) {
        return;
    }
    std::erase(m_windows, window);
    insertTab(placeOf(view), view, QString());
    window->hide();
    window->deleteLater(); // it may be closing
    showTexts();
    setCurrentWidget(view);
    emit detachableChanged();
}

int ViewTabs::placeOf(const View* view) const {
    return static_cast<int>(std::ranges::count_if(
        m_views.begin(), std::ranges::find(m_views, view),
        [this](const View* other) { return !isDetached(other) && !isAway(other); }));
}

void ViewTabs::takeAway(View* view, bool away) {
    if (away == isAway(view)) {
        return;
    }
    if (away) {
        attach(view);
        m_away.insert(view);
        removeTab(indexOf(view));
        view->hide();
    } else {
        m_away.erase(view);
        insertTab(placeOf(view), view, QString());
    }
    showTexts();
    emit detachableChanged();
}

void ViewTabs::attachAll() {
    const QWidget* const current = currentWidget();
    while (!m_windows.empty()) {
        attach(m_windows.back()->view());
    }
    setCurrentIndex(indexOf(current));
}

void ViewTabs::openMenu(const QPoint& place) {
    auto* view = qobject_cast<View*>(widget(tabBar()->tabAt(place)));
    if (!view) {
        return;
    }
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* action = menu->addAction(themeIcon(u"detach"), tr("&Detach into a separate window"));
    action->setEnabled(canDetach());
    connect(action, &QAction::triggered, this, [this, view] { detach(view); });
    menu->popup(tabBar()->mapToGlobal(place));
}

void ViewTabs::showTexts() {
    m_tear->setEnabled(canDetach());
    m_tear->setToolTip(canDetach() ? tr("Detach the view into a separate window (also: double "
                                        "click on its tab). It returns when the window is closed.")
                                   : tr("The last view stays in the main window."));
    for (const View* view : m_views) {
        const int index = indexOf(view);
        if (index >= 0) {
            setTabText(index, view->brief());
            setTabToolTip(index, view->title());
        }
    }
    for (Window* window : m_windows) {
        window->setWindowTitle(tr("%1 — Sparkout").arg(window->view()->title()));
        window->setAccessibleName(window->view()->title());
    }
}

void ViewTabs::retranslate() {
    setAccessibleName(tr("Views"));
    tabBar()->setAccessibleName(tr("Views"));
    m_tear->setAccessibleName(tr("Detach the view"));
    showTexts();
}

// --- state --------------------------------------------------------------------------------------

QByteArray ViewTabs::saveState() const {
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream << (currentWidget() ? currentWidget()->objectName() : QString());
    QMap<QString, QByteArray> torn;
    for (const Window* window : m_windows) {
        torn.insert(window->view()->objectName(), window->saveGeometry());
    }
    stream << torn;
    return state;
}

bool ViewTabs::restoreState(const QByteArray& state) {
    QDataStream stream(state);
    QString current;
    QMap<QString, QByteArray> torn;
    stream >> current >> torn;
    if (stream.status() != QDataStream::Ok) {
        return false;
    }
    attachAll();
    for (View* view : m_views) {
        const auto place = torn.constFind(view->objectName());
        if (place != torn.cend()) {
            detach(view);
            if (QWidget* window = windowOf(view)) {
                window->restoreGeometry(*place);
                QTimer::singleShot(0, window, &QWidget::raise); // after the main window
            }
        }
    }
    for (View* view : m_views) {
        if (view->objectName() == current && indexOf(view) >= 0) {
            setCurrentWidget(view);
        }
    }
    return true;
}

} // namespace sparkout
