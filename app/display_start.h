// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QtGlobal>

namespace sparkout {

/// During its lifetime, a display that cannot be used ends the program with a message and status 2.
/// Qt itself aborts if it finds no display or no plug-in of the wanted name, and some of its
/// plug-ins crash without their device.
class DisplayStart {
public:
    DisplayStart();
    DisplayStart(const DisplayStart&) = delete;
    DisplayStart& operator=(const DisplayStart&) = delete;
    ~DisplayStart();

    /// Ends the program if there is no screen; call once the application exists.
    static void checkScreen();

private:
    static void receive(QtMsgType type, const QMessageLogContext& context, const QString& text);
    [[noreturn]] static void crash(int signal);
    [[noreturn]] static void end(const QString& reason);

    static inline QStringList s_told; ///< warnings so far; the last one is often the reason
    QtMessageHandler m_before;
};

} // namespace sparkout
