// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>

#include <deque>
#include <mutex>
#include <vector>

namespace sparkout {

/// Something the program or Qt reported.
struct LogLine {
    QDateTime when;
    QtMsgType type = QtInfoMsg;
    QString text;
};

/// What was reported since it was made, of every thread, the newest lines only. As long as it
/// lives it receives Qt's messages, which still go where they went before. There is one at a time.
class ProgramLog : public QObject {
    Q_OBJECT

public:
    ProgramLog();
    ~ProgramLog() override;

    /// Adds a line to the log there is, if there is one; any thread.
    static void note(const QString& text);
    [[nodiscard]] static ProgramLog* current(); ///< null when there is none

    [[nodiscard]] std::vector<LogLine> lines() const; ///< oldest first
    [[nodiscard]] long long dropped() const;          ///< lines that gave way to newer ones

    static constexpr std::size_t mostLines = 1000;
    static constexpr qsizetype longestLine = 2000; ///< characters; the rest is cut off

signals:
    void changed(); ///< maybe from another thread

private:
    void add(QtMsgType type, const QString& text);
    static void receive(QtMsgType type, const QMessageLogContext& context, const QString& text);

    mutable std::mutex m_mutex;
    std::deque<LogLine> m_lines;
    long long m_dropped = 0;
    QtMessageHandler m_before = nullptr;
};

} // namespace sparkout
