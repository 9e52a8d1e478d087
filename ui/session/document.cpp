// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/document.h"

#include "core/project/project_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QUndoCommand>

#include <memory>

namespace sparkout {

namespace {

std::filesystem::path systemPath(const QString& path) {
    return {QFile::encodeName(path).toStdString()};
}

} // namespace

QString EditText::shown() const {
    return QCoreApplication::translate(context, text);
}

/// One step of the history: the whole value before and after.
class Document::Edit : public QUndoCommand {
public:
    Edit(Document& document, Project after, EditText text, QString mergeKey)
        : m_document(document)
        , m_before(std::make_shared<Project>(document.m_project))
        , m_after(std::make_shared<Project>(std::move(after)))
        , m_text(text)
        , m_mergeKey(std::move(mergeKey)) {}

    [[nodiscard]] const EditText& editText() const { return m_text; }
    [[nodiscard]] const Project& before() const { return *m_before; }

    int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    void undo() override { m_document.setProject(*m_before); }
    void redo() override { m_document.setProject(*m_after); }

    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const Edit*>(other);
        if (next->m_mergeKey != m_mergeKey) {
            return false;
        }
        m_after = next->m_after;
        setObsolete(sameProject(*m_before, *m_after));
        return true;
    }

private:
    Document& m_document;
    std::shared_ptr<const Project> m_before;
    std::shared_ptr<const Project> m_after;
    EditText m_text;
    QString m_mergeKey;
};

Document::Document(QObject* parent) : QObject(parent) {
    connect(&m_history, &QUndoStack::indexChanged, this, &Document::historyChanged);
    connect(&m_history, &QUndoStack::cleanChanged, this, &Document::historyChanged);
}

void Document::edit(Project changed, EditText text, const QString& mergeKey) {
    if (sameProject(changed, m_project)) {
        return;
    }
    const QString key =
        mergeKey.isEmpty() ? QString() : QString::number(m_mergeRound) + u' ' + mergeKey;
    m_history.push(new Edit(*this, std::move(changed), text, key));
}

void Document::endMerge() {
    ++m_mergeRound;
}

QString Document::undoText() const {
    const auto* edit = static_cast<const Edit*>(m_history.command(m_history.index() - 1));
    return edit ? edit->editText().shown() : QString();
}

QString Document::redoText() const {
    const auto* edit = static_cast<const Edit*>(m_history.command(m_history.index()));
    return edit ? edit->editText().shown() : QString();
}

void Document::undo() {
    endMerge();
    m_history.undo();
}

void Document::redo() {
    endMerge();
    m_history.redo();
}

const Project* Document::lastWith(Operation operation) const {
    if (m_project.operation == operation) {
        return &m_project;
    }
    for (int i = m_history.index() - 1; i >= 0; --i) {
        const Project& before = static_cast<const Edit*>(m_history.command(i))->before();
        if (before.operation == operation) {
            return &before;
        }
    }
    return nullptr;
}

void Document::startUntitled(Project project) {
    replace(std::move(project), {});
}

OpenResult Document::open(const QString& path) {
    OpenResult result;
    const auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        result.error = *error;
        return result;
    }
    ReadResult parsed = readProject(std::get<std::string>(read));
    result.issues = std::move(parsed.issues);
    auto& project = parsed.project ? parsed.project : parsed.unfinished;
    if (project) {
        result.taken = true;
        replace(std::move(*project), path);
    }
    return result;
}

Issues Document::openCopy(const QByteArray& text) {
    ReadResult parsed = readProject({text.constData(), static_cast<std::size_t>(text.size())});
    if (parsed.project && !hasErrors(parsed.issues)) {
        replace(std::move(*parsed.project), {});
    }
    return parsed.issues;
}

std::optional<FileError> Document::save() {
    return saveAs(m_filePath);
}

std::optional<FileError> Document::saveAs(const QString& path) {
    // A text that could not be opened again must never reach the disk.
    const std::string text = writeProject(m_project);
    const ReadResult back = readProject(text);
    const auto& same = back.project ? back.project : back.unfinished;
    if (!same || !sameProject(*same, m_project)) {
        FileError error;
        error.path = path.toStdString();
        error.step = FileStep::verify;
        return error;
    }
    auto error = writeFileSafely(systemPath(path), text);
    if (!error) {
        m_filePath = path;
        endMerge();
        m_history.setClean();
        emit historyChanged();
    }
    return error;
}

void Document::replace(Project project, const QString& path) {
    m_history.clear();
    m_project = std::move(project);
    m_filePath = path;
    endMerge();
    emit historyChanged();
    emit replaced();
    emit changed();
}

void Document::setProject(const Project& project) {
    m_project = project;
    emit changed();
}

} // namespace sparkout
