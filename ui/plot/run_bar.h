// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstdint>
#include <initializer_list>

class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

class Job;

/// The row of a view that runs many cycles: buttons to run and to stop them, what was run and,
/// meanwhile, how far it is and how long it will take; beside them what the view adds.
class RunBar : public QWidget {
    Q_OBJECT
public:
    /// Texts of counted parts; left_s below 0: not known yet.
    using Progress = QString (*)(qint64 done, qint64 parts, double left_s);

    /// The name is the beginning of those of its parts.
    RunBar(const QString& name, QWidget* parent, Progress text = nullptr);

    /// Once: what stands before the text and behind it, which has a line to itself unless it is at
    /// least so many letters wide.
    void layOut(std::initializer_list<QWidget*> before, std::initializer_list<QWidget*> behind,
                int letters = 0);
    /// A count of what is done with the time that the rest will take, once that is known.
    [[nodiscard]] static QString withTimeLeft(const QString& count, double left_s);
    /// Whether so many runs, each of so many radii, take about two seconds of one processor at
    /// most: they run by themselves.
    [[nodiscard]] static bool areQuick(std::int64_t runs, std::int64_t radii);
    void takeTurns() { m_turns = true; } ///< the two buttons, in one place
    /// Shows the progress of work whose parts are counted, and stops it.
    void follow(Job& job);
    void showProgress(qint64 done, qint64 parts, double left_s = -1);
    void showProgress(double share, const QString& text);
    void showRunning(bool runs, bool mayRun);

    [[nodiscard]] QPushButton* run() const { return m_run; }
    [[nodiscard]] QPushButton* stop() const { return m_stop; }
    [[nodiscard]] QLabel* state() const { return m_state; } ///< what was run
    [[nodiscard]] QProgressBar* progress() const { return m_progress; }

private:
    Progress m_text;
    QPushButton* m_run;
    QPushButton* m_stop;
    QLabel* m_state;
    QProgressBar* m_progress;
    bool m_turns = false;
};

} // namespace sparkout
