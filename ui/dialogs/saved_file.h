// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

class QWidget;

namespace sparkout {

class NoticeBar;

/// Shows where a file was written, and offers to open it or its folder.
class SavedFile {
    Q_DECLARE_TR_FUNCTIONS(SavedFile)

public:
    static constexpr const char* noticeKey = "savedFile";

    /// In the notices of the main window, whatever window saved the file; without one in its status
    /// bar.
    static void show(QWidget* from, const QString& path);

private:
    static void addNotice(NoticeBar& bar, const QString& path);
    static void open(NoticeBar& bar, const QString& path); ///< with the system's program for it
};

} // namespace sparkout
