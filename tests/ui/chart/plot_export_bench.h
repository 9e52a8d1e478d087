// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/plot_tools.h"
#include "ui/session/settings.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <clocale>
#include <memory>

/// What the plot tools write, through the real menu and the real file dialog.
namespace sparkout::plot_export_bench {

using namespace fixtures;

/// Answers the dialogs that open while it lives: names a file, presses buttons of messages.
class User : public QObject {
public:
    QStringList paths;    ///< for the file dialogs, in turn; none left: cancel
    QStringList proposed; ///< names the dialogs proposed
    QStringList folders;  ///< they started in
    QStringList messages; ///< texts of the message boxes
    bool tryAgain = true; ///< in message boxes: the accepting button

    User() {
        m_timer.callOnTimeout(this, &User::look);
        m_timer.start(10);
    }

private:
    void look() {
        QWidget* dialog = QApplication::activeModalWidget();
        if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
            auto* name = files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            proposed << name->text();
            folders << files->directory().absolutePath();
            if (paths.isEmpty()) {
                files->reject();
                return;
            }
            name->setText(paths.takeFirst());
            QTest::keyClick(name, Qt::Key_Return);
        } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
            messages << box->text();
            for (QAbstractButton* button : box->buttons()) {
                const bool accepts = box->buttonRole(button) == QMessageBox::AcceptRole;
                if (accepts == tryAgain) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    return;
                }
            }
        }
    }

    QTimer m_timer;
};

/// A test of the files that the tools of a view's plot save into a folder of the test's own.
class PlotExportTest : public QObject {
protected:
    void begin() {
        setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
        // Where Qt's file dialog remembers the folders it has seen: not the user's own file.
        QVERIFY(m_config.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_config.path());
        Project project = traverseProject();
        project.title = "Shaft 30h6: rough/fine";
        m_outcome = run(project);
        QVERIFY(m_outcome->ran());
    }
    void showView() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_settings = std::make_unique<Settings>(Settings::transient());
        m_settings->setLastFolder(m_folder->path());
        m_view = std::make_unique<FeedsView>(nullptr, m_settings.get());
        m_view->resize(700, 620);
        m_view->show();
        draw(*m_view, m_outcome);
        m_view->grab();
    }
    [[nodiscard]] QString path(const char* name) const {
        return m_folder->filePath(QString::fromUtf8(name));
    }
    /// The bytes of the file that the action saves under the name.
    QByteArray saved(QAction* action, const char* name) {
        User user;
        user.paths << path(name);
        action->trigger();
        return on_disk::bytesOf(path(name));
    }

    QTemporaryDir m_config;
    OutcomePtr m_outcome;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<FeedsView> m_view;
};

} // namespace sparkout::plot_export_bench
