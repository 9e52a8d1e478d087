// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/company.h"

#include "core/project/card_entries.h"
#include "core/text.h"
#include "ui/session/kept_texts.h"

#include <array>

namespace sparkout {

namespace {

const QString logoKey = QStringLiteral("logo");

} // namespace

template <>
const StructInfo& tableOf<CompanyTexts>() {
    using T = CompanyTexts;
    constexpr Range letters{0, 200};
    static const std::array rows{
        SPARKOUT_FIELD(T, name, .label = SPARKOUT_NOOP("Input", "Company"), .hard = letters),
        SPARKOUT_FIELD(T, department, .label = SPARKOUT_NOOP("Input", "Department"),
                       .hard = letters),
        SPARKOUT_FIELD(T, developed, .label = SPARKOUT_NOOP("Input", "Prepared by"),
                       .hard = letters),
        SPARKOUT_FIELD(T, checked, .label = SPARKOUT_NOOP("Input", "Checked by"), .hard = letters),
        SPARKOUT_FIELD(T, agreed, .label = SPARKOUT_NOOP("Input", "Agreed by"), .hard = letters),
        SPARKOUT_FIELD(T, standards, .label = SPARKOUT_NOOP("Input", "Standards checked by"),
                       .hard = letters),
        SPARKOUT_FIELD(T, approved, .label = SPARKOUT_NOOP("Input", "Approved by"),
                       .hard = letters),
        SPARKOUT_FIELD(T, designation, .label = SPARKOUT_NOOP("Input", "Document number"),
                       .hard = letters),
        SPARKOUT_FIELD(T, part, .label = SPARKOUT_NOOP("Input", "Part designation"),
                       .hard = letters),
        SPARKOUT_FIELD(T, shop, .label = SPARKOUT_NOOP("Input", "Shop"), .hard = letters),
        SPARKOUT_FIELD(T, area, .label = SPARKOUT_NOOP("Input", "Shop area"), .hard = letters),
        SPARKOUT_FIELD(T, place, .label = SPARKOUT_NOOP("Input", "Work place"), .hard = letters),
        SPARKOUT_FIELD(T, operation, .label = SPARKOUT_NOOP("Input", "Operation number"),
                       .hard = letters),
    };
    static const StructInfo info =
        makeTable<CompanyTexts>(SPARKOUT_NOOP("Struct", "Company and signatures"), rows);
    return info;
}

Company Company::with(const CardEntries& entries) const {
    Company made = *this;
    const auto take = [](std::string& number, const std::string& given) {
        if (const QString text = QString::fromStdString(given).simplified(); !text.isEmpty()) {
            number = text.toStdString();
        }
    };
    take(made.part, entries.part_number);
    take(made.designation, entries.document_number);
    take(made.operation, entries.operation_number);
    return made;
}

QVariantMap Company::kept() const {
    QVariantMap kept = keptTexts(tableOf<CompanyTexts>(), static_cast<const CompanyTexts*>(this));
    if (!logo.isEmpty()) {
        kept.insert(logoKey, QString::fromLatin1(logo.toBase64()));
    }
    return kept;
}

Company Company::fromKept(const QVariantMap& kept) {
    Company made;
    readKeptTexts(kept, tableOf<CompanyTexts>(), static_cast<CompanyTexts*>(&made));
    made.logo = QByteArray::fromBase64(kept.value(logoKey).toString().toLatin1());
    return made;
}

} // namespace sparkout
