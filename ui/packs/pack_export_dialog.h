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

/// Chooses what of the user's own goes into a pack.
class PackExportDialog : public QDialog {
    Q_OBJECT

public:
    PackExportDialog(Settings& settings, QWidget* parent);

    [[nodiscard]] Pack pack() const; ///< what is chosen
    /// Adds lessons from files, or says why one is none.
    void addLessons(const QStringList& paths);

private:
    void buildTree();
    QTreeWidgetItem* group(PackPart part);
    void addItem(PackPart part, const QString& name, std::function<void(Pack&)> put);
    void chooseLessons();
    void showChosen();

    /// What stands in a line of the tree.
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
    QStringList m_files; ///< names of the lessons, each once
};

} // namespace sparkout
