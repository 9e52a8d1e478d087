// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/access_page.h"

#include "ui/kit/metrics.h"
#include "ui/lesson/edit/lesson_draft.h"
#include "ui/lesson/edit/lesson_inputs.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int pathRole = Qt::UserRole, wordsRole = Qt::UserRole + 1;
enum AccessColumn { inputColumn, accessColumn, accessColumns };

QString accessName(Access access) {
    return choiceText(choicesOf<Access>()[static_cast<std::size_t>(access)].label);
}

void addAccesses(QComboBox& combo) {
    for (std::size_t i = 0; i < choicesOf<Access>().size(); ++i) {
        combo.addItem(accessName(static_cast<Access>(i)), static_cast<int>(i));
    }
}

std::string pathOf(const QTreeWidgetItem& item) {
    return item.data(inputColumn, pathRole).toString().toStdString();
}

} // namespace

AccessPage::AccessPage(LessonDraft& draft, std::size_t step, QWidget* parent)
    : QWidget(parent)
    , m_draft(draft)
    , m_step(step)
    , m_others(new QComboBox(this))
    , m_search(new QLineEdit(this))
    , m_tree(new QTreeWidget(this))
    , m_access(new QComboBox(this)) {
    m_others->setObjectName(QStringLiteral("otherInputs"));
    m_search->setObjectName(QStringLiteral("inputSearch"));
    m_tree->setObjectName(QStringLiteral("inputTree"));
    m_access->setObjectName(QStringLiteral("inputAccess"));
    addAccesses(*m_others);
    m_access->addItem(tr("as the inputs around them"), -1);
    addAccesses(*m_access);
    m_search->setPlaceholderText(tr("Search the inputs"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_search->setClearButtonEnabled(true);
    m_tree->setAccessibleName(tr("Inputs"));
    m_tree->setColumnCount(accessColumns);
    m_tree->setHeaderLabels({tr("Input"), tr("For the student")});
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setUniformRowHeights(true);
    auto* form = new QFormLayout;
    form->addRow(tr("Inputs that are not named"), m_others);
    auto* below = new QFormLayout;
    below->addRow(tr("Selected inputs"), m_access);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::gap);
    layout->addLayout(form);
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    layout->addLayout(below);
    fill();
    connect(m_others, &QComboBox::activated, this, [this](int index) {
        change({}, [index](LessonStep& of) { of.others = static_cast<Access>(index); });
    });
    connect(m_search, &QLineEdit::textChanged, this, &AccessPage::search);
    connect(m_access, &QComboBox::activated, this, [this](int index) {
        const int access = m_access->itemData(index).toInt();
        give(access < 0 ? std::nullopt : std::optional(static_cast<Access>(access)));
    });
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &AccessPage::show);
    connect(&m_draft, &LessonDraft::changed, this, &AccessPage::show);
}

const LessonStep* AccessPage::now() const {
    const auto& steps = m_draft.lesson().steps;
    return m_step < steps.size() ? &steps[m_step] : nullptr;
}

void AccessPage::fill() {
    for (const std::string& path :
         formInputs(m_draft.projectAt("/steps/" + std::to_string(m_step)))) {
        addInput(path);
    }
    m_tree->header()->setSectionResizeMode(inputColumn, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(accessColumn, QHeaderView::ResizeToContents);
    m_tree->header()->setStretchLastSection(false);
    show();
}

void AccessPage::addInput(const std::string& path) {
    if (m_items.contains(path)) {
        return;
    }
    const auto above = m_items.find(path.substr(0, path.rfind('/')));
    auto* item =
        above == m_items.end() ? new QTreeWidgetItem(m_tree) : new QTreeWidgetItem(above->second);
    const QString place = inputLocation(path);
    item->setText(inputColumn, place.section(QStringLiteral(" › "), -1));
    item->setData(inputColumn, pathRole, QString::fromStdString(path));
    item->setData(inputColumn, wordsRole, place);
    item->setToolTip(inputColumn, place);
    m_items[path] = item;
}

void AccessPage::show() {
    const LessonStep* const step = now();
    if (!step) {
        return;
    }
    m_others->setCurrentIndex(static_cast<int>(step->others));
    for (const InputAccess& each : step->inputs) { // includes inputs that the project does not have
        addInput(each.path);
    }
    for (const auto& [path, item] : m_items) {
        const bool isNamed = std::ranges::any_of(
            step->inputs, [&path = path](const InputAccess& each) { return each.path == path; });
        item->setText(accessColumn, accessName(accessTo(*step, path)));
        QFont font = m_tree->font();
        font.setBold(isNamed);
        item->setFont(accessColumn, font);
    }
    const auto selected = m_tree->selectedItems();
    m_access->setEnabled(!selected.empty());
    if (!selected.empty()) {
        const std::string path = pathOf(*selected.front());
        const auto named = std::ranges::find(step->inputs, path, &InputAccess::path);
        m_access->setCurrentIndex(
            named == step->inputs.end() ? 0 : 1 + static_cast<int>(named->access));
    }
}

void AccessPage::search(const QString& text) {
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    for (const auto& [path, item] : m_items) {
        item->setHidden(!words.empty());
    }
    if (words.empty()) {
        m_tree->collapseAll();
        return;
    }
    for (const auto& [path, item] : m_items) {
        const QString place = item->data(inputColumn, wordsRole).toString();
        if (std::ranges::all_of(words, [&place](const QString& word) {
                return place.contains(word, Qt::CaseInsensitive);
            })) {
            for (QTreeWidgetItem* up = item; up; up = up->parent()) {
                up->setHidden(false);
                up->setExpanded(up != item || up->isExpanded());
            }
        }
    }
}

void AccessPage::give(std::optional<Access> access) {
    std::vector<std::string> paths;
    for (const QTreeWidgetItem* item : m_tree->selectedItems()) {
        paths.push_back(pathOf(*item));
    }
    std::string key =
        "/steps/" + std::to_string(m_step) + "/inputs"; // a choice by arrow keys is one
    for (const std::string& path : paths) {
        key += path;
    }
    change(key, [&](LessonStep& step) {
        for (const std::string& path : paths) {
            const auto named = std::ranges::find(step.inputs, path, &InputAccess::path);
            if (!access) {
                std::erase_if(step.inputs,
                              [&path](const InputAccess& each) { return each.path == path; });
            } else if (named == step.inputs.end()) {
                step.inputs.push_back({path, *access});
            } else {
                named->access = *access;
            }
        }
    });
}

void AccessPage::change(const std::string& key,
                        const std::function<void(LessonStep& step)>& change) {
    m_draft.edit(key, [&](Lesson& lesson) {
        if (m_step < lesson.steps.size()) {
            change(lesson.steps[m_step]);
        }
    });
}

} // namespace sparkout
