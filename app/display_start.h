// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QtGlobal>

namespace sparkout {

/// While it lives, a display that cannot be used ends the program in words and with status 2. Qt
/// itself aborts where it finds no display or no plug-in of the wanted name, and some of its
/// plug-ins crash without their device.
class DisplayStart {
public:
    DisplayStart();
    DisplayStart(const DisplayStart&) = delete;
    DisplayStart& operator=(const DisplayStart&) = delete;
    ~DisplayStart();

    /// Once the application is there: ends the program if there is no screen.
    static void checkScreen();

private:
    static void receive(QtMsgType type, const QMessageLogContext& context, const QString& text);
    [[noreturn]] static void crash(int signal);
    [[noreturn]] static void end(const QString& reason);

    static inline QStringList s_told; ///< warnings until now: the last one often is the reason
    QtMessageHandler m_before;
};

} // namespace sparkout
