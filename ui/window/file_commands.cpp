// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_commands.h"

#include "core/file/project_file.h"
#include "core/project/part.h"
#include "core/study/new_project.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/dialogs/watched_work.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/pdf_details.h"
#include "ui/lesson/lesson_desk.h"
#include "ui/session/document.h"
#include "ui/session/file_guard.h"
#include "ui/session/guarded_file.h"
#include "ui/session/program_log.h"
#include "ui/session/settings.h"
#include "ui/text/designation_text.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/examples_dialog.h"
#include "ui/window/dialogs/pack_commands.h"
#include "ui/window/recent_files_menu.h"

#include <QCoreApplication>
#include <QDialog>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QStandardPaths>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

const QString projectSuffix = QStringLiteral(".sparkout");

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
        path += projectSuffix;
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
        return folder + u'/' + tr("%1 copy").arg(file.completeBaseName()) + projectSuffix;
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
    return m_settings.lastFolder() + u'/' + name + projectSuffix;
}

namespace {

/// The earlier versions of a project. The chosen one is opened as a copy.
class VersionsDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(sparkout::VersionsDialog)

public:
    VersionsDialog(const QString& project, std::vector<EarlierVersion> versions,
                   QWidget* parent = nullptr);

    [[nodiscard]] QString chosenFile() const; ///< may be empty

private:
    std::vector<EarlierVersion> m_versions;
    QTreeWidget* m_list;
};

VersionsDialog::VersionsDialog(const QString& project, std::vector<EarlierVersion> versions,
                               QWidget* parent)
    : QDialog(parent), m_versions(std::move(versions)), m_list(new QTreeWidget(this)) {
    setWindowTitle(tr("Earlier versions"));
    setHelpTopic(*this, QStringLiteral("files#versions"));
    auto* head = new QLabel(m_versions.empty()
                                ? tr("No earlier version of “%1” is kept yet.")
                                      .arg(printableText(QFileInfo(project).fileName()))
                                : tr("Versions of “%1” that a save has replaced. The chosen one is "
                                     "opened as a copy; the file stays as it is.")
                                      .arg(printableText(QFileInfo(project).fileName())),
                            this);
    head->setTextFormat(Qt::PlainText);
    head->setWordWrap(true);
    m_list->setAccessibleName(tr("Earlier versions"));
    m_list->setRootIsDecorated(false);
    m_list->setHeaderLabels({tr("Replaced at"), tr("Size"), tr("File")});
    m_list->setTextElideMode(Qt::ElideMiddle);
    for (const EarlierVersion& earlier : m_versions) {
        auto* row =
            new QTreeWidgetItem(m_list, {momentText(earlier.when.toLocalTime()),
                                         sizeText(earlier.bytes), printableText(earlier.file)});
        row->setToolTip(2, printableText(earlier.file));
    }
    for (const int column : {0, 1}) {
        m_list->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
    auto* buttons = new AnswerButtons(tr("&Open a copy"), tr("&Cancel"), this);
    buttons->acceptButton()->setEnabled(!m_versions.empty());
    connect(m_list, &QTreeWidget::itemActivated, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(head);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    resize(720, 320);
}

QString VersionsDialog::chosenFile() const {
    const int index = m_list->indexOfTopLevelItem(m_list->currentItem());
    return index < 0 ? QString() : m_versions[std::size_t(index)].file;
}

/// An example is not locked until it is saved to.
bool isExample(const QByteArray& hash) {
    const QStringList paths = ExamplesDialog::paths();
    return std::any_of(paths.begin(), paths.end(), [&](const QString& path) {
        const QByteArray text = ExamplesDialog::textOf(path);
        return contentHash({text.constData(), std::size_t(text.size())}) == hash;
    });
}

} // namespace

FileCommands::FileCommands(Document& document, Settings& settings, QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_settings(settings)
    , m_window(window)
    , m_bar(new NoticeBar(window))
    , m_recent(new RecentFilesMenu(settings, window))
    , m_guard(document)
    , m_questions(m_guard, m_wait, window)
    , m_notices(document, settings, m_guard, *m_bar, window)
    , m_saver(document, settings, m_guard, m_questions, window)
    , m_recovery(document, m_guard, m_notices, m_wait, window) {
    connect(m_recent, &RecentFilesMenu::chosen, this, &FileCommands::openInstead);
    connect(&m_notices, &FileNotices::saveWanted, this, &FileCommands::save);
    connect(&m_notices, &FileNotices::saveAsWanted, this, &FileCommands::saveAs);
    connect(&m_notices, &FileNotices::reloadWanted, this, &FileCommands::reload);
    connect(&m_saver, &ProjectSaver::reloadWanted, this, &FileCommands::reload);
    connect(&m_saver, &ProjectSaver::saved, this, [this](const QString& path) {
        m_notices.followSaved();
        remember(path);
        emit saved();
    });
    m_window->installEventFilter(this);
}

FileCommands::~FileCommands() = default;

void FileCommands::protect(const QString& stateFolder, Autosave::Times times) {
    m_guard.protect(stateFolder, times);
}

void FileCommands::start(const QString& file) {
    m_notices.showDamagedSettings();
    if (m_guard.recovery() != nullptr) {
        m_guard.recovery()->removeOldDiscarded(QDateTime::currentDateTimeUtc());
    }
    const bool recovered = recover(false);
    const bool isOpen = recovered && realPath(file) == realPath(m_document.filePath());
    if (!file.isEmpty() && !isOpen) {
        openInstead(file);
    }
}

/// A work recovered before its drawing was complete asks for the rest.
bool FileCommands::recover(bool alsoDiscarded) {
    const bool recovered = m_recovery.offer(alsoDiscarded);
    if (recovered && !m_document.openInputs().empty()) {
        emit begun(m_document.openInputs().front());
    }
    return recovered;
}

void FileCommands::startNew(Operation operation) {
    if (mayDiscard()) {
        m_document.startIncomplete(undrawnProject(operation), drawingInputs());
        emit begun(drawingInputs().front());
    }
}

void FileCommands::open() {
    const QString path =
        FileDialog::openPath(m_window, tr("Open a project or a lesson"), m_settings.lastFolder(),
                             tr("Projects, lessons and works (*.sparkout *.sparkout-lesson "
                                "*.sparkout-work);;All files (*)"));
    if (!path.isEmpty()) {
        openInstead(path);
    }
}

void FileCommands::openInstead(const QString& path) {
    if (PackCommands::isPack(path)) {
        emit packChosen(path);
        return;
    }
    const QString ending = QFileInfo(path).suffix().toLower();
    if (QStringList{QStringLiteral("csv"), QStringLiteral("txt"), QStringLiteral("tsv"),
                    QStringLiteral("dat")}
            .contains(ending)) {
        emit measurementsChosen(path);
        return;
    }
    if (m_wait.busy() || !mayDiscard()) {
        return;
    }
    if (ending == QLatin1StringView("pdf")) {
        openAttached(path);
    } else if (LessonDesk::isOfLesson(path)) {
        m_lessons.open(path);
    } else {
        openFile(path);
    }
}

/// A PDF contains its project, which is opened without a file.
void FileCommands::openAttached(const QString& path) {
    constexpr qsizetype most = 200'000'000; // bytes of a PDF
    QFile file(path);
    std::optional<PdfAttachment> attached;
    if (file.open(QIODevice::ReadOnly)) {
        attached = attachmentOf(file.read(most), QStringLiteral(".sparkout"),
                                static_cast<qsizetype>(limits::fileBytes));
    }
    if (!attached) {
        showFailure(m_window, tr("The file was not opened"),
                    tr("%1 contains no project. Cards, passports, hand-outs and drawings written "
                       "by Sparkout contain one.")
                        .arg(printableText(QFileInfo(path).fileName())));
        return;
    }
    LoadedProject loaded =
        parseProject({attached->data.constData(), static_cast<std::size_t>(attached->data.size())});
    if (!loaded.setup) {
        showWhyRefused(loaded, path);
        return;
    }
    m_document.startUntitled(std::move(*loaded.setup));
    m_notices.showOpened(loaded.issues);
}

bool FileCommands::openFile(const QString& given) {
    const QString path = QFileInfo(given).absoluteFilePath();
    const auto opening =
        m_questions.wayToOpen(path); // first, or another program could save during reading
    if (!opening) {
        return false;
    }
    LoadedProject loaded;
    std::stop_source stop;
    bool read = false;
    m_wait.during([&] {
        read = runWatched(
            m_window, tr("Opening %1").arg(printableText(QFileInfo(path).fileName())),
            [&](const KeepGoing&) { loaded = loadProject(path, stop.get_token()); }, stop);
    });
    if (!read) {
        m_guard.dropClaim();
        return false;
    }
    if (loaded.setup) {
        take(std::move(loaded), path, *opening);
        return true;
    }
    m_guard.dropClaim();
    showWhyRefused(loaded, path);
    return false;
}

void FileCommands::showWhyRefused(const LoadedProject& loaded, const QString& path) {
    if (loaded.error) {
        showFailure(m_window, tr("The file was not opened"), readErrorText(*loaded.error));
    } else {
        FaultsDialog(path, loaded.issues, m_window).exec();
    }
}

void FileCommands::take(LoadedProject loaded, const QString& path,
                        GuardQuestions::Opening opening) {
    if (opening == GuardQuestions::Opening::copy) {
        m_document.startUntitled(std::move(*loaded.setup));
    } else {
        m_document.take(std::move(*loaded.setup), path, loaded.hash,
                        opening == GuardQuestions::Opening::readOnly);
    }
    if (isExample(loaded.hash)) {
        m_guard.unlock();
    }
    remember(path);
    ProgramLog::note(tr("Opened: %1").arg(printableText(path)));
    m_notices.showOpened(loaded.issues);
}

void FileCommands::remember(const QString& path) {
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    m_settings.addRecentFile(path);
    m_recent->fill();
}

void FileCommands::openExample() {
    ExamplesDialog dialog(m_window);
    if (dialog.exec() != QDialog::Accepted || !mayDiscard()) {
        return;
    }
    const Issues issues = m_document.openCopy(dialog.chosenText());
    if (hasErrors(issues)) {
        FaultsDialog(dialog.chosenTitle(), issues, m_window).exec();
    }
}

void FileCommands::openEarlierVersion() {
    const QString project = m_document.filePath();
    std::vector<EarlierVersion> versions;
    if (m_guard.history() != nullptr && !project.isEmpty()) {
        versions = earlierVersions(*m_guard.history(), project);
    }
    VersionsDialog dialog(project.isEmpty() ? tr("Untitled") : project, std::move(versions),
                          m_window);
    if (dialog.exec() == QDialog::Accepted && mayDiscard()) {
        openAsCopy(dialog.chosenFile());
    }
}

bool FileCommands::openAsCopy(const QString& path) {
    LoadedProject loaded;
    m_wait.aside([&] { loaded = loadProject(path); });
    if (loaded.setup) {
        m_document.startUntitled(std::move(*loaded.setup));
        return true;
    }
    showWhyRefused(loaded, path);
    return false;
}

/// The history keeps the previous contents.
void FileCommands::reload() {
    const QString path = m_document.filePath();
    LoadedProject loaded;
    m_wait.aside([&] { loaded = loadProject(path); });
    if (loaded.setup) {
        m_document.reload(std::move(*loaded.setup), loaded.hash);
        m_guard.followDocument();
        m_notices.followDisk();
        m_notices.showOpened(loaded.issues);
    } else {
        showWhyRefused(loaded, path);
    }
}

void FileCommands::recoverWork() {
    if (mayDiscard()) {
        recover(true);
    }
}

bool FileCommands::save() {
    return m_saver.save();
}

bool FileCommands::saveAs() {
    return m_saver.saveAs();
}

bool FileCommands::mayDiscard() {
    if (!m_lessons.mayLeave()) {
        return false;
    }
    const QStringList refused = m_refused();
    if (!m_document.modified()) {
        return refused.isEmpty() || mayLoseRefused(m_window, refused);
    }
    switch (askUnsaved(m_window, m_document, refused)) {
    case UnsavedAnswer::save: return save();
    case UnsavedAnswer::discard:
        if (m_guard.autosave() != nullptr) {
            m_guard.autosave()->flush(); // it goes to the discarded ones with the last keystroke
        }
        return true;
    case UnsavedAnswer::cancel: break;
    }
    return false;
}

bool FileCommands::mayClose() {
    if (m_wait.busy() || !mayDiscard()) {
        return false;
    }
    if (m_guard.autosave() != nullptr) {
        m_guard.autosave()->discard();
    }
    return true;
}

/// Checks files when the window is activated, for systems without notifications of changes.
bool FileCommands::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_window && event->type() == QEvent::WindowActivate) {
        m_guard.watch().check();
    }
    return QObject::eventFilter(watched, event);
}

} // namespace sparkout
