// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/batch_runner.h"
#include "ui/tables/csv_table.h"

#include <QAbstractTableModel>

#include <string>

namespace sparkout {

/// The figures of one characteristic of a batch: a column a zone or section, a row a figure.
class BatchFigures : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Row {
        least,
        most,
        mean,
        meanInterval,
        deviation,
        lowPercentile,
        median,
        highPercentile,
        pp,
        ppk,
        outside,
        normality,
        rowCount_
    };

    using QAbstractTableModel::QAbstractTableModel;

    void show(BatchOutcomePtr outcome, const std::string& name); ///< of the characteristic
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

    /// One figure of a characteristic as it is shown.
    [[nodiscard]] static QString text(const CharacteristicSummary& summary, bool isSample, int row);

private:
    [[nodiscard]] const CharacteristicSummary& at(int column) const;

    BatchOutcomePtr m_outcome;
    std::vector<std::size_t> m_places; ///< indices of the summary's characteristics
};

/// All figures of all characteristics with all their digits: a row a characteristic of a place.
[[nodiscard]] CsvTable batchFiguresTable(const BatchSummary& summary);

} // namespace sparkout
