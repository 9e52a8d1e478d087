// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <memory>

class QMainWindow;
class QWidget;

namespace sparkout {

class Actions;
class HelpWindow;
class InputsPanel;
class Settings;
class Tour;
class ViewTabs;

/// The commands of the Help menu, and F1 in every window of the program.
class HelpDesk : public QObject {
    Q_OBJECT

public:
    HelpDesk(QMainWindow& window, Settings& settings, InputsPanel& inputs, ViewTabs& tabs,
             Actions& actions);
    ~HelpDesk() override;

    void open(const QString& topic); ///< "feeds#mouse"
    /// The help topic of a widget; without one, that of the current view.
    [[nodiscard]] QString topicAt(const QWidget* widget) const;
    [[nodiscard]] HelpWindow* helpWindow() const { return m_help.get(); } ///< null: not opened yet

    /// Starts the tour if this user has not seen it and no dialog is open.
    void offerTour();
    [[nodiscard]] Tour& tour() const { return *m_tour; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectActions(Actions& actions);
    void startTour();
    void showLog();
    [[nodiscard]] HelpWindow* make(QWidget* parent);

    QMainWindow& m_window;
    Settings& m_settings;
    ViewTabs& m_tabs;
    Tour* m_tour;
    std::unique_ptr<HelpWindow> m_help;
};

} // namespace sparkout
