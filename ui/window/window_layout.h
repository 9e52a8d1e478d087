// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QHash>
#include <QObject>

#include <optional>

class QAction;
class QDockWidget;
class QMainWindow;
class QWidget;

namespace sparkout {

class MessagesDock;
class MessagesPanel;
class PanelWidths;
class PlaybackBar;
class Settings;
class ViewTabs;

/// The arrangement of panels and views in the window, kept between starts.
class WindowLayout : public QObject {
    Q_OBJECT

public:
    /// The contents of the panels beside the views.
    struct Panels {
        QWidget* inputs;
        QWidget* verdict;
        MessagesPanel* messages;
        QWidget* sheet;
        QWidget* lesson;
    };
    WindowLayout(QMainWindow& window, const Panels& panels, ViewTabs& tabs, PlaybackBar& playback,
                 Settings& settings);
    ~WindowLayout() override; ///< deletes the panels that use document and cycle

    [[nodiscard]] QList<QAction*> toggles() const; ///< for showing the panels
    void showInputs();
    /// Shows the panel of a lesson, or restores the layout before it.
    void showLesson(bool shown);
    enum class Panel { verdict, messages, sheet };
    void takeAway(Panel panel, bool away); ///< hides it in every layout
    void restore();                        ///< from the last time the window was closed
    void save() const;
    void reset();
    void fitPanels(); ///< to their wanted widths beside the views
    void movePanel(int by);
    void retranslate();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QDockWidget* dockOf(Panel panel) const;
    QDockWidget* addDock(QWidget* content, const QString& name, Qt::DockWidgetArea area);

    QMainWindow& m_window;
    ViewTabs& m_tabs;
    PlaybackBar& m_playback;
    Settings& m_settings;
    QDockWidget* m_inputsDock;
    QDockWidget* m_verdictDock;
    QDockWidget* m_messagesDock;
    QDockWidget* m_sheetDock;
    QDockWidget* m_lessonDock;
    QHash<QDockWidget*, bool> m_away;         ///< with whether they were visible
    std::optional<QByteArray> m_beforeLesson; ///< the state of the window
    PanelWidths* m_widths;
    MessagesDock* m_messages;
};

} // namespace sparkout
