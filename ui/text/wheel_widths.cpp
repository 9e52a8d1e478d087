// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/wheel_widths.h"

#include "core/catalogue/shipped_catalogue.h"
#include "ui/text/number_text.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <set>
#include <variant>
#include <vector>

namespace sparkout {

namespace {

std::set<double> shippedWidths() {
    std::set<double> widths;
    for (const WheelEntry& entry : shippedEntries<WheelEntry>()) {
        widths.insert(entry.value.width_mm);
    }
    return widths;
}

QString listed(std::vector<double> widths) {
    constexpr std::size_t most = 3;
    QStringList texts;
    widths.resize(std::min(widths.size(), most));
    for (const double width : widths) {
        texts << QLocale().toString(width);
    }
    return texts.join(QStringLiteral(", "));
}

} // namespace

QString WheelWidths::hint(const Issue& issue) {
    const bool isTraverse = issue.code == IssueCode::zoneTooShort;
    if (!isTraverse && issue.code != IssueCode::wheelTooNarrow) {
        return {};
    }
    const auto* const amount = std::get_if<Amount>(&issue.value);
    const auto* const bounds = std::get_if<Bounds>(&issue.limit);
    if (!amount || !bounds) {
        return {};
    }
    const double length_mm = isTraverse ? amount->number : bounds->range.low;
    constexpr double zonesPerWidth = 4.0 / 3; // both reversal zones, with overruns of a third
    std::vector<double> narrower, covering;
    for (const double width : shippedWidths()) {
        if (zonesPerWidth * width < length_mm) {
            narrower.insert(narrower.begin(), width); // the widest first
        } else if (width >= length_mm) {
            covering.push_back(width);
        }
    }
    QStringList texts;
    if (!narrower.empty()) {
        texts << tr("to traverse %1 mm (overruns of a third)", "widths of wheels")
                     .arg(listed(narrower));
    }
    if (!covering.empty()) {
        texts << tr("to plunge %1 mm", "widths of wheels").arg(listed(covering));
    }
    return texts.isEmpty()
               ? tr("no wheel of the catalogue would do")
               : tr("of the catalogue's wheels would do: %1").arg(texts.join(QStringLiteral("; ")));
}

} // namespace sparkout
