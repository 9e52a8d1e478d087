// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QObject>

class QWidget;

namespace sparkout {

class Document;
class Settings;

/// The commands that deal with files, with their questions and messages.
class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Document& document, Settings& settings, QWidget* window);

    void startNew(Operation operation);
    void open();
    bool openFile(const QString& path); ///< without asking for unsaved changes
    void openExample();
    bool save();
    bool saveAs();
    /// Asks what to do with unsaved changes; false when the user wants to stay.
    [[nodiscard]] bool mayDiscard();

signals:
    void saved();

private:
    bool saveTo(const QString& path);
    [[nodiscard]] QString suggestedPath() const;

    Document& m_document;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
