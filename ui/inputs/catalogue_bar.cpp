// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/catalogue_bar.h"

#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/wheel.h"
#include "ui/form/mark.h"
#include "ui/inputs/stiffness_offer.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/name_dialog.h"
#include "ui/kit/sealed_state.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr QSize usualSize(940, 620);
const QString settingsName = QStringLiteral("catalogue");

/// The keys of the main numbers of an entry.
std::vector<std::string> mainKeys(CatalogueKind kind) {
    switch (kind) {
    case CatalogueKind::materials:
        return {"hardness_hrc", "flow_stress_mpa", "conductivity_w_mk", "diffusivity_mm2_s",
                "burn_rise_k"};
    case CatalogueKind::wheels:
        return {"diameter_mm", "width_mm", "max_speed_m_s", "grain_mm", "grain_share"};
    case CatalogueKind::machines:
        return {"limits/part_diameter_mm",  "limits/part_length_mm",    "wheel_speed_m_s",
                "wheel_drive_kw",           "stiffness_n_um/headstock", "stiffness_n_um/tailstock",
                "stiffness_n_um/wheel_head"};
    }
    return {};
}

QString withUnit(const QString& text, const Field& field) {
    return *field.unit ? text + QStringLiteral(", ") + unitText(field.unit) : text;
}

const StructInfo& valueTable(CatalogueKind kind) {
    return kind == CatalogueKind::materials ? tableOf<Material>()
           : kind == CatalogueKind::wheels  ? tableOf<Wheel>()
                                            : tableOf<Machine>();
}

const Field* fieldAt(const StructInfo& table, const std::string& key) {
    const std::size_t slash = key.find('/');
    const Field* field = table.find(key.substr(0, slash));
    return slash == std::string::npos || !field ? field
                                                : fieldAt(*field->nested, key.substr(slash + 1));
}

/// Makes the contents visible, by scrolling if they are too wide, and fills the width otherwise.
void fitColumns(QTreeWidget& tree) {
    tree.header()->setStretchLastSection(false);
    for (int column = 0; column < tree.columnCount(); ++column) {
        tree.resizeColumnToContents(column);
    }
    tree.header()->setStretchLastSection(tree.header()->length() < tree.viewport()->width());
}

void setUp(QTreeWidget& tree) {
    tree.setRootIsDecorated(false);
    tree.setUniformRowHeights(true);
    tree.setAllColumnsShowFocus(true);
    tree.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
}

} // namespace

CatalogueDialog::CatalogueDialog(CatalogueStore& store, Project project, Settings* settings,
                                 QWidget* parent)
    : QDialog(parent)
    , m_store(store)
    , m_project(std::move(project))
    , m_settings(settings)
    , m_fault(plainLabel({}, this))
    , m_aside(new QPushButton(tr("Rename it, &start a new one"), this))
    , m_search(new QLineEdit(this))
    , m_found(plainLabel({}, this))
    , m_list(new QTreeWidget(this))
    , m_note(plainLabel({}, this))
    , m_preview(new QTreeWidget(this))
    , m_stiffness(new StiffnessOffer(m_project, this))
    , m_refused(plainLabel({}, this))
    , m_rename(new QPushButton(tr("&Rename…"), this))
    , m_remove(new QPushButton(tr("&Delete…"), this)) {
    setHelpTopic(*this, QStringLiteral("editing#catalogues"));
    setWindowTitle(title(store.kind()));
    build();
    resize(usualSize);
    if (m_settings) {
        if (const auto parts = unsealed(m_settings->dialogGeometry(settingsName), 1)) {
            restoreGeometry(parts->front());
        }
    }
    m_store.refresh();
    fill({});
    showFault();
}

CatalogueDialog::~CatalogueDialog() {
    if (m_settings) {
        m_settings->setDialogGeometry(settingsName, sealed({saveGeometry()}));
    }
}

QString CatalogueDialog::title(CatalogueKind kind) {
    switch (kind) {
    case CatalogueKind::materials: return tr("Catalogue of materials");
    case CatalogueKind::wheels: return tr("Catalogue of wheels");
    case CatalogueKind::machines: return tr("Catalogue of machines");
    }
    return {};
}

void CatalogueDialog::build() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(buildList());
    splitter->addWidget(buildPreview());
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    auto* buttons = new AnswerButtons(tr("&Apply"), tr("&Cancel"), this);
    m_take = buttons->acceptButton();
    m_take->setObjectName(QStringLiteral("takeOver"));
    QPushButton* const cancel = buttons->rejectButton();
    cancel->setObjectName(QStringLiteral("cancel"));
    for (QPushButton* button : {m_rename, m_remove}) {
        buttons->addButton(button, QDialogButtonBox::ResetRole);
    }
    for (QPushButton* button : {m_rename, m_remove, m_aside, cancel}) {
        button->setAutoDefault(false);
    }
    m_rename->setObjectName(QStringLiteral("renameEntry"));
    m_remove->setObjectName(QStringLiteral("deleteEntry"));
    m_aside->setObjectName(QStringLiteral("putAside"));
    m_fault->setObjectName(QStringLiteral("catalogueFault"));
    m_fault->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_fault->setAccessibleName(tr("State of your catalogue"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_fault);
    layout->addWidget(m_aside, 0, Qt::AlignLeft);
    layout->addWidget(splitter, 1);
    layout->addWidget(m_stiffness);
    layout->addWidget(m_refused);
    layout->addWidget(buttons);
    m_refused->setObjectName(QStringLiteral("catalogueRefused"));
    m_refused->setAccessibleName(tr("Why the inputs would be refused"));
    m_refused->setMinimumHeight(m_refused->fontMetrics().lineSpacing() * 2);
    m_refused->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    connect(m_search, &QLineEdit::textChanged, this, &CatalogueDialog::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &CatalogueDialog::showChosen);
    connect(m_stiffness, &StiffnessOffer::chosen, this, &CatalogueDialog::showPreview);
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
    connect(m_aside, &QPushButton::clicked, this, &CatalogueDialog::putAside);
    connect(m_rename, &QPushButton::clicked, this, &CatalogueDialog::renameOwn);
    connect(m_remove, &QPushButton::clicked, this, &CatalogueDialog::removeOwn);
    for (QTreeWidget* tree : {m_list, m_preview}) {
        tree->viewport()->installEventFilter(this);
    }
    m_search->setFocus();
}

QWidget* CatalogueDialog::buildList() {
    auto* part = new QWidget(this);
    m_search->setObjectName(QStringLiteral("catalogueSearch"));
    m_search->setPlaceholderText(tr("Name, grade, marking, use or source"));
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    m_search->setAccessibleName(tr("Search the catalogue"));
    auto* label = new QLabel(tr("&Search:"), part);
    label->setBuddy(m_search);
    m_found->setObjectName(QStringLiteral("catalogueFound"));
    m_found->setAccessibleName(tr("Entries found"));
    m_found->setWordWrap(false);
    setUp(*m_list);
    m_list->setObjectName(QStringLiteral("catalogueList"));
    m_list->setAccessibleName(tr("Entries"));
    QStringList heads{tr("Name")};
    QStringList tips = heads;
    for (const std::string& key : mainKeys(m_store.kind())) {
        const Field& field = *fieldAt(valueTable(m_store.kind()), key);
        const QString symbol = QString::fromUtf8(field.symbol).remove(u'_');
        heads += symbol.isEmpty() || symbol == unitText(field.unit)
                     ? withUnit(inputText(field.label), field)
                     : withUnit(symbol, field);
        tips += withUnit(inputText(field.label), field);
    }
    m_list->setHeaderLabels(heads << tr("Whose") << tr("Sources"));
    for (int column = 0; column < tips.size(); ++column) {
        m_list->headerItem()->setToolTip(column, tips[column]);
    }
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_search, 1);
    row->addWidget(m_found);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(row);
    layout->addWidget(m_list, 1);
    return part;
}

QWidget* CatalogueDialog::buildPreview() {
    auto* part = new QWidget(this);
    setUp(*m_preview);
    m_preview->setObjectName(QStringLiteral("cataloguePreview"));
    m_preview->setAccessibleName(tr("Resulting changes"));
    m_preview->setHeaderLabels({tr("Input"), tr("Now"), tr("Then"), tr("Source")});
    m_note->setObjectName(QStringLiteral("catalogueNote"));
    m_note->setAccessibleName(tr("The chosen entry"));
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, metrics::gap, 0, 0);
    layout->addWidget(m_note);
    layout->addWidget(m_preview, 1);
    return part;
}

void CatalogueDialog::fill(const QString& current) {
    m_list->clear();
    const std::vector<std::string> keys = mainKeys(m_store.kind());
    for (const CatalogueItem& item : m_store.items()) {
        auto* row = new QTreeWidgetItem(m_list, {entryName(item.entry)});
        const auto values = changesBy(item.entry, m_project);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto value =
                std::find_if(values.begin(), values.end(), [&](const CatalogueChange& change) {
                    return change.key == keys[i] && change.source;
                });
            row->setText(int(i) + 1, value == values.end() ? QStringLiteral("—") : value->then);
            row->setTextAlignment(int(i) + 1, Qt::AlignRight | Qt::AlignVCenter);
        }
        const int whose = int(keys.size()) + 1;
        row->setText(whose, item.own ? tr("mine") : tr("shipped"));
        row->setText(whose + 1, sourcesShown(item));
        row->setToolTip(0, entryNote(item.entry));
        row->setToolTip(whose + 1, row->text(whose + 1));
        if (entryName(item.entry) == current) {
            m_list->setCurrentItem(row);
        }
    }
    fitColumns(*m_list);
    filter();
}

void CatalogueDialog::filter() {
    int found = 0;
    QTreeWidgetItem* first = nullptr;
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = m_list->topLevelItem(i);
        const bool shows = matchesQuery(m_store.items()[std::size_t(i)].search, m_search->text());
        row->setHidden(!shows);
        found += shows;
        first = shows && !first ? row : first;
    }
    m_found->setText(tr("%1 of %2").arg(found).arg(m_list->topLevelItemCount()));
    if (!m_list->currentItem() || m_list->currentItem()->isHidden()) {
        m_list->setCurrentItem(first);
    }
    if (m_list->currentItem()) {
        m_list->scrollToItem(m_list->currentItem());
    }
    showChosen();
}

const CatalogueItem* CatalogueDialog::chosen() const {
    const QTreeWidgetItem* row = m_list->currentItem();
    const int index =
        row && !row->isHidden() ? m_list->indexOfTopLevelItem(m_list->currentItem()) : -1;
    return index < 0 ? nullptr : &m_store.items()[std::size_t(index)];
}

Project CatalogueDialog::taken() const {
    return m_stiffness->taken(withEntry(chosen()->entry, m_project));
}

void CatalogueDialog::showChosen() {
    const CatalogueItem* item = chosen();
    m_take->setEnabled(item != nullptr);
    m_rename->setEnabled(item && item->own);
    m_remove->setEnabled(item && item->own);
    if (!item) {
        m_preview->clear();
        m_stiffness->withdraw();
        m_note->setText(tr("No entry has all these words."));
        m_refused->clear();
        return;
    }
    if (m_store.kind() == CatalogueKind::machines) {
        m_stiffness->offer(withEntry(item->entry, m_project));
    }
    showPreview();
}

/// Leaves out values that do not change since the stiffness is not taken.
void CatalogueDialog::showPreview() {
    const CatalogueItem* item = chosen();
    if (!item) {
        return;
    }
    m_preview->clear();
    int count = 0;
    QFont bold = font();
    bold.setBold(true);
    for (const CatalogueChange& change : changesBy(item->entry, m_project)) {
        const bool isStiffness = change.key.starts_with("stiffness_n_um");
        if (isStiffness && !m_stiffness->isTaken() && !complianceIsGiven()) {
            continue;
        }
        auto* row = new QTreeWidgetItem(
            m_preview,
            {withUnit(inputText(change.field->label), *change.field), change.now, change.then,
             change.source ? sourceShown(*change.source, *change.field, item->own) : QString()});
        for (int column = 0; column < 4; ++column) {
            row->setToolTip(column, row->text(column));
        }
        if (change.changed) {
            row->setFont(0, bold);
            row->setFont(2, bold);
            ++count;
        }
    }
    fitColumns(*m_preview);
    const QString note = entryNote(item->entry);
    const QString changes =
        count == 0 ? tr("It changes nothing.")
                   : tr("%n inputs change (in bold); the others stay as they are.", nullptr, count);
    QStringList said{note.isEmpty() ? QString() : note + u'.', changes};
    if (complianceIsGiven() && !m_stiffness->isTaken()) {
        said += tr("The compliance is given on this page, so the stiffness is not used.");
    }
    m_note->setText(joined(said, QStringLiteral(" ")));
    const Issues errors = newErrors(m_project, taken());
    m_refused->setText(errors.empty()
                           ? QString()
                           : tr("This entry would make the inputs invalid: %1")
                                 .arg(locationText(errors.front().path) + QStringLiteral(": ")
                                      + issueText(errors.front())));
}

bool CatalogueDialog::complianceIsGiven() const {
    return m_store.kind() == CatalogueKind::machines
           && !std::holds_alternative<std::monostate>(m_project.machine->compliance_mm_per_n);
}

void CatalogueDialog::showFault() {
    const bool damaged = !m_store.fault().isEmpty();
    m_fault->setText(damaged ? tr("Your own entries cannot be read and are left as they are in "
                                  "%1: %2")
                                   .arg(m_store.ownFile(), m_store.fault())
                             : QString());
    m_fault->setVisible(damaged);
    m_aside->setVisible(damaged);
}

void CatalogueDialog::putAside() {
    QString aside;
    const QString fault = m_store.putAside(aside);
    fill({});
    showFault();
    if (fault.isEmpty()) {
        m_fault->setText(tr("The unreadable file is kept as %1.").arg(aside));
        m_fault->show();
    } else {
        m_fault->setText(m_fault->text() + u'\n' + fault);
    }
}

void CatalogueDialog::renameOwn() {
    const QString old = entryName(chosen()->entry);
    NameDialog dialog(
        tr("Rename the entry"), tr("&Rename"), old,
        [this, &old](const QString& name) -> NameDialog::Answer {
            const bool taken = name != old && m_store.hasOwn(name);
            return {taken ? tr("You already have an entry with this name.") : QString(), !taken};
        },
        this);
    if (dialog.exec() == QDialog::Accepted && dialog.name() != old) {
        finishChange(m_store.rename(old, dialog.name()), dialog.name());
    }
}

void CatalogueDialog::removeOwn() {
    const QString name = entryName(chosen()->entry);
    QMessageBox box(QMessageBox::Question, windowTitle(),
                    tr("Delete “%1” from your catalogue? Projects that use it keep their values.")
                        .arg(printableText(name)),
                    QMessageBox::Yes | QMessageBox::No, this);
    box.setTextFormat(Qt::PlainText);
    box.setDefaultButton(QMessageBox::No);
    if (box.exec() == QMessageBox::Yes) {
        finishChange(m_store.remove(name), {});
    }
}

void CatalogueDialog::finishChange(const QString& fault, const QString& name) {
    fill(name);
    showFault();
    if (!fault.isEmpty()) {
        m_fault->setText(tr("Nothing was changed in your catalogue: %1").arg(fault));
        m_fault->show();
    }
}

/// Arrows in the search field move in the list; columns follow the width.
bool CatalogueDialog::eventFilter(QObject* watched, QEvent* event) {
    for (QTreeWidget* tree : {m_list, m_preview}) {
        if (watched == tree->viewport() && event->type() == QEvent::Resize) {
            fitColumns(*tree);
        }
    }
    if (watched == m_search && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp
            || key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(m_list, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

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
                return {
                    tr("Your own catalogue cannot be read. “From catalogue…” shows the reason."),
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
    m_choose->setToolTip(tr("Apply values from the catalogue; the changes are shown first"));
    m_keep->setText(tr("Save as mine…"));
    m_keep->setToolTip(tr("Keep the values of this page as an entry of your own catalogue"));
    for (QPushButton* button : {m_choose, m_keep}) {
        button->setAccessibleName(button->text());
        button->setAccessibleDescription(button->toolTip());
    }
}

} // namespace sparkout
