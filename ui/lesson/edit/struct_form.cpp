// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/struct_form.h"

#include "ui/kit/metrics.h"
#include "ui/lesson/edit/lesson_draft.h"
#include "ui/lesson/edit/lesson_inputs.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// Describes which widgets exist: by optional objects, items of lists, and choices.
std::string shapeOf(const StructInfo& info, const void* owner) {
    std::string shape;
    for (const Field& field : info.fields) {
        if (ValueWidgets::isInput(info, field)) {
            shape += field.as<std::string>(owner) + '|';
        } else if (ValueWidgets::isNumbered(info, field)) {
            shape += std::to_string(field.as<int>(owner)) + '|';
        } else if (field.kind == Kind::optionalNumberList) {
            shape += field.as<std::optional<std::vector<double>>>(owner) ? "()" : "-";
        } else if (field.kind == Kind::optionalObject || field.kind == Kind::object) {
            const void* const object = field.objectIn(owner);
            shape += object ? '{' + shapeOf(*field.nested, object) + '}' : "-";
        } else if (field.kind == Kind::objectList) {
            shape += '[';
            for (std::size_t i = 0; i < field.size(owner); ++i) {
                shape += shapeOf(*field.nested, field.itemIn(owner, i)) + ',';
            }
            shape += ']';
        }
    }
    return shape;
}

/// The whole list of objects, since the struct cannot remove one from its middle.
template <class Act>
void withItems(const Field& field, void* owner, const Act& act) {
    const auto on = [&]<class T>(const T*) {
        if (field.nested == &tableOf<T>()) {
            act(field.as<std::vector<T>>(owner));
        }
    };
    on(static_cast<const Hint*>(nullptr));
    on(static_cast<const ChoiceOption*>(nullptr));
    on(static_cast<const InputValue*>(nullptr));
    on(static_cast<const ControlQuestion*>(nullptr));
    on(static_cast<const TypicalMistake*>(nullptr));
    on(static_cast<const VariedInput*>(nullptr));
    on(static_cast<const ValueSet*>(nullptr));
    on(static_cast<const FigureBound*>(nullptr));
}

/// Adds required items to a new object.
void addNeeded(const StructInfo& info, void* owner) {
    for (const Field& field : info.fields) {
        if (field.kind == Kind::objectList) {
            const auto least = static_cast<std::size_t>(std::max(field.hard.low, 0.0));
            if (field.size(owner) < least) {
                field.resize(owner, least);
            }
        }
    }
}

/// Adds an item at the end; a set like the last.
void addItemTo(const Field& field, void* owner) {
    const std::size_t count = field.size(owner);
    field.resize(owner, count + 1);
    if (field.nested == &tableOf<ValueSet>() && count > 0) {
        auto& sets = field.as<std::vector<ValueSet>>(owner);
        sets.back().values = sets[count - 1].values;
    }
    addNeeded(*field.nested, field.at(owner, count));
}

int linesOfText(std::string_view key) {
    constexpr int few = 3, many = 9;
    return key == "title" ? 2 : key == "theory" ? many : few;
}

/// Keeps non-breaking spaces, which toPlainText() converts.
QString typedIn(const QPlainTextEdit& box) {
    return box.document()->toRawText().replace(QChar::ParagraphSeparator, u'\n');
}

} // namespace

StructForm::StructForm(LessonDraft& draft, Subject subject, QWidget* parent)
    : QWidget(parent), m_draft(draft), m_subject(std::move(subject)), m_values(draft, this) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    build();
    connect(&m_draft, &LessonDraft::changed, this, &StructForm::refresh);
}

// --- the form as a whole ------------------------------------------------------------------------

void StructForm::build() {
    const void* const owner = m_values.ownerOf(m_subject.reach);
    if (m_body) { // the call may come from a signal of one of its parts
        for (QWidget* part : m_body->findChildren<QWidget*>()) {
            part->blockSignals(true);
        }
        m_body->hide();
        m_body->setParent(nullptr);
        m_body->deleteLater();
        m_body = nullptr;
    }
    m_values.clear();
    if (!owner) {
        return;
    }
    m_shape = shapeOf(m_subject.table, owner);
    m_body = new QWidget(this);
    auto* form = new QFormLayout(m_body);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addStruct(*form, m_subject);
    layout()->addWidget(m_body);
    m_body->show();
}

void StructForm::refresh() {
    const void* const owner = m_values.ownerOf(m_subject.reach);
    if (!owner || !m_body) {
        return; // the page is deleted, too
    }
    if (shapeOf(m_subject.table, owner) != m_shape) {
        const QWidget* const focus = focusWidget();
        const QString named =
            focus && m_body->isAncestorOf(focus) ? focus->objectName() : QString();
        build();
        if (auto* again = named.isEmpty() ? nullptr : m_body->findChild<QWidget*>(named)) {
            again->setFocus();
        }
        return;
    }
    m_values.refresh();
}

void StructForm::addStruct(QFormLayout& form, const Subject& subject) {
    if (&subject.table == &tableOf<Goal>()) {
        addGoal(form, subject);
        return;
    }
    if (&subject.table == &tableOf<VariedInput>()) {
        addVaried(form, subject);
        return;
    }
    for (const Field& field : subject.table.fields) {
        if (subject.keys.empty() || std::ranges::count(subject.keys, field.key) > 0) {
            addRow(form, {subject.table, field, subject.path + '/' + field.key, subject.reach});
        }
    }
}

/// Adds the choice of the kind and its fields.
void StructForm::addGoal(QFormLayout& form, const Subject& subject) {
    const auto kinds = tableOf<Goal>().fields;
    const Row row{subject.table, kinds.front(), subject.path + "/kind", subject.reach};
    auto* kind = new QComboBox;
    for (const Field& field : kinds) {
        kind->addItem(inputText(field.label));
    }
    const auto now =
        static_cast<std::size_t>(static_cast<const Goal*>(m_values.ownerOf(subject.reach))->kind());
    kind->setCurrentIndex(static_cast<int>(now));
    kind->setObjectName(QString::fromStdString(row.path));
    kind->setAccessibleName(tr("Kind of goal"));
    m_values.watch(*kind);
    form.addRow(tr("Kind of goal"), kind);
    auto* about = new QLabel(inputText(kinds[now].hint));
    about->setWordWrap(true);
    form.addRow(about);
    connect(kind, &QComboBox::activated, this, [this, row, kinds](int index) {
        m_values.change(
            row,
            [&](void* owner) {
                auto& goal = *static_cast<Goal*>(owner);
                const auto figure = goal.asked() ? std::optional(*goal.asked()) : std::nullopt;
                goal = Goal();
                kinds[static_cast<std::size_t>(index)].object(&goal, true);
                if (goal.asked() && figure) { // the same figure in another form
                    const_cast<Figure&>(*goal.asked()) = *figure;
                }
                const Field& field = kinds[static_cast<std::size_t>(index)];
                addNeeded(*field.nested, field.object(&goal, false));
            },
            false);
    });
    const Field& given = kinds[now];
    addStruct(form, {*given.nested, subject.path + '/' + given.key,
                     [reach = subject.reach, &given](Lesson& lesson) -> void* {
                         void* const owner = reach(lesson);
                         return owner ? given.object(owner, false) : nullptr;
                     }});
}

/// Adds a range, a list or sets, with only the values of this kind.
void StructForm::addVaried(QFormLayout& form, const Subject& subject) {
    const auto rowOf = [&subject](const char* key) {
        return Row{subject.table, *subject.table.find(key), subject.path + '/' + key,
                   subject.reach};
    };
    auto* combo = new QComboBox;
    combo->addItems({tr("a range in steps"), tr("a list of values"), tr("named sets of values")});
    const VariedBy by = variedBy(*static_cast<const VariedInput*>(m_values.ownerOf(subject.reach)));
    combo->setCurrentIndex(static_cast<int>(by));
    combo->setObjectName(QString::fromStdString(subject.path + "/by"));
    combo->setAccessibleName(tr("Varied over"));
    m_values.watch(*combo);
    form.addRow(tr("Varied over"), combo);
    connect(combo, &QComboBox::activated, this, [this, row = rowOf("path")](int index) {
        m_values.change(
            row,
            [&](void* owner) {
                auto& input = *static_cast<VariedInput*>(owner);
                if (const auto chosen = static_cast<VariedBy>(index); chosen != variedBy(input)) {
                    input = variedAs(input, chosen, m_draft.projectAt(row.path));
                }
            },
            false);
    });
    if (by == VariedBy::sets) {
        addRow(form, rowOf("sets"));
        return;
    }
    addRow(form, rowOf("path"));
    if (by == VariedBy::list) {
        addRow(form, rowOf("list"));
        return;
    }
    auto* line = new QHBoxLayout;
    for (const char* key : {"from", "to", "step"}) {
        const Row row = rowOf(key);
        if (line->count() > 0) {
            line->addWidget(new QLabel(m_values.labelOf(row)));
        }
        line->addWidget(m_values.make(row), 1);
    }
    form.addRow(m_values.labelOf(rowOf("from")), line);
}

void StructForm::addRow(QFormLayout& form, const Row& row) {
    switch (row.field.kind) {
    case Kind::object:
        if (row.field.nested == &tableOf<Bilingual>()) {
            addTexts(form, row);
        } else {
            addObject(form, row);
        }
        return;
    case Kind::optionalObject: addObject(form, row); return;
    case Kind::objectList: addItems(form, row); return;
    default: break;
    }
    if (QWidget* const widget = m_values.make(row)) {
        form.addRow(row.field.kind == Kind::boolean ? QString() : m_values.labelOf(row), widget);
    }
}

// --- texts, objects, lists ----------------------------------------------------------------------

/// Both languages side by side.
void StructForm::addTexts(QFormLayout& form, const Row& row) {
    auto* head = new QLabel(m_values.labelOf(row));
    head->setToolTip(inputText(row.field.hint));
    form.addRow(head);
    auto* both = new QHBoxLayout;
    for (const Field& language : tableOf<Bilingual>().fields) {
        const Row text{tableOf<Bilingual>(), language, row.path + '/' + language.key,
                       [reach = row.reach, &of = row.field](Lesson& lesson) -> void* {
                           void* const owner = reach(lesson);
                           return owner ? of.object(owner, false) : nullptr;
                       }};
        auto* box = new QPlainTextEdit;
        m_values.name(*box, text);
        box->setAccessibleName(
            QStringLiteral("%1, %2").arg(m_values.labelOf(row), inputText(language.label)));
        box->setPlaceholderText(inputText(language.label));
        box->setTabChangesFocus(true);
        box->setUndoRedoEnabled(false);
        const int frame = 2 * (metrics::gap + box->frameWidth());
        const int height = linesOfText(row.field.key) * box->fontMetrics().lineSpacing() + frame;
        box->setMinimumHeight(height);
        box->setMaximumHeight(2 * height);
        connect(box, &QPlainTextEdit::textChanged, this, [this, text, box] {
            m_values.change(text, [&](void* owner) {
                text.field.as<std::string>(owner) = typedIn(*box).toStdString();
            });
        });
        m_values.showBy(text, [box, &of = text.field](const void* owner) {
            const QString stored = QString::fromStdString(of.as<std::string>(owner));
            if (typedIn(*box) != stored) {
                const QSignalBlocker quiet(box);
                box->setPlainText(stored);
                box->moveCursor(QTextCursor::End);
            }
        });
        both->addWidget(box);
    }
    form.addRow(both);
}

void StructForm::addObject(QFormLayout& form, const Row& row) {
    auto* group = new QGroupBox(m_values.labelOf(row));
    group->setObjectName(QString::fromStdString(row.path));
    group->setToolTip(inputText(row.field.hint));
    auto* inner = new QFormLayout(group);
    inner->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const bool isGiven = row.field.objectIn(m_values.ownerOf(row.reach)) != nullptr;
    if (row.field.kind == Kind::optionalObject) {
        group->setCheckable(true);
        group->setChecked(isGiven);
        connect(group, &QGroupBox::clicked, this, [this, row](bool on) {
            m_values.change(
                row,
                [&](void* owner) {
                    if (on) {
                        addNeeded(*row.field.nested, row.field.object(owner, true));
                    } else {
                        row.field.reset(owner);
                    }
                },
                false);
        });
    }
    if (isGiven) {
        addStruct(*inner, {*row.field.nested, row.path,
                           [reach = row.reach, &of = row.field](Lesson& lesson) -> void* {
                               void* const owner = reach(lesson);
                               return owner ? of.object(owner, false) : nullptr;
                           }});
    }
    form.addRow(group);
}

void StructForm::addItems(QFormLayout& form, const Row& row) {
    const std::size_t count = row.field.size(m_values.ownerOf(row.reach));
    for (std::size_t i = 0; i < count; ++i) {
        addItem(form, row, i, count);
    }
    auto* add = new QPushButton(tr("Add: %1").arg(structText(row.field.nested->name)));
    add->setObjectName(QString::fromStdString(row.path + "/add"));
    add->setAutoDefault(false);
    add->setToolTip(inputText(row.field.hint));
    connect(add, &QPushButton::clicked, this, [this, row] {
        m_values.change(
            row, [&](void* owner) { addItemTo(row.field, owner); }, false);
    });
    auto* line = new QHBoxLayout;
    line->addWidget(add);
    line->addStretch(1);
    if (row.field.nested == &tableOf<VariedInput>()) {
        auto* inAll = new QLabel;
        inAll->setObjectName(QString::fromStdString(row.path + "/count"));
        line->addWidget(inAll);
        m_values.showBy(row, [inAll](const void* owner) {
            inAll->setText(
                tr("Variants in all: %1")
                    .arg(printedNumber(variantCount(*static_cast<const VariantRules*>(owner)))));
        });
    }
    form.addRow(line);
}

void StructForm::addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count) {
    const QString title =
        QStringLiteral("%1. %2").arg(index + 1).arg(structText(row.field.nested->name));
    const Subject item{*row.field.nested, row.path + '/' + std::to_string(index),
                       [reach = row.reach, &of = row.field, index](Lesson& lesson) -> void* {
                           void* const owner = reach(lesson);
                           return owner && index < of.size(owner) ? of.at(owner, index) : nullptr;
                       }};
    auto* line = new QHBoxLayout;
    if (row.field.nested == &tableOf<InputValue>()) { // on one line
        const Row input{item.table, *item.table.find("path"), item.path + "/path", item.reach};
        line->addWidget(m_values.make(input), 3);
        line->addWidget(m_values.makeValue(item.table, item.path, item.reach), 2);
        addItemButtons(*line, row, index, count, title);
        form.addRow(line);
        return;
    }
    auto* group = new QGroupBox(title);
    group->setObjectName(QString::fromStdString(item.path));
    auto* inner = new QFormLayout(group);
    inner->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addStruct(*inner, item);
    if (row.field.nested == &tableOf<VariedInput>()) {
        line->addWidget(levelsOf(row, index));
    }
    line->addStretch(1);
    addItemButtons(*line, row, index, count, title);
    inner->addRow(line);
    form.addRow(group);
}

QWidget* StructForm::levelsOf(const Row& row, std::size_t index) {
    auto* label = new QLabel;
    label->setObjectName(
        QString::fromStdString(row.path + '/' + std::to_string(index) + "/levels"));
    m_values.showBy(row, [label, index](const void* owner) {
        const auto& inputs = static_cast<const VariantRules*>(owner)->inputs;
        if (index < inputs.size()) {
            const VariedInput& input = inputs[index];
            label->setText(tr("Levels: %1")
                               .arg(printedNumber(input.alternatives() == 1 ? input.levels() : 0)));
        }
    });
    return label;
}

void StructForm::addItemButtons(QHBoxLayout& line, const Row& row, std::size_t index,
                                std::size_t count, const QString& title) {
    const std::string path = row.path + '/' + std::to_string(index);
    const auto button = [&](const QString& text, const char* key, bool on, const auto& act) {
        auto* made = new QPushButton(text);
        made->setObjectName(QString::fromStdString(path + '/' + key));
        made->setAccessibleName(QStringLiteral("%1: %2").arg(title, text));
        made->setAutoDefault(false);
        made->setEnabled(on);
        connect(made, &QPushButton::clicked, this, [this, row, act] {
            m_values.change(
                row, [&](void* owner) { withItems(row.field, owner, act); }, false);
        });
        line.addWidget(made);
    };
    const bool areSets = row.field.nested == &tableOf<ValueSet>(); // without any it is not an input
    const auto at = static_cast<std::ptrdiff_t>(index);
    button(tr("Up"), "up", index > 0,
           [at](auto& items) { std::swap(items[std::size_t(at)], items[std::size_t(at) - 1]); });
    button(tr("Remove"), "remove", count > (areSets ? 1 : 0),
           [at](auto& items) { items.erase(items.begin() + at); });
}

} // namespace sparkout
