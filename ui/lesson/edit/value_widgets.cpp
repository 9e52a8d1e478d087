// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/value_widgets.h"

#include "core/project/member.h"
#include "core/project/operation.h"
#include "core/project/project.h"
#include "ui/fields/number_field.h"
#include "ui/kit/search_combo.h"
#include "ui/lesson/edit/lesson_draft.h"
#include "ui/lesson/edit/lesson_inputs.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int fewChoices = 12;     ///< without a search
constexpr int sectionsFrom = 1000; ///< in the list of places, after the zones

QString choiceName(const Field& field, std::size_t index) {
    if (field.choices.data() == choicesOf<FigureName>().data()) {
        const FigureRow& row = rowOf(static_cast<FigureName>(index));
        const QString name = QCoreApplication::translate("Figure", row.choice.label);
        return *row.unit ? name + QStringLiteral(", ") + unitText(row.unit) : name;
    }
    if (field.choices.data() == choicesOf<Step>().data() && index > 0) {
        return Names::step(static_cast<Step>(index));
    }
    return choiceText(field.choices[index].label);
}

QString labelWithUnit(const QString& label, const char* unit) {
    return *unit ? label + QStringLiteral(", ") + unitText(unit) : label;
}

/// Another input has other values: begins with that of the project.
void beginValues(const StructInfo& info, void* owner, const Project& project) {
    if (&info == &tableOf<InputValue>()) {
        auto& value = *static_cast<InputValue*>(owner);
        value = valueIn(project, value.path);
        return;
    }
    auto& input = *static_cast<VariedInput*>(owner);
    input = variedAs({input.path, {}, {}, {}, {}, {}}, variedBy(input), project);
}

constexpr const char* refusedNumbers = "refusedNumbers"; ///< property: why they were not taken

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

bool ValueWidgets::isNumbered(const StructInfo& info, const Field& field) {
    const std::string_view key = field.key;
    return (key == "surface" && field.kind == Kind::integer)
           || (&info == &tableOf<FigureBound>() && key == "step");
}

bool ValueWidgets::isInput(const StructInfo& info, const Field& field) {
    return (&info == &tableOf<InputValue>() || &info == &tableOf<VariedInput>())
           && std::string_view(field.key) == "path";
}

ValueWidgets::ValueWidgets(LessonDraft& draft, QObject* parent) : QObject(parent), m_draft(draft) {}

void ValueWidgets::refresh() {
    for (const auto& show : m_shows) {
        show();
    }
}

void ValueWidgets::watch(QWidget& widget) {
    widget.installEventFilter(this);
}

QWidget* ValueWidgets::make(const Row& row) {
    if (isNumbered(row.table, row.field)) {
        const std::vector<Numbered> numbered = numberedFor(row);
        const bool isChosen = numbered.size() > 1 || row.field.as<int>(ownerOf(row.reach)) != 1;
        return isChosen ? numberedOf(row, numbered) : nullptr;
    }
    switch (row.field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger: return numberOf(row);
    case Kind::numberList:
    case Kind::optionalNumberList: return numbersOf(row);
    case Kind::boolean: return tickOf(row);
    case Kind::text: {
        const std::vector<Option> options = optionsFor(row);
        return options.empty() ? lineOf(row) : optionsOf(row, options);
    }
    case Kind::choice: return choiceOf(row);
    case Kind::countOrWord: return placeOf(row);
    default: return nullptr; // not a value, or not used in lessons
    }
}

QStringList ValueWidgets::refusals(const QWidget& within) {
    QStringList lines;
    for (const NumberField* field : within.findChildren<NumberField*>()) {
        if (field->refused()) {
            lines += QStringLiteral("%1: %2").arg(
                LessonDraft::location(field->objectName().toStdString()), field->refusal());
        }
    }
    for (const QLineEdit* line : within.findChildren<QLineEdit*>()) {
        if (const QString why = line->property(refusedNumbers).toString(); !why.isEmpty()) {
            lines += QStringLiteral("%1: %2").arg(
                LessonDraft::location(line->objectName().toStdString()), why);
        }
    }
    return lines;
}

const void* ValueWidgets::ownerOf(const Reach& reach) const {
    return reach(const_cast<Lesson&>(m_draft.lesson())); // only read: it creates nothing
}

void ValueWidgets::change(const Row& row, const std::function<void(void* owner)>& set,
                          bool merges) {
    m_draft.edit(merges ? row.path : std::string(), [&](Lesson& lesson) {
        if (void* const owner = row.reach(lesson)) {
            set(owner);
        }
    });
}

void ValueWidgets::name(QWidget& widget, const Row& row, const std::string& more) {
    widget.setObjectName(QString::fromStdString(row.path + more));
    widget.setAccessibleName(labelOf(row));
    widget.setToolTip(inputText(row.field.hint));
    watch(widget);
}

void ValueWidgets::showBy(const Row& row, std::function<void(const void* owner)> show) {
    m_shows.emplace_back([this, reach = row.reach, act = std::move(show)] {
        if (const void* const owner = ownerOf(reach)) {
            act(owner);
        }
    });
    m_shows.back()();
}

bool ValueWidgets::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::Wheel && !qobject_cast<QPlainTextEdit*>(watched)) {
        event->ignore(); // scrolls the page instead of changing the choice
        return true;
    }
    return QObject::eventFilter(watched, event);
}

std::optional<NumberInput> ValueWidgets::inputOf(const Row& row) const {
    const void* const owner = ownerOf(row.reach);
    const std::string* path = nullptr;
    if (owner && &row.table == &tableOf<VariedInput>()) {
        path = &static_cast<const VariedInput*>(owner)->path;
    } else if (owner && &row.table == &tableOf<InputValue>()) {
        path = &static_cast<const InputValue*>(owner)->path;
    }
    return path ? numberInput(m_draft.projectAt(row.path), *path) : std::nullopt;
}

/// The range and unit of an input's value are those of the input.
NumberSpec ValueWidgets::specOf(const Row& row) const {
    NumberSpec spec = NumberSpec::of(row.field);
    if (&row.table == &tableOf<VariedInput>() || &row.table == &tableOf<InputValue>()) {
        spec.optional = false;
    }
    if (const auto input = inputOf(row)) {
        spec.unit = input->field->unit;
        spec.integer = input->integer;
        spec.scale = ShownScale::ofInput(*input->field);
        if (std::string_view(row.field.key) == "step") {
            spec.scale.shift = 0; // a difference
        } else {
            spec.hard = input->allowed;
        }
    }
    return spec;
}

QString ValueWidgets::labelOf(const Row& row) const {
    return labelWithUnit(inputText(row.field.label),
                         std::string_view(row.field.key) == "path" ? "" : specOf(row).unit);
}

QWidget* ValueWidgets::numberOf(const Row& row) {
    auto* field = new NumberField(specOf(row));
    name(*field, row);
    field->setHint(inputText(row.field.hint));
    connect(field, &NumberField::valueEdited, this, [this, row, field] {
        const std::optional<double> value = field->value();
        change(row, [&](void* owner) {
            switch (row.field.kind) {
            case Kind::number: row.field.as<double>(owner) = value.value_or(0); break;
            case Kind::optionalNumber: row.field.as<std::optional<double>>(owner) = value; break;
            case Kind::integer:
                row.field.as<int>(owner) = static_cast<int>(value.value_or(0));
                break;
            default:
                row.field.as<std::optional<int>>(owner) =
                    value ? std::optional(static_cast<int>(*value)) : std::nullopt;
            }
        });
    });
    showBy(row, [field, &of = row.field](const void* owner) {
        std::optional<double> value;
        if (of.kind == Kind::number) {
            value = of.as<double>(owner);
        } else if (of.kind == Kind::optionalNumber) {
            value = of.as<std::optional<double>>(owner);
        } else if (const int* number = of.wholeNumber(owner)) {
            value = *number;
        }
        field->setValue(value);
    });
    return field;
}

/// Numbers on one line, separated by spaces; an invalid text stays without being applied.
QWidget* ValueWidgets::numbersOf(const Row& row) {
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

QWidget* ValueWidgets::tickOf(const Row& row) {
    auto* box = new QCheckBox(labelOf(row));
    name(*box, row);
    connect(box, &QCheckBox::clicked, this, [this, row](bool on) {
        change(row, [&](void* owner) { row.field.as<bool>(owner) = on; });
    });
    showBy(row, [box, &of = row.field](const void* owner) { box->setChecked(of.as<bool>(owner)); });
    return box;
}

QWidget* ValueWidgets::lineOf(const Row& row) {
    auto* line = new QLineEdit;
    name(*line, row);
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

QWidget* ValueWidgets::choiceOf(const Row& row) {
    const std::size_t count = row.field.choices.size();
    auto* combo = count > fewChoices ? new SearchCombo : new QComboBox;
    name(*combo, row);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (std::size_t i = 0; i < count; ++i) {
        combo->addItem(choiceName(row.field, i));
    }
    connect(combo, &QComboBox::activated, this, [this, row](int index) {
        change(row, [&](void* owner) { row.field.setChoice(owner, index); });
    });
    showBy(row, [combo, &of = row.field](const void* owner) {
        combo->setCurrentIndex(of.getChoice(owner));
    });
    return combo;
}

std::vector<ValueWidgets::Option> ValueWidgets::optionsFor(const Row& row) const {
    std::vector<Option> options;
    const std::string_view key = row.field.key;
    if (isInput(row.table, row.field)) {
        const bool isVaried = &row.table == &tableOf<VariedInput>();
        const Project& project = m_draft.projectAt(row.path);
        for (std::string& path : inputsToPut(project, isVaried ? Puts::numbers : Puts::anything)) {
            const Field* const field = nearestField(project, path);
            QString text = labelWithUnit(inputLocation(path), field ? field->unit : "");
            options.push_back({std::move(text), std::move(path)});
        }
    } else if (&row.table == &tableOf<ShownMoment>() && key == "view") {
        options.push_back({tr("the one in front"), {}});
        for (const Choice& choice : choicesOf<Hideable>()) {
            if (viewNamed(choice.key)) {
                options.push_back({choiceText(choice.label), choice.key});
            }
        }
    }
    return options;
}

/// A choice of known texts, and the current one.
QWidget* ValueWidgets::optionsOf(const Row& row, const std::vector<Option>& options) {
    auto* combo = options.size() > fewChoices ? new SearchCombo : new QComboBox;
    name(*combo, row);
    combo->setToolTip({}); // it describes the file
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Option& option : options) {
        combo->addItem(option.text, QString::fromStdString(option.value));
    }
    connect(combo, &QComboBox::activated, this, [this, row, combo](int index) {
        const std::string chosen = combo->itemData(index).toString().toStdString();
        const Project& project = m_draft.projectAt(row.path);
        change(row, [&](void* owner) {
            if (auto& text = row.field.as<std::string>(owner); text != chosen) {
                text = chosen;
                if (isInput(row.table, row.field)) {
                    beginValues(row.table, owner, project);
                }
            }
        });
    });
    showBy(row, [combo, &of = row.field](const void* owner) {
        const QString value = QString::fromStdString(of.as<std::string>(owner));
        if (combo->findData(value) < 0) {
            combo->addItem(inputLocation(value.toStdString()), value);
        }
        combo->setCurrentIndex(combo->findData(value));
    });
    return combo;
}

/// A zone, a section, or none.
QWidget* ValueWidgets::placeOf(const Row& row) {
    auto* combo = new QComboBox;
    name(*combo, row);
    combo->setToolTip({});
    const Project& project = m_draft.projectAt(row.path);
    combo->addItem(inputText(row.field.nullMeaning), -1);
    const auto add = [combo](int chosen) {
        combo->addItem(
            chosen < sectionsFrom
                ? zoneText(PlaceName::words()[static_cast<std::size_t>(chosen)].key)
                : QCoreApplication::translate("Zone", "Section %1").arg(chosen - sectionsFrom + 1),
            chosen);
    };
    const int places = static_cast<int>(placeCount(project));
    for (int i = 0; i < places; ++i) {
        add(project.operation->hasZones ? i : sectionsFrom + i);
    }
    connect(combo, &QComboBox::activated, this, [this, row, combo](int index) {
        const int chosen = combo->itemData(index).toInt();
        change(row, [&](void* owner) {
            if (chosen < sectionsFrom) {
                row.field.setChoice(owner, chosen);
            } else {
                row.field.setNumber(owner, chosen - sectionsFrom);
            }
        });
    });
    showBy(row, [combo, add, &of = row.field](const void* owner) {
        const int* const number = of.wholeNumber(owner);
        const int chosen = number ? sectionsFrom + *number : of.getChoice(owner);
        if (combo->findData(chosen) < 0) { // of another kind of operation
            add(chosen);
        }
        combo->setCurrentIndex(combo->findData(chosen));
    });
    return combo;
}

std::vector<ValueWidgets::Numbered> ValueWidgets::numberedFor(const Row& row) const {
    std::vector<Numbered> numbered;
    const Lesson& lesson = m_draft.lesson();
    const auto add = [&numbered](const QString& text) {
        const int number = static_cast<int>(numbered.size()) + 1;
        numbered.push_back({QStringLiteral("%1. %2").arg(number).arg(text), number});
    };
    if (&row.table == &tableOf<FigureBound>()) {
        for (const LessonStep& step : lesson.steps) {
            const auto kind = static_cast<std::size_t>(step.goal.kind());
            add(inputText(tableOf<Goal>().fields[kind].label));
        }
    } else {
        for (const GroundSurface& surface : lesson.base.surfaces) {
            add(QString::fromStdString(surface.name));
        }
    }
    return numbered;
}

/// A surface or a step, or the number of one that is not there.
QWidget* ValueWidgets::numberedOf(const Row& row, const std::vector<Numbered>& numbered) {
    auto* combo = new QComboBox;
    name(*combo, row);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Numbered& each : numbered) {
        combo->addItem(each.text, each.number);
    }
    connect(combo, &QComboBox::activated, this, [this, row, combo](int index) {
        change(row,
               [&](void* owner) { row.field.as<int>(owner) = combo->itemData(index).toInt(); });
    });
    showBy(row, [combo, &of = row.field](const void* owner) {
        const int number = of.as<int>(owner);
        if (combo->findData(number) < 0) {
            combo->addItem(QString::number(number), number);
        }
        combo->setCurrentIndex(combo->findData(number));
    });
    return combo;
}

QWidget* ValueWidgets::makeValue(const StructInfo& info, const std::string& path,
                                 const Reach& reach) {
    const auto& value = *static_cast<const InputValue*>(ownerOf(reach));
    const Row number{info, *info.find("number"), path + "/number", reach};
    const Row text{info, *info.find("text"), path + "/text", reach};
    const ConstMember member = findMember(m_draft.projectAt(path), value.path);
    if (!value.number && member && member.field->kind == Kind::choice) {
        std::vector<Option> options;
        for (const Choice& choice : member.field->choices) {
            options.push_back({choiceText(choice.label), choice.key});
        }
        return optionsOf(text, options);
    }
    return value.number || inputOf(number) ? numberOf(number) : lineOf(text);
}

} // namespace sparkout
