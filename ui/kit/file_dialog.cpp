// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/file_dialog.h"

#include "ui/kit/font_size.h"
#include "ui/kit/theme_icon.h"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QHeaderView>
#include <QLocale>
#include <QScreen>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr QSize usualDialogSize(760, 460); ///< size of Qt's dialog at the usual font size
constexpr int placesWidth = 140, leastName = 220;
enum Column { name, size, kind, changed };

/// Shows sizes, types and dates in the language of the program, which may differ from the system's.
class FileDelegate : public QStyledItemDelegate {
public:
    FileDelegate(QString folder, QString kilobytes, QObject* parent)
        : QStyledItemDelegate(parent)
        , m_folder(std::move(folder))
        , m_kilobytes(std::move(kilobytes)) {}

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const auto* files = qobject_cast<const QFileSystemModel*>(index.model());
        if (!files) {
            return;
        }
        const QFileInfo file = files->fileInfo(index);
        const QLocale locale;
        if (index.column() == changed) {
            option->text = locale.toString(file.lastModified(), QLocale::ShortFormat);
        } else if (index.column() == size && !file.isDir()) {
            option->text = m_kilobytes.arg(locale.toString((file.size() + 999) / 1000));
        } else if (index.column() == kind && file.isDir()) {
            option->text = m_folder;
        }
    }

private:
    QString m_folder, m_kilobytes;
};

/// Makes the other columns as wide as their contents and gives the name the rest.
void fitColumns(QTreeView& files) {
    int rest = files.viewport()->width();
    for (const int column : {size, kind, changed}) {
        files.resizeColumnToContents(column);
        rest -= files.columnWidth(column);
    }
    files.setColumnWidth(name, std::max(rest, atFontSize(leastName)));
}

} // namespace

void FileDialog::dress(QFileDialog& dialog) {
    auto* const files = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
    if (!files) { // it is the desktop's dialog
        return;
    }
    dialog.setViewMode(QFileDialog::Detail);
    dialog.setItemDelegate(new FileDelegate(tr("Folder"), tr("%1 kB"), &dialog));
    const std::pair<const char*, QStringView> icons[] = {{"backButton", u"back"},
                                                         {"forwardButton", u"forward"},
                                                         {"toParentButton", u"up"},
                                                         {"newFolderButton", u"add"}};
    for (const auto& [button, icon] : icons) {
        if (auto* const found = dialog.findChild<QToolButton*>(QLatin1StringView(button))) {
            found->setIcon(themeIcon(icon));
        }
    }
    for (const char* button : {"listModeButton", "detailModeButton"}) {
        if (auto* const found = dialog.findChild<QToolButton*>(QLatin1StringView(button))) {
            found->hide();
        }
    }
    QSize wanted(atFontSize(usualDialogSize.width()), atFontSize(usualDialogSize.height()));
    if (const QScreen* const screen = dialog.screen()) {
        wanted = wanted.boundedTo(screen->availableSize());
    }
    dialog.resize(wanted);
    if (auto* const parts = dialog.findChild<QSplitter*>(QStringLiteral("splitter"))) {
        const int places = atFontSize(placesWidth);
        parts->setSizes({places, wanted.width() - places});
    }
    const auto fit = [files] { QTimer::singleShot(0, files, [files] { fitColumns(*files); }); };
    if (const auto* const model = qobject_cast<QFileSystemModel*>(files->model())) {
        QObject::connect(model, &QFileSystemModel::directoryLoaded, files, fit);
    }
    fit();
}

QString FileDialog::chosen(QFileDialog& dialog) {
    dress(dialog);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString FileDialog::openPath(QWidget* parent, const QString& title, const QString& folder,
                             const QString& filter) {
    QFileDialog dialog(parent, title, folder, filter);
    dialog.setFileMode(QFileDialog::ExistingFile);
    return chosen(dialog);
}

QString FileDialog::savePath(QWidget* parent, const QString& title, const QString& path,
                             const QString& filter, const QString& suffix) {
    const QFileInfo wanted(path);
    QFileDialog dialog(parent, title, wanted.absolutePath(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(wanted.fileName());
    return chosen(dialog);
}

} // namespace sparkout
