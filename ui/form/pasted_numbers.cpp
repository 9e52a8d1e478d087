// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/pasted_numbers.h"

#include "ui/text/texts.h"

#include <algorithm>

namespace sparkout {

PastedNumbers::PastedNumbers(const PastedCells& cells, const Range& allowed, const char* unit) {
    const bool columns = std::any_of(cells.rows.begin(), cells.rows.end(),
                                     [](const QStringList& row) { return row.size() > 1; });
    for (std::size_t i = 0; i < cells.rows.size(); ++i) {
        std::vector<double>& row = m_rows.emplace_back();
        for (qsizetype k = 0; k < cells.rows[i].size(); ++k) {
            const QString text = cells.rows[i][k].trimmed();
            const std::optional<double> value = pastedNumber(text);
            if (value && allowed.contains(*value)) {
                row.push_back(*value);
                continue;
            }
            const QString range = rangeShown(allowed, unit);
            const QString reason =
                value ? tr("“%1” is out of range").arg(text) : tr("“%1” is not a number").arg(text);
            m_fault = range.isEmpty() ? reason : tr("%1; allowed: %2").arg(reason, range);
            if (!cells.single()) {
                const QString number = QString::number(i + 1);
                const QString place = columns ? tr("row %1, column %2").arg(number).arg(k + 1)
                                              : tr("row %1").arg(number);
                m_fault = tr("not pasted: %1: %2", "place: reason").arg(place, m_fault);
            }
            return;
        }
    }
}

std::vector<double> PastedNumbers::inOrder() const {
    std::vector<double> numbers;
    for (const std::vector<double>& row : m_rows) {
        numbers.insert(numbers.end(), row.begin(), row.end());
    }
    return numbers;
}

} // namespace sparkout
