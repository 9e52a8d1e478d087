// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/read_curves.h"
#include "ui/tables/csv_table.h"

#include <QAbstractTableModel>

#include <array>

namespace sparkout {

/// What the two cursors of a plot read: a row a curve, below their places; at A, at B and B − A,
/// for each zone, section or run.
class CursorModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using Places = std::array<std::optional<double>, 2>;
    using QAbstractTableModel::QAbstractTableModel;

    void show(const QString& axis, const Places& places, const ReadCurves& curves);
    [[nodiscard]] QString asTsv() const; ///< with all digits
    [[nodiscard]] CsvTable table() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    static constexpr int perGroup = 3; ///< A, B and the difference

    struct Row {
        QString name;
        Digits digits = Digits::hundredths;
        bool place = false; ///< of the cursors
        std::vector<std::optional<double>> values;
    };
    [[nodiscard]] QString header(int section, QChar between) const;
    [[nodiscard]] QString cell(const Row& row, int column) const;

    QStringList m_groups;
    std::vector<Row> m_rows;
};

} // namespace sparkout
