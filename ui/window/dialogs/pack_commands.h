// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/pack.h"
#include "ui/dialogs/file_questions.h"
#include "ui/session/guarded_file.h"
#include "ui/window/dialogs/pack_plan.h"

#include <QDialog>
#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

class QCheckBox;
class QLineEdit;
class QPlainTextEdit;

class QWidget;

namespace sparkout {

/// The contents of a pack, the user's corresponding data, and the choice of what to apply.
class PackImportDialog : public QDialog {
    Q_OBJECT

public:
    PackImportDialog(Pack pack, Settings& settings, QWidget* parent);

    void accept() override; ///< applies it; stays open if something could not be saved

private:
    QWidget* buildHead();
    QWidget* buildLines();
    void addLine(std::size_t line);
    void showDifferences();
    void showChosen();
    [[nodiscard]] static QString stateText(PackPlan::State state);
    [[nodiscard]] static QString choiceText(PackPlan::Choice choice, PackPlan::State state);

    Settings& m_settings;
    PackPlan m_plan;
    QTreeWidget* m_lines;
    QTreeWidget* m_differences;
    QLabel* m_state;
    QPushButton* m_take = nullptr;
};

class Settings;

/// Selects the user's data for a pack.
class PackExportDialog : public QDialog {
    Q_OBJECT

public:
    PackExportDialog(Settings& settings, QWidget* parent);

    [[nodiscard]] Pack pack() const; ///< the selected data
    /// Adds lessons from files, or shows why a file is not one.
    void addLessons(const QStringList& paths);

private:
    void buildTree();
    QTreeWidgetItem* group(PackPart part);
    void addItem(PackPart part, const QString& name, std::function<void(Pack&)> put);
    void chooseLessons();
    void showChosen();

    /// A line of the tree.
    struct Item {
        QTreeWidgetItem* row;
        std::function<void(Pack&)> put;
    };

    Settings& m_settings;
    QLineEdit* m_title;
    QPlainTextEdit* m_note;
    QTreeWidget* m_tree;
    QCheckBox* m_forStudents;
    QLabel* m_state;
    QPushButton* m_save = nullptr;
    std::vector<Item> m_items;
    QStringList m_files; ///< unique names of the lessons
};

/// Exports and imports packs.
class PackCommands : public QObject {
    Q_OBJECT

public:
    PackCommands(Settings& settings, QWidget* window);

    /// Locks a pack while writing from now on, and keeps replaced versions in this folder.
    void protect(const QString& stateFolder) { m_file.protect(stateFolder); }
    void exportPack();
    void importPack();
    void importFile(const QString& path); ///< asks which parts to apply

    /// Whether a path is that of a pack, by its name.
    [[nodiscard]] static bool isPack(const QString& path);

private:
    Settings& m_settings;
    QWidget* m_window;
    GuardedFile m_file; ///< last exported pack
    DiskWait m_wait;
    GuardQuestions m_questions;
};

} // namespace sparkout
