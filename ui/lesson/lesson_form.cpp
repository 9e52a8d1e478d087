// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_form.h"

#include "core/project/member.h"
#include "core/project/operation.h"
#include "core/project/project.h"
#include "core/project/validate.h"
#include "ui/form/field_editor.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_draft.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int sectionsFrom = 1000; ///< in the list of places, after the zones

/// Whether it has values of an input.
bool isValue(const StructInfo& info) {
    return &info == &tableOf<InputValue>() || &info == &tableOf<VariedInput>();
}

/// Whether the field names an input, which decides what widgets its values have.
bool isInput(const Field& field) {
    return &field == tableOf<InputValue>().find("path")
           || &field == tableOf<VariedInput>().find("path");
}

/// Whether the number is that of a surface or step of the lesson, chosen by its name.
bool isNumbered(const Field& field) {
    return (std::string_view(field.key) == "surface" && field.kind == Kind::integer)
           || &field == tableOf<FigureBound>().find("step");
}

QString labelWithUnit(const QString& label, const char* unit) {
    return *unit ? label + QStringLiteral(", ") + unitText(unit) : label;
}

/// Another input has other values: it begins with that of the project.
void beginValues(const StructInfo& info, void* owner, const Project& project) {
    if (&info == &tableOf<InputValue>()) {
        auto& value = *static_cast<InputValue*>(owner);
        value = valueIn(project, value.path);
        return;
    }
    auto& input = *static_cast<VariedInput*>(owner);
    input = variedAs({input.path, {}, {}, {}, {}, {}}, variedBy(input), project);
}

/// The hint of the row speaks of the file.
QWidget* withoutHint(QWidget* widget) {
    widget->setToolTip({});
    widget->setAccessibleDescription({});
    return widget;
}

int linesOfText(std::string_view key) {
    constexpr int few = 3, many = 9;
    return key == "title" ? 2 : key == "theory" ? many : few;
}

} // namespace

LessonForm::LessonForm(LessonDraft& draft, Subject subject, QWidget* parent)
    : StructForm(draft, std::move(subject), parent), m_draft(draft) {
    build();
}

std::string LessonForm::decisiveValue(const Leaf& leaf) const {
    return isInput(*leaf.field)      ? leaf.field->as<std::string>(leaf.owner)
           : isNumbered(*leaf.field) ? std::to_string(leaf.field->as<int>(leaf.owner))
           : leaf.field->kind != Kind::optionalNumberList                   ? std::string()
           : leaf.field->as<std::optional<std::vector<double>>>(leaf.owner) ? "given"
                                                                            : "";
}

// --- structs in their own way -------------------------------------------------------------------

void LessonForm::addStruct(QFormLayout& form, const Subject& subject) {
    if (&subject.table == &tableOf<Goal>()) {
        addGoal(form, subject);
    } else if (&subject.table == &tableOf<VariedInput>()) {
        addVaried(form, subject);
    } else {
        StructForm::addStruct(form, subject);
    }
}

void LessonForm::addRow(QFormLayout& form, const Row& row) {
    if (row.field.nested == &tableOf<Bilingual>()) {
        addTexts(form, row);
    } else {
        StructForm::addRow(form, row);
    }
}

/// One of the kinds, with what it asks for.
void LessonForm::addGoal(QFormLayout& form, const Subject& subject) {
    const auto kinds = tableOf<Goal>().fields;
    const Row row = rowOf(subject, kinds.front());
    auto* kind = new StillComboBox;
    for (const Field& field : kinds) {
        kind->addItem(inputText(field.label));
    }
    const auto now = static_cast<std::size_t>(static_cast<const Goal*>(ownerOf(row))->kind());
    kind->setCurrentIndex(static_cast<int>(now));
    kind->setObjectName(QString::fromStdString(subject.path + "/kind"));
    kind->setAccessibleName(tr("Kind of goal"));
    form.addRow(tr("Kind of goal"), kind);
    auto* about = new QLabel(inputText(kinds[now].hint));
    about->setWordWrap(true);
    form.addRow(about);
    connect(kind, &QComboBox::activated, this, [this, row, kinds](int index) {
        change(row, [&](void* owner) {
            auto& goal = *static_cast<Goal*>(owner);
            const auto figure = goal.asked() ? std::optional(*goal.asked()) : std::nullopt;
            const Field& field = kinds[static_cast<std::size_t>(index)];
            goal = Goal();
            field.object(&goal, true);
            if (goal.asked() && figure) { // keeps the figure for the new kind of goal
                const_cast<Figure&>(*goal.asked()) = *figure;
            }
            addNeeded(*field.nested, field.object(&goal, false));
        });
    });
    addStruct(form, {*kinds[now].nested, subject.path + '/' + kinds[now].key});
}

/// Over a range, a list or sets, with the values of this way alone.
void LessonForm::addVaried(QFormLayout& form, const Subject& subject) {
    const Row path = rowOf(subject, "path");
    auto* combo = new StillComboBox;
    combo->addItems({tr("a range in steps"), tr("a list of values"), tr("named sets of values")});
    const VariedBy by = variedBy(*static_cast<const VariedInput*>(ownerOf(path)));
    combo->setCurrentIndex(static_cast<int>(by));
    combo->setObjectName(QString::fromStdString(subject.path + "/by"));
    combo->setAccessibleName(tr("Varied over"));
    form.addRow(tr("Varied over"), combo);
    connect(combo, &QComboBox::activated, this, [this, path](int index) {
        change(path, [&](void* owner) {
            auto& input = *static_cast<VariedInput*>(owner);
            if (const auto chosen = static_cast<VariedBy>(index); chosen != variedBy(input)) {
                input = variedAs(input, chosen, m_draft.projectAt(path.path));
            }
        });
    });
    if (by == VariedBy::sets) {
        addRow(form, rowOf(subject, "sets"));
        return;
    }
    addRow(form, path);
    if (by == VariedBy::list) {
        addRow(form, rowOf(subject, "list"));
        return;
    }
    auto* line = new QHBoxLayout;
    for (const char* key : {"from", "to", "step"}) {
        const Row row = rowOf(subject, key);
        if (line->count() > 0) {
            line->addWidget(new QLabel(labelOf(row)));
        }
        line->addWidget(make(row), 1);
    }
    form.addRow(labelOf(rowOf(subject, "from")), line);
}

/// Both languages side by side.
void LessonForm::addTexts(QFormLayout& form, const Row& row) {
    auto* head = new QLabel(labelOf(row));
    head->setToolTip(inputText(row.field.hint));
    form.addRow(head);
    auto* both = new QHBoxLayout;
    for (const Field& language : tableOf<Bilingual>().fields) {
        const Row text = rowOf({tableOf<Bilingual>(), row.path}, language);
        auto* box = static_cast<QPlainTextEdit*>(
            adopt(text, std::make_unique<NotesEditor>(text.path, language, model(), nullptr)));
        box->setAccessibleName(
            QStringLiteral("%1, %2").arg(labelOf(row), inputText(language.label)));
        box->setPlaceholderText(inputText(language.label));
        box->setUndoRedoEnabled(false);
        const int frame = 2 * (metrics::gap + box->frameWidth());
        const int height = linesOfText(row.field.key) * box->fontMetrics().lineSpacing() + frame;
        box->setMinimumHeight(height);
        box->setMaximumHeight(2 * height);
        both->addWidget(box);
    }
    form.addRow(both);
}

// --- lists --------------------------------------------------------------------------------------

void LessonForm::addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count) {
    if (row.field.nested != &tableOf<InputValue>()) {
        StructForm::addItem(form, row, index, count);
        return;
    }
    const Subject item{tableOf<InputValue>(), row.path + '/' + std::to_string(index)};
    auto* line = new QHBoxLayout; // input and value in one
    line->addWidget(make(rowOf(item, "path")), 3);
    line->addWidget(makeValue(item), 2);
    addItemButtons(*line, row, index, count);
    form.addRow(line);
}

/// Levels of an input that is varied, and the variants that all of them make.
void LessonForm::addBeside(QHBoxLayout& line, const Row& row, std::optional<std::size_t> item) {
    if (row.field.nested != &tableOf<VariedInput>()) {
        return;
    }
    auto* label = new QLabel;
    label->setObjectName(QString::fromStdString(
        row.path + (item ? '/' + std::to_string(*item) + "/levels" : "/count")));
    line.addWidget(label);
    showBy(row, [label, item](const void* owner) {
        const auto& rules = *static_cast<const VariantRules*>(owner);
        if (!item) {
            label->setText(tr("Total variants: %1").arg(printedNumber(variantCount(rules))));
        } else if (*item < rules.inputs.size()) {
            const VariedInput& input = rules.inputs[*item];
            label->setText(tr("Levels: %1")
                               .arg(printedNumber(input.alternatives() == 1 ? input.levels() : 0)));
        }
    });
}

/// A set of values is begun like the one before it.
void LessonForm::fillNewItem(const Field& list, void* owner) const {
    if (const std::size_t count = list.size(owner);
        list.nested == &tableOf<ValueSet>() && count > 1) {
        auto& sets = list.as<std::vector<ValueSet>>(owner);
        sets.back().values = sets[count - 2].values;
    }
    StructForm::fillNewItem(list, owner);
}

/// Without any set it is no varied input.
std::size_t LessonForm::leastItems(const Field& list) const {
    return list.nested == &tableOf<ValueSet>() ? 1 : 0;
}

// --- values -------------------------------------------------------------------------------------

QWidget* LessonForm::make(const Row& row) {
    if (isNumbered(row.field)) {
        const std::vector<Option> numbered = numberedFor(row);
        const bool isChosen = numbered.size() > 1 || row.field.as<int>(ownerOf(row)) != 1;
        return isChosen ? choiceOf(
                   row, {[numbered] { return numbered; },
                         [&of = row.field](const void* owner) { return of.as<int>(owner); },
                         [&of = row.field](void* owner, const QVariant& chosen) {
                             of.as<int>(owner) = chosen.toInt();
                         }})
                        : nullptr;
    }
    if (row.field.kind == Kind::countOrWord) {
        return placeOf(row);
    }
    if (const std::vector<Option> names = namesOf(row.field); !names.empty()) {
        ChoiceEditor::Choosing named = ChoiceEditor::choicesOf(row.field);
        named.options = [names] { return names; };
        return choiceOf(row, std::move(named));
    }
    const std::vector<Option> options = optionsFor(row);
    return options.empty() ? StructForm::make(row) : optionsOf(row, options);
}

/// Figures have their units, steps the names of a report.
std::vector<LessonForm::Option> LessonForm::namesOf(const Field& field) {
    std::vector<Option> names;
    const auto add = [&names](const QString& text) {
        names.push_back({text, static_cast<int>(names.size())});
    };
    for (std::size_t i = 0; i < field.choices.size(); ++i) {
        if (field.choices.data() == choicesOf<FigureName>().data()) {
            const FigureRow& row = sparkout::rowOf(static_cast<FigureName>(i));
            add(labelWithUnit(QCoreApplication::translate("Figure", row.choice.label), row.unit));
        } else if (field.choices.data() == choicesOf<Step>().data()) {
            add(i > 0 ? Names::step(static_cast<Step>(i)) : choiceText(field.choices[i].label));
        }
    }
    return names;
}

std::optional<NumberInput> LessonForm::inputOf(const Row& row) const {
    const void* const owner = isValue(row.table) ? ownerOf(row) : nullptr;
    if (!owner) {
        return std::nullopt;
    }
    return numberInput(m_draft.projectAt(row.path), row.table.find("path")->as<std::string>(owner));
}

/// A value of an input is one that the input takes, in its unit.
NumberSpec LessonForm::specOf(const Row& row) const {
    NumberSpec spec = StructForm::specOf(row);
    if (!isValue(row.table) || isInput(row.field)) {
        return spec;
    }
    spec.optional = false;
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

/// The hint states the range of the input.
Field LessonForm::described(const Row& row) const {
    Field field = StructForm::described(row);
    if (isValue(row.table) && !isInput(row.field)) {
        const NumberSpec spec = specOf(row);
        field.hard = spec.scale.shown(spec.hard);
        field.unit = spec.unit;
        field.nullMeaning = "";
    }
    return field;
}

std::vector<LessonForm::Option> LessonForm::optionsFor(const Row& row) const {
    std::vector<Option> options;
    if (isInput(row.field)) {
        const bool isVaried = &row.table == &tableOf<VariedInput>();
        const Project& project = m_draft.projectAt(row.path);
        for (const std::string& path :
             inputsToPut(project, isVaried ? Puts::numbers : Puts::anything)) {
            const Field* const field = nearestField(project, path);
            QString text = labelWithUnit(inputLocation(path), field ? field->unit : "");
            options.push_back({std::move(text), QString::fromStdString(path)});
        }
    } else if (&row.table == &tableOf<ShownMoment>() && std::string_view(row.field.key) == "view") {
        options.push_back({tr("the current one"), QString()});
        for (const Choice& choice : choicesOf<Hideable>()) {
            if (viewNamed(choice.key)) {
                options.push_back({choiceText(choice.label), QString::fromLatin1(choice.key)});
            }
        }
    }
    return options;
}

/// One of known texts, or the one that is there.
QWidget* LessonForm::optionsOf(const Row& row, const std::vector<Option>& options) {
    return withoutHint(choiceOf(
        row, {[options] { return options; },
              [&of = row.field](const void* owner) {
                  return QString::fromStdString(of.as<std::string>(owner));
              },
              [this, row](void* owner, const QVariant& chosen) {
                  auto& text = row.field.as<std::string>(owner);
                  if (std::string value = chosen.toString().toStdString(); value != text) {
                      text = std::move(value);
                      if (isInput(row.field)) {
                          beginValues(row.table, owner, m_draft.projectAt(row.path));
                      }
                  }
              },
              [](const QVariant& path) { return inputLocation(path.toString().toStdString()); }}));
}

/// A zone, a section, or none.
QWidget* LessonForm::placeOf(const Row& row) {
    const auto textOf = [](const QVariant& value) {
        const int place = value.toInt();
        return place < sectionsFrom
                   ? zoneText(PlaceName::words()[static_cast<std::size_t>(place)].key)
                   : QCoreApplication::translate("Zone", "Section %1")
                         .arg(place - sectionsFrom + 1);
    };
    const Project& project = m_draft.projectAt(row.path);
    std::vector<Option> options{{inputText(row.field.nullMeaning), -1}};
    const int places = static_cast<int>(placeCount(project));
    for (int i = 0; i < places; ++i) {
        const int place = project.operation->travels ? i : sectionsFrom + i;
        options.push_back({textOf(place), place});
    }
    return withoutHint(
        choiceOf(row, {[options] { return options; },
                       [&of = row.field](const void* owner) {
                           const int* const number = of.wholeNumber(owner);
                           return number ? sectionsFrom + *number : of.getChoice(owner);
                       },
                       [&of = row.field](void* owner, const QVariant& chosen) {
                           if (const int place = chosen.toInt(); place < sectionsFrom) {
                               of.setChoice(owner, place);
                           } else {
                               of.setNumber(owner, place - sectionsFrom);
                           }
                       },
                       textOf})); // of another kind of operation
}

/// The surfaces or the steps by their names.
std::vector<LessonForm::Option> LessonForm::numberedFor(const Row& row) const {
    std::vector<Option> numbered;
    const Lesson& lesson = m_draft.lesson();
    const auto add = [&numbered](const QString& text) {
        const int number = static_cast<int>(numbered.size()) + 1;
        numbered.push_back({QStringLiteral("%1. %2").arg(number).arg(text), number});
    };
    if (&row.table == &tableOf<FigureBound>()) {
        for (const LessonStep& step : lesson.steps) {
            add(inputText(
                tableOf<Goal>().fields[static_cast<std::size_t>(step.goal.kind())].label));
        }
    } else {
        for (const GroundSurface& surface : lesson.base.surfaces) {
            add(QString::fromStdString(surface.name));
        }
    }
    return numbered;
}

/// The value of an input, as the input takes it: a number, a choice or a text.
QWidget* LessonForm::makeValue(const Subject& subject) {
    const Row number = rowOf(subject, "number"), text = rowOf(subject, "text");
    const auto& value = *static_cast<const InputValue*>(ownerOf(number));
    const ConstMember member = findMember(m_draft.projectAt(subject.path), value.path);
    if (!value.number && member && member.field->kind == Kind::choice) {
        std::vector<Option> options;
        for (const Choice& choice : member.field->choices) {
            options.push_back({choiceText(choice.label), QString::fromLatin1(choice.key)});
        }
        return optionsOf(text, options);
    }
    return StructForm::make(value.number || inputOf(number) ? number : text);
}

namespace {

constexpr double mostLevelsListed = 100; ///< for a range converted to a list or sets

std::vector<double> levelNumbers(const VariedInput& input) {
    std::vector<double> numbers;
    const double count = std::min(input.alternatives() == 1 ? input.levels() : 0, mostLevelsListed);
    for (std::size_t level = 0; static_cast<double>(level) < count; ++level) {
        const std::vector<InputValue> values = input.valuesAt(level);
        if (!values.empty() && values.front().number) {
            numbers.push_back(*values.front().number);
        }
    }
    return numbers;
}

} // namespace

std::vector<std::string> formInputs(const Project& project) {
    std::vector<std::string> paths;
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (leaf.field->page == Page::none) {
            continue;
        }
        for (std::size_t end = 1; (end = leaf.path.find('/', end)) != std::string::npos; ++end) {
            std::string above = leaf.path.substr(0, end);
            if (std::ranges::find(paths, above) == paths.end()) {
                paths.push_back(std::move(above));
            }
        }
        if (std::ranges::find(paths, leaf.path) == paths.end()) {
            paths.push_back(leaf.path);
        }
    }
    return paths;
}

std::vector<std::string> inputsToPut(const Project& project, Puts puts) {
    std::vector<std::string> paths;
    const std::vector<NumberInput> numbers = numberInputs(project);
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (leaf.field->page == Page::none || !leaf.owner) {
            continue;
        }
        if (leaf.field->kind == Kind::text || leaf.field->kind == Kind::choice) {
            if (puts == Puts::anything) {
                paths.push_back(leaf.path);
            }
            continue;
        }
        for (const NumberInput& number : numbers) { // a compliance has one for each place
            if (number.path == leaf.path || number.path.starts_with(leaf.path + '/')) {
                paths.push_back(number.path);
            }
        }
    }
    return paths;
}

InputValue valueIn(const Project& project, const std::string& path) {
    if (const auto input = numberInput(project, path)) {
        return {path, input->value.value_or(0), {}};
    }
    const ConstMember member = findMember(project, path);
    InputValue value{path, {}, {}};
    if (member && member.field->kind == Kind::text) {
        value.text = member.field->as<std::string>(member.owner);
    } else if (member && member.field->kind == Kind::choice) {
        const int index = member.field->getChoice(member.owner);
        value.text = member.field->choices[static_cast<std::size_t>(std::max(index, 0))].key;
    }
    return value;
}

VariedBy variedBy(const VariedInput& input) {
    return !input.sets.empty() ? VariedBy::sets : input.list ? VariedBy::list : VariedBy::range;
}

VariedInput variedAs(const VariedInput& input, VariedBy by, const Project& project) {
    VariedInput made;
    made.path = !input.sets.empty() && !input.sets.front().values.empty()
                    ? input.sets.front().values.front().path
                    : input.path;
    std::vector<double> numbers = levelNumbers(input);
    const InputValue now = valueIn(project, made.path);
    if (numbers.empty() && now.number) {
        numbers.push_back(*now.number);
    }
    switch (by) {
    case VariedBy::range:
        if (!numbers.empty()) {
            const auto [least, most] = std::ranges::minmax(numbers);
            made.from = least;
            made.to = most;
        }
        break;
    case VariedBy::list: made.list = std::move(numbers); break;
    case VariedBy::sets:
        for (const double number : numbers) {
            made.sets.push_back({numberText(number), {{made.path, number, {}}}});
        }
        if (made.sets.empty()) {
            made.sets.push_back({{}, {now}});
        }
        made.path.clear();
        break;
    }
    return made;
}

double variantCount(const VariantRules& rules) {
    double count = rules.inputs.empty() ? 0 : 1;
    for (const VariedInput& input : rules.inputs) {
        count *= input.alternatives() == 1 ? input.levels() : 0;
    }
    return count;
}

} // namespace sparkout
