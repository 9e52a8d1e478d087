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

/// Keeps the panels beside the views at their wanted widths. A wide view, a narrow window or a
/// large font may narrow them until there is space again; a large font may also widen them
/// temporarily. The wanted width is set by the program or by dragging a separator; the program may
/// set a greater one for a wide window.
class PanelWidths : public QObject {
    Q_OBJECT
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

} // namespace sparkout
