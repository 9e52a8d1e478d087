// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/packs/pack_parts.h"

#include "ui/report/card/logo.h"
#include "ui/session/kept_texts.h"

#include <QLocale>
#include <QVariantMap>

#include <utility>

namespace sparkout {

namespace {

QByteArray logoOf(const Pack& pack) {
    return QByteArray::fromBase64(QByteArray::fromStdString(pack.logo));
}

} // namespace

QString PackParts::name(PackPart part) {
    switch (part) {
    case PackPart::machine: return tr("Machine");
    case PackPart::wheel: return tr("Wheel");
    case PackPart::material: return tr("Material");
    case PackPart::company: return tr("Company and signatures");
    case PackPart::lesson: return tr("Laboratory work");
    }
    return {};
}

std::vector<CatalogueEntry> PackParts::entries(const Pack& pack, PackPart part) {
    switch (part) {
    case PackPart::machine: return {pack.machines.begin(), pack.machines.end()};
    case PackPart::wheel: return {pack.wheels.begin(), pack.wheels.end()};
    case PackPart::material: return {pack.materials.begin(), pack.materials.end()};
    case PackPart::company:
    case PackPart::lesson: break;
    }
    return {};
}

void PackParts::add(const CatalogueEntry& entry, Pack& pack) {
    if (const auto* machine = std::get_if<MachineEntry>(&entry)) {
        pack.machines.push_back(*machine);
    } else if (const auto* wheel = std::get_if<WheelEntry>(&entry)) {
        pack.wheels.push_back(*wheel);
    } else {
        pack.materials.push_back(std::get<MaterialEntry>(entry));
    }
}

Company PackParts::company(const Pack& pack) {
    QVariantMap kept;
    for (const auto& [key, text] : pack.company) {
        kept.insert(QString::fromStdString(key), QString::fromStdString(text));
    }
    Company company = Company::fromKept(kept);
    if (QByteArray logo = logoOf(pack); report::Logo::fault(logo).isEmpty()) {
        company.logo = std::move(logo);
    }
    return company;
}

QString PackParts::logoFault(const Pack& pack) {
    return report::Logo::fault(logoOf(pack));
}

void PackParts::setCompany(const Company& company, Pack& pack) {
    const CompanyTexts& texts = company;
    for (const Field& field : tableOf<CompanyTexts>().fields) {
        if (const QString text = textIn(field, &texts); !text.isEmpty()) {
            pack.company[field.key] = text.toStdString();
        }
    }
    if (report::Logo::fault(company.logo).isEmpty()) {
        pack.logo = company.logo.toBase64().toStdString();
    }
}

QString PackParts::title(const Lesson& lesson) {
    return QString::fromStdString(lesson.title.in(QLocale().language() == QLocale::Russian));
}

CatalogueKind kindOf(PackPart part) {
    return part == PackPart::machine ? CatalogueKind::machines
           : part == PackPart::wheel ? CatalogueKind::wheels
                                     : CatalogueKind::materials;
}

} // namespace sparkout
