// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/output_csv.h"

#include <limits>

namespace sparkout {

namespace {

constexpr double emptyCell = std::numeric_limits<double>::quiet_NaN();

void addInterval(CsvLine& line, const std::optional<Interval>& interval) {
    line.number(interval ? interval->low : emptyCell).number(interval ? interval->high : emptyCell);
}

} // namespace

void addCsvHeads(CsvLine& line, const OutputRow& row, OutputKind kind) {
    const std::string name = row.columnName();
    if (name.empty()) {
        return;
    }
    if (kind != OutputKind::interval) {
        line.text(name);
    }
    if (kind == OutputKind::interval || kind == OutputKind::estimate || kind == OutputKind::share) {
        line.text(name + "_low").text(name + "_high");
    }
}

void addCsvCells(CsvLine& line, OutputKind kind, const OutputValue& value) {
    switch (kind) {
    case OutputKind::number:
    case OutputKind::optionalNumber: {
        const auto* number = std::get_if<double>(&value);
        line.number(number ? *number : emptyCell);
        break;
    }
    case OutputKind::whole:
    case OutputKind::optionalWhole: {
        const auto* whole = std::get_if<std::int64_t>(&value);
        whole ? line.whole(*whole) : line.empty();
        break;
    }
    case OutputKind::truth:
    case OutputKind::optionalTruth: {
        const auto* truth = std::get_if<bool>(&value);
        line.text(!truth ? "" : *truth ? "true" : "false");
        break;
    }
    case OutputKind::text:
    case OutputKind::optionalText: {
        const auto* text = std::get_if<std::string>(&value);
        line.text(text ? *text : std::string());
        break;
    }
    case OutputKind::interval: {
        const auto* interval = std::get_if<Interval>(&value);
        addInterval(line, interval ? std::optional(*interval) : std::nullopt);
        break;
    }
    case OutputKind::estimate: {
        const auto* estimate = std::get_if<Estimate>(&value);
        line.number(estimate ? estimate->value : emptyCell);
        addInterval(line, estimate ? std::optional(estimate->interval) : std::nullopt);
        break;
    }
    case OutputKind::share: {
        const auto* share = std::get_if<Share>(&value);
        line.number(share ? share->value : emptyCell);
        addInterval(line, share ? share->interval : std::nullopt);
        break;
    }
    }
}

} // namespace sparkout
