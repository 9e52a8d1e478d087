// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_commands.h"

#include "ui/dialogs/examples_dialog.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/session/document.h"
#include "ui/session/operation.h"
#include "ui/session/settings.h"
#include "ui/session/texts.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

namespace sparkout {

namespace {

const QString suffix = QStringLiteral(".sparkout");

void showFailure(QWidget* window, const QString& title, const QString& text) {
    QMessageBox box(QMessageBox::Critical, title, text, QMessageBox::NoButton, window);
    box.setTextFormat(Qt::PlainText);
    box.addButton(FileCommands::tr("C&lose"), QMessageBox::RejectRole);
    box.exec();
}

bool mayReplace(QWidget* window, const QString& path) {
    QMessageBox box(QMessageBox::Question, FileCommands::tr("Replace the file?"),
                    FileCommands::tr("“%1” exists already. Replace it?").arg(path),
                    QMessageBox::NoButton, window);
    box.setTextFormat(Qt::PlainText);
    const auto* replace = box.addButton(FileCommands::tr("&Replace"), QMessageBox::AcceptRole);
    box.addButton(FileCommands::tr("&Cancel"), QMessageBox::RejectRole);
    box.exec();
    return box.clickedButton() == replace;
}

} // namespace

FileCommands::FileCommands(Document& document, Settings& settings, QWidget* window)
    : QObject(window), m_document(document), m_settings(settings), m_window(window) {}

void FileCommands::startNew(Operation operation) {
    if (mayDiscard()) {
        m_document.startUntitled(newProject(operation));
    }
}

void FileCommands::open() {
    if (!mayDiscard()) {
        return;
    }
    const QString path =
        QFileDialog::getOpenFileName(m_window, tr("Open a project"), m_settings.lastFolder(),
                                     tr("Sparkout projects (*.sparkout);;All files (*)"));
    if (!path.isEmpty()) {
        openFile(path);
    }
}

bool FileCommands::openFile(const QString& path) {
    const OpenResult result = m_document.open(path);
    if (result.error) {
        showFailure(m_window, tr("The file was not opened"), readErrorText(*result.error));
    } else if (!result.opened()) {
        FaultsDialog(path, result.issues, m_window).exec();
    } else {
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
    }
    return result.opened();
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

bool FileCommands::save() {
    return m_document.filePath().isEmpty() ? saveAs() : saveTo(m_document.filePath());
}

bool FileCommands::saveAs() {
    QString path = QFileDialog::getSaveFileName(m_window, tr("Save the project"), suggestedPath(),
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

bool FileCommands::saveTo(const QString& path) {
    if (const auto error = m_document.saveAs(path)) {
        showFailure(m_window, tr("The project was not saved"), saveErrorText(*error));
        return false;
    }
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    emit saved();
    return true;
}

QString FileCommands::suggestedPath() const {
    if (!m_document.filePath().isEmpty()) {
        return m_document.filePath();
    }
    static const QRegularExpression unfit(QStringLiteral("[\\\\/:*?\"<>|\\x00-\\x1f]+"));
    QString name = QString::fromStdString(m_document.project().title).simplified();
    name.replace(unfit, QStringLiteral("_")).truncate(80);
    return m_settings.lastFolder() + u'/' + (name.isEmpty() ? tr("Untitled") : name) + suffix;
}

bool FileCommands::mayDiscard() {
    if (!m_document.modified()) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("The project has changes that are not saved. Save them?"),
                    QMessageBox::NoButton, m_window);
    const auto* save = box.addButton(tr("&Save"), QMessageBox::AcceptRole);
    const auto* discard = box.addButton(tr("&Do not save"), QMessageBox::DestructiveRole);
    auto* cancel = box.addButton(tr("&Cancel"), QMessageBox::RejectRole);
    box.setEscapeButton(cancel);
    box.exec();
    return box.clickedButton() == save ? this->save() : box.clickedButton() == discard;
}

} // namespace sparkout
