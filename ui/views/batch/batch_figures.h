// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/batch_runner.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/table_model.h"

#include <string>

namespace sparkout {

/// The figures of one characteristic of a batch: a column a zone or section, a row a figure.
class BatchFigures : public TableModel {
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

    using TableModel::TableModel;

    void show(BatchOutcomePtr outcome, const std::string& name); ///< of the characteristic
    /// Else a dash stands for the interval of the mean, Pp and Ppk, from the next show() on.
    void tellIndices(bool tells) { m_tellsIndices = tells; }

    /// One figure of a characteristic as it is shown.
    [[nodiscard]] static QString text(const CharacteristicSummary& summary, bool isSample, int row);

private:
    [[nodiscard]] int rowsShown() const override { return m_places.empty() ? 0 : rowCount_; }
    [[nodiscard]] int columnsShown() const override { return static_cast<int>(m_places.size()); }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] const CharacteristicSummary& at(int column) const;
    [[nodiscard]] QString shownText(int row, int column) const;

    BatchOutcomePtr m_outcome;
    std::vector<std::size_t> m_places; ///< indices of the summary's characteristics
    bool m_tellsIndices = true;
};

/// All figures of all characteristics with all their digits: a row a characteristic of a place.
[[nodiscard]] CsvTable batchFiguresTable(const BatchSummary& summary);

} // namespace sparkout
