// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/output_cells.h"

#include "ui/text/output_text.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

struct OutputCells {
    Q_DECLARE_TR_FUNCTIONS(OutputCells)
};

void addIntervalHeads(QStringList& header, const QString& name) {
    header << OutputCells::tr("%1, 95 % from").arg(name)
           << OutputCells::tr("%1, 95 % to").arg(name);
}

} // namespace

void addEstimateHeads(QStringList& header, const QString& name) {
    header << name;
    addIntervalHeads(header, name);
}

void addIntervalCells(std::vector<CsvCell>& cells, const std::optional<Interval>& interval) {
    cells.push_back(interval ? CsvCell(interval->low) : CsvCell());
    cells.push_back(interval ? CsvCell(interval->high) : CsvCell());
}

void addHeads(QStringList& header, const OutputRow& row, OutputKind kind, bool revolutions) {
    const QString name = outputName(row, revolutions);
    switch (kind) {
    case OutputKind::interval: addIntervalHeads(header, name); break;
    case OutputKind::estimate: addEstimateHeads(header, name); break;
    case OutputKind::share:
        header << name << OutputCells::tr("%1, share").arg(name);
        addIntervalHeads(header, name);
        break;
    default: header << name;
    }
}

void addCells(std::vector<CsvCell>& cells, const OutputRow& row, OutputKind kind,
              const OutputValue& value) {
    const std::optional<double> number = outputNumber(row, value);
    const CsvCell cell = number ? CsvCell(*number) : CsvCell();
    switch (kind) {
    case OutputKind::interval: {
        const auto* interval = std::get_if<Interval>(&value);
        addIntervalCells(cells, interval ? std::optional(*interval) : std::nullopt);
        break;
    }
    case OutputKind::estimate: {
        const auto* estimate = std::get_if<Estimate>(&value);
        cells.push_back(cell);
        addIntervalCells(cells, estimate ? std::optional(estimate->interval) : std::nullopt);
        break;
    }
    case OutputKind::share: {
        const auto* share = std::get_if<Share>(&value);
        cells.push_back(share ? CsvCell(static_cast<double>(share->count)) : CsvCell());
        cells.push_back(cell);
        addIntervalCells(cells, share ? share->interval : std::nullopt);
        break;
    }
    default: cells.push_back(cell);
    }
}

} // namespace sparkout
