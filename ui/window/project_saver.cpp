// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/project_saver.h"

#include "core/project/part.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/files/file_guard.h"
#include "ui/kit/file_dialog.h"
#include "ui/session/document.h"
#include "ui/session/program_log.h"
#include "ui/session/settings.h"
#include "ui/text/designation_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QStandardPaths>

namespace sparkout {

namespace {

const QString suffix = QStringLiteral(".sparkout");

} // namespace

ProjectSaver::ProjectSaver(Document& document, const Settings& settings, FileGuard& guard,
                           GuardQuestions& questions, QWidget* window)
    : m_document(document)
    , m_settings(settings)
    , m_guard(guard)
    , m_questions(questions)
    , m_window(window) {}

/// Substitutes for missing numbers would be read as given.
bool ProjectSaver::isComplete() {
    QStringList missing;
    for (const SurfaceStatePtr& surface : m_document.state().surfaces) {
        for (const std::string& path : surface->open) {
            missing +=
                surface->name.empty()
                    ? locationText(path)
                    : tr("%1: %2").arg(QString::fromStdString(surface->name), locationText(path));
        }
    }
    if (!missing.isEmpty()) {
        showFailure(m_window, tr("The project is not complete"),
                    tr("It can be saved once its drawing is given. Still needed:")
                        + QStringLiteral("\n• ") + missing.join(QStringLiteral("\n• ")));
    }
    return missing.isEmpty();
}

bool ProjectSaver::save() {
    if (!isComplete()) {
        return false;
    }
    return m_document.filePath().isEmpty() || m_document.readOnly() ? saveAs()
                                                                    : saveTo(m_document.filePath());
}

bool ProjectSaver::saveAs() {
    if (!isComplete()) {
        return false;
    }
    QString path = FileDialog::savePath(m_window, tr("Save the project"), suggestedPath(),
                                        tr("Sparkout projects (*.sparkout)"));
    if (path.isEmpty()) {
        return false;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += suffix;
        if (QFileInfo::exists(path) && !mayReplace(m_window, path)) {
            return false;
        }
    }
    return saveTo(path);
}

bool ProjectSaver::saveTo(const QString& path) {
    const auto write = [&] { return m_guard.save(path); };
    for (;;) {
        switch (m_questions.save(path, Reloading::offered, write)) {
        case GuardQuestions::Outcome::saved:
            ProgramLog::note(tr("Saved: %1").arg(printableText(path)));
            emit saved(path);
            return true;
        case GuardQuestions::Outcome::elsewhere: return saveAs();
        case GuardQuestions::Outcome::reload: emit reloadWanted(); return false;
        case GuardQuestions::Outcome::cancelled: return false;
        case GuardQuestions::Outcome::failed: break;
        }
        const FailureAnswer next = askSaveFailed(m_window, *m_questions.error());
        if (next != FailureAnswer::again) {
            m_guard.dropClaim();
            return next == FailureAnswer::elsewhere && saveAs();
        }
    }
}

QString ProjectSaver::suggestedPath() const {
    const QString path = m_document.filePath();
    if (!path.isEmpty() && !m_document.readOnly()) {
        return path;
    }
    if (!path.isEmpty()) { // beside the original if the folder allows, otherwise in the documents
                           // folder
        const QFileInfo file(path);
        const QString folder =
            QFileInfo(file.absolutePath()).isWritable()
                ? file.absolutePath()
                : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        return folder + u'/' + tr("%1 copy").arg(file.completeBaseName()) + suffix;
    }
    const Project& project = m_document.project(); // named after the part, like its drawing
    QString name = fileNameOf({QString::fromStdString(project.part->name)});
    if (name.isEmpty()) {
        name = fileNameOf({QString::fromStdString(project.title)});
    }
    if (name.isEmpty()) {
        const QString field = fieldOf(*project.part);
        const QString size = field.isEmpty()
                                 ? printedNumber(project.part->diameter_mm) + u' ' + unitText("mm")
                                 : field;
        name = fileNameOf({QStringLiteral("%1, %2").arg(
            size, choiceText(project.operation->choice.label))}); // 30h6, plunge grinding
    }
    return m_settings.lastFolder() + u'/' + name + suffix;
}

} // namespace sparkout
