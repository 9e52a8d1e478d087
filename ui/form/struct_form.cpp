// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/struct_form.h"

#include "core/project/leaves.h"
#include "core/project/member.h"
#include "ui/kit/search_combo.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr std::size_t fewChoices = 12;                   ///< without a search
constexpr const char* refusedNumbers = "refusedNumbers"; ///< property: why they were not taken

/// A struct that is changed in its place.
class EditedStruct : public FormModel {
public:
    EditedStruct(const StructInfo& table, void* value, QObject* parent)
        : FormModel(table, parent), m_value(value) {}

    [[nodiscard]] const void* root() const override { return m_value; }
    void change(const std::string&, const Change& set) override {
        set(m_value);
        emit changed();
    }
    [[nodiscard]] bool hasHistory() const override { return false; }

private:
    void* m_value;
};

std::optional<std::vector<double>> readNumbers(const QString& text) {
    std::vector<double> numbers;
    for (const QString& part :
         text.split(QRegularExpression(QStringLiteral("[;\\s]+")), Qt::SkipEmptyParts)) {
        const std::optional<double> number = parseNumber(part);
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

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
            change(
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
        change(
            row,
            [&](void* owner) {
                row.field.resize(owner, row.field.size(owner) + 1);
                fillNewItem(row.field, owner);
            },
            false);
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
        connect(made, &QPushButton::clicked, this, [this, row, act] { change(row, act, false); });
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
    return memberIn(m_model.table(), m_model.root(), row.path).owner;
}

void StructForm::change(const Row& row, const std::function<void(void* owner)>& set, bool merges) {
    m_model.change(merges ? row.path : std::string(), [&](void* root) {
        if (void* const owner = memberIn(m_model.table(), root, row.path).owner) {
            set(owner);
        }
    });
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

void StructForm::name(QWidget& widget, const Row& row) {
    widget.setObjectName(QString::fromStdString(row.path));
    widget.setAccessibleName(labelOf(row));
    widget.setToolTip(hintMarkup(described(row)));
    watch(widget);
}

void StructForm::watch(QWidget& widget) {
    widget.installEventFilter(this);
}

bool StructForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_model.hasHistory()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::Wheel && !qobject_cast<QPlainTextEdit*>(watched)) {
        event->ignore(); // the page scrolls, and no choice is changed by that
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

std::vector<Refusal> StructForm::refusals(const QWidget& within) {
    std::vector<Refusal> refused;
    for (const QLineEdit* line : within.findChildren<QLineEdit*>()) {
        const auto* field = qobject_cast<const NumberField*>(line);
        const QString why = !field             ? line->property(refusedNumbers).toString()
                            : field->refused() ? field->refusal()
                                               : QString();
        if (!why.isEmpty()) {
            refused.push_back({line->objectName().toStdString(), why});
        }
    }
    return refused;
}

QWidget* StructForm::make(const Row& row) {
    switch (row.field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger: return numberOf(row);
    case Kind::numberList:
    case Kind::optionalNumberList: return numbersOf(row);
    case Kind::boolean: return tickOf(row);
    case Kind::text: return lineOf(row);
    case Kind::choice: return choiceOf(row);
    default: return nullptr;
    }
}

NumberSpec StructForm::specOf(const Row& row) const {
    return NumberSpec::of(row.field);
}

QString StructForm::choiceName(const Field& field, std::size_t index) const {
    return choiceText(field.choices[index].label);
}

QWidget* StructForm::numberOf(const Row& row) {
    auto* field = new NumberField(specOf(row));
    name(*field, row);
    field->setHint(hintPlain(described(row)));
    connect(field, &NumberField::valueEdited, this, [this, row, field] {
        const std::optional<double> value = field->value();
        change(row, [&](void* owner) { setNumberIn(row.field, owner, value); });
    });
    connect(field, &NumberField::remarkChanged, this, &StructForm::edited);
    showBy(row,
           [field, &of = row.field](const void* owner) { field->setValue(numberIn(of, owner)); });
    return field;
}

/// Numbers in one line, separated by spaces; a text that is none stays, and is not taken.
QWidget* StructForm::numbersOf(const Row& row) {
    auto* line = new QLineEdit;
    name(*line, row);
    const bool isOptional = row.field.kind == Kind::optionalNumberList;
    const NumberSpec spec = specOf(row);
    const auto numbersIn = [isOptional, &of = row.field](const void* owner) {
        return isOptional ? of.as<std::optional<std::vector<double>>>(owner).value_or(
                   std::vector<double>())
                          : of.as<std::vector<double>>(owner);
    };
    const auto read = [spec](const QString& text) {
        auto numbers = readNumbers(text);
        for (std::size_t i = 0; numbers && i < numbers->size(); ++i) {
            (*numbers)[i] = spec.scale.kept((*numbers)[i]);
        }
        return numbers;
    };
    connect(line, &QLineEdit::textEdited, this,
            [this, row, line, isOptional, spec, read](const QString& text) {
                const auto numbers = read(text);
                const bool isWithin = numbers && std::ranges::all_of(*numbers, [&](double number) {
                                          return spec.hard.contains(number);
                                      });
                line->setProperty(
                    refusedNumbers,
                    !numbers   ? tr("numbers separated by spaces")
                    : isWithin ? QVariant()
                               : tr("out of range; allowed: %1")
                                     .arg(rangeShown(spec.scale.shown(spec.hard), spec.unit)));
                if (isWithin) {
                    change(row, [&](void* owner) {
                        if (isOptional) {
                            row.field.as<std::optional<std::vector<double>>>(owner) = *numbers;
                        } else {
                            row.field.as<std::vector<double>>(owner) = *numbers;
                        }
                    });
                }
                emit edited();
            });
    showBy(row, [line, numbersIn, read, spec](const void* owner) {
        const std::vector<double> numbers = numbersIn(owner);
        if (read(line->text()) != numbers) {
            QStringList words;
            for (const double number : numbers) {
                words += printedNumber(spec.scale.shown(number));
            }
            line->setText(words.join(u' '));
            line->setProperty(refusedNumbers, QVariant());
        }
    });
    return line;
}

QWidget* StructForm::tickOf(const Row& row) {
    auto* box = new QCheckBox(labelOf(row));
    name(*box, row);
    connect(box, &QCheckBox::clicked, this, [this, row](bool on) {
        change(row, [&](void* owner) { row.field.as<bool>(owner) = on; });
    });
    showBy(row, [box, &of = row.field](const void* owner) { box->setChecked(of.as<bool>(owner)); });
    return box;
}

QWidget* StructForm::lineOf(const Row& row) {
    auto* line = new QLineEdit;
    name(*line, row);
    if (std::isfinite(row.field.hard.high)) {
        line->setMaxLength(static_cast<int>(row.field.hard.high));
    }
    connect(line, &QLineEdit::textEdited, this, [this, row](const QString& text) {
        change(row, [&](void* owner) { row.field.as<std::string>(owner) = text.toStdString(); });
    });
    showBy(row, [line, &of = row.field](const void* owner) {
        const QString text = QString::fromStdString(of.as<std::string>(owner));
        if (line->text() != text) {
            line->setText(text);
        }
    });
    return line;
}

QWidget* StructForm::choiceOf(const Row& row) {
    std::vector<Option> options;
    for (std::size_t i = 0; i < row.field.choices.size(); ++i) {
        options.push_back({choiceName(row.field, i), static_cast<int>(i)});
    }
    return comboOf(row, options,
                   {[&of = row.field](const void* owner) { return of.getChoice(owner); },
                    [&of = row.field](void* owner, const QVariant& chosen) {
                        of.setChoice(owner, chosen.toInt());
                    }});
}

QWidget* StructForm::comboOf(const Row& row, const std::vector<Option>& options,
                             const Choosing& by) {
    auto* combo = options.size() > fewChoices ? new SearchCombo : new QComboBox;
    name(*combo, row);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Option& option : options) {
        combo->addItem(option.text, option.value);
    }
    connect(combo, &QComboBox::activated, this, [this, row, combo, put = by.put](int index) {
        change(row, [&](void* owner) { put(owner, combo->itemData(index)); });
    });
    showBy(row, [combo, by](const void* owner) {
        const QVariant value = by.get(owner);
        if (combo->findData(value) < 0) {
            combo->addItem(by.text ? by.text(value) : value.toString(), value);
        }
        combo->setCurrentIndex(combo->findData(value));
    });
    return combo;
}

} // namespace sparkout
