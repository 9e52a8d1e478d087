// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/stock_fit.h"

#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/study/stage_edits.h"
#include "ui/session/document.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <algorithm>

namespace sparkout {

QString StockFit::text(const Document& document) {
    const auto& before = document.project().cycle->stages;
    if (before.empty() || document.isOpen("/part/stock_mm") || stocksAddUp(document.project())) {
        return {};
    }
    const Project fitted = withFittedStocks(document.project());
    const auto& after = fitted.cycle->stages;
    const bool firstAlone =
        std::equal(before.begin() + 1, before.end(), after.begin() + 1,
                   [](const Stage& a, const Stage& b) { return a.stock_mm == b.stock_mm; });
    const auto amount = [](double value_mm) {
        const Field& stock = *tableOf<Part>().find("stock_mm");
        const QString number = printedNumber(ShownScale::ofInput(stock).shown(value_mm));
        return StockReading::isOnDiameter(stock)
                   ? tr("%1\u00a0%2 on diameter").arg(number, unitText("mm"))
                   : number + u'\u00a0' + unitText("mm");
    };
    return firstAlone
               ? tr("Fit the stocks: the first stage takes %1").arg(amount(after.front().stock_mm))
               : tr("Fit the stocks in proportion, to %1 together")
                     .arg(amount(document.project().part->stock_mm));
}

void StockFit::apply(Document& document) {
    document.endMerge();
    document.edit(withFittedStocks(document.project()),
                  {"Edit", QT_TRANSLATE_NOOP("Edit", "Fit the stocks of the stages")});
}

} // namespace sparkout
