// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/given_factors.h"
#include "core/study/starting_cycle.h"
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

/// Name of an edit in the Edit menu: a text marked for translation and its context.
struct EditText {
    const char* context = "Edit";
    const char* text = "";
    [[nodiscard]] QString shown() const;
};

/// Result of opening a file: opened, refused with faults, or not read at all. Unfinished work, in
/// which only rules between values are broken, is opened with its faults.
struct OpenResult {
    Issues issues;
    std::optional<FileError> error;
    bool taken = false;
    [[nodiscard]] bool opened() const { return taken; }
};

/// Returns the faults that a change of the inputs introduces.
[[nodiscard]] Issues newErrors(const Project& before, const Project& after);

/// Returns whether a change of the inputs introduces new faults.
[[nodiscard]] bool breaksRules(const Project& before, const Project& after);

/// The set-up being edited: its value, its file and its history. One of its surfaces is current:
/// the views show its project, and edit() changes it. Every change of the value is made by edit()
/// or editSetup() and can therefore be undone, also after a save; undo and redo make the surface
/// current that they concern.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    [[nodiscard]] const Project& project() const {
        return m_project;
    } ///< project of the current surface
    [[nodiscard]] const SetupState& state() const { return m_present; }
    [[nodiscard]] Setup setup() const { return m_present.setup(); }
    [[nodiscard]] std::size_t surface() const {
        return m_present.present;
    } ///< index of the current surface
    [[nodiscard]] std::size_t surfaceCount() const { return m_present.surfaces.size(); }
    /// Makes a surface current; like a change of the view, this is not an edit.
    void showSurface(std::size_t surface);
    /// Returns the inputs of a run of the current surface: it is the last of these surfaces; where
    /// the wheel wears, the earlier ones are included.
    [[nodiscard]] Setup upToPresent() const;
    [[nodiscard]] const QString& filePath() const { return m_filePath; } ///< empty: untitled
    [[nodiscard]] bool modified() const { return !m_history.isClean() && !m_isKeptElsewhere; }
    /// Returns whether the file must not be written, so that a save needs another file.
    [[nodiscard]] bool readOnly() const { return m_readOnly; }
    /// Returns the hash of the file as it was last read or written; empty: untitled.
    [[nodiscard]] const QByteArray& diskHash() const { return m_diskHash; }
    /// Returns the names of the edits since the last save, each once, in their order. When it is
    /// empty and the document is modified(), the edits are no longer known.
    [[nodiscard]] QStringList unsavedEdits() const;

    /// Whether the laws of batches move along with the inputs that an edit changes, moveLaws().
    enum class Laws { move, stay };
    /// Replaces the current project, and in the other surfaces the inputs that all share.
    /// Successive edits with the same non-empty key become one step of the history, until
    /// endMerge(). No law moves under a gate, or with a number that is entered for the first time.
    void edit(Project changed, EditText text, const QString& mergeKey = {}, Laws laws = Laws::move);
    /// Returns the factors of the current surface whose laws the last edit() moved.
    [[nodiscard]] const std::vector<FactorKind>& movedLaws() const { return m_movedLaws; }
    /// As edit(), for the whole set-up: its surfaces, their names and order, its times and wear.
    void editSetup(SetupState changed, EditText text, const QString& mergeKey = {});
    /// Returns the number of an added surface.
    [[nodiscard]] int newSurfaceId() { return ++m_lastId; }
    void endMerge();
    /// Sets a gate that may refuse edits; after a refused edit changed() is emitted with the value
    /// unchanged. The gate is removed when another document is opened.
    void setGate(std::function<bool(const SetupState& after)> gate) { m_gate = std::move(gate); }
    /// Marks the document as stored elsewhere, as by a lesson, so that it has no changes that a
    /// file could lose.
    void keepElsewhere();
    /// Returns the project before the edits with this key that a further edit would join, with its
    /// kept runs.
    [[nodiscard]] Project beforeEditsOf(const QString& mergeKey) const;

    [[nodiscard]] bool canUndo() const { return m_history.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_history.canRedo(); }
    [[nodiscard]] QString undoText() const; ///< in the current language
    [[nodiscard]] QString redoText() const;
    void undo();
    void redo();

    /// Returns whether the cycle is the one made for the drawing, with no other edits since: it is
    /// made again when the drawing changes.
    [[nodiscard]] bool followsDrawing() const;
    /// Returns that cycle; null where no cycle follows the drawing, or none can grind the part.
    [[nodiscard]] const StartingCycle* followingCycle() const;

    /// Returns the project as it last was under an operation, as far as undo reaches, without kept
    /// runs if that was before; null: it never was.
    [[nodiscard]] const Project* lastWith(Operation operation) const;

    void startUntitled(Project project);
    void startUntitled(Setup setup);
    /// As startUntitled(), with these numbers still to be entered; the project has substitutes for
    /// them.
    void startIncomplete(Project project, std::vector<std::string> open);
    /// Returns the paths of the numbers that are still to be entered. A number that an edit changes
    /// has been entered.
    [[nodiscard]] const std::vector<std::string>& openInputs() const {
        return m_present.inFront().open;
    }
    /// Returns the open inputs of all surfaces, by their paths in the file: after the first surface
    /// with "/surfaces/N".
    [[nodiscard]] std::vector<std::string> allOpenInputs() const;
    [[nodiscard]] bool isOpen(const std::string& path) const;
    /// Returns a fault for each open input and, of a project whose cycle was made for its drawing
    /// and that has no file yet, for what the machine does not take.
    [[nodiscard]] Issues newFaults() const;
    /// Marks a number as still to be entered, as it was before the edits that a further one would
    /// join.
    void withdraw(const std::string& path, EditText text);
    [[nodiscard]] OpenResult open(const QString& path);
    [[nodiscard]] Issues openCopy(const QByteArray& text); ///< opens an example as untitled
    /// Translates the titles of an example that was neither edited nor saved, after a change of
    /// language.
    void nameExample();
    [[nodiscard]] std::optional<FileError> save();
    [[nodiscard]] std::optional<FileError> saveAs(const QString& path);

    // Parts of open() and save(), for callers that read and write the file themselves.
    void take(Setup setup, const QString& path, const QByteArray& hash, bool readOnly);
    /// Restores work after a crash: it has its file and is modified, and its history starts here.
    /// The numbers at `open`, as in allOpenInputs(), are still to be entered.
    void recover(Setup setup, const QString& path, const QByteArray& hash, bool readOnly,
                 const std::vector<std::string>& open = {});
    void reload(Setup setup, const QByteArray& hash); ///< from its file; it can be undone
    void markSaved(const QString& path, const QByteArray& hash);
    void markUnsaved(); ///< the file no longer contains it

signals:
    /// The value or the current surface has changed, or a first save has lifted newFaults().
    void changed();
    void edited(const sparkout::Project& before); ///< after edit() and changed()
    /// After an undo or redo and changed(): path of the first changed value.
    void stepped(const std::string& path);
    void replaced();        ///< another document was opened; projectReplaced() and changed() follow
    void projectReplaced(); ///< another surface is current, or another document was opened;
                            ///< changed() follows
    void saved();           ///< historyChanged() follows
    void historyChanged();  ///< undo, redo, modified state or file has changed

private:
    class Edit;

    enum class Kept { onDisk, nowhere };
    void replace(SetupState state, const QString& path, const QByteArray& hash, bool readOnly,
                 Kept kept);
    [[nodiscard]] SetupState stateOf(Setup setup);
    [[nodiscard]] std::vector<std::string> openIn(const Project& changed) const;
    [[nodiscard]] bool isStarting(const Project& changed,
                                  const std::vector<std::string>& open) const;
    [[nodiscard]] bool hasWheelAsMade(const Project& changed) const;
    [[nodiscard]] bool hasBatchAsMade(const Project& changed) const;
    [[nodiscard]] std::vector<FactorKind> moveLawsOf(Project& changed, const SurfaceState& present,
                                                     const QString& mergeKey) const;
    void moveLawsOfOthers(SetupState& after, const QString& mergeKey);
    [[nodiscard]] const SurfaceState* beforeJoined(int surface, const QString& mergeKey) const;
    [[nodiscard]] SetupState with(Project changed, std::vector<std::string> open) const;
    /// Makes an edit; returns false if the gate refuses it.
    bool push(SetupState after, EditText text, const QString& mergeKey);
    void setState(const SetupState& state);
    void step(const std::function<void()>& step);
    [[nodiscard]] const Edit* editAt(int index) const;

    SetupState m_present;
    Project m_project; ///< current project, with its runs
    Project m_begun;   ///< project as started, with the substitutes for open inputs
    /// Project made for the complete drawing: its cycle, and the search about it, follow the
    /// drawing as long as nothing else is edited. Without a usual depth it has no starting cycle.
    std::optional<StartingCycle> m_started;
    QString m_filePath;
    QByteArray m_diskHash;
    bool m_readOnly = false;
    std::vector<std::pair<std::string, std::string>>
        m_exampleNames;                  ///< titles and surfaces as shipped
    std::vector<FactorKind> m_movedLaws; ///< by the last edit
    std::function<bool(const SetupState& after)> m_gate;
    bool m_isKeptElsewhere = false;
    QUndoStack m_history;
    [[nodiscard]] QString roundKey(const QString& mergeKey) const;

    int m_mergeRound = 0;
    int m_lastId = 0; ///< last id of a surface
};

} // namespace sparkout
