// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/dialogs/file_questions.h"

#include <QObject>
#include <QString>

class QWidget;

namespace sparkout {

class DiskWait;
class Document;
class FileGuard;
class Settings;

/// Saves the document, after all that may speak against writing there was asked of the user.
class ProjectSaver : public QObject {
    Q_OBJECT

public:
    ProjectSaver(Document& document, const Settings& settings, FileGuard& guard, DiskWait& wait,
                 QWidget* window);

    bool save(); ///< to its file; asks for one when there is none that may be written
    bool saveAs();

signals:
    void saved(const QString& path);
    void reloadWanted(); ///< instead: the file was changed by another program

private:
    bool isComplete(); ///< or says why it cannot be saved
    bool saveTo(const QString& path);
    [[nodiscard]] SaveAnswer clearTheWay(const QString& path);
    [[nodiscard]] QString suggestedPath() const;

    Document& m_document;
    const Settings& m_settings;
    FileGuard& m_guard;
    DiskWait& m_wait;
    QWidget* m_window;
    QString m_linksAccepted; ///< the file whose other names may keep the old text
};

} // namespace sparkout
