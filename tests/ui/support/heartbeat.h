// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QFile>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

namespace sparkout {

inline constexpr int beat_ms = 5;

/// A beat of the window's thread.
struct Beat {
    double at_ms = 0;   ///< since the first
    double gap_ms = 0;  ///< since the one before, without the waits for a processor
    double work_ms = 0; ///< of them, the processor time of the thread
};
using Beats = std::vector<Beat>;

/// Beats every 5 ms in the thread it is made in, and remembers how late it was.
class Heartbeat : public QObject {
public:
    Heartbeat() {
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, &Heartbeat::beat);
        m_all.start();
        m_clock.start();
        m_timer.start(beat_ms);
    }
    [[nodiscard]] Beats stop() {
        beat();
        m_timer.stop();
        return std::move(m_beats);
    }

private:
    /// What this thread has waited for a processor so far, in ms: a busy machine's doing. 0 where
    /// the kernel does not tell.
    static double waited_ms() {
        QFile file(QStringLiteral("/proc/thread-self/schedstat"));
        return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(1).toDouble() * 1e-6
                                              : 0;
    }
    static double worked_ms() {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
    }

    void beat() {
        const double gap_ms = double(m_clock.nsecsElapsed()) * 1e-6;
        const double waits_ms = waited_ms(), works_ms = worked_ms();
        m_clock.start();
        m_beats.push_back({double(m_all.nsecsElapsed()) * 1e-6,
                           std::max(0.0, gap_ms - (waits_ms - m_waited_ms)),
                           works_ms - m_worked_ms});
        m_waited_ms = waits_ms;
        m_worked_ms = works_ms;
    }

    QTimer m_timer;
    QElapsedTimer m_clock, m_all;
    double m_waited_ms = waited_ms(), m_worked_ms = worked_ms();
    Beats m_beats;
};

inline double worstGap_ms(const Beats& beats) {
    return std::ranges::max(beats, {}, &Beat::gap_ms).gap_ms;
}
inline double worstWork_ms(const Beats& beats) {
    return std::ranges::max(beats, {}, &Beat::work_ms).work_ms;
}

} // namespace sparkout
