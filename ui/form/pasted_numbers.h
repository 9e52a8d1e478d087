// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "ui/table/pasted_cells.h"

#include <QCoreApplication>
#include <QString>

#include <vector>

namespace sparkout {

/// Pasted cells as numbers within a range; records the first invalid cell by row and column.
class PastedNumbers {
    Q_DECLARE_TR_FUNCTIONS(PastedNumbers)

public:
    PastedNumbers(const PastedCells& cells, const Range& allowed, const char* unit);

    [[nodiscard]] const std::vector<std::vector<double>>& rows() const { return m_rows; }
    [[nodiscard]] std::vector<double> inOrder() const;             ///< by rows
    [[nodiscard]] const QString& fault() const { return m_fault; } ///< empty: all are valid

private:
    std::vector<std::vector<double>> m_rows;
    QString m_fault;
};

} // namespace sparkout
