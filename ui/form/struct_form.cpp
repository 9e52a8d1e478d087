// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/struct_form.h"

#include "core/project/member.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// A struct that is changed in its place.
class EditedStruct : public FormModel {
public:
    EditedStruct(const StructInfo& table, void* value, QObject* parent)
        : FormModel(parent), m_table(table), m_value(value) {}

    [[nodiscard]] const void* ownerOf(const std::string& path) const override {
        return memberIn(m_table, static_cast<const void*>(m_value), path).owner;
    }
    void change(const std::string& path, const Change& set, bool) override {
        if (void* const owner = memberIn(m_table, m_value, path).owner) {
            set(owner);
        }
        emit changed();
    }
    [[nodiscard]] bool hasHistory() const override { return false; }

private:
    const StructInfo& m_table;
    void* m_value;
};

} // namespace

StructForm::StructForm(FormModel& model, Subject subject, QWidget* parent)
    : QWidget(parent), m_model(model), m_subject(std::move(subject)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    connect(&m_model, &FormModel::changed, this, [this] {
        refresh();
        emit edited();
    });
}

StructForm* StructForm::over(const StructInfo& table, void* value, QWidget* parent) {
    auto* form = new StructForm(*new EditedStruct(table, value, parent), {table, {}}, parent);
    form->build();
    return form;
}

// --- the form as a whole ------------------------------------------------------------------------

void StructForm::build() {
    if (m_body) { // it may be within a signal of one of its parts
        for (QWidget* part : m_body->findChildren<QWidget*>()) {
            part->blockSignals(true);
        }
        m_body->hide();
        m_body->setParent(nullptr);
        m_body->deleteLater();
        m_body = nullptr;
    }
    m_editors.clear();
    m_shows.clear();
    const void* const owner = ownerOf(rowOf(m_subject, m_subject.table.fields.front()));
    if (!owner) {
        return;
    }
    m_shape = shapeOf(owner);
    m_body = new QWidget(this);
    auto* form = new QFormLayout(m_body);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addStruct(*form, m_subject);
    layout()->addWidget(m_body);
    m_body->show();
}

std::string StructForm::shapeOf(const void* owner) const {
    std::string shape;
    for (const Leaf& leaf : leavesOf(m_subject.table, owner)) {
        shape += leaf.path + '=' + decisiveValue(leaf) + '|';
    }
    return shape;
}

void StructForm::refresh() {
    const void* const owner = ownerOf(rowOf(m_subject, m_subject.table.fields.front()));
    if (!owner || !m_body) {
        return; // the page goes with it
    }
    if (shapeOf(owner) == m_shape) {
        for (FieldEditor* editor : m_editors) {
            editor->show(false);
        }
        for (const auto& show : m_shows) {
            show();
        }
        return;
    }
    const QWidget* const focus = window()->focusWidget(); // its own may have lost it since
    const QString named = focus && m_body->isAncestorOf(focus) ? focus->objectName() : QString();
    build();
    if (auto* again = named.isEmpty() ? nullptr : m_body->findChild<QWidget*>(named)) {
        again->setFocus();
    }
}

void StructForm::addStruct(QFormLayout& form, const Subject& subject) {
    for (const Field& field : subject.table.fields) {
        if (subject.keys.empty() || std::ranges::count(subject.keys, field.key) > 0) {
            addRow(form, rowOf(subject, field));
        }
    }
}

void StructForm::addRow(QFormLayout& form, const Row& row) {
    switch (row.field.kind) {
    case Kind::object:
    case Kind::optionalObject: addObject(form, row); return;
    case Kind::objectList: addItems(form, row); return;
    default: break;
    }
    QWidget* const widget = make(row);
    if (!widget) {
        return;
    }
    if (row.field.kind == Kind::boolean) {
        form.addRow(QString(), widget);
        return;
    }
    const QString unit = unitText(specOf(row).unit).toHtmlEscaped();
    auto* label = new QLabel(unit.isEmpty() ? labelMarkup(row.field)
                                            : labelMarkup(row.field) + QStringLiteral(", ") + unit);
    label->setTextFormat(Qt::RichText);
    label->setBuddy(widget);
    form.addRow(label, widget);
}

// --- objects and lists --------------------------------------------------------------------------

void StructForm::addNeeded(const StructInfo& info, void* owner) {
    for (const Field& field : info.fields) {
        if (field.kind == Kind::objectList) {
            const auto least = static_cast<std::size_t>(std::max(field.hard.low, 0.0));
            if (field.size(owner) < least) {
                field.resize(owner, least);
            }
        }
    }
}

void StructForm::fillNewItem(const Field& list, void* owner) const {
    addNeeded(*list.nested, list.at(owner, list.size(owner) - 1));
}

void StructForm::addObject(QFormLayout& form, const Row& row) {
    auto* group = new QGroupBox(labelOf(row));
    group->setObjectName(QString::fromStdString(row.path));
    group->setToolTip(inputText(row.field.hint));
    auto* inner = new QFormLayout(group);
    inner->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const bool isGiven = row.field.objectIn(ownerOf(row)) != nullptr;
    if (row.field.kind == Kind::optionalObject) {
        group->setCheckable(true);
        group->setChecked(isGiven);
        connect(group, &QGroupBox::clicked, this, [this, row](bool on) {
            change(row, [&](void* owner) {
                if (on) {
                    addNeeded(*row.field.nested, row.field.object(owner, true));
                } else {
                    row.field.reset(owner);
                }
            });
        });
    }
    if (isGiven) {
        addStruct(*inner, {*row.field.nested, row.path});
    }
    form.addRow(group);
}

void StructForm::addItems(QFormLayout& form, const Row& row) {
    const std::size_t count = row.field.size(ownerOf(row));
    for (std::size_t i = 0; i < count; ++i) {
        addItem(form, row, i, count);
    }
    auto* add = new QPushButton(tr("Add: %1").arg(structText(row.field.nested->name)));
    add->setObjectName(QString::fromStdString(row.path + "/add"));
    add->setAutoDefault(false);
    add->setToolTip(inputText(row.field.hint));
    connect(add, &QPushButton::clicked, this, [this, row] {
        change(row, [&](void* owner) {
            row.field.resize(owner, row.field.size(owner) + 1);
            fillNewItem(row.field, owner);
        });
    });
    auto* line = new QHBoxLayout;
    line->addWidget(add);
    line->addStretch(1);
    addBeside(*line, row, {});
    form.addRow(line);
}

void StructForm::addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count) {
    const std::string path = row.path + '/' + std::to_string(index);
    auto* group = new QGroupBox(
        QStringLiteral("%1. %2").arg(index + 1).arg(structText(row.field.nested->name)));
    group->setObjectName(QString::fromStdString(path));
    auto* inner = new QFormLayout(group);
    inner->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addStruct(*inner, {*row.field.nested, path});
    auto* line = new QHBoxLayout;
    addBeside(*line, row, index);
    line->addStretch(1);
    addItemButtons(*line, row, index, count);
    inner->addRow(line);
    form.addRow(group);
}

void StructForm::addItemButtons(QHBoxLayout& line, const Row& row, std::size_t index,
                                std::size_t count) {
    const auto button = [&](const QString& text, const char* key, bool on, const auto& act) {
        auto* made = new QPushButton(text);
        made->setObjectName(
            QString::fromStdString(row.path + '/' + std::to_string(index) + '/' + key));
        made->setAccessibleName(QStringLiteral("%1. %2: %3")
                                    .arg(index + 1)
                                    .arg(structText(row.field.nested->name), text));
        made->setAutoDefault(false);
        made->setEnabled(on);
        connect(made, &QPushButton::clicked, this, [this, row, act] { change(row, act); });
        line.addWidget(made);
    };
    button(tr("Up"), "up", index > 0,
           [&list = row.field, index](void* owner) { list.swap(owner, index, index - 1); });
    button(tr("Remove"), "remove", count > leastItems(row.field),
           [&list = row.field, index](void* owner) { list.erase(owner, index); });
}

// --- values -------------------------------------------------------------------------------------

StructForm::Row StructForm::rowOf(const Subject& subject, const Field& field) {
    return {subject.table, field, subject.path + '/' + field.key};
}

StructForm::Row StructForm::rowOf(const Subject& subject, const char* key) {
    return rowOf(subject, *subject.table.find(key));
}

const void* StructForm::ownerOf(const Row& row) const {
    return m_model.ownerOf(row.path);
}

void StructForm::change(const Row& row, const FormModel::Change& set) {
    m_model.change(row.path, set, false);
}

void StructForm::showBy(const Row& row, std::function<void(const void* owner)> show) {
    m_shows.emplace_back([this, row, act = std::move(show)] {
        if (const void* const owner = ownerOf(row)) {
            act(owner);
        }
    });
    m_shows.back()();
}

QString StructForm::labelOf(const Row& row) const {
    const QString label = inputText(row.field.label);
    const QString unit = unitText(specOf(row).unit);
    return unit.isEmpty() ? label : label + QStringLiteral(", ") + unit;
}

QWidget* StructForm::adopt(const Row& row, std::unique_ptr<FieldEditor> editor) {
    if (!editor) {
        return nullptr;
    }
    FieldEditor* const adopted = editor.release();
    adopted->setParent(m_body); // it is destroyed before its widget, which then has no effect on it
    m_editors.push_back(adopted);
    adopted->retranslate();
    const Field hinted = described(row);
    adopted->describe(labelOf(row), hintMarkup(hinted), hintPlain(hinted));
    adopted->show(false);
    connect(adopted, &FieldEditor::remarkChanged, this, &StructForm::edited);
    return adopted->widget();
}

std::vector<Refusal> StructForm::refusals(const QWidget& within) {
    std::vector<Refusal> refused;
    for (const StructForm* form : within.findChildren<StructForm*>()) {
        for (const FieldEditor* editor : form->m_editors) {
            if (const QString why = editor->refusal(); !why.isEmpty()) {
                refused.push_back({editor->path(), why});
            }
        }
    }
    return refused;
}

NumberSpec StructForm::specOf(const Row& row) const {
    return NumberSpec::of(row.field);
}

QWidget* StructForm::make(const Row& row) {
    QWidget* const widget = adopt(row, makeEditor(row.path, row.field, m_model, nullptr,
                                                  [this, row] { return specOf(row); }));
    if (auto* tick = qobject_cast<QCheckBox*>(widget)) {
        tick->setText(labelOf(row));
    }
    return widget;
}

QWidget* StructForm::choiceOf(const Row& row, ChoiceEditor::Choosing by) {
    return adopt(
        row, std::make_unique<ChoiceEditor>(row.path, row.field, m_model, nullptr, std::move(by)));
}

} // namespace sparkout
