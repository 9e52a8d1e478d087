// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace sparkout {

struct Outcome;

/// The line at the bottom of the window: the end of the current run, and temporary messages.
class StatusLine : public QObject {
    Q_OBJECT

public:
    explicit StatusLine(QStatusBar& bar);

    /// Null: none yet. For refused inputs, `hasCurves` states whether curves of an earlier run are
    /// visible.
    void showOutcome(const Outcome* outcome, double lastRun_ms, bool hasCurves);
    void showForAWhile(const QString& text);
    void retranslate();

private:
    QStatusBar& m_bar;
    QLabel* m_status;
    QLabel* m_time;
};

} // namespace sparkout
