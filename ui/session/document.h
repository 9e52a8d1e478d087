// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/project_io.h"
#include "ui/session/setup_state.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// The faults that a change of the inputs brings.
[[nodiscard]] Issues newErrors(const Project& before, const Project& after);

/// Whether a change of the inputs brings faults that were not there.
[[nodiscard]] bool breaksRules(const Project& before, const Project& after);

/// The set-up being worked on: its value, its file, its history. One of its surfaces is in front:
/// its project is what the views show and edit() changes. Every change of the value goes through
/// edit() or editSetup(), so all of it can be undone, also across a save; undo and redo bring the
/// surface to the front that they concern.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    [[nodiscard]] const Project& project() const { return m_project; } ///< of the one in front
    [[nodiscard]] const SetupState& state() const { return m_present; }
    [[nodiscard]] Setup setup() const { return m_present.setup(); }
    [[nodiscard]] std::size_t surface() const { return m_present.present; } ///< in front
    [[nodiscard]] std::size_t surfaceCount() const { return m_present.surfaces.size(); }
    /// Brings a surface to the front: no edit, as little as a change of the view.
    void showSurface(std::size_t surface);
    /// What a run of the surface in front depends on: it is the last of these; where the wheel
    /// wears those before it are there, too.
    [[nodiscard]] Setup upToPresent() const;
    [[nodiscard]] const QString& filePath() const { return m_filePath; } ///< empty: untitled
    [[nodiscard]] bool modified() const { return !m_history.isClean() && !m_isKeptElsewhere; }
    /// The file may not be written: a save goes elsewhere.
    [[nodiscard]] bool readOnly() const { return m_readOnly; }
    /// Of the file as it was last read or written; empty: untitled.
    [[nodiscard]] const QByteArray& diskHash() const { return m_diskHash; }
    /// What the edits since the last save are called, each once, the first one first. Empty with
    /// modified(): nobody knows any more.
    [[nodiscard]] QStringList unsavedEdits() const;

    /// Replaces the project in front, and in the others what all surfaces share. Edits in a row
    /// with the same non-empty key become one step of the history, until endMerge().
    void edit(Project changed, EditText text, const QString& mergeKey = {});
    /// The same of the whole set-up: its surfaces, their names and order, its times and wear.
    void editSetup(SetupState changed, EditText text, const QString& mergeKey = {});
    /// For a surface that is added.
    [[nodiscard]] int newSurfaceId() { return ++m_lastId; }
    void endMerge();
    /// Edits that it refuses do not come about: changed() shows what is still there. It goes, as
    /// the next does, when another document comes.
    void setGate(std::function<bool(const SetupState& after)> gate) { m_gate = std::move(gate); }
    /// Somebody else keeps it, as a lesson does: it has no changes that a file could lose.
    void keepElsewhere();
    /// The project before the edits of this place that a further one would join.
    [[nodiscard]] const Project& beforeEditsOf(const QString& mergeKey) const;

    [[nodiscard]] bool canUndo() const { return m_history.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_history.canRedo(); }
    [[nodiscard]] QString undoText() const; ///< in the present language
    [[nodiscard]] QString redoText() const;
    void undo();
    void redo();

    /// Whether the cycle is the one that was made for the drawing, with nothing else edited since:
    /// it is made anew when the drawing changes.
    [[nodiscard]] bool followsDrawing() const;

    /// The project as it was the last time under an operation, as far as undo reaches; null when
    /// it never was.
    [[nodiscard]] const Project* lastWith(Operation operation) const;

    void startUntitled(Project project);
    void startUntitled(Setup setup);
    /// The same, but these numbers are yet to be given; what the project has there stands in.
    void startIncomplete(Project project, std::vector<std::string> open);
    /// Numbers that have not been given yet. One that becomes another by an edit has been.
    [[nodiscard]] const std::vector<std::string>& openInputs() const {
        return m_present.inFront().open;
    }
    /// Those of all surfaces, by their paths in the file: after the first with "/surfaces/N".
    [[nodiscard]] std::vector<std::string> allOpenInputs() const;
    [[nodiscard]] bool isOpen(const std::string& path) const;
    [[nodiscard]] Issues missingInputs() const; ///< a fault for each of them
    /// A number is to be given again, as before the edits that a further one would join.
    void withdraw(const std::string& path, EditText text);
    [[nodiscard]] OpenResult open(const QString& path);
    [[nodiscard]] Issues openCopy(const QByteArray& text); ///< of an example, untitled
    /// Another language: an example that nobody has edited or saved since has its titles in it.
    void nameExample();
    [[nodiscard]] std::optional<FileError> save();
    [[nodiscard]] std::optional<FileError> saveAs(const QString& path);

    // The same in parts, for whoever reads and writes the file himself.
    void take(Setup setup, const QString& path, const QByteArray& hash, bool readOnly);
    /// What a crash left: it has its file and is modified; its history starts here.
    /// The numbers at `open`, as allOpenInputs() gives them, are yet to be given.
    void recover(Setup setup, const QString& path, const QByteArray& hash, bool readOnly,
                 const std::vector<std::string>& open = {});
    void reload(Setup setup, const QByteArray& hash); ///< from its file; can be undone
    void markSaved(const QString& path, const QByteArray& hash);
    void markUnsaved(); ///< the file does not hold it any more

signals:
    void changed();                               ///< another value, or surface in front
    void edited(const sparkout::Project& before); ///< by edit(); changed() came before
    /// By undo or redo, after changed(): another value at a path, the first of them.
    void stepped(const std::string& path);
    void replaced();        ///< another document; projectReplaced() and changed() follow
    void projectReplaced(); ///< another surface is in front, or another document; changed() follows
    void saved();           ///< historyChanged() follows
    void historyChanged();  ///< undo, redo, modified state or file

private:
    class Edit;

    enum class Kept { onDisk, nowhere };
    void replace(SetupState state, const QString& path, const QByteArray& hash, bool readOnly,
                 Kept kept);
    [[nodiscard]] SetupState stateOf(Setup setup);
    [[nodiscard]] std::vector<std::string> openIn(const Project& changed) const;
    [[nodiscard]] bool isStarting(const Project& changed,
                                  const std::vector<std::string>& open) const;
    [[nodiscard]] bool hasBatchAsMade(const Project& changed) const;
    [[nodiscard]] SetupState with(Project changed, std::vector<std::string> open) const;
    /// False: the gate refuses it.
    bool push(SetupState after, EditText text, const QString& mergeKey);
    void setState(const SetupState& state);
    void step(const std::function<void()>& step);
    [[nodiscard]] const Edit* editAt(int index) const;

    SetupState m_present;
    Project m_project; ///< the one in front, with its runs
    Project m_begun;   ///< as it was started: has what stands in for open inputs
    /// What a drawing was made into when it was complete: its cycle, and the search about it,
    /// follow the drawing as long as nothing else is changed.
    std::optional<Project> m_started;
    QString m_filePath;
    QByteArray m_diskHash;
    bool m_readOnly = false;
    std::vector<std::pair<std::string, std::string>>
        m_exampleNames; ///< titles, surfaces: as shipped
    std::function<bool(const SetupState& after)> m_gate;
    bool m_isKeptElsewhere = false;
    QUndoStack m_history;
    [[nodiscard]] QString roundKey(const QString& mergeKey) const;

    int m_mergeRound = 0;
    int m_lastId = 0; ///< of a surface
};

} // namespace sparkout
