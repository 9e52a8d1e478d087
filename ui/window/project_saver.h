// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/guard_questions.h"

#include <QObject>
#include <QString>

class QWidget;

namespace sparkout {

class Document;
class FileGuard;
class Settings;

/// Saves the document after asking the user about every obstacle.
class ProjectSaver : public QObject {
    Q_OBJECT

public:
    ProjectSaver(Document& document, const Settings& settings, FileGuard& guard,
                 GuardQuestions& questions, QWidget* window);

    bool save(); ///< to its file; asks for one if there is none that may be written
    bool saveAs();

signals:
    void saved(const QString& path);
    void reloadWanted(); ///< instead of saving: the file was changed by another program

private:
    bool isComplete(); ///< or shows why it cannot be saved
    bool saveTo(const QString& path);
    [[nodiscard]] QString suggestedPath() const;

    Document& m_document;
    const Settings& m_settings;
    FileGuard& m_guard;
    GuardQuestions& m_questions;
    QWidget* m_window;
};

} // namespace sparkout
