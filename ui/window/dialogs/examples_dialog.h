// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QDialog>

#include <vector>

class QLabel;
class QListWidget;

namespace sparkout {

/// The example gallery: shipped projects with their operation and notes. The chosen one is opened
/// as a copy.
class ExamplesDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExamplesDialog(QWidget* parent = nullptr);

    [[nodiscard]] QByteArray chosenText() const;
    [[nodiscard]] QString chosenTitle() const;

    /// Paths of the shipped examples in the resources, in order.
    [[nodiscard]] static QStringList paths();
    [[nodiscard]] static QByteArray textOf(const QString& path);

private:
    void fill();
    void showNotes();

    struct Entry {
        QString path;
        Project project;
    };
    std::vector<Entry> m_entries;
    QListWidget* m_list;
    QLabel* m_notes;
};

} // namespace sparkout
