// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>

#include <deque>
#include <mutex>
#include <vector>

namespace sparkout {

/// A message of the program or Qt.
struct LogLine {
    QDateTime when;
    QtMsgType type = QtInfoMsg;
    QString text;
};

/// Messages of all threads since its creation, only the newest lines. While it exists it receives
/// Qt's messages and passes them to the previous handler. At most one exists at a time.
class ProgramLog : public QObject {
    Q_OBJECT

public:
    ProgramLog();
    ~ProgramLog() override;

    /// Adds a line to the current log, if there is one; may be called on any thread.
    static void note(const QString& text);
    [[nodiscard]] static ProgramLog* current(); ///< may be null

    [[nodiscard]] std::vector<LogLine> lines() const; ///< oldest first
    [[nodiscard]] long long dropped() const;          ///< number of lines replaced by newer ones

    static constexpr std::size_t mostLines = 1000;
    static constexpr qsizetype longestLine = 2000; ///< characters; the rest is cut off

signals:
    void changed(); ///< may be emitted in another thread

private:
    void add(QtMsgType type, const QString& text);
    static void receive(QtMsgType type, const QMessageLogContext& context, const QString& text);

    mutable std::mutex m_mutex;
    std::deque<LogLine> m_lines;
    long long m_dropped = 0;
    QtMessageHandler m_before = nullptr;
};

} // namespace sparkout
