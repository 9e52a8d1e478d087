// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/stock_fit.h"

#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/study/stock_edits.h"
#include "ui/session/document.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>

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
    const QString unit = unitText("mm");
    return firstAlone ? tr("Fit the stocks: the first stage takes %1\u00a0%2")
                            .arg(showNumber(after.front().stock_mm, QLocale()), unit)
                      : tr("Fit the stocks in proportion, to %1\u00a0%2 together")
                            .arg(showNumber(document.project().part->stock_mm, QLocale()), unit);
}

void StockFit::apply(Document& document) {
    document.endMerge();
    document.edit(withFittedStocks(document.project()),
                  {"Edit", QT_TRANSLATE_NOOP("Edit", "Fit the stocks of the stages")});
}

} // namespace sparkout
