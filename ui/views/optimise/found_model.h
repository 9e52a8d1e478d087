// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/search_runner.h"
#include "ui/tables/csv_table.h"

#include <QAbstractTableModel>

#include <optional>

namespace sparkout {

/// The best cycles that a search came upon, the quickest first.
class FoundModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { stages, time, change, gap, margin, cycle, columnCount_ };

    using QAbstractTableModel::QAbstractTableModel;

    /// With the time of the cycle compared with, if it ends by itself.
    void show(SearchOutcomePtr outcome, std::optional<double> before_s);
    void setBefore(std::optional<double> before_s); ///< the choice in the table stays
    void retranslate();
    [[nodiscard]] CsvTable table() const; ///< with all digits

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    void tellAll(); ///< that every cell may have changed
    [[nodiscard]] QString text(const FoundCycle& found, int column) const;
    [[nodiscard]] static QString kindOf(const FoundCycle& found);

    SearchOutcomePtr m_outcome;
    std::optional<double> m_before_s;
};

} // namespace sparkout
