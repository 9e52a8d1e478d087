// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pack/pack.h"
#include "ui/packs/pack_parts.h"

#include <QDialog>
#include <QStringList>

#include <functional>
#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace sparkout {

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

} // namespace sparkout
