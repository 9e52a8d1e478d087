// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace sparkout {

struct Outcome;

/// The line at the foot of the window: how the present run ended, and for some seconds what was
/// done.
class StatusLine : public QObject {
    Q_OBJECT

public:
    explicit StatusLine(QStatusBar& bar);

    /// Null: none yet. Of refused inputs, whether the curves of a run before them are in sight.
    void showOutcome(const Outcome* outcome, double lastRun_ms, bool hasCurves);
    void showForAWhile(const QString& text);
    void retranslate();

private:
    QStatusBar& m_bar;
    QLabel* m_status;
    QLabel* m_time;
};

} // namespace sparkout
