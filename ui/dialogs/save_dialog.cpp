// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/save_dialog.h"

#include "core/file/safe_file.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/dialogs/watched_work.h"
#include "ui/kit/file_dialog.h"
#include "ui/session/background.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QUrl>

#include <optional>

namespace sparkout {

namespace {

constexpr int patience_ms = 10'000;

} // namespace

void SavedFile::show(QWidget* from, const QString& path) {
    QWidgetList windows = QApplication::topLevelWidgets();
    for (QWidget* one = from; one; one = one->parentWidget()) {
        windows.prepend(one);
    }
    for (const QWidget* one : windows) {
        const auto* main = qobject_cast<const QMainWindow*>(one);
        if (!main) {
            continue;
        }
        if (auto* notices = main->findChild<NoticeBar*>()) {
            addNotice(*notices, path);
            return;
        }
        if (auto* status = main->findChild<QStatusBar*>()) {
            const QFileInfo file(path);
            status->showMessage(
                tr("Saved: “%1” in %2")
                    .arg(printableText(file.fileName()),
                         printableText(QDir::toNativeSeparators(file.absolutePath()))),
                patience_ms);
            return;
        }
    }
}

void SavedFile::addNotice(NoticeBar& bar, const QString& path) {
    const QFileInfo file(path);
    const auto to = [&bar](const QString& target) {
        return [notices = QPointer(&bar), target] {
            if (notices) {
                open(*notices, target);
            }
        };
    };
    bar.add({QString::fromLatin1(noticeKey),
             Mark::none,
             [file] {
                 return tr("Saved: “%1” in %2")
                     .arg(printableText(file.fileName()),
                          printableText(QDir::toNativeSeparators(file.absolutePath())));
             },
             {{[] { return tr("Open"); }, to(file.absoluteFilePath())},
              {[] { return tr("Show in folder"); }, to(file.absolutePath())}}});
}

/// Without a desktop the program does not exist: shows the path of the file.
void SavedFile::open(NoticeBar& bar, const QString& path) {
    if (QFileInfo::exists(path) && QDesktopServices::openUrl(QUrl::fromLocalFile(path))) {
        return;
    }
    bar.add({QString::fromLatin1(noticeKey),
             Mark::warning,
             [path] {
                 const QString shown = printableText(QDir::toNativeSeparators(path));
                 return QFileInfo::exists(path) ? tr("No program opens %1; assign one").arg(shown)
                                                : tr("%1 is no longer there").arg(shown);
             },
             {}});
}

namespace {

constexpr int longestName = 80;

class SaveDialog {
    Q_DECLARE_TR_FUNCTIONS(SaveDialog)
public:
    static QString askPath(QWidget* window, const QString& folder, const SaveRequest& request);
    static bool offerAnother(QWidget* window, const QString& text);
    static QString failure() { return tr("The document, picture or table could not be made."); }
};

QString SaveDialog::askPath(QWidget* window, const QString& folder, const SaveRequest& request) {
    return FileDialog::savePath(window, request.title,
                                folder + u'/' + request.name + u'.' + request.suffix,
                                request.filter, request.suffix);
}

bool SaveDialog::offerAnother(QWidget* window, const QString& text) {
    QMessageBox box(QMessageBox::Critical, tr("The file was not saved"), text,
                    QMessageBox::NoButton, window);
    box.setTextFormat(Qt::PlainText);
    const auto* other = box.addButton(tr("Choose &another place…"), QMessageBox::AcceptRole);
    box.addButton(tr("C&lose"), QMessageBox::RejectRole);
    box.exec();
    return box.clickedButton() == other;
}

/// Empty, or the reason why the file was not saved; outer empty if the user cancelled.
std::optional<QString> save(QWidget* window, const QString& path, const SaveRequest& request) {
    const std::filesystem::path target = systemPath(path);
    bool made = false;
    std::optional<FileError> error;
    const auto write = [&](const QByteArray& bytes) {
        made = !bytes.isEmpty();
        if (made) {
            error = writeFileSafely(target,
                                    {bytes.constData(), static_cast<std::size_t>(bytes.size())});
        }
    };
    if (request.stream) {
        const std::stop_source stop;
        runWatched(
            window, request.title,
            [&](const KeepGoing& keepGoing) {
                made = request.stream(target, keepGoing, stop.get_token(), error);
            },
            stop);
        if (!made && !error) {
            return std::nullopt; // stopped
        }
        made = true;
    } else if (request.longWork) {
        const bool whole = runWatched(window, request.title, [&](const KeepGoing& keepGoing) {
            write(request.longWork(keepGoing));
        });
        if (!whole && !made) {
            return std::nullopt;
        }
    } else {
        QGuiApplication::setOverrideCursor(Qt::WaitCursor);
        const std::function<QByteArray()> make = request.prepare();
        runAside([&] { write(make()); });
        QGuiApplication::restoreOverrideCursor();
    }
    return !made ? SaveDialog::failure() : error ? saveErrorText(*error) : QString();
}

/// Saves a guarded file; changes its path if the user wants.
std::optional<QString> saveGuarded(QWidget* window, QString& path, const SaveRequest& request) {
    while (!path.isEmpty()) {
        switch (request.guard->save(path, Reloading::notOffered, request.content)) {
        case GuardQuestions::Outcome::saved: return QString();
        case GuardQuestions::Outcome::failed: return saveErrorText(*request.guard->error());
        case GuardQuestions::Outcome::elsewhere:
            path = SaveDialog::askPath(window, QFileInfo(path).absolutePath(), request);
            break;
        default: return std::nullopt;
        }
    }
    return std::nullopt;
}

} // namespace

bool saveWithDialog(QWidget* from, Settings* settings, const SaveRequest& request) {
    const QPointer<QWidget> window(from); // a detached window may be closed by then
    QString folder = settings ? settings->lastFolder() : QDir::homePath();
    for (;;) {
        QString path = SaveDialog::askPath(window.data(), folder, request);
        if (path.isEmpty()) {
            return false;
        }
        const std::optional<QString> outcome = request.guard
                                                   ? saveGuarded(window.data(), path, request)
                                                   : save(window.data(), path, request);
        if (!outcome) {
            return false;
        }
        const QString& failure = *outcome;
        const QDir chosen = QFileInfo(path).absoluteDir();
        if (failure.isEmpty() && settings) {
            settings->setLastFolder(chosen.absolutePath());
        }
        if (failure.isEmpty()) {
            SavedFile::show(window.data(), path);
            return true;
        }
        folder = chosen.exists() ? chosen.absolutePath() : folder;
        if (!SaveDialog::offerAnother(window.data(), failure)) {
            return false;
        }
    }
}

QString fileNameOf(const QStringList& parts) {
    static const QRegularExpression unfit(QStringLiteral("[\\\\/:*?\"<>|\\x00-\\x1f]+"));
    QStringList kept;
    for (const QString& part : parts) {
        if (const QString text = part.simplified(); !text.isEmpty()) {
            kept << text;
        }
    }
    QString name = kept.join(QStringLiteral(" – "));
    name.replace(unfit, QStringLiteral("_"));
    if (name.size() > longestName) { // preferably at the end of a word
        const qsizetype space = name.lastIndexOf(u' ', longestName);
        name.truncate(space > longestName / 2 ? space : longestName);
        static const QRegularExpression loose(QStringLiteral("[ –·,;_-]+$"));
        name.remove(loose);
    }
    while (name.startsWith(u'.') || name.startsWith(u' ')) {
        name.remove(0, 1); // no hidden file
    }
    return name.trimmed();
}

} // namespace sparkout
