// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/program_log.h"

#include "ui/text/texts.h"

#include <atomic>

namespace sparkout {

namespace {

std::atomic<ProgramLog*> currentLog = nullptr; ///< Qt's handler is a plain function
}

ProgramLog::ProgramLog() {
    m_before = qInstallMessageHandler(receive);
    currentLog = this;
}

ProgramLog::~ProgramLog() {
    currentLog = nullptr;
    qInstallMessageHandler(m_before);
}

ProgramLog* ProgramLog::current() {
    return currentLog;
}

void ProgramLog::note(const QString& text) {
    if (ProgramLog* log = currentLog) {
        log->add(QtInfoMsg, text);
    }
}

void ProgramLog::receive(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    ProgramLog* log = currentLog;
    if (!log) {
        return;
    }
    log->add(type, text);
    if (log->m_before) {
        log->m_before(type, context, text);
    }
}

void ProgramLog::add(QtMsgType type, const QString& text) {
    {
        const std::lock_guard lock(m_mutex);
        m_lines.push_back(
            {QDateTime::currentDateTime(), type, harmlessText(text.left(longestLine))});
        if (m_lines.size() > mostLines) {
            m_lines.pop_front();
            ++m_dropped;
        }
    }
    emit changed();
}

std::vector<LogLine> ProgramLog::lines() const {
    const std::lock_guard lock(m_mutex);
    return {m_lines.begin(), m_lines.end()};
}

long long ProgramLog::dropped() const {
    const std::lock_guard lock(m_mutex);
    return m_dropped;
}

} // namespace sparkout
