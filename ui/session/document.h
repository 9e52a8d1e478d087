// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/project/safe_file.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <optional>

namespace sparkout {

/// What an edit is called in the Edit menu: a text marked for translation and its context.
struct EditText {
    const char* context = "Edit";
    const char* text = "";
    [[nodiscard]] QString shown() const;
};

/// What came of opening a file: opened, refused with faults, or not read at all. Unfinished work,
/// in which only a rule between values is broken, is opened with its faults.
struct OpenResult {
    Issues issues;
    std::optional<FileError> error;
    bool taken = false;
    [[nodiscard]] bool opened() const { return taken; }
};

/// The project being worked on: its value, its file, its history. Every change of the value goes
/// through edit(), so all of it can be undone, also across a save.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    [[nodiscard]] const Project& project() const { return m_project; }
    [[nodiscard]] const QString& filePath() const { return m_filePath; } ///< empty: untitled
    [[nodiscard]] bool modified() const { return !m_history.isClean(); }

    /// Replaces the value. Edits in a row with the same non-empty key become one step of the
    /// history, until endMerge().
    void edit(Project changed, EditText text, const QString& mergeKey = {});
    void endMerge();

    [[nodiscard]] bool canUndo() const { return m_history.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_history.canRedo(); }
    [[nodiscard]] QString undoText() const; ///< in the present language
    [[nodiscard]] QString redoText() const;
    void undo();
    void redo();

    /// The project as it was the last time under an operation, as far as undo reaches; null when
    /// it never was.
    [[nodiscard]] const Project* lastWith(Operation operation) const;

    void startUntitled(Project project);
    [[nodiscard]] OpenResult open(const QString& path);
    [[nodiscard]] Issues openCopy(const QByteArray& text); ///< as an untitled document
    [[nodiscard]] std::optional<FileError> save();
    [[nodiscard]] std::optional<FileError> saveAs(const QString& path);

signals:
    void changed();        ///< another value
    void replaced();       ///< another document; changed() follows
    void historyChanged(); ///< undo, redo, modified state or file

private:
    class Edit;

    void replace(Project project, const QString& path);
    void setProject(const Project& project);

    Project m_project;
    QString m_filePath;
    QUndoStack m_history;
    int m_mergeRound = 0;
};

} // namespace sparkout
