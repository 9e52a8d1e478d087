// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/catalogue_bar.h"

#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/wheel.h"
#include "ui/fields/mark.h"
#include "ui/inputs/forms/catalogue_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/name_dialog.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

EditText editText(CatalogueKind kind) {
    switch (kind) {
    case CatalogueKind::materials:
        return {"Edit", QT_TRANSLATE_NOOP("Edit", "Material from the catalogue")};
    case CatalogueKind::wheels:
        return {"Edit", QT_TRANSLATE_NOOP("Edit", "Wheel from the catalogue")};
    case CatalogueKind::machines:
        return {"Edit", QT_TRANSLATE_NOOP("Edit", "Machine from the catalogue")};
    }
    return {};
}

} // namespace

CatalogueBar::CatalogueBar(CatalogueKind kind, Document& document, Settings* settings,
                           QWidget* parent)
    : QWidget(parent)
    , m_kind(kind)
    , m_document(document)
    , m_settings(settings)
    , m_choose(new QPushButton(this))
    , m_keep(new QPushButton(this))
    , m_fault(new ReasonLabel(this)) {
    setHelpTopic(*this, QStringLiteral("editing#catalogues"));
    m_choose->setObjectName(QStringLiteral("fromCatalogue"));
    m_keep->setObjectName(QStringLiteral("saveAsMine"));
    m_fault->setObjectName(QStringLiteral("catalogueKeptFault"));
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::gap);
    row->addWidget(m_choose, 1);
    row->addWidget(m_keep, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, metrics::gap);
    layout->addLayout(row);
    layout->addWidget(m_fault);
    connect(m_choose, &QPushButton::clicked, this, &CatalogueBar::choose);
    connect(m_keep, &QPushButton::clicked, this, &CatalogueBar::keep);
    connect(&document, &Document::changed, this, [this] { m_fault->showRemark({}); });
    retranslate();
}

CatalogueBar::~CatalogueBar() = default;

CatalogueStore& CatalogueBar::store() {
    if (!m_store) {
        m_store = CatalogueStore::make(m_kind, m_settings ? m_settings->folder() : QString());
    }
    return *m_store;
}

void CatalogueBar::choose() {
    CatalogueDialog dialog(store(), m_document.project(), m_settings, window());
    if (dialog.exec() != QDialog::Accepted || !dialog.chosen()) {
        return;
    }
    m_document.endMerge();
    m_document.edit(dialog.taken(), editText(m_kind));
}

QString CatalogueBar::nameInProject() const {
    const Project& project = m_document.project();
    const std::string& name = m_kind == CatalogueKind::materials ? project.material->grade
                              : m_kind == CatalogueKind::wheels  ? project.wheel->marking
                                                                 : project.machine->name;
    return QString::fromStdString(name);
}

std::optional<Project> CatalogueBar::asInCatalogue() {
    const QString name = nameInProject();
    const auto& items = store().items();
    const auto item = std::ranges::find_if(
        items, [&name](const CatalogueItem& one) { return entryName(one.entry) == name; });
    return item == items.end() ? std::nullopt
                               : std::optional(withEntry(item->entry, m_document.project()));
}

void CatalogueBar::keep() {
    store().refresh();
    NameDialog dialog(
        tr("Save as mine"), tr("&Keep"), nameInProject(),
        [this](const QString& name) -> NameDialog::Answer {
            if (!store().fault().isEmpty()) {
                return {tr("Your own catalogue cannot be read. “From catalogue…” says why."),
                        false};
            }
            if (store().hasOwn(name)) {
                return {tr("Your entry of this name will be replaced.")};
            }
            const bool shipped =
                std::ranges::any_of(store().items(), [&name](const CatalogueItem& item) {
                    return entryName(item.entry) == name;
                });
            return {shipped ? tr("It will be shown in place of the shipped entry of this name.")
                            : tr("The values of this page will be kept as an entry of your own.")};
        },
        window());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const QString fault = store().save(m_document.project(), dialog.name());
    m_fault->showRemark(fault.isEmpty() ? Remark{}
                                        : Remark{Mark::error, tr("Not kept: %1").arg(fault)});
}

void CatalogueBar::retranslate() {
    m_choose->setText(tr("From catalogue…"));
    m_choose->setToolTip(tr("Take values from the catalogue; what changes is shown first"));
    m_keep->setText(tr("Save as mine…"));
    m_keep->setToolTip(tr("Keep the values of this page as an entry of your own catalogue"));
    for (QPushButton* button : {m_choose, m_keep}) {
        button->setAccessibleName(button->text());
        button->setAccessibleDescription(button->toolTip());
    }
}

} // namespace sparkout
