// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/field_editor.h"

#include "core/file/project_file.h"
#include "core/project/machine.h"
#include "core/project/member.h"
#include "ui/form/choice_editor.h"
#include "ui/form/number_field.h"
#include "ui/form/pasted_numbers.h"
#include "ui/form/value_slider.h"
#include "ui/session/slider_scale.h"
#include "ui/text/field_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QTextCursor>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

LineEditor::LineEditor(const std::string& path, const Field& field, FormModel& model,
                       QWidget* parent)
    : FieldEditor(path, field, model), m_line(new CellsLineEdit(parent)) {
    m_line->installEventFilter(this);
    m_line->setTakesCells([this](const PastedCells& cells) { takeCells(cells); });
    connect(&model, &FormModel::saved, this, &LineEditor::forgetPaste);
    connect(m_line, &QLineEdit::textEdited, this, &LineEditor::take);
    connect(m_line, &QLineEdit::editingFinished, this, [this] {
        this->model().endMerge();
        emit remarkChanged();
    });
}

QWidget* LineEditor::widget() const {
    return m_line;
}

void LineEditor::take() {
    forgetPaste();
    refuse(accept(m_line->text()));
}

void LineEditor::takeCells(const PastedCells& cells) {
    const CellsText meant = textOf(cells);
    model().endMerge();
    m_notPasted = meant.fault.isEmpty() ? accept(meant.text) : meant.fault;
    model().endMerge();
    if (m_notPasted.isEmpty()) {
        m_line->setText(meant.text);
        refuse({});
    } else {
        emit remarkChanged();
    }
}

void LineEditor::forgetPaste() {
    if (!m_notPasted.isEmpty()) {
        m_notPasted.clear();
        emit remarkChanged();
    }
}

void LineEditor::refuse(const QString& reason) {
    m_kept = storedText();
    m_refused = reason;
    emit remarkChanged();
}

void LineEditor::show(bool replaced) {
    forgetPaste();
    if (!m_refused.isEmpty() && !replaced && storedText() == m_kept) {
        return; // the refused text stays in sight
    }
    refuse({});
    if (replaced || !isStored(m_line->text())) { // otherwise as typed
        m_line->setText(storedText());
    }
}

void LineEditor::retranslate() {
    forgetPaste();
    m_line->setPlaceholderText(inputText(field().nullMeaning));
    if (m_refused.isEmpty()) {
        m_line->setText(storedText());
    } else {
        take();
    }
}

Remark LineEditor::remark() const {
    if (!m_notPasted.isEmpty()) {
        return {Mark::error, m_notPasted};
    }
    const bool typing = m_line->hasFocus();
    return m_refused.isEmpty() || typing ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

namespace {

constexpr int longestLine = 20'000; // in UTF-8 still below the limit of a file

} // namespace

TextEditor::TextEditor(const std::string& path, const Field& field, FormModel& model,
                       QWidget* parent)
    : FieldEditor(path, field, model), m_line(new QLineEdit(parent)) {
    m_line->setMaxLength(std::isfinite(field.hard.high) ? static_cast<int>(field.hard.high)
                                                        : longestLine);
    m_line->installEventFilter(this);
    connect(m_line, &QLineEdit::textEdited, this, [this](const QString& text) {
        change([this, &text](void* to) { this->field().as<std::string>(to) = text.toStdString(); });
    });
    connect(m_line, &QLineEdit::editingFinished, this, [this] { this->model().endMerge(); });
}

void TextEditor::show(bool) {
    const QString text = QString::fromStdString(field().as<std::string>(owner()));
    if (m_line->text() != text) {
        m_line->setText(text);
        m_line->setCursorPosition(0);
    }
}

NotesEditor::NotesEditor(const std::string& path, const Field& field, FormModel& model,
                         QWidget* parent)
    : FieldEditor(path, field, model), m_text(new QPlainTextEdit(parent)) {
    m_text->setTabChangesFocus(true);
    m_text->installEventFilter(this);
    connect(m_text, &QPlainTextEdit::textChanged, this, &NotesEditor::take);
}

QString NotesEditor::stored() const {
    return QString::fromStdString(field().as<std::string>(owner()));
}

/// With the spaces that do not break, which toPlainText() makes plain ones.
QString NotesEditor::typed() const {
    return m_text->document()
        ->toRawText()
        .replace(QChar::ParagraphSeparator, u'\n')
        .replace(QChar::LineSeparator, u'\n');
}

void NotesEditor::take() {
    const std::string text = typed().toStdString();
    if (text.size() > limits::stringBytes) {
        m_kept = stored();
        refuse(tooLong(text.size()));
        return;
    }
    refuse({});
    change([this, &text](void* to) { field().as<std::string>(to) = text; });
}

QString NotesEditor::tooLong(std::size_t bytes) {
    const auto kilobytes = [](double size) { return QLocale().toString(size / 1024, 'f', 1); };
    return tr("the text takes %1 KB; at most %2 KB are kept")
        .arg(kilobytes(double(bytes)), kilobytes(double(limits::stringBytes)));
}

void NotesEditor::refuse(const QString& reason) {
    if (reason != m_refused) {
        m_refused = reason;
        emit remarkChanged();
    }
}

Remark NotesEditor::remark() const {
    return m_refused.isEmpty() ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

void NotesEditor::dropRefusal() {
    m_kept.clear();
    refuse({});
    show(true);
}

void NotesEditor::show(bool replaced) {
    const QString text = stored();
    if (!m_refused.isEmpty() && !replaced && text == m_kept) {
        return; // the refused text stays in sight
    }
    refuse({});
    if (typed() != text) {
        const QSignalBlocker quiet(m_text);
        QTextCursor cursor = m_text->textCursor();
        const int place = cursor.position();
        m_text->setPlainText(text);
        cursor.setPosition(std::min(place, m_text->document()->characterCount() - 1));
        m_text->setTextCursor(cursor);
    }
}

void NotesEditor::retranslate() {
    if (!m_refused.isEmpty()) {
        m_refused = tooLong(std::size_t(typed().toUtf8().size()));
    }
}

bool NotesEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        model().endMerge();
    }
    return FieldEditor::eventFilter(watched, event);
}

class ValueSlider;

namespace {

/// A list of numbers in one line of text, "1; 2; 3"; for levels also from, to and step, "300…2400
/// step 100". Empty means not given, where allowed.
class NumbersEditor : public LineEditor {
    Q_DECLARE_TR_FUNCTIONS(sparkout::NumbersEditor)

public:
    NumbersEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent,
                  SpecOf spec = {});
    [[nodiscard]] bool wide() const override { return !*field().unit; }
    [[nodiscard]] bool empty() const override { return stored() == Levels(); }

protected:
    [[nodiscard]] QString storedText() const override;
    [[nodiscard]] bool isStored(const QString& text) const override;
    [[nodiscard]] QString accept(const QString& text) override;
    [[nodiscard]] CellsText textOf(const PastedCells& cells) const override;

private:
    [[nodiscard]] Levels stored() const;
    void put(const Levels& levels, void* to) const;
    /// The value of a text; empty if it is invalid.
    [[nodiscard]] std::optional<Levels> read(const QString& text) const;
    /// The reason for refusing a value; empty if it is accepted.
    [[nodiscard]] QString fault(const Levels& levels) const;
    [[nodiscard]] QString grammar() const;
    [[nodiscard]] QString joined(const std::vector<double>& values) const;

    SpecOf m_spec;
};

/// "from…to step s", written in either language, with … or dots or a dash between.
std::optional<SteppedLevels> steppedIn(const QString& text) {
    static const QRegularExpression pattern(
        QStringLiteral(R"(^\s*(\S+?)\s*(?:…|\.{2,3}|–|\s-\s|\sto\s|\sдо\s)\s*(\S+?))"
                       R"(\s*(?:;|:|/|,\s|step|шаг|in steps of|шагом|с шагом)\s*(\S+)\s*$)"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    const QRegularExpressionMatch found = pattern.match(text);
    const auto from = parseNumber(found.captured(1)), to = parseNumber(found.captured(2)),
               step = parseNumber(found.captured(3));
    return found.hasMatch() && from && to && step ? std::optional(SteppedLevels{*from, *to, *step})
                                                  : std::nullopt;
}

NumbersEditor::NumbersEditor(const std::string& path, const Field& field, FormModel& model,
                             QWidget* parent, SpecOf spec)
    : LineEditor(path, field, model, parent), m_spec(spec ? std::move(spec) : SpecOf([&field] {
        NumberSpec own;
        own.hard = field.stated();
        own.unit = field.unit;
        own.optional = field.kind != Kind::numberList;
        return own;
    })) {}

QString NumbersEditor::joined(const std::vector<double>& values) const {
    const ShownScale scale = m_spec().scale;
    QStringList texts;
    for (const double value : values) {
        texts += showNumber(scale.shown(value), QLocale());
    }
    return texts.join(QStringLiteral("; "));
}

Levels NumbersEditor::stored() const {
    switch (field().kind) {
    case Kind::numberList: return field().as<std::vector<double>>(owner());
    case Kind::optionalNumberList: {
        const auto& list = field().as<std::optional<std::vector<double>>>(owner());
        return list ? Levels(*list) : Levels();
    }
    default: return field().as<Levels>(owner());
    }
}

void NumbersEditor::put(const Levels& levels, void* to) const {
    const auto* list = std::get_if<std::vector<double>>(&levels);
    switch (field().kind) {
    case Kind::numberList: field().as<std::vector<double>>(to) = *list; break;
    case Kind::optionalNumberList:
        field().as<std::optional<std::vector<double>>>(to) =
            list ? std::optional(*list) : std::nullopt;
        break;
    default: field().as<Levels>(to) = levels;
    }
}

QString NumbersEditor::storedText() const {
    const Levels levels = stored();
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        return tr("%1…%2 step %3")
            .arg(showNumber(stepped->from, QLocale()), showNumber(stepped->to, QLocale()),
                 showNumber(stepped->step, QLocale()));
    }
    const auto* list = std::get_if<std::vector<double>>(&levels);
    return list ? joined(*list) : QString();
}

std::optional<Levels> NumbersEditor::read(const QString& text) const {
    if (text.trimmed().isEmpty()) {
        return m_spec().optional ? std::optional(Levels()) : std::nullopt;
    }
    if (field().kind == Kind::levels) {
        if (const auto stepped = steppedIn(text)) {
            return Levels(*stepped);
        }
    }
    const ShownScale scale = m_spec().scale;
    std::vector<double> list;
    for (const QString& part : text.split(u';', Qt::SkipEmptyParts)) {
        const std::optional<double> value = parseNumber(part);
        if (!value) {
            return std::nullopt;
        }
        list.push_back(scale.kept(*value));
    }
    return field().count > 0 && list.size() != field().count ? std::nullopt
                                                             : std::optional(Levels(list));
}

bool NumbersEditor::isStored(const QString& text) const {
    const std::optional<Levels> read = this->read(text);
    return read && *read == stored();
}

QString NumbersEditor::grammar() const {
    if (field().kind == Kind::levels) {
        return tr("values separated by semicolons, as in 300; 500; 800, or from, to and step, as "
                  "in 300…2400 step 100");
    }
    return field().count > 0 ? tr("%n number(s) separated by semicolons", nullptr,
                                  static_cast<int>(field().count))
                             : tr("numbers separated by semicolons, as in 1; 2; 3");
}

QString NumbersEditor::fault(const Levels& levels) const {
    std::vector<double> values;
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        if (stepped->to < stepped->from) {
            return tr("the second value is below the first");
        }
        values = {stepped->from, stepped->to, stepped->step};
    } else if (const auto* list = std::get_if<std::vector<double>>(&levels)) {
        values = *list;
    }
    const NumberSpec spec = m_spec();
    const auto outside =
        std::ranges::find_if(values, [&spec](double value) { return !spec.hard.contains(value); });
    if (outside != values.end()) {
        return tr("%1; allowed: %2")
            .arg(printedNumber(spec.scale.shown(*outside)),
                 rangeShown(spec.scale.shown(spec.hard), spec.unit));
    }
    return fits([this, &levels](void* to) { put(levels, to); })
               ? QString()
               : tr("these values contradict the other inputs");
}

NumbersEditor::CellsText NumbersEditor::textOf(const PastedCells& cells) const {
    const NumberSpec spec = m_spec();
    const PastedNumbers numbers(cells, spec.scale.shown(spec.hard), spec.unit);
    std::vector<double> values = numbers.inOrder();
    std::ranges::transform(values, values.begin(),
                           [&spec](double value) { return spec.scale.kept(value); });
    return {joined(values), numbers.fault()};
}

QString NumbersEditor::accept(const QString& text) {
    const std::optional<Levels> levels = read(text);
    if (!levels) {
        return grammar();
    }
    const QString reason = fault(*levels);
    if (reason.isEmpty()) {
        change([this, &levels](void* to) { put(*levels, to); });
    }
    return reason;
}

/// An editor for numbers, whole or not, required or optional.
class NumberEditor : public FieldEditor {
    Q_DECLARE_TR_FUNCTIONS(sparkout::NumberEditor)

public:
    NumberEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent,
                 SpecOf spec = {});

    [[nodiscard]] QWidget* widget() const override { return m_field; }
    [[nodiscard]] QWidget* slider() const override;
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override { return m_field->remark(); }
    [[nodiscard]] QString refusal() const override;
    void dropRefusal() override;
    void setIssue(const Remark& issue) override { m_field->setIssue(issue); }
    [[nodiscard]] bool empty() const override { return !m_field->value(); }

private:
    [[nodiscard]] std::optional<double> stored() const;
    void store(std::optional<double> value);
    void addSlider(QWidget* parent);

    SpecOf m_spec;
    NumberField* m_field;
    ValueSlider* m_slider = nullptr;
};

NumberEditor::NumberEditor(const std::string& path, const Field& field, FormModel& model,
                           QWidget* parent, SpecOf spec)
    : FieldEditor(path, field, model)
    , m_spec(spec ? std::move(spec) : SpecOf([&field] { return NumberSpec::of(field); }))
    , m_field(new NumberField(m_spec(), parent)) {
    connect(m_field, &NumberField::valueEdited, this, [this] { store(m_field->value()); });
    m_field->setFits([this](std::optional<double> value) {
        return fits([this, value](void* to) { setNumberIn(this->field(), to, value); });
    });
    m_field->setSteps([this](double value, int steps) {
        const Project* const project = this->model().project();
        return project ? steppedOnMachine(*project, this->path(), value, steps) : std::nullopt;
    });
    connect(m_field, &NumberField::remarkChanged, this, &FieldEditor::remarkChanged);
    connect(m_field, &QLineEdit::editingFinished, this, [this] { this->model().endMerge(); });
    if (field.slider && model.project()) {
        addSlider(parent);
    }
}

void NumberEditor::addSlider(QWidget* parent) {
    m_slider = new ValueSlider(parent);
    m_slider->setObjectName(QString::fromStdString(path()) + QStringLiteral("/slider"));
    connect(m_slider, &ValueSlider::valueEdited, this, [this](double value) {
        m_field->reset(value); // discards a refused text
        store(value);
    });
    connect(m_slider, &ValueSlider::settled, this, [this] { model().endMerge(); });
}

QWidget* NumberEditor::slider() const {
    return m_slider;
}

std::optional<double> NumberEditor::stored() const {
    return model().isOpen(path()) ? std::nullopt : numberIn(field(), owner());
}

void NumberEditor::store(std::optional<double> value) {
    const bool needed = field().kind == Kind::number || field().kind == Kind::integer;
    if (!value && needed) { // typed and deleted again
        model().withdraw(path());
        return;
    }
    change([this, value](void* to) { setNumberIn(field(), to, value); });
}

void NumberEditor::show(bool replaced) {
    replaced ? m_field->reset(stored()) : m_field->setValue(stored());
    if (m_slider) {
        m_slider->display(sliderSpec(*model().project(), path(), field()), stored(),
                          unitText(field().unit), ShownScale::ofInput(field()));
    }
}

void NumberEditor::retranslate() {
    m_field->setSpec(m_spec());
    m_field->retranslate();
    if (m_slider) {
        m_slider->setAccessibleName(tr("%1, slider").arg(StockReading::label(field())));
    }
}

QString NumberEditor::refusal() const {
    return m_field->refused() ? m_field->refusal() : QString();
}

void NumberEditor::dropRefusal() {
    if (m_field->refused()) {
        m_field->reset(stored());
    }
}

} // namespace

FieldEditor::FieldEditor(std::string path, const Field& field, FormModel& model)
    : m_path(std::move(path)), m_field(field), m_model(model) {}

void FieldEditor::setIssue(const Remark& issue) {
    m_issue = issue;
    emit remarkChanged();
}

void FieldEditor::describe(const QString& name, const QString& hint, const QString& plain) {
    widget()->setObjectName(QString::fromStdString(m_path));
    widget()->setAccessibleName(name);
    widget()->setToolTip(hint);
    if (auto* number = qobject_cast<NumberField*>(widget())) {
        number->setHint(plain);
    } else {
        widget()->setAccessibleDescription(plain);
    }
}

bool FieldEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_model.hasHistory()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::Wheel && qobject_cast<QComboBox*>(watched)) {
        event->ignore();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

bool FieldEditor::changedFromDefault() const {
    return !isDefault(m_field, owner());
}

void FieldEditor::resetToDefault() {
    m_model.endMerge();
    change([this](void* to) { setDefault(m_field, to); });
    m_model.endMerge();
    dropRefusal();
}

std::unique_ptr<FieldEditor> makeEditor(const std::string& path, const Field& field,
                                        FormModel& model, QWidget* parent, const SpecOf& spec) {
    switch (field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger:
        return std::make_unique<NumberEditor>(path, field, model, parent, spec);
    case Kind::choice:
        return std::make_unique<ChoiceEditor>(path, field, model, parent,
                                              ChoiceEditor::choicesOf(field));
    case Kind::boolean: return std::make_unique<BooleanEditor>(path, field, model, parent);
    case Kind::text: return std::make_unique<TextEditor>(path, field, model, parent);
    case Kind::numberList:
    case Kind::optionalNumberList:
    case Kind::levels: return std::make_unique<NumbersEditor>(path, field, model, parent, spec);
    default: return nullptr;
    }
}

} // namespace sparkout
