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

/// The bar of a view that runs many cycles: buttons to run and stop, a text on the results or on
/// the progress and remaining time, and the view's own parts.
class RunBar : public QWidget {
    Q_OBJECT
public:
    /// Text for a number of parts; left_s is negative while unknown.
    using Progress = QString (*)(qint64 done, qint64 parts, double left_s);

    /// `name` is the prefix of the names of its parts.
    RunBar(const QString& name, QWidget* parent, Progress text = nullptr);

    /// Call once: sets the widgets before and behind the text. The text takes a line of its own
    /// unless it has room for so many letters.
    void layOut(std::initializer_list<QWidget*> before, std::initializer_list<QWidget*> behind,
                int letters = 0);
    /// A count of finished parts with the remaining time, if known.
    [[nodiscard]] static QString withTimeLeft(const QString& count, double left_s);
    /// Whether so many runs with so many radii each take at most about two seconds of one
    /// processor, so that they may start automatically.
    [[nodiscard]] static bool areQuick(std::int64_t runs, std::int64_t radii);
    void takeTurns() { m_turns = true; } ///< shows one of the two buttons at a time
    /// Shows the progress of a job whose parts are counted, and stops it.
    void follow(Job& job);
    void showProgress(qint64 done, qint64 parts, double left_s = -1);
    void showProgress(double share, const QString& text);
    void showRunning(bool runs, bool mayRun);

    [[nodiscard]] QPushButton* run() const { return m_run; }
    [[nodiscard]] QPushButton* stop() const { return m_stop; }
    [[nodiscard]] QLabel* state() const { return m_state; } ///< text on the results
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
