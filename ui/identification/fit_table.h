// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/copy_table.h"

#include <QStringList>

#include <vector>

class QStandardItemModel;

namespace sparkout {

/// A table of a fit, as high as its rows: the first column texts, the others numbers.
class FitTable : public CopyTable {
    Q_OBJECT

public:
    explicit FitTable(const QString& name, QWidget* parent = nullptr);

    void setCells(const QStringList& head, const std::vector<QStringList>& rows);

private:
    void fitHeight();
    [[nodiscard]] QString text() const;

    QStandardItemModel* m_model;
};

} // namespace sparkout
