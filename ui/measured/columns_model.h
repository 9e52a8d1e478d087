// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"
#include "core/project/project.h"
#include "ui/table/value_table.h"

#include <QStringList>

#include <utility>
#include <vector>

namespace sparkout {

/// The interpretation of a table's columns: a row for each column, or key of key-value lines, whose
/// properties have a few choices.
class ColumnsModel : public TableModel {
    Q_OBJECT
public:
    enum Column { heading, quantity, unit, place, columnCount_ };

    explicit ColumnsModel(const Project& project, QObject* parent = nullptr);

    void show(std::vector<ColumnMatch> matches);
    [[nodiscard]] const std::vector<ColumnMatch>& matches() const { return m_matches; }

    /// The choices of a cell: texts and values; empty if there is no choice.
    using Choices = std::vector<std::pair<QString, int>>;
    [[nodiscard]] Choices choices(const QModelIndex& cell) const;
    [[nodiscard]] static QString name(int column);

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    void edited(); ///< called after an edit by the user

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_matches.size()); }
    [[nodiscard]] int columnsShown() const override { return columnCount_; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] int valueOf(const ColumnMatch& match, int column) const;
    [[nodiscard]] bool hasPlace(const ColumnMatch& match) const;

    Project m_project;
    std::vector<ColumnMatch> m_matches;
};

} // namespace sparkout
