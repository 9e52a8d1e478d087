// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/company.h"

#include "core/project/card_entries.h"

#include <QCoreApplication>

#include <array>
#include <string>

namespace sparkout {

namespace {

const QString logoKey = QStringLiteral("logo");
constexpr qsizetype longestCompanyText = 200;

constexpr std::array fields{
    CompanyField{"name", &Company::name, QT_TRANSLATE_NOOP("Company", "Company")},
    CompanyField{"department", &Company::department, QT_TRANSLATE_NOOP("Company", "Department")},
    CompanyField{"developed", &Company::developed, QT_TRANSLATE_NOOP("Company", "Prepared by")},
    CompanyField{"checked", &Company::checked, QT_TRANSLATE_NOOP("Company", "Checked by")},
    CompanyField{"agreed", &Company::agreed, QT_TRANSLATE_NOOP("Company", "Agreed by")},
    CompanyField{"standards", &Company::standards,
                 QT_TRANSLATE_NOOP("Company", "Standards checked by")},
    CompanyField{"approved", &Company::approved, QT_TRANSLATE_NOOP("Company", "Approved by")},
    CompanyField{"designation", &Company::designation,
                 QT_TRANSLATE_NOOP("Company", "Document number")},
    CompanyField{"part", &Company::part, QT_TRANSLATE_NOOP("Company", "Part designation")},
    CompanyField{"shop", &Company::shop, QT_TRANSLATE_NOOP("Company", "Shop")},
    CompanyField{"area", &Company::area, QT_TRANSLATE_NOOP("Company", "Shop area")},
    CompanyField{"place", &Company::place, QT_TRANSLATE_NOOP("Company", "Work place")},
    CompanyField{"operation", &Company::operation,
                 QT_TRANSLATE_NOOP("Company", "Operation number")},
};

} // namespace

std::span<const CompanyField> companyFields() {
    return fields;
}

Company Company::with(const CardEntries& entries) const {
    Company made = *this;
    const auto take = [](QString& number, const std::string& given) {
        if (const QString text = QString::fromStdString(given).simplified(); !text.isEmpty()) {
            number = text;
        }
    };
    take(made.part, entries.part_number);
    take(made.designation, entries.document_number);
    take(made.operation, entries.operation_number);
    return made;
}

QVariantMap Company::kept() const {
    QVariantMap kept;
    for (const CompanyField& field : fields) {
        if (const QString text = (this->*field.value).simplified(); !text.isEmpty()) {
            kept.insert(QString::fromLatin1(field.key), text);
        }
    }
    if (!logo.isEmpty()) {
        kept.insert(logoKey, QString::fromLatin1(logo.toBase64()));
    }
    return kept;
}

Company Company::fromKept(const QVariantMap& kept) {
    Company made;
    for (const CompanyField& field : fields) {
        made.*field.value = kept.value(QString::fromLatin1(field.key))
                                .toString()
                                .simplified()
                                .left(longestCompanyText);
    }
    made.logo = QByteArray::fromBase64(kept.value(logoKey).toString().toLatin1());
    return made;
}

} // namespace sparkout
