// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/struct_form.h"

#include "core/project/leaves.h"
#include "core/project/operation.h"
#include "core/project/project.h"
#include "ui/fields/number_field.h"
#include "ui/kit/metrics.h"
#include "ui/kit/search_combo.h"
#include "ui/lesson/edit/lesson_draft.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int fewChoices = 12;     ///< without a search
constexpr int sectionsFrom = 1000; ///< in the list of places, after the zones

/// Which optional objects are there and how many items lists have.
std::string shapeOf(const StructInfo& info, const void* owner) {
    std::string shape;
    for (const Field& field : info.fields) {
        if (field.kind == Kind::optionalObject || field.kind == Kind::object) {
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

/// The list of objects as it is; the struct has no other way to take one out of its middle.
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
}

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

QString labelOf(const Field& field) {
    const QString label = inputText(field.label);
    return *field.unit ? label + QStringLiteral(", ") + unitText(field.unit) : label;
}

int linesOfText(std::string_view key) {
    constexpr int few = 3, many = 9;
    return key == "title" ? 2 : key == "theory" ? many : few;
}

/// With the spaces that do not break, which toPlainText() makes plain ones.
QString typedIn(const QPlainTextEdit& box) {
    return box.document()->toRawText().replace(QChar::ParagraphSeparator, u'\n');
}

constexpr const char* refusedNumbers = "refusedNumbers"; ///< property: why they were not taken

std::optional<std::vector<double>> readNumbers(const QString& text) {
    std::vector<double> numbers;
    for (const QString& part :
         text.split(QRegularExpression(QStringLiteral("[;\\s]+")), Qt::SkipEmptyParts)) {
        bool isRead = false;
        numbers.push_back(QString(part).replace(u',', u'.').toDouble(&isRead));
        if (!isRead) {
            return std::nullopt;
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

StructForm::StructForm(LessonDraft& draft, Subject subject, QWidget* parent)
    : QWidget(parent), m_draft(draft), m_subject(std::move(subject)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    build();
    connect(&m_draft, &LessonDraft::changed, this, &StructForm::refresh);
}

QStringList StructForm::refusals(const QWidget& within) {
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

// --- the form as a whole ------------------------------------------------------------------------

const void* StructForm::ownerOf(const Reach& reach) const {
    return reach(const_cast<Lesson&>(m_draft.lesson())); // to be read: it creates nothing
}

void StructForm::build() {
    const void* const owner = ownerOf(m_subject.reach);
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
    const void* const owner = ownerOf(m_subject.reach);
    if (!owner || !m_body) {
        return; // the page goes with it
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
    for (const auto& show : m_shows) {
        show();
    }
}

void StructForm::change(const Row& row, const std::function<void(void* owner)>& set, bool merges) {
    m_draft.edit(merges ? row.path : std::string(), [&](Lesson& lesson) {
        if (void* const owner = row.reach(lesson)) {
            set(owner);
        }
    });
}

void StructForm::name(QWidget& widget, const Row& row, const std::string& more) const {
    widget.setObjectName(QString::fromStdString(row.path + more));
    widget.setAccessibleName(labelOf(row.field));
    widget.setToolTip(inputText(row.field.hint));
    widget.installEventFilter(const_cast<StructForm*>(this));
}

void StructForm::showBy(const Row& row, std::function<void(const void* owner)> show) {
    m_shows.emplace_back([this, reach = row.reach, act = std::move(show)] {
        if (const void* const owner = ownerOf(reach)) {
            act(owner);
        }
    });
    m_shows.back()();
}

bool StructForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
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

void StructForm::addStruct(QFormLayout& form, const Subject& subject) {
    if (&subject.table == &tableOf<Goal>()) {
        addGoal(form, subject);
        return;
    }
    for (const Field& field : subject.table.fields) {
        if (subject.keys.empty() || std::ranges::count(subject.keys, field.key) > 0) {
            addRow(form, {subject.table, field, subject.path + '/' + field.key, subject.reach});
        }
    }
}

/// One of the kinds, with what it asks for.
void StructForm::addGoal(QFormLayout& form, const Subject& subject) {
    const auto kinds = tableOf<Goal>().fields;
    const Row row{subject.table, kinds.front(), subject.path + "/kind", subject.reach};
    auto* kind = new QComboBox;
    for (const Field& field : kinds) {
        kind->addItem(inputText(field.label));
    }
    const auto now =
        static_cast<std::size_t>(static_cast<const Goal*>(ownerOf(subject.reach))->kind());
    kind->setCurrentIndex(static_cast<int>(now));
    kind->setObjectName(QString::fromStdString(row.path));
    kind->setAccessibleName(tr("Kind of goal"));
    kind->installEventFilter(this);
    form.addRow(tr("Kind of goal"), kind);
    auto* about = new QLabel(inputText(kinds[now].hint));
    about->setWordWrap(true);
    form.addRow(about);
    connect(kind, &QComboBox::activated, this, [this, row, kinds](int index) {
        change(
            row,
            [&](void* owner) {
                auto& goal = *static_cast<Goal*>(owner);
                const auto figure = goal.asked() ? std::optional(*goal.asked()) : std::nullopt;
                goal = Goal();
                kinds[static_cast<std::size_t>(index)].object(&goal, true);
                if (goal.asked() && figure) { // the same one, in another way
                    const_cast<Figure&>(*goal.asked()) = *figure;
                }
                if (goal.choice) {
                    goal.choice->options.resize(2);
                }
            },
            false);
    });
    const Field& given = kinds[now];
    addStruct(form, {*given.nested,
                     subject.path + '/' + given.key,
                     [reach = subject.reach, &given](Lesson& lesson) -> void* {
                         void* const owner = reach(lesson);
                         return owner ? given.object(owner, false) : nullptr;
                     },
                     {},
                     subject.step});
}

void StructForm::addRow(QFormLayout& form, const Row& row) {
    QWidget* widget = nullptr;
    switch (row.field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger: widget = numberOf(row); break;
    case Kind::numberList:
    case Kind::optionalNumberList: widget = numbersOf(row); break;
    case Kind::boolean: form.addRow(QString(), tickOf(row)); return;
    case Kind::text: {
        const std::vector<Option> options = optionsFor(row);
        widget = options.empty() ? lineOf(row) : optionsOf(row, options);
        break;
    }
    case Kind::choice: widget = choiceOf(row); break;
    case Kind::countOrWord: widget = placeOf(row); break;
    case Kind::object:
        if (row.field.nested == &tableOf<Bilingual>()) {
            addTexts(form, row);
        } else {
            addObject(form, row);
        }
        return;
    case Kind::optionalObject: addObject(form, row); return;
    case Kind::objectList: addItems(form, row); return;
    case Kind::compliance:
    case Kind::levels:
    case Kind::numberRows:
    case Kind::samples:
    case Kind::jsonText: return; // no lesson has them
    }
    form.addRow(labelOf(row.field), widget);
}

// --- values -------------------------------------------------------------------------------------

QWidget* StructForm::numberOf(const Row& row) {
    auto* field = new NumberField(NumberSpec::of(row.field));
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

/// Numbers in one line, from blanks apart; a text that is none stays, and is not taken.
QWidget* StructForm::numbersOf(const Row& row) {
    auto* line = new QLineEdit;
    name(*line, row);
    const bool isOptional = row.field.kind == Kind::optionalNumberList;
    connect(line, &QLineEdit::textEdited, this, [this, row, line, isOptional](const QString& text) {
        const auto numbers = readNumbers(text);
        line->setProperty(refusedNumbers,
                          numbers ? QVariant() : tr("numbers with spaces between them"));
        if (numbers) {
            change(row, [&](void* owner) {
                if (isOptional) {
                    row.field.as<std::optional<std::vector<double>>>(owner) = *numbers;
                } else {
                    row.field.as<std::vector<double>>(owner) = *numbers;
                }
            });
        }
    });
    showBy(row, [line, isOptional, &of = row.field](const void* owner) {
        const auto numbers =
            isOptional
                ? of.as<std::optional<std::vector<double>>>(owner).value_or(std::vector<double>())
                : of.as<std::vector<double>>(owner);
        if (readNumbers(line->text()) != numbers) {
            QStringList words;
            for (const double number : numbers) {
                words += printedNumber(number);
            }
            line->setText(words.join(u' '));
        }
    });
    return line;
}

QWidget* StructForm::tickOf(const Row& row) {
    auto* box = new QCheckBox(labelOf(row.field));
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

std::vector<StructForm::Option> StructForm::optionsFor(const Row& row) const {
    std::vector<Option> options;
    const std::string_view key = row.field.key;
    if (&row.table == &tableOf<InputValue>() && key == "path") {
        for (std::string& path : formInputs(m_draft.projectOf(m_subject.step))) {
            QString text = inputLocation(path);
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

/// One of known texts, or the one that is there.
QWidget* StructForm::optionsOf(const Row& row, const std::vector<Option>& options) {
    auto* combo = options.size() > fewChoices ? new SearchCombo : new QComboBox;
    name(*combo, row);
    combo->setToolTip({}); // it speaks of the file
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Option& option : options) {
        combo->addItem(option.text, QString::fromStdString(option.value));
    }
    connect(combo, &QComboBox::activated, this, [this, row, combo](int index) {
        change(row, [&](void* owner) {
            row.field.as<std::string>(owner) = combo->itemData(index).toString().toStdString();
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
QWidget* StructForm::placeOf(const Row& row) {
    auto* combo = new QComboBox;
    name(*combo, row);
    combo->setToolTip({});
    const Project& project = m_draft.projectOf(m_subject.step);
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

// --- texts, objects, lists ----------------------------------------------------------------------

/// Both languages side by side.
void StructForm::addTexts(QFormLayout& form, const Row& row) {
    auto* head = new QLabel(labelOf(row.field));
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
        name(*box, text);
        box->setAccessibleName(
            QStringLiteral("%1, %2").arg(labelOf(row.field), inputText(language.label)));
        box->setPlaceholderText(inputText(language.label));
        box->setTabChangesFocus(true);
        box->setUndoRedoEnabled(false);
        const int frame = 2 * (metrics::gap + box->frameWidth());
        const int height = linesOfText(row.field.key) * box->fontMetrics().lineSpacing() + frame;
        box->setMinimumHeight(height);
        box->setMaximumHeight(2 * height);
        connect(box, &QPlainTextEdit::textChanged, this, [this, text, box] {
            change(text, [&](void* owner) {
                text.field.as<std::string>(owner) = typedIn(*box).toStdString();
            });
        });
        showBy(text, [box, &of = text.field](const void* owner) {
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
    auto* group = new QGroupBox(labelOf(row.field));
    group->setObjectName(QString::fromStdString(row.path));
    group->setToolTip(inputText(row.field.hint));
    auto* inner = new QFormLayout(group);
    inner->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const bool isGiven = row.field.objectIn(ownerOf(row.reach)) != nullptr;
    if (row.field.kind == Kind::optionalObject) {
        group->setCheckable(true);
        group->setChecked(isGiven);
        connect(group, &QGroupBox::clicked, this, [this, row](bool on) {
            change(
                row,
                [&](void* owner) {
                    if (on) {
                        row.field.object(owner, true);
                    } else {
                        row.field.reset(owner);
                    }
                },
                false);
        });
    }
    if (isGiven) {
        addStruct(*inner, {*row.field.nested,
                           row.path,
                           [reach = row.reach, &of = row.field](Lesson& lesson) -> void* {
                               void* const owner = reach(lesson);
                               return owner ? of.object(owner, false) : nullptr;
                           },
                           {},
                           m_subject.step});
    }
    form.addRow(group);
}

void StructForm::addItems(QFormLayout& form, const Row& row) {
    const std::size_t count = row.field.size(ownerOf(row.reach));
    for (std::size_t i = 0; i < count; ++i) {
        addItem(form, row, i, count);
    }
    auto* add = new QPushButton(tr("Add: %1").arg(structText(row.field.nested->name)));
    add->setObjectName(QString::fromStdString(row.path + "/add"));
    add->setAutoDefault(false);
    add->setToolTip(inputText(row.field.hint));
    connect(add, &QPushButton::clicked, this, [this, row, count] {
        change(
            row, [&](void* owner) { row.field.resize(owner, count + 1); }, false);
    });
    auto* line = new QHBoxLayout;
    line->addWidget(add);
    line->addStretch(1);
    form.addRow(line);
}

void StructForm::addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count) {
    const std::string path = row.path + '/' + std::to_string(index);
    const QString title =
        QStringLiteral("%1. %2").arg(index + 1).arg(structText(row.field.nested->name));
    auto* group = new QGroupBox(title);
    auto* inner = new QFormLayout(group);
    inner->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addStruct(*inner, {*row.field.nested,
                       path,
                       [reach = row.reach, &of = row.field, index](Lesson& lesson) -> void* {
                           void* const owner = reach(lesson);
                           return owner && index < of.size(owner) ? of.at(owner, index) : nullptr;
                       },
                       {},
                       m_subject.step});
    auto* line = new QHBoxLayout;
    line->addStretch(1);
    const auto button = [&](const QString& text, const char* key, bool on, const auto& act) {
        auto* made = new QPushButton(text);
        made->setObjectName(QString::fromStdString(path + '/' + key));
        made->setAccessibleName(QStringLiteral("%1: %2").arg(title, text));
        made->setAutoDefault(false);
        made->setEnabled(on);
        connect(made, &QPushButton::clicked, this, [this, row, act] {
            change(
                row, [&](void* owner) { withItems(row.field, owner, act); }, false);
        });
        line->addWidget(made);
    };
    const auto at = static_cast<std::ptrdiff_t>(index);
    button(tr("Up"), "up", index > 0,
           [at](auto& items) { std::swap(items[std::size_t(at)], items[std::size_t(at) - 1]); });
    button(tr("Remove"), "remove", count > 0,
           [at](auto& items) { items.erase(items.begin() + at); });
    inner->addRow(line);
    form.addRow(group);
}

} // namespace sparkout
