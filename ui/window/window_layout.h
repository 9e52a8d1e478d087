// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;
class QWidget;

namespace sparkout {

class MessagesDock;
class InputsPanel;
class MessagesPanel;
class PanelWidths;
class PlaybackBar;
class Settings;
class ViewTabs;

/// Where the panels and views of the window stand, and how that is kept from one start to the next.
class WindowLayout : public QObject {
    Q_OBJECT

public:
    /// What stands in the panels beside the views.
    struct Panels {
        InputsPanel* inputs;
        QWidget* verdict;
        MessagesPanel* messages;
        QWidget* sheet;
    };
    WindowLayout(QMainWindow& window, const Panels& panels, ViewTabs& tabs, PlaybackBar& playback,
                 Settings& settings);
    ~WindowLayout() override; ///< with the panels that look at the document and the cycle

    [[nodiscard]] QList<QAction*> toggles() const; ///< that show the panels
    void showInputs();
    void restore(); ///< as it was when the window was closed last
    void save() const;
    void reset();
    void fitPanels(); ///< beside the views, to the width that they need
    void movePanel(int by);
    void retranslate();

private:
    QDockWidget* addDock(QWidget* content, const QString& name, Qt::DockWidgetArea area);

    QMainWindow& m_window;
    ViewTabs& m_tabs;
    PlaybackBar& m_playback;
    Settings& m_settings;
    InputsPanel& m_inputs;
    QDockWidget* m_inputsDock;
    QDockWidget* m_verdictDock;
    QDockWidget* m_messagesDock;
    QDockWidget* m_sheetDock;
    PanelWidths* m_widths;
    MessagesDock* m_messages;
};

} // namespace sparkout
