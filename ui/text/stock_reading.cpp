// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/stock_reading.h"

#include "core/project/cycle.h"
#include "core/project/part.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

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

} // namespace sparkout
