// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/shown_scale.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

const Field* stockOf(const StructInfo& table) {
    return table.find("stock_mm");
}

} // namespace

StockReading& StockReading::instance() {
    static StockReading reading;
    return reading;
}

void StockReading::setOnDiameter(bool onDiameter) {
    if (onDiameter != m_onDiameter) {
        m_onDiameter = onDiameter;
        emit changed();
    }
}

bool StockReading::isStock(const Field& field) {
    return &field == stockOf(tableOf<Part>()) || &field == stockOf(tableOf<Stage>());
}

bool StockReading::isOnDiameter(const Field& field) {
    return instance().m_onDiameter && isStock(field);
}

QString StockReading::label(const Field& field) {
    if (!isOnDiameter(field)) {
        return inputText(field.label);
    }
    return &field == stockOf(tableOf<Part>()) ? tr("Stock on diameter")
                                              : tr("Stage stock on diameter");
}

QString StockReading::column(const Field& field) {
    return column(field, isOnDiameter(field));
}

QString StockReading::column(const Field& field, bool onDiameter) {
    return onDiameter       ? tr("Stock on diameter")
           : !*field.column ? inputText(field.label)
                            : QCoreApplication::translate("InputBrief", field.column);
}

QString StockReading::symbol(const Field& field) {
    const QString symbol = *field.symbol ? inputText(field.symbol) : QString();
    return isOnDiameter(field) ? u'2' + symbol : symbol;
}

ShownScale ShownScale::of(const Field& field) {
    static const Field* const section = tableOf<Gauge>().find("section");
    return &field == section ? ShownScale{1, 1} : ShownScale{};
}

ShownScale ShownScale::at(const std::string& path) {
    const Field* const field = nearestField(Project(), path);
    return field ? of(*field) : ShownScale{};
}

ShownScale ShownScale::ofInput(const Field& field) {
    return StockReading::isOnDiameter(field) ? ShownScale{2, 0} : of(field);
}

ShownScale ShownScale::of(const Issue& issue) {
    const bool ofStocks = issue.code == IssueCode::stocksDoNotSumUp;
    const Field* const field =
        ofStocks ? tableOf<Part>().find("stock_mm") : nearestField(Project(), issue.path);
    return field ? ofInput(*field) : ShownScale{};
}

std::optional<double> ShownScale::shown(const std::optional<double>& kept) const {
    return kept ? std::optional(shown(*kept)) : std::nullopt;
}

std::optional<double> ShownScale::kept(const std::optional<double>& shown) const {
    return shown ? std::optional(kept(*shown)) : std::nullopt;
}

Range ShownScale::shown(Range kept) const {
    kept.low = shown(kept.low);
    kept.high = shown(kept.high);
    return kept;
}

Detail ShownScale::shown(Detail kept) const {
    if (auto* const amount = std::get_if<Amount>(&kept)) {
        amount->number = shown(amount->number);
    } else if (auto* const count = std::get_if<Count>(&kept)) {
        count->number =
            static_cast<std::int64_t>(std::llround(shown(static_cast<double>(count->number))));
    } else if (auto* const bounds = std::get_if<Bounds>(&kept)) {
        bounds->range = shown(bounds->range);
    }
    return kept;
}

} // namespace sparkout
