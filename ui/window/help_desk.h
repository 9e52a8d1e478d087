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
    /// What the help says of a widget; without a topic of its own, of the view in sight.
    [[nodiscard]] QString topicAt(const QWidget* widget) const;
    [[nodiscard]] HelpWindow* helpWindow() const { return m_help.get(); } ///< null: not yet opened

    /// Starts the tour when this user has not seen it yet, and nothing else waits for an answer.
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
