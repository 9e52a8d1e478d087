// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/saved_file.h"

#include "ui/dialogs/notice_bar.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QPointer>
#include <QStatusBar>
#include <QUrl>

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

/// Without a desktop there is no such program: shows the path of the file.
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

} // namespace sparkout
