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

void addNumber(std::vector<CsvCell>& cells, const std::optional<double>& number) {
    if (number) {
        cells.emplace_back(*number);
    } else {
        cells.emplace_back();
    }
}

} // namespace

void addEstimateHeads(QStringList& header, const QString& name) {
    header << name;
    addIntervalHeads(header, name);
}

void addIntervalCells(std::vector<CsvCell>& cells, const std::optional<Interval>& interval,
                      double factor) {
    addNumber(cells, interval ? std::optional(interval->low * factor) : std::nullopt);
    addNumber(cells, interval ? std::optional(interval->high * factor) : std::nullopt);
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
    switch (kind) {
    case OutputKind::interval: {
        const auto* interval = std::get_if<Interval>(&value);
        addIntervalCells(cells, interval ? std::optional(*interval) : std::nullopt,
                         row.shownFactor);
        break;
    }
    case OutputKind::estimate: {
        const auto* estimate = std::get_if<Estimate>(&value);
        addNumber(cells, number);
        addIntervalCells(cells, estimate ? std::optional(estimate->interval) : std::nullopt,
                         row.shownFactor);
        break;
    }
    case OutputKind::share: {
        const auto* share = std::get_if<Share>(&value);
        addNumber(cells, share ? std::optional(static_cast<double>(share->count)) : std::nullopt);
        addNumber(cells, number);
        addIntervalCells(cells, share ? share->interval : std::nullopt);
        break;
    }
    default: addNumber(cells, number);
    }
}

} // namespace sparkout
