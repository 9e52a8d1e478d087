// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/packs/pack_import_dialog.h"

#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

enum LineColumn { partColumn, nameColumn, stateColumn, choiceColumn };

QTreeWidget* newTree(const char* name, const QString& accessible, const QStringList& heads,
                     QWidget* parent) {
    auto* tree = new QTreeWidget(parent);
    tree->setObjectName(QString::fromLatin1(name));
    tree->setAccessibleName(accessible);
    tree->setHeaderLabels(heads);
    tree->setRootIsDecorated(false);
    tree->setAllColumnsShowFocus(true);
    tree->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    return tree;
}

void fitColumns(QTreeWidget& tree) {
    for (int column = 0; column < tree.columnCount(); ++column) {
        tree.resizeColumnToContents(column);
    }
}

} // namespace

PackImportDialog::PackImportDialog(Pack pack, Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_plan(std::move(pack), settings)
    , m_lines(newTree("packLines", tr("Contents of the pack"),
                      {tr("Item"), tr("Name"), tr("You have"), tr("Action")}, this))
    , m_differences(newTree("packDifferences", tr("The chosen line in detail"),
                            {tr("Input"), tr("Yours"), tr("In the pack")}, this))
    , m_state(plainLabel({}, this)) {
    setWindowTitle(tr("Import a pack"));
    setHelpTopic(*this, QStringLiteral("packs#import"));
    m_state->setObjectName(QStringLiteral("packState"));
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new AnswerButtons(tr("&Import"), tr("&Cancel"), this);
    m_take = buttons->acceptButton();
    m_take->setObjectName(QStringLiteral("importPack"));
    buttons->rejectButton()->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(buildHead());
    layout->addWidget(buildLines(), 1);
    layout->addWidget(m_state);
    layout->addWidget(buttons);
    resize(atFontSize(860), atFontSize(560));
    showChosen();
    m_lines->setFocus();
}

QWidget* PackImportDialog::buildHead() {
    const Pack& pack = m_plan.pack();
    auto* head = new QWidget(this);
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    for (const std::string* text : {&pack.title, &pack.note}) {
        if (text->empty()) {
            continue;
        }
        auto* label = plainLabel(QString::fromStdString(*text), head);
        if (text == &pack.title) {
            QFont bold = label->font();
            bold.setBold(true);
            label->setFont(bold);
        }
        column->addWidget(label);
    }
    if (const QString fault = m_plan.logoFault(); !fault.isEmpty()) {
        auto* label = plainLabel(tr("The logo of the pack is left out. %1").arg(fault), head);
        label->setObjectName(QStringLiteral("packLogoFault"));
        column->addWidget(label);
    }
    column->addWidget(plainLabel(tr("Your own data are replaced only if you choose so here. A pack "
                                    "contains only data: nothing in it is executed."),
                                 head));
    return head;
}

QWidget* PackImportDialog::buildLines() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_lines);
    splitter->addWidget(m_differences);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    for (std::size_t line = 0; line < m_plan.lines().size(); ++line) {
        addLine(line);
    }
    fitColumns(*m_lines);
    m_lines->header()->setStretchLastSection(false);
    m_lines->header()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
    connect(m_lines, &QTreeWidget::currentItemChanged, this, &PackImportDialog::showDifferences);
    const auto conflict =
        std::ranges::find(m_plan.lines(), PackPlan::State::different, &PackPlan::Line::state);
    const bool found = conflict != m_plan.lines().end();
    m_lines->setCurrentItem(
        m_lines->topLevelItem(found ? static_cast<int>(conflict - m_plan.lines().begin()) : 0));
    return splitter;
}

void PackImportDialog::addLine(std::size_t line) {
    const PackPlan::Line& at = m_plan.lines()[line];
    auto* item = new QTreeWidgetItem(
        m_lines, {PackParts::name(at.part), printableText(at.name), stateText(at.state)});
    item->setToolTip(nameColumn, printableText(at.note));
    const std::vector<PackPlan::Choice> choices = m_plan.choices(line);
    if (choices.size() == 1) {
        item->setText(choiceColumn, choiceText(choices.front(), at.state));
        return;
    }
    auto* box = new QComboBox(m_lines);
    box->setObjectName(QStringLiteral("packChoice%1").arg(line + 1));
    box->setAccessibleName(tr("Action for “%1”").arg(printableText(at.name)));
    for (const PackPlan::Choice choice : choices) {
        box->addItem(choiceText(choice, at.state), static_cast<int>(choice));
    }
    box->setCurrentIndex(box->findData(static_cast<int>(at.choice)));
    m_lines->setItemWidget(item, choiceColumn, box);
    item->setSizeHint(choiceColumn, box->sizeHint());
    connect(box, &QComboBox::currentIndexChanged, this, [this, box, line, item] {
        m_plan.choose(line, static_cast<PackPlan::Choice>(box->currentData().toInt()));
        m_lines->setCurrentItem(item);
        showChosen();
    });
}

void PackImportDialog::showDifferences() {
    m_differences->clear();
    const int line = m_lines->indexOfTopLevelItem(m_lines->currentItem());
    if (line < 0) {
        return;
    }
    const auto at = static_cast<std::size_t>(line);
    if (m_plan.lines()[at].state == PackPlan::State::same) {
        new QTreeWidgetItem(m_differences, {tr("No difference.")});
        m_differences->resizeColumnToContents(0);
        return;
    }
    for (const PackPlan::Difference& difference : m_plan.differences(at)) {
        new QTreeWidgetItem(m_differences, {difference.what, printableText(difference.yours),
                                            printableText(difference.packs)});
    }
    fitColumns(*m_differences);
}

void PackImportDialog::showChosen() {
    const int chosen = m_plan.chosen();
    m_take->setEnabled(chosen > 0);
    m_state->setText(m_plan.lines().empty() ? tr("The pack is empty.")
                     : chosen == 0          ? tr("Nothing is chosen.")
                                            : tr("To be imported: %1.").arg(chosen));
}

void PackImportDialog::accept() {
    const QStringList faults = m_plan.carryOut(m_settings);
    if (faults.empty()) {
        QDialog::accept();
        return;
    }
    m_state->setText(tr("Not everything could be kept: %1").arg(faults.join(u' ')));
}

QString PackImportDialog::stateText(PackPlan::State state) {
    switch (state) {
    case PackPlan::State::fresh: return tr("nothing of that name");
    case PackPlan::State::shipped: return tr("the one that comes with the program");
    case PackPlan::State::same: return tr("the same");
    case PackPlan::State::different: return tr("another of that name");
    }
    return {};
}

QString PackImportDialog::choiceText(PackPlan::Choice choice, PackPlan::State state) {
    switch (choice) {
    case PackPlan::Choice::leave:
        return state == PackPlan::State::same        ? tr("stays as it is")
               : state == PackPlan::State::different ? tr("Keep yours")
                                                     : tr("Do not take");
    case PackPlan::Choice::take:
        return state == PackPlan::State::different ? tr("Replace yours") : tr("Take");
    case PackPlan::Choice::takeBeside: return tr("Keep both");
    }
    return {};
}

} // namespace sparkout
