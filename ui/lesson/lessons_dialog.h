// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QDialog>

#include <vector>

class QListWidget;
class QTextBrowser;

namespace sparkout {

/// The available laboratory works, the shipped ones and the user's own, each with its aim, steps
/// and points.
class LessonsDialog : public QDialog {
    Q_OBJECT

public:
    /// @param settingsFolder contains the folder of the user's own; empty: none
    explicit LessonsDialog(const QString& settingsFolder, QWidget* parent = nullptr);

    [[nodiscard]] QString chosen() const; ///< path of the lesson; may be empty

    /// Paths of the shipped lessons in the resources, in order.
    [[nodiscard]] static QStringList paths();

private:
    void showChosen();

    struct Entry {
        QString path;
        Lesson lesson;
    };
    std::vector<Entry> m_entries;
    QListWidget* m_list;
    QTextBrowser* m_about;
};

} // namespace sparkout
