// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QPointer>
#include <QTabWidget>

#include <set>
#include <vector>

class QToolButton;

namespace sparkout {

class View;

/// The views as tabs. A tab can be detached into a window (button, double click on the tab, its
/// context menu), and returns to its place when that window is closed. The last tab stays.
class ViewTabs : public QTabWidget {
    Q_OBJECT

public:
    explicit ViewTabs(QWidget* parent = nullptr);
    ~ViewTabs() override;

    void addView(View* view);
    [[nodiscard]] const std::vector<View*>& views() const { return m_views; } ///< in order
    [[nodiscard]] View* currentView() const; ///< of the active window, otherwise of the current tab
    [[nodiscard]] bool isDetached(const View* view) const;
    [[nodiscard]] bool canDetach() const { return count() > 1; }
    [[nodiscard]] QWidget* windowOf(const View* view) const; ///< its own window, or null

    void showView(View* view); ///< raises its tab or its window, unless it is hidden
    /// Hides a view, without a tab or a window, or shows it again.
    void takeAway(View* view, bool away);
    [[nodiscard]] bool isAway(const View* view) const { return m_away.contains(view); }
    void detach(View* view);
    void attach(View* view);
    void attachAll();
    void retranslate();

    [[nodiscard]] QByteArray saveState() const; ///< current tab, detached views and their places
    bool restoreState(const QByteArray& state); ///< false and unchanged if the state is invalid

signals:
    void detachableChanged();

protected:
    bool event(QEvent* event) override;

private:
    class Window;

    [[nodiscard]] Window* findWindow(const View* view) const;
    [[nodiscard]] int placeOf(const View* view) const; ///< index of its tab among the existing ones
    void openMenu(const QPoint& place);
    void showTexts();
    void fitTabs();

    std::vector<View*> m_views;
    std::vector<Window*> m_windows;
    std::set<const View*> m_away;
    QToolButton* m_tear;
};

} // namespace sparkout
