// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QTimer>

#include <vector>

class QDockWidget;
class QMainWindow;

namespace sparkout {

/// Keeps the panels beside the views as wide as they were wanted. A view that needs much room, a
/// narrow window or large type may press them; when there is room again they take it back. Large
/// type may also make them wider than that; with smaller type they give it back. Wanted is what the
/// program sets, and what the user drags a separator to; the program may want more in a wide
/// window.
class PanelWidths : public QObject {
    Q_OBJECT
public:
    PanelWidths(QMainWindow& window, QList<QDockWidget*> panels);

    void want(QDockWidget* panel, int width); ///< now, or when there is room
    /// More in a window that is wide, until the user drags it to a width of his own.
    void wantInWideWindow(QDockWidget* panel, int width);
    /// What they have in a layout that was restored is what is wanted.
    void takeOverWhenShown();

    [[nodiscard]] QByteArray saveState() const;
    bool restoreState(const QByteArray& state); ///< false, and nothing changed: it is none

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void restore();
    void takeOver(QDockWidget* panel); ///< what it has is what is wanted
    void takeOverDragged();
    [[nodiscard]] bool stands(const QDockWidget& panel) const; ///< beside the views, in sight
    [[nodiscard]] int wanted(const QDockWidget* panel) const;  ///< in the window as it is
    [[nodiscard]] std::vector<int> widths() const;

    QMainWindow& m_window;
    QList<QDockWidget*> m_panels;
    QHash<const QDockWidget*, int> m_wanted;
    QHash<const QDockWidget*, int> m_wantedWide; ///< 0: as in any window
    QTimer m_later;                              ///< when the layout has been made
    QHash<const QDockWidget*, int> m_pressed;    ///< widths when the mouse button went down
    std::vector<int> m_tried;                    ///< what was found when it was tried last
    bool m_dragging = false;
    bool m_released = false; ///< the separator, after it was dragged
    bool m_restored = false; ///< the layout; it is taken over when it is in sight
};

} // namespace sparkout
