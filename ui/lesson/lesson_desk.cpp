// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_desk.h"

#include "core/file/project_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/make_variants.h"
#include "core/setup/setup_file.h"
#include "core/study/new_project.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/dialogs/watched_work.h"
#include "ui/kit/file_dialog.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/lesson/lesson_text.h"
#include "ui/lesson/lessons_dialog.h"
#include "ui/lesson/marks_dialog.h"
#include "ui/session/document.h"
#include "ui/session/program_log.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"
#include "words/lesson_words.h"

#include <QFile>
#include <QFileInfo>

#include <stop_token>
#include <utility>

namespace sparkout {

namespace {

const QString lessonEnding = QStringLiteral(".sparkout-lesson");
const QString workEnding = QStringLiteral(".sparkout-work");
const QString saveNotice = QStringLiteral("lesson-not-saved");
const QString changedNotice = QStringLiteral("lesson-changed-outside");
const QString readOnlyNotice = QStringLiteral("lesson-read-only");
const QString diskNotice = QStringLiteral("lesson-disk");
const QString lockNotice = QStringLiteral("lesson-lock");
constexpr int draftPause_ms = 1000;

/// The part of a set-up that is handed in: without kept runs and measurements.
std::string handedIn(Setup setup) {
    for (GroundSurface& surface : setup.surfaces) {
        surface.project.runs.clear();
        surface.project.measured.reset();
    }
    return writeSetup(setup);
}

} // namespace

LessonDesk::LessonDesk(Document& document, Settings& settings, NoticeBar& notices, QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_settings(settings)
    , m_notices(notices)
    , m_window(window)
    , m_panel(new LessonPanel(m_run, window))
    , m_questions(m_file, m_wait, window) {
    m_draft.setSingleShot(true);
    m_draft.setInterval(draftPause_ms);
    connect(&m_draft, &QTimer::timeout, this, &LessonDesk::keepDraft);
    connect(m_panel, &LessonPanel::edited, this, [this] { m_draft.start(); });
    connect(m_panel, &LessonPanel::handInAsked, this, &LessonDesk::handIn);
    connect(m_panel, &LessonPanel::stepAsked, this, &LessonDesk::showStep);
    connect(&m_document, &Document::edited, this, [this] {
        if (isRunning()) {
            m_draft.start();
        }
    });
    connect(&m_document, &Document::replaced, this, [this] {
        if (!m_isOwn && isRunning()) { // another one was opened
            finish();
        }
    });
    connect(&m_run, &LessonRun::saveWanted, this, &LessonDesk::takeEntry);
    connect(&m_file, &GuardedFile::changedOnDisk, this, &LessonDesk::showChangedOnDisk);
    connect(&m_file, &GuardedFile::restoredOnDisk, this, &LessonDesk::showFileState);
}

LessonDesk::~LessonDesk() {
    m_document.disconnect(this);
    if (isRunning()) {
        keepDraft();
        m_run.flush();
    }
    delete m_panel; // it uses the run
}

void LessonDesk::protect(const QString& stateFolder) {
    m_stateFolder = stateFolder;
    m_file.protect(stateFolder);
    m_run.keepDraftsIn(draftFolder());
}

bool LessonDesk::isOfLesson(const QString& path) {
    return path.endsWith(lessonEnding, Qt::CaseInsensitive)
           || path.endsWith(workEnding, Qt::CaseInsensitive);
}

void LessonDesk::open(const QString& path) {
    if (path.endsWith(workEnding, Qt::CaseInsensitive)) {
        openWork(path);
    } else {
        openLesson(path);
    }
}

void LessonDesk::choose(const std::function<bool()>& mayDiscard) {
    LessonsDialog dialog(m_settings.folder(), m_window);
    if (dialog.exec() == QDialog::Accepted && !dialog.chosen().isEmpty() && mayDiscard()) {
        openLesson(dialog.chosen());
    }
}

bool LessonDesk::tryOut(const Lesson& lesson, std::size_t step) {
    auto work = makeWork(lesson, 1, tr("trial"), {});
    auto trial = std::make_unique<Trial>();
    if (!work || !trial->folder.isValid()) {
        return false;
    }
    if (isRunning()) {
        finish();
    }
    trial->base = lesson.base;
    m_trial = std::move(trial);
    m_file.unprotect();
    QString path = m_trial->folder.filePath(tr("trial") + workEnding);
    const bool isSaved = keep(*work, path) == GuardQuestions::Outcome::saved;
    start(std::move(*work), path, isSaved);
    showStep(step);
    return true;
}

void LessonDesk::markWorks() {
    if (!m_marks) {
        m_marks = new MarksDialog(m_settings, m_window);
    }
    m_marks->show();
    m_marks->raise();
    m_marks->activateWindow();
}

std::optional<std::string> LessonDesk::textOf(const QString& path) {
    if (path.startsWith(u':')) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? std::optional(file.readAll().toStdString())
                                              : std::nullopt;
    }
    auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        showFailure(m_window, tr("The file was not opened"), readErrorText(*error));
        return std::nullopt;
    }
    return std::get<std::string>(std::move(read));
}

void LessonDesk::showFaults(const QString& path, const Issues& issues) {
    FaultsDialog(path, issues, m_window).exec();
}

void LessonDesk::openLesson(const QString& path) {
    const auto text = textOf(path);
    if (!text) {
        return;
    }
    const ReadLesson read = readLessonOfAnybody(*text);
    if (!read.lesson) {
        showFaults(path, read.issues);
        return;
    }
    begin(*read.lesson, QFileInfo(path).completeBaseName());
}

/// Asks once for the student, the variant and the file.
void LessonDesk::begin(const Lesson& lesson, const QString& name) {
    const QStringList before = m_settings.student();
    StudentDialog dialog(lesson, before.value(0), before.value(1), m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    m_settings.setStudent(dialog.name(), dialog.group());
    auto work = makeWork(lesson, dialog.variant(), dialog.name(), dialog.group());
    if (!work) {
        return;
    }
    const QString file = fileNameOf({name, dialog.group(), dialog.name()});
    QString path = askPath(m_settings.lastFolder() + u'/' + file + workEnding);
    if (path.isEmpty()) {
        return;
    }
    if (m_trial) {
        finish();
    }
    switch (keep(*work, path)) {
    case GuardQuestions::Outcome::saved: start(std::move(*work), path, true); break;
    case GuardQuestions::Outcome::failed: // it begins anyway, and can be saved elsewhere
        m_file.follow(path, {});
        start(std::move(*work), path, false);
        break;
    default: break;
    }
}

std::optional<Work> LessonDesk::makeWork(const Lesson& lesson, int variant, const QString& name,
                                         const QString& group) {
    MadeVariants made;
    if (lesson.variants || asksForBest(lesson)) {
        std::stop_source stop;
        const bool done = runWatched(
            m_window, tr("Making the variant"),
            [&](const KeepGoing& keepGoing) {
                made = makeVariants(lesson, std::size_t(variant), seedByNumber, stop.get_token(),
                                    [&](const VariantTry& tried) {
                                        if (!keepGoing(double(tried.made) / variant)) {
                                            stop.request_stop();
                                        }
                                    });
            },
            stop);
        if (!done || made.isStopped) {
            return std::nullopt;
        }
        if (made.fault != LessonFault::none) {
            const QString why =
                QCoreApplication::translate("Variants", lessonFaultText(made.fault));
            showFailure(m_window, tr("The lesson cannot be started"),
                        why.left(1).toUpper() + why.mid(1) + u'.');
            return std::nullopt;
        }
        if (made.variants.size() < std::size_t(variant)) {
            showFailure(m_window, tr("This variant does not exist"),
                        tr("The lesson has %1 variants.").arg(made.variants.size()));
            return std::nullopt;
        }
    } else {
        made.variants.assign(std::size_t(variant), MadeVariant());
    }
    const MadeVariant& drawn = made.variants[std::size_t(variant) - 1];
    return newWork(lesson, drawn.levels,
                   drawn.best ? std::optional(drawn.best->time_min) : std::nullopt, variant,
                   name.toStdString(), group.toStdString());
}

void LessonDesk::openWork(const QString& given) {
    if (m_trial) { // it is discarded, and its file is not protected
        finish();
    }
    const QString path = QFileInfo(given).absoluteFilePath();
    const auto opening = m_questions.wayToOpen(path); // first, or somebody could save meanwhile
    if (!opening) {
        return;
    }
    const auto text = textOf(path);
    ReadWork read = text ? readWork(*text) : ReadWork();
    if (!read.work) {
        m_file.dropClaim();
        if (text) {
            showFaults(path, read.issues);
        }
        return;
    }
    const bool isBroken = brokenSeal(*read.work).has_value();
    if (*opening == GuardQuestions::Opening::copy) {
        QString copy =
            askPath(QFileInfo(path).path() + u'/'
                    + tr("%1 copy").arg(QFileInfo(path).completeBaseName()) + workEnding);
        if (copy.isEmpty() || keep(*read.work, copy) != GuardQuestions::Outcome::saved) {
            if (const auto& error = m_questions.error(); !copy.isEmpty() && error) {
                m_file.dropClaim();
                showFailure(m_window, tr("The work is not saved"), saveErrorText(*error));
            }
            return;
        }
        start(std::move(*read.work), copy, true);
    } else {
        m_file.follow(path, contentHash(*text), *opening == GuardQuestions::Opening::readOnly);
        start(std::move(*read.work), path, true);
    }
    if (isBroken) {
        m_notices.add(
            {changedNotice,
             Mark::warning,
             [] {
                 return tr("This work was changed outside the program. The teacher will see it.");
             },
             {}});
    }
}

void LessonDesk::start(Work work, const QString& path, bool isSaved) {
    if (isRunning()) {
        keepDraft();
        endRun();
    }
    m_notices.remove(changedNotice);
    m_run.keepDraftsIn(draftFolder());
    m_run.start(std::move(work), path, isSaved);
    ProgramLog::note(tr("Opened: %1").arg(printableText(path)));
    if (!m_trial) {
        emit opened(path);
    }
    if (!isSaved) {
        showNotSaved();
    }
    showFileState();
    putStep();
}

/// Empty for a trial and for a work that somebody else has open.
QString LessonDesk::draftFolder() const {
    return m_stateFolder.isEmpty() || m_trial || m_file.isReadOnly()
               ? QString()
               : m_stateFolder + QStringLiteral("/lessons");
}

QString LessonDesk::askPath(const QString& suggested) {
    const QString path = FileDialog::savePath(m_window, tr("Keep the work in"), suggested,
                                              tr("Works (*%1)").arg(workEnding), workEnding);
    return path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
}

GuardQuestions::Outcome LessonDesk::keep(const Work& work, QString& path) {
    const auto text = [&work]() -> std::optional<std::string> {
        std::string written = writeWork(work);
        return readWork(written).work ? std::optional(std::move(written)) : std::nullopt;
    };
    for (;;) {
        const auto outcome = m_questions.save(path, Reloading::notOffered, text);
        if (outcome != GuardQuestions::Outcome::elsewhere) {
            return outcome;
        }
        path = askPath(path);
        if (path.isEmpty()) {
            return GuardQuestions::Outcome::cancelled;
        }
    }
}

bool LessonDesk::write(QString path) {
    if (m_wait.busy()) {
        return false;
    }
    m_questions.forgetError();
    if (isReadOnly() && path == m_run.file()) {
        path = askPath(path);
    }
    const Work work = m_run.work();
    if (path.isEmpty() || keep(work, path) != GuardQuestions::Outcome::saved) {
        showNotSaved();
        return false;
    }
    const bool isAnother = path != m_run.file();
    m_notices.remove(saveNotice);
    m_run.keepDraftsIn(draftFolder());
    m_run.markSaved(path, work.entries.size());
    showFileState();
    if (isAnother && !m_trial) {
        emit opened(path);
    }
    return true;
}

void LessonDesk::showNotSaved() {
    const auto error = m_questions.error();
    m_notices.add({saveNotice,
                   Mark::error,
                   [error] {
                       return error ? tr("The work is not saved. %1").arg(saveErrorText(*error))
                                    : tr("The work is not saved: the answers handed in are only in "
                                         "this window.");
                   },
                   {{[] { return tr("Try again"); }, [this] { save(); }},
                    {[] { return tr("Save elsewhere…"); }, [this] { saveAs(); }}}});
}

/// Shows notices about the file.
void LessonDesk::showFileState() {
    for (const QString& key : {readOnlyNotice, diskNotice, lockNotice}) {
        m_notices.remove(key);
    }
    if (m_file.isReadOnly()) {
        m_notices.add(
            {readOnlyNotice,
             Mark::none,
             [name = printableText(QFileInfo(m_run.file()).fileName())] {
                 return tr("“%1” is open read-only. Answers handed in are saved to another "
                           "file.")
                     .arg(name);
             },
             {{[] { return tr("Save elsewhere…"); }, [this] { saveAs(); }}}});
    }
    if (const QString strange = m_file.strangeLock(); !strange.isEmpty()) {
        m_notices.add(
            {lockNotice, Mark::warning, [strange] { return strangeLockText(strange); }, {}});
    }
}

void LessonDesk::showChangedOnDisk() {
    m_run.markUnsaved();
    m_notices.add({diskNotice,
                   Mark::warning,
                   [name = printableText(QFileInfo(m_run.file()).fileName())] {
                       return tr("“%1” was changed or removed by another program while it is open "
                                 "here. Saving will ask which version counts.")
                           .arg(name);
                   },
                   {{[] { return tr("Save elsewhere…"); }, [this] { saveAs(); }}}});
}

void LessonDesk::showStep(std::size_t step) {
    if (!isRunning() || step >= m_run.lesson().steps.size()) {
        return;
    }
    m_endTyping();
    keepDraft();
    m_run.show(step);
    putStep();
}

void LessonDesk::showNext(int by) {
    const auto to = static_cast<qsizetype>(m_run.step()) + by;
    if (isRunning() && to >= 0) {
        showStep(static_cast<std::size_t>(to));
    }
}

/// Shows the current step in the window: its inputs, what is free and hidden, and its moment.
void LessonDesk::putStep() {
    const LessonStep& step = m_run.current();
    m_moment = step.moment;
    m_isOwn = true;
    m_hidden.hide(HiddenThings::of(m_run));
    m_document.startUntitled(m_run.setupFor(m_run.step()));
    m_document.showSurface(static_cast<std::size_t>(step.surface) - 1);
    m_document.setGate([this](const SetupState& after) { return allows(after); });
    m_document.keepElsewhere();
    m_isOwn = false;
    m_draft.stop();
    m_run.announce();
    emit limitsChanged();
}

/// Whether a set-up differs from that of the step only in free inputs.
bool LessonDesk::allows(const SetupState& after) const {
    Lesson one;
    one.base = m_run.lesson().base;
    one.steps = {m_run.current()};
    if (isCovered()) {
        one.steps.front().others = Access::locked;
        one.steps.front().inputs.clear();
    }
    return forbiddenChanges(one, 0, after.setup()).empty();
}

void LessonDesk::handIn(Answer answer) {
    m_endTyping();
    if (isMetBySetting(m_run.current().goal.kind())) {
        answer.setup.text = handedIn(m_document.setup());
    }
    m_draft.stop();
    m_wasCovered = isCovered();
    m_run.handIn(std::move(answer));
    m_wasCovered = false;
}

/// Shows what was handed in before asking anything.
void LessonDesk::takeEntry() {
    if (m_wasCovered && !isCovered()) {
        m_hidden.hide(HiddenThings::of(m_run));
        emit limitsChanged();
        emit uncovered();
    }
    write(m_run.file());
}

/// Includes the set-up if it was changed.
void LessonDesk::keepDraft() {
    m_draft.stop();
    if (!isRunning()) {
        return;
    }
    Answer draft = m_panel->answer();
    const std::string setup = handedIn(m_document.setup());
    if (setup != handedIn(setupOf(m_run.lesson(), m_run.step()))) {
        draft.setup.text = setup;
    }
    m_run.setDraft(std::move(draft));
}

void LessonDesk::save() {
    keepDraft();
    if (write(m_run.file())) {
        emit reported(tr("Saved."));
    }
}

void LessonDesk::saveAs() {
    if (const QString path = askPath(m_run.file()); !path.isEmpty()) {
        write(path);
    }
}

bool LessonDesk::mayLeave() {
    if (!isRunning()) {
        return true;
    }
    if (m_wait.busy()) {
        return false;
    }
    m_endTyping();
    keepDraft();
    m_run.flush();
    if (m_run.isSaved() || write(m_run.file())) {
        return true;
    }
    if (m_questions.error()) {
        showFailure(m_window, tr("The work is not saved"), saveErrorText(*m_questions.error()));
        saveAs();
    }
    return m_run.isSaved();
}

void LessonDesk::leave() {
    if (isRunning() && mayLeave()) {
        const Setup next = m_trial ? m_trial->base : plainSetup(newProject());
        finish();
        m_document.startUntitled(next);
    }
}

void LessonDesk::endRun() {
    m_draft.stop();
    m_moment.reset();
    m_notices.remove(saveNotice);
    m_run.end();
    m_hidden.hide({});
    emit limitsChanged();
    if (m_trial) {
        m_trial.reset();
        if (!m_stateFolder.isEmpty()) {
            m_file.protect(m_stateFolder);
        }
        emit tried();
    }
}

void LessonDesk::finish() {
    endRun();
    m_file.follow({}, {});
    showFileState();
}

void LessonDesk::takeOutcome(bool ran) {
    if (ran && m_moment && isRunning() && !isCovered()) {
        const ShownMoment moment = *m_moment;
        m_moment.reset();
        emit momentWanted(moment);
    }
}

void LessonDesk::retranslate() {
    m_panel->retranslate();
}

} // namespace sparkout
