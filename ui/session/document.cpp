// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/document.h"

#include "core/format/project_file.h"
#include "core/project/difference.h"
#include "core/project/leaves.h"
#include "core/project/member.h"
#include "core/project/validate.h"
#include "ui/text/example_texts.h"

#include <QCoreApplication>
#include <QUndoCommand>

#include <algorithm>
#include <memory>

namespace sparkout {

namespace {

std::optional<double> numberAt(const Project& project, const std::string& path) {
    const ConstMember member = findMember(project, path);
    return numberIn(*member.field, member.owner);
}

constexpr EditText reloadText{"Edit", QT_TRANSLATE_NOOP("Edit", "Reload the file")};

} // namespace

QString EditText::shown() const {
    return QCoreApplication::translate(context, text);
}

Issues newErrors(const Project& before, const Project& after) {
    const Issues known = validate(before);
    Issues issues = validate(after);
    std::erase_if(issues, [&known](const Issue& issue) {
        return issue.severity != Severity::error
               || std::any_of(known.begin(), known.end(), [&issue](const Issue& other) {
                      return other.code == issue.code && other.path == issue.path;
                  });
    });
    return issues;
}

bool breaksRules(const Project& before, const Project& after) {
    return !newErrors(before, after).empty();
}

/// One step of the history: the whole value before and after.
class Document::Edit : public QUndoCommand {
public:
    Edit(Document& document, Snapshot after, EditText text, QString mergeKey)
        : m_document(document)
        , m_before(document.m_present)
        , m_after(std::move(after))
        , m_text(text)
        , m_mergeKey(std::move(mergeKey)) {}

    [[nodiscard]] const EditText& editText() const { return m_text; }
    [[nodiscard]] const Project& before() const { return m_before.project; }
    [[nodiscard]] const QString& mergeKey() const { return m_mergeKey; }

    int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    void undo() override { m_document.setProject(m_before); }
    void redo() override { m_document.setProject(m_after); }

    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const Edit*>(other);
        if (next->m_mergeKey != m_mergeKey) {
            return false;
        }
        m_after = next->m_after;
        setObsolete(m_before.runs == m_after.runs
                    && std::ranges::is_permutation(m_before.open, m_after.open)
                    && sameProject(m_before.project, m_after.project));
        return true;
    }

private:
    Document& m_document;
    Snapshot m_before;
    Snapshot m_after;
    EditText m_text;
    QString m_mergeKey;
};

Document::Document(QObject* parent) : QObject(parent), m_present(snapshot(m_project, {})) {
    connect(&m_history, &QUndoStack::indexChanged, this, &Document::historyChanged);
    connect(&m_history, &QUndoStack::cleanChanged, this, &Document::historyChanged);
}

void Document::edit(Project changed, EditText text, const QString& mergeKey) {
    if (sameProject(changed, m_project)) {
        return;
    }
    std::vector<std::string> open = openIn(changed);
    push(snapshot(std::move(changed), std::move(open)), text, mergeKey);
}

void Document::push(Snapshot after, EditText text, const QString& mergeKey) {
    const Snapshot before = m_present;
    m_history.push(new Edit(*this, std::move(after), text, roundKey(mergeKey)));
    emit edited(before.project);
}

/// Another operation fits the numbers to itself: that does not give them.
std::vector<std::string> Document::openIn(const Project& changed) const {
    std::vector<std::string> open = m_present.open;
    if (changed.operation == m_project.operation) {
        std::erase_if(open, [&](const std::string& path) {
            return numberAt(changed, path) != numberAt(m_project, path);
        });
    }
    return open;
}

bool Document::isOpen(const std::string& path) const {
    return std::ranges::find(m_present.open, path) != m_present.open.end();
}

Issues Document::missingInputs() const {
    Issues issues;
    for (const std::string& path : m_present.open) {
        const Field& field = *findMember(m_project, path).field;
        issues.push_back(
            {IssueCode::missingKey, Severity::error, path, {}, Bounds{field.stated(), field.unit}});
    }
    return issues;
}

void Document::withdraw(const std::string& path, EditText text) {
    if (isOpen(path)) {
        return;
    }
    Project project = m_project;
    const Member member = findMember(project, path);
    setNumberIn(*member.field, member.owner, numberAt(m_begun, path));
    std::vector<std::string> open = m_present.open;
    open.push_back(path);
    push(snapshot(std::move(project), std::move(open)), text, QString::fromStdString(path));
}

QString Document::roundKey(const QString& mergeKey) const {
    return mergeKey.isEmpty() ? QString() : QString::number(m_mergeRound) + u' ' + mergeKey;
}

const Project& Document::beforeEditsOf(const QString& mergeKey) const {
    const Edit* last = editAt(m_history.index() - 1);
    return last && !mergeKey.isEmpty() && last->mergeKey() == roundKey(mergeKey) ? last->before()
                                                                                 : m_project;
}

void Document::endMerge() {
    ++m_mergeRound;
}

const Document::Edit* Document::editAt(int index) const {
    return static_cast<const Edit*>(m_history.command(index));
}

QString Document::undoText() const {
    const Edit* edit = editAt(m_history.index() - 1);
    return edit ? edit->editText().shown() : QString();
}

QString Document::redoText() const {
    const Edit* edit = editAt(m_history.index());
    return edit ? edit->editText().shown() : QString();
}

void Document::undo() {
    step([this] { m_history.undo(); });
}

void Document::redo() {
    step([this] { m_history.redo(); });
}

void Document::step(const std::function<void()>& step) {
    endMerge();
    const Snapshot before = m_present;
    step();
    if (const std::string path = firstDifference(before.project, m_present.project);
        !path.empty()) {
        emit stepped(path);
    }
}

QStringList Document::unsavedEdits() const {
    QStringList texts;
    const int clean = m_history.cleanIndex();
    if (clean >= 0) { // edits made since, or undone since
        for (int i = std::min(clean, m_history.index()); i < std::max(clean, m_history.index());
             ++i) {
            texts += editAt(i)->editText().shown();
        }
    }
    texts.removeDuplicates();
    return texts;
}

const Project* Document::lastWith(Operation operation) const {
    if (m_project.operation == operation) {
        return &m_project;
    }
    for (int i = m_history.index() - 1; i >= 0; --i) {
        const Project& before = editAt(i)->before();
        if (before.operation == operation) {
            return &before;
        }
    }
    return nullptr;
}

void Document::startUntitled(Project project) {
    take(std::move(project), {}, {}, false);
}

void Document::startIncomplete(Project project, std::vector<std::string> open) {
    replace(std::move(project), {}, {}, false, Kept::onDisk, std::move(open));
}

OpenResult Document::open(const QString& path) {
    LoadedProject loaded = loadProject(path);
    OpenResult result{std::move(loaded.issues), std::move(loaded.error)};
    if (loaded.project) {
        result.taken = true;
        take(std::move(*loaded.project), path, loaded.hash, false);
    }
    return result;
}

Issues Document::openCopy(const QByteArray& text) {
    LoadedProject loaded = parseProject({text.constData(), static_cast<std::size_t>(text.size())});
    if (loaded.project && !hasErrors(loaded.issues)) {
        loaded.project->title = exampleTitle(loaded.project->title).toStdString();
        startUntitled(std::move(*loaded.project));
    }
    return loaded.issues;
}

std::optional<FileError> Document::save() {
    return saveAs(m_filePath);
}

std::optional<FileError> Document::saveAs(const QString& path) {
    const SavedProject saved = saveProject(m_project, path);
    if (!saved.error) {
        markSaved(path, saved.hash);
    }
    return saved.error;
}

void Document::markSaved(const QString& path, const QByteArray& hash) {
    m_filePath = path;
    m_diskHash = hash;
    m_readOnly = false;
    endMerge();
    m_history.setClean();
    emit historyChanged();
}

void Document::markUnsaved() {
    m_history.resetClean();
}

void Document::reload(Project project, const QByteArray& hash) {
    endMerge();
    edit(std::move(project), reloadText);
    m_diskHash = hash;
    m_history.setClean();
}

void Document::take(Project project, const QString& path, const QByteArray& hash, bool readOnly) {
    replace(std::move(project), path, hash, readOnly, Kept::onDisk);
}

void Document::recover(Project project, const QString& path, const QByteArray& hash, bool readOnly,
                       std::vector<std::string> open) {
    const std::vector<Leaf> leaves = leavesOf(tableOf<Project>(), &project);
    std::erase_if(open, [&leaves](const std::string& each) {
        return std::ranges::none_of(leaves, [&each](const Leaf& leaf) {
            return leaf.path == each
                   && (leaf.field->kind == Kind::number || leaf.field->kind == Kind::integer);
        });
    });
    replace(std::move(project), path, hash, readOnly, Kept::nowhere, std::move(open));
}

void Document::replace(Project project, const QString& path, const QByteArray& hash, bool readOnly,
                       Kept kept, std::vector<std::string> open) {
    m_history.clear();
    if (kept == Kept::nowhere) {
        m_history.resetClean();
    }
    m_project = std::move(project);
    m_begun = m_project;
    m_present = snapshot(m_project, std::move(open));
    m_filePath = path;
    m_diskHash = hash;
    m_readOnly = readOnly;
    endMerge();
    emit historyChanged();
    emit replaced();
    emit changed();
}

Document::Snapshot Document::snapshot(Project project, std::vector<std::string> open) const {
    Snapshot made;
    made.open = std::move(open);
    made.runs = m_present.runs;
    if (!made.runs || project.runs != *made.runs) {
        made.runs = std::make_shared<const std::vector<KeptRun>>(project.runs);
    }
    project.runs.clear();
    made.project = std::move(project);
    return made;
}

void Document::setProject(const Snapshot& snapshot) {
    const bool sameRuns = snapshot.runs == m_present.runs;
    std::vector<KeptRun> runs = sameRuns ? std::move(m_project.runs) : *snapshot.runs;
    m_present = snapshot;
    m_project = snapshot.project;
    m_project.runs = std::move(runs);
    emit changed();
}

} // namespace sparkout
