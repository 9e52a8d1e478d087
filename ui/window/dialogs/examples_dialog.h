// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"

#include <QDialog>

#include <vector>

class QLabel;
class QListWidget;

namespace sparkout {

/// The example gallery: shipped files with a drawing of the part, the operation and the notes. The
/// chosen one is opened as a copy.
class ExamplesDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExamplesDialog(QWidget* parent = nullptr);

    [[nodiscard]] QByteArray chosenText() const;
    [[nodiscard]] QString chosenTitle() const;

    /// Paths of the shipped examples in the resources, in the order of exampleFiles().
    [[nodiscard]] static QStringList paths();
    [[nodiscard]] static QByteArray textOf(const QString& path);

private:
    struct Entry {
        QString path;
        Setup setup;

        [[nodiscard]] const Project& first() const { return setup.surfaces.front().project; }
    };

    void fill();
    void showNotes();
    [[nodiscard]] static QString kindOf(const Entry& entry);
    /// Time, status and verdict of the cycle, or of all cycles.
    [[nodiscard]] static QString resultOf(const Entry& entry);

    std::vector<Entry> m_entries;
    QListWidget* m_list;
    QLabel* m_notes;
};

} // namespace sparkout
