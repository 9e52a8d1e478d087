// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/file_questions.h"

#include "ui/form/mark.h"
#include "ui/kit/help_topic.h"
#include "ui/session/background.h"
#include "ui/session/document.h"
#include "ui/session/guarded_file.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QCursor>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace sparkout {

QStringList FaultsDialog::lines(const Issues& issues) {
    QStringList list;
    for (const Issue& issue : issues) {
        const QString path = QString::fromStdString(issue.path);
        const QString where = locationText(issue.path);
        list += path.isEmpty() ? fileIssueText(issue)
                : where.isEmpty() || where == path.section(u'/', -1)
                    ? tr("%1: %2").arg(path, fileIssueText(issue))
                    : tr("%1 (%2): %3").arg(where, path, fileIssueText(issue));
    }
    return list;
}

FaultsDialog::FaultsDialog(const QString& file, const Issues& issues, QWidget* parent, File state)
    : QDialog(parent) {
    setHelpTopic(*this, QStringLiteral("files#faults"));
    const QString name = printableText(QFileInfo(file).fileName());
    setWindowTitle(state == File::refused ? tr("The file was not opened")
                                          : tr("Faults of the file"));
    auto* head = new QLabel(state == File::refused
                                ? tr("“%1” is refused for these reasons. The project in the window "
                                     "is unchanged.")
                                      .arg(name)
                                : tr("“%1” is open, but these values are refused:").arg(name),
                            this);
    head->setTextFormat(Qt::PlainText);
    head->setWordWrap(true);
    auto* list = new QListWidget(this);
    list->setWordWrap(true);
    list->setAccessibleName(tr("Faults of the file"));
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const QStringList texts = lines(issues);
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const bool isError = issues[std::size_t(i)].severity == Severity::error;
        new QListWidgetItem(markIcon(isError ? Mark::error : Mark::warning), texts[i], list);
    }
    auto* buttons = new QDialogButtonBox(this);
    auto* copy = buttons->addButton(tr("&Copy the list"), QDialogButtonBox::ActionRole);
    auto* close = buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
    copy->setAutoDefault(false);
    close->setDefault(true);
    connect(copy, &QPushButton::clicked, this,
            [texts] { QGuiApplication::clipboard()->setText(texts.join(u'\n')); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(head);
    layout->addWidget(list, 1);
    layout->addWidget(buttons);
    resize(640, 320);
}

void DiskWait::during(const std::function<void()>& work) {
    m_busy = true;
    work();
    m_busy = false;
}

void DiskWait::aside(const std::function<void()>& work) {
    during([&work] {
        QGuiApplication::setOverrideCursor(Qt::WaitCursor);
        runAside(work);
        QGuiApplication::restoreOverrideCursor();
    });
}

std::optional<GuardQuestions::Opening> GuardQuestions::wayToOpen(const QString& path) {
    switch (m_file.claim(path)) {
    case GuardedFile::Access::write: return Opening::write;
    case GuardedFile::Access::readOnly: return Opening::readOnly;
    case GuardedFile::Access::conflict: break;
    }
    switch (askLocked(m_window, path, m_file.holder())) {
    case LockedAnswer::readOnly: return Opening::readOnly;
    case LockedAnswer::copy: m_file.dropClaim(); return Opening::copy;
    case LockedAnswer::takeOver:
        return m_file.takeOver() == GuardedFile::Access::write ? Opening::write : Opening::readOnly;
    case LockedAnswer::cancel: break;
    }
    m_file.dropClaim();
    return {};
}

/// Asks the user about every obstacle to writing the file.
SaveAnswer GuardQuestions::clearTheWay(const QString& path, Reloading reloading) {
    if (m_file.claim(path) == GuardedFile::Access::conflict) {
        const SaveAnswer answer = askSaveLocked(m_window, path, m_file.holder());
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
        (void)m_file.takeOver();
    }
    if (const auto state = m_file.changedOutside(path)) {
        const SaveAnswer answer = askChangedOutside(
            m_window, path,
            state->kind == DiskState::Kind::missing ? Outside::removed : Outside::changed,
            reloading);
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
    }
    if (const std::uint64_t links = linkCount(path); links > 1 && m_linksAccepted != path) {
        const SaveAnswer answer = askHardLinks(m_window, path, links);
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
        m_linksAccepted = path;
    }
    return SaveAnswer::proceed;
}

GuardQuestions::Outcome
GuardQuestions::save(const QString& path, Reloading reloading,
                     const std::function<std::optional<FileError>()>& write) {
    m_error.reset();
    do {
        switch (clearTheWay(path, reloading)) {
        case SaveAnswer::proceed: break;
        case SaveAnswer::elsewhere: m_file.dropClaim(); return Outcome::elsewhere;
        case SaveAnswer::reload: m_file.dropClaim(); return Outcome::reload;
        case SaveAnswer::cancel: m_file.dropClaim(); return Outcome::cancelled;
        }
        m_wait.during([&] { m_error = write(); });
        // Somebody was quicker than the answer: the next look at the disk asks again.
    } while (m_error && m_error->step == FileStep::changed && m_file.changedOutside(path));
    return m_error ? Outcome::failed : Outcome::saved;
}

GuardQuestions::Outcome GuardQuestions::save(const QString& path, Reloading reloading,
                                             const MakeContent& make) {
    return save(path, reloading, [&] { return m_file.write(path, make); });
}

namespace {

constexpr qsizetype linesShown = 6;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(FileQuestion)
};

/// A message box of plain text, so that no file name is taken for markup.
class Question {
public:
    Question(QWidget* window, QMessageBox::Icon icon, const QString& title, const QString& text)
        : m_box(icon, title, {}, QMessageBox::NoButton, window) {
        m_box.setTextFormat(Qt::PlainText);
        m_box.setText(text);
    }

    /// A long path may be broken after each slash.
    void breakPath(const QString& path) {
        const QString shown = printableText(path);
        QString broken = shown;
        broken.replace(u'/', QStringLiteral("/\u200b"));
        m_box.setText(m_box.text().replace(shown, broken));
    }

    QAbstractButton* add(const QString& text, QMessageBox::ButtonRole role, const char* name) {
        QAbstractButton* button = m_box.addButton(text, role);
        button->setObjectName(QString::fromLatin1(name));
        return button;
    }
    void addDefault(const QString& text, QMessageBox::ButtonRole role, const char* name) {
        m_box.setDefaultButton(qobject_cast<QPushButton*>(add(text, role, name)));
    }
    void addCancel(const QString& text = Words::tr("&Cancel")) {
        QAbstractButton* button = add(text, QMessageBox::RejectRole, "cancel");
        m_box.setEscapeButton(button);
        if (m_box.defaultButton() == nullptr) {
            m_box.setDefaultButton(qobject_cast<QPushButton*>(button));
        }
    }

    /// The name of the chosen button.
    [[nodiscard]] QString ask() {
        m_box.exec();
        return m_box.clickedButton() ? m_box.clickedButton()->objectName() : QString();
    }

private:
    QMessageBox m_box;
};

/// The first lines of a list under a heading.
QString listed(const QString& heading, const QStringList& lines) {
    QString text = QStringLiteral("\n\n") + heading;
    for (const QString& line : lines.mid(0, linesShown)) {
        text += QStringLiteral("\n• ") + line;
    }
    if (const qsizetype more = lines.size() - linesShown; more > 0) {
        text += QStringLiteral("\n• ") + Words::tr("%n more", nullptr, int(more));
    }
    return text;
}

QString unsavedText(const Document& document, const QStringList& refused) {
    const QString title = QString::fromStdString(document.project().title).simplified();
    const QString path = document.filePath();
    QString text = path.isEmpty() ? Words::tr("“%1” has never been saved. Save it?")
                                        .arg(title.isEmpty() ? Words::tr("Untitled") : title)
                                  : Words::tr("Save the changes to “%1”?").arg(printableText(path));
    if (const QStringList edits = document.unsavedEdits(); !edits.isEmpty()) {
        text += listed(Words::tr("Not saved:"), edits);
    }
    if (!refused.isEmpty()) {
        text += listed(Words::tr("Invalid entries (not saved):"), refused);
    }
    return text;
}

} // namespace

void showFailure(QWidget* window, const QString& title, const QString& text) {
    Question question(window, QMessageBox::Critical, title, text);
    question.addCancel(Words::tr("C&lose"));
    (void)question.ask();
}

bool mayReplace(QWidget* window, const QString& path) {
    Question question(window, QMessageBox::Question, Words::tr("Replace the file?"),
                      Words::tr("“%1” exists already. Replace it?").arg(printableText(path)));
    question.breakPath(path);
    question.add(Words::tr("&Replace"), QMessageBox::AcceptRole, "replace");
    question.addCancel();
    return question.ask() == u"replace";
}

UnsavedAnswer askUnsaved(QWidget* window, const Document& document, const QStringList& refused) {
    Question question(window, QMessageBox::Question, Words::tr("Unsaved changes"),
                      unsavedText(document, refused));
    if (!document.filePath().isEmpty()) {
        question.breakPath(document.filePath());
    }
    question.addDefault(document.readOnly() ? Words::tr("&Save as…") : Words::tr("&Save"),
                        QMessageBox::AcceptRole, "save");
    question.add(Words::tr("&Do not save"), QMessageBox::DestructiveRole, "discard");
    question.addCancel();
    const QString answer = question.ask();
    return answer == u"save"      ? UnsavedAnswer::save
           : answer == u"discard" ? UnsavedAnswer::discard
                                  : UnsavedAnswer::cancel;
}

bool mayLoseRefused(QWidget* window, const QStringList& refused) {
    Question question(
        window, QMessageBox::Question, Words::tr("Invalid entries"),
        Words::tr("Everything but the invalid entries is saved. Continue without them?")
            + listed(Words::tr("Refused:"), refused));
    question.add(Words::tr("&Continue"), QMessageBox::DestructiveRole, "discard");
    question.addCancel(Words::tr("&Back to the fields"));
    return question.ask() == u"discard";
}

QString holderText(const LockHolder& holder) {
    const QString since = momentText(holder.since);
    if (!holder.readable) {
        return Words::tr("The lock file beside it cannot be read; it belongs to the user %1 and "
                         "dates from %2.")
            .arg(holder.user, since);
    }
    return Words::tr("User: %1\nComputer: %2\nProgram: %3, process %4\nSince: %5")
        .arg(holder.user, printableText(holder.host), printableText(holder.program),
             QString::number(holder.process), since);
}

QString inUseText(const QString& path, const LockHolder& holder) {
    return Words::tr("“%1” is open in another window.").arg(printableText(path))
           + QStringLiteral("\n\n") + holderText(holder);
}

QString strangeLockText(const QString& strange) {
    return Words::tr("The file is not locked against other users: “%1” has the name of its lock "
                     "file but is not one. It was left unchanged.")
        .arg(printableText(strange));
}

LockedAnswer askLocked(QWidget* window, const QString& path, const LockHolder& holder) {
    QString text = holder.readable
                       ? Words::tr("“%1” is open already.").arg(printableText(path))
                       : Words::tr("“%1” seems to be open already.").arg(printableText(path));
    text += QStringLiteral("\n\n") + holderText(holder) + QStringLiteral("\n\n")
            + Words::tr("Open it anyway only if nobody is working in it any more.");
    Question question(window, QMessageBox::Warning, Words::tr("The file is in use"), text);
    question.breakPath(path);
    question.addDefault(Words::tr("Open &read-only"), QMessageBox::AcceptRole, "readOnly");
    question.add(Words::tr("Open a co&py"), QMessageBox::AcceptRole, "copy");
    question.add(Words::tr("&Open anyway"), QMessageBox::DestructiveRole, "takeOver");
    question.addCancel();
    const QString answer = question.ask();
    return answer == u"readOnly"   ? LockedAnswer::readOnly
           : answer == u"copy"     ? LockedAnswer::copy
           : answer == u"takeOver" ? LockedAnswer::takeOver
                                   : LockedAnswer::cancel;
}

namespace {

SaveAnswer saveAnswer(const QString& answer) {
    return answer == u"proceed"     ? SaveAnswer::proceed
           : answer == u"elsewhere" ? SaveAnswer::elsewhere
           : answer == u"reload"    ? SaveAnswer::reload
                                    : SaveAnswer::cancel;
}

} // namespace

SaveAnswer askChangedOutside(QWidget* window, const QString& path, Outside what,
                             Reloading reloading) {
    const bool missing = what == Outside::removed;
    const bool reloads = reloading == Reloading::offered && !missing;
    const QString text =
        missing ? Words::tr("“%1” has been removed or renamed since it was opened.")
        : reloads
            ? Words::tr("“%1” was changed by another program since it was opened.\n\nSaving "
                        "replaces that version; it is kept as the previous one.\nReloading "
                        "takes that version; your changes stay in Undo.")
            : Words::tr("“%1” was changed by another program since it was opened or saved.\n\n"
                        "Saving replaces that version; it is kept as the previous one.\nWith "
                        "another name both versions stay as they are.");
    Question question(window, QMessageBox::Warning, Words::tr("Changed outside"),
                      text.arg(printableText(path)));
    question.breakPath(path);
    question.add(Words::tr("Save an&yway"),
                 missing ? QMessageBox::AcceptRole : QMessageBox::DestructiveRole, "proceed");
    question.addDefault(Words::tr("Save &as…"), QMessageBox::AcceptRole, "elsewhere");
    if (reloads) {
        question.add(Words::tr("&Reload"), QMessageBox::AcceptRole, "reload");
    }
    question.addCancel();
    return saveAnswer(question.ask());
}

SaveAnswer askSaveLocked(QWidget* window, const QString& path, const LockHolder& holder) {
    Question question(window, QMessageBox::Warning, Words::tr("The file is in use"),
                      inUseText(path, holder));
    question.breakPath(path);
    question.add(Words::tr("Save an&yway"), QMessageBox::DestructiveRole, "proceed");
    question.addDefault(Words::tr("Save &as…"), QMessageBox::AcceptRole, "elsewhere");
    question.addCancel();
    return saveAnswer(question.ask());
}

SaveAnswer askHardLinks(QWidget* window, const QString& path, std::uint64_t links) {
    Question question(window, QMessageBox::Warning, Words::tr("The file has several names"),
                      Words::tr("“%1” has %n other names (hard links). They will keep the old text "
                                "and no longer be the same file.",
                                nullptr, int(links) - 1)
                          .arg(printableText(path)));
    question.breakPath(path);
    question.add(Words::tr("Save an&yway"), QMessageBox::DestructiveRole, "proceed");
    question.addDefault(Words::tr("Save &as…"), QMessageBox::AcceptRole, "elsewhere");
    question.addCancel();
    return saveAnswer(question.ask());
}

FailureAnswer askSaveFailed(QWidget* window, const FileError& error) {
    Question question(window, QMessageBox::Critical, Words::tr("The project was not saved"),
                      saveErrorText(error) + QStringLiteral("\n\n")
                          + Words::tr("The project in the window is unchanged and still counts as "
                                      "not saved."));
    question.breakPath(QString::fromStdString(error.path));
    question.addDefault(Words::tr("&Try again"), QMessageBox::AcceptRole, "again");
    question.add(Words::tr("Save &as…"), QMessageBox::AcceptRole, "elsewhere");
    question.addCancel();
    const QString answer = question.ask();
    return answer == u"again"       ? FailureAnswer::again
           : answer == u"elsewhere" ? FailureAnswer::elsewhere
                                    : FailureAnswer::cancel;
}

} // namespace sparkout
