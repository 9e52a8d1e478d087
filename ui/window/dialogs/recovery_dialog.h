// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/recovery_store.h"

#include <QDialog>

#include <optional>
#include <vector>

class QPushButton;
class QTreeWidget;

namespace sparkout {

/// Unsaved work of programs that ended. Each item is recovered, deferred or discarded; a damaged
/// one can only be discarded, and its folder is shown.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    /// `offeredElsewhere`: only discarded items are listed, as another window offers the others.
    RecoveryDialog(const RecoveryStore& store, std::vector<RecoveryItem> items,
                   bool offeredElsewhere, QWidget* parent = nullptr);

    [[nodiscard]] static QString offeredElsewhereText();

    /// The item to recover, after accept().
    [[nodiscard]] std::optional<RecoveryItem> chosen() const;

private:
    void fill();
    void discard();
    void followSelection();
    [[nodiscard]] int current() const; ///< index of the item; -1: none

    const RecoveryStore& m_store;
    std::vector<RecoveryItem> m_items;
    QTreeWidget* m_list;
    QPushButton* m_recover;
    QPushButton* m_discard;
};

} // namespace sparkout
