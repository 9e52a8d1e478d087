// SPDX-License-Identifier: GPL-3.0-or-later
// A user without a plan: random mouse, key and wheel events at whatever is in sight, rather at what
// is new, and on to another page where nothing is.
#pragma once

#include "tests/ui/support/window_bench.h"

#include <QElapsedTimer>
#include <QFile>
#include <QHash>
#include <QPointer>
#include <QRandomGenerator>
#include <QSet>
#include <QTemporaryDir>

namespace sparkout {

/// Works from timers, so that it goes on inside the loops of modal dialogs. File dialogs are
/// answered with files of a temporary folder; nothing else of the disk is touched. A window that
/// was closed is opened again, as if the program was started anew.
class Monkey : public QObject {
    Q_OBJECT

public:
    Monkey(quint32 seed, int events, const QString& logFile);
    ~Monkey() override;

    /// Runs to the end or to the first trouble, which it gives; empty when there was none.
    [[nodiscard]] QString run();

    [[nodiscard]] int done() const { return m_done; }
    [[nodiscard]] qsizetype seen() const { return m_seen.size(); }
    [[nodiscard]] QStringList missed() const; ///< widgets that were in sight and got no event
    [[nodiscard]] int restarts() const { return m_restarts; }
    [[nodiscard]] int dialogs() const { return m_dialogs; }
    [[nodiscard]] MainWindow& window() { return *m_bench.window; }

private:
    void step();
    void later();
    void act();
    void openWindow();
    bool answerDialog(QWidget* modal);
    void answerFileDialog(QWidget* dialog);
    void closeOldPopup(QWidget* popup);
    void useMenu();
    void turnPage();
    void resizeWindow();
    void useWidget(QWidget* widget);
    void click(QWidget* widget);
    void drag(QWidget* widget);
    void wheel(QWidget* widget);
    void keys(QWidget* widget);
    void shortcut();
    void note(const QString& what);
    [[nodiscard]] QWidget* place();
    [[nodiscard]] QWidget* pick(QWidget& from);
    /// What can be used of a window, and what of it was not yet.
    struct InSight {
        QList<QWidget*> all, fresh;
    };
    [[nodiscard]] InSight inSight(QWidget& window);
    [[nodiscard]] QPoint pointIn(const QWidget& widget);
    [[nodiscard]] int random(int below) { return int(m_random.bounded(quint32(below))); }

    QRandomGenerator m_random;
    int m_events;
    int m_done = 0;
    int m_restarts = 0;
    int m_dialogs = 0;
    int m_depth = 0; ///< of loops within loops
    int m_sinceModal = 0;
    QPointer<QWidget> m_lastModal;
    QSet<QString> m_seen;
    QSet<QString> m_reached;
    QSet<QString> m_usedActions;    ///< of menus, by their names
    QHash<QString, int> m_turnedTo; ///< how often to which page
    QString m_trouble;
    QTemporaryDir m_folder;
    QStringList m_files;
    QFile m_log;
    QStringList m_lastNotes;
    WarningCatcher m_warnings;
    Bench m_bench;
};

} // namespace sparkout
