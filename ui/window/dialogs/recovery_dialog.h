// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/recovery_store.h"

#include <QDialog>

#include <optional>
#include <vector>

class QPushButton;
class QTreeWidget;

namespace sparkout {

/// The work that programs which ended without saving left behind. Each item is recovered, put off
/// or discarded; a damaged one can only be discarded, and its folder is named.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    /// `offeredElsewhere`: the items are discarded ones alone, as another window offers the others.
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
