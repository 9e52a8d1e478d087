// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/backup_history.h"

#include <QDialog>

#include <vector>

class QTreeWidget;

namespace sparkout {

/// The earlier versions of a project. The chosen one is opened as a copy.
class VersionsDialog : public QDialog {
    Q_OBJECT

public:
    VersionsDialog(const QString& project, std::vector<EarlierVersion> versions,
                   QWidget* parent = nullptr);

    [[nodiscard]] QString chosenFile() const; ///< may be empty

private:
    std::vector<EarlierVersion> m_versions;
    QTreeWidget* m_list;
};

} // namespace sparkout
