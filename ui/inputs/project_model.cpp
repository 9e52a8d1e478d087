// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/project_model.h"

#include "core/file/safe_file.h"
#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/operation.h"
#include "ui/form/field_editor.h"
#include "ui/form/number_field.h"
#include "ui/form/pasted_numbers.h"
#include "ui/inputs/form_metrics.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/table/profile_csv.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;

namespace sparkout {

class NumberField;

namespace {

/// Lowest, highest and step of a machine's range: three numbers, or none.
class RangeEditor : public FieldEditor {
    Q_DECLARE_TR_FUNCTIONS(sparkout::RangeEditor)

public:
    RangeEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_body; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override;
    void dropRefusal() override { show(true); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

private:
    using Values = std::optional<std::vector<double>>;

    void take();
    /// The reason why the three are not a range; empty if they are.
    [[nodiscard]] QString fault() const;
    [[nodiscard]] const Values& stored() const;

    QWidget* m_body;
    std::array<NumberField*, 3> m_fields{};
    std::array<QLabel*, 3> m_names{}; ///< labels before the fields
    QLabel* m_unit;
    Values m_kept; ///< the document's value when the texts were last in order
};

constexpr int longestUnit = 8; ///< longest unit on one line

RangeEditor::RangeEditor(const std::string& path, const Field& field, FormModel& model,
                         QWidget* parent)
    : FieldEditor(path, field, model), m_body(new QWidget(parent)), m_unit(new QLabel(m_body)) {
    auto* layout = new QHBoxLayout(m_body);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::gap);
    NumberSpec spec = NumberSpec::of(field);
    spec.optional = true;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        m_names[i] = new QLabel(m_body);
        m_names[i]->setTextFormat(Qt::PlainText);
        layout->addWidget(m_names[i]);
        NumberField* const number = m_fields[i] = new NumberField(spec, m_body);
        m_names[i]->setBuddy(number);
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        layout->addWidget(number, 1);
        connect(number, &NumberField::valueEdited, this, &RangeEditor::take);
        connect(number, &NumberField::remarkChanged, this, &FieldEditor::remarkChanged);
        connect(number, &QLineEdit::editingFinished, this, [this] {
            this->model().endMerge();
            emit remarkChanged(); // a joint remark of all three
        });
    }
    m_unit->setTextFormat(Qt::PlainText);
    setTextWidth(*m_unit, unitColumn);
    layout->addWidget(m_unit);
    m_body->setFocusProxy(m_fields[0]);
}

const RangeEditor::Values& RangeEditor::stored() const {
    return field().as<Values>(owner());
}

QString RangeEditor::fault() const {
    for (const NumberField* number : m_fields) {
        if (number->refused()) {
            return number->refusal();
        }
    }
    const auto given = std::count_if(m_fields.begin(), m_fields.end(),
                                     [](const NumberField* f) { return f->value().has_value(); });
    if (given != 0 && given != 3) {
        return tr("minimum, maximum and step are needed, or none of them");
    }
    return given == 3 && *m_fields[0]->value() > *m_fields[1]->value()
               ? tr("the minimum is above the maximum")
               : QString();
}

void RangeEditor::take() {
    if (fault().isEmpty()) {
        Values values;
        if (m_fields[0]->value()) {
            values = {*m_fields[0]->value(), *m_fields[1]->value(), *m_fields[2]->value()};
        }
        m_kept = values;
        change([this, &values](void* to) { field().as<Values>(to) = values; });
    }
    emit remarkChanged();
}

void RangeEditor::show(bool replaced) {
    const Values values = stored();
    if (!replaced && !fault().isEmpty() && values == m_kept) {
        return; // an incomplete range stays visible
    }
    m_kept = values;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const bool given = values && i < values->size();
        const auto value = given ? std::optional((*values)[i]) : std::nullopt;
        replaced ? m_fields[i]->reset(value) : m_fields[i]->setValue(value);
    }
    emit remarkChanged();
}

void RangeEditor::retranslate() {
    const std::array names{tr("minimum"), tr("maximum"), tr("step")};
    const std::array brief{tr("from"), tr("to"), tr("step", "after from and to")};
    const QString label = inputText(field().label);
    const QString unit = unitText(field().unit);
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        m_fields[i]->retranslate();
        m_fields[i]->setPlaceholderText({});
        m_names[i]->setText(brief[i]);
        m_fields[i]->setAccessibleName(tr("%1: %2, %3").arg(label, names[i], unit));
        m_fields[i]->setToolTip(tr("%1: %2").arg(label, names[i]));
    }
    const bool isLong = unit.size() > longestUnit; // it breaks after the slash
    if (isLong) {
        m_unit->setWordWrap(true);
        setTextLines(*m_unit, 2, 6);
    }
    m_unit->setText(isLong ? QString(unit).replace(u'/', QStringLiteral("/\u200b")) : unit);
}

QString RangeEditor::refusal() const {
    return fault();
}

Remark RangeEditor::remark() const {
    for (const NumberField* number : m_fields) {
        if (number->refused() && !number->typing()) {
            return number->remark();
        }
    }
    const bool within = m_body->isAncestorOf(QApplication::focusWidget()); // the others may follow
    const QString reason = within ? QString() : fault();
    return reason.isEmpty() ? FieldEditor::remark() : Remark{Mark::error, reason};
}

/// The measured profile of the blank: a summary line, a button that reads it from a CSV file and
/// one that removes it. An unreadable file leaves the profile unchanged and shows the reason.
class RadiiEditor : public FieldEditor {
    Q_DECLARE_TR_FUNCTIONS(sparkout::RadiiEditor)

public:
    RadiiEditor(const std::string& path, const Field& field, ProjectModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_body; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    void dropRefusal() override { refuse({}, {}); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

    void readFrom(const QString& path);

private:
    void askForFile();
    void clear();
    void refuse(const QString& file, const QString& reason);
    [[nodiscard]] QString summary() const;

    Document& m_document;
    QWidget* m_body;
    QLabel* m_summary;
    QPushButton* m_read;
    QPushButton* m_clear;
    QString m_refused; ///< why the last file was refused; empty: accepted
};

constexpr std::size_t largestFile = 1u << 20; // bytes; 360 lines need a hundredth of this

RadiiEditor::RadiiEditor(const std::string& path, const Field& field, ProjectModel& model,
                         QWidget* parent)
    : FieldEditor(path, field, model)
    , m_document(model.document())
    , m_body(new QWidget(parent))
    , m_summary(new QLabel(m_body))
    , m_read(new QPushButton(m_body))
    , m_clear(new QPushButton(m_body)) {
    auto* layout = new QGridLayout(m_body);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_summary, 0, 0, 1, 3);
    layout->addWidget(m_read, 1, 0);
    layout->addWidget(m_clear, 1, 1);
    layout->setColumnStretch(2, 1);
    m_summary->setTextFormat(Qt::PlainText);
    m_body->setFocusProxy(m_read);
    for (QPushButton* button : {m_read, m_clear}) {
        button->setAutoDefault(false);
    }
    connect(m_read, &QPushButton::clicked, this, &RadiiEditor::askForFile);
    connect(m_clear, &QPushButton::clicked, this, &RadiiEditor::clear);
}

void RadiiEditor::askForFile() {
    const QString path =
        FileDialog::openPath(m_body->window(), tr("Read a measured profile"), {},
                             tr("Tables (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (!path.isEmpty()) {
        readFrom(path);
    }
}

void RadiiEditor::readFrom(const QString& path) {
    const QString name = printableText(QFileInfo(path).fileName());
    const auto read = readFile(systemPath(path), largestFile);
    if (const auto* error = std::get_if<FileError>(&read)) {
        m_refused = readErrorText(*error);
        emit remarkChanged();
        return;
    }
    const auto parsed = readProfileCsv(std::get<std::string>(read));
    if (const auto* fault = std::get_if<ProfileCsvFault>(&parsed)) {
        refuse(name, profileCsvFaultText(*fault));
        return;
    }
    refuse({}, {});
    m_document.edit(withRadii(m_document.project(), std::get<std::vector<double>>(parsed)),
                    {"Input", field().label});
}

void RadiiEditor::refuse(const QString& file, const QString& reason) {
    m_refused = reason.isEmpty() ? QString() : tr("“%1” was not read: %2").arg(file, reason);
    emit remarkChanged();
}

void RadiiEditor::clear() {
    m_read->setFocus(); // the button becomes disabled
    change([this](void* to) { field().as<std::optional<std::vector<double>>>(to).reset(); });
    model().endMerge();
}

QString RadiiEditor::summary() const {
    const auto& radii = field().as<std::optional<std::vector<double>>>(owner());
    if (!radii || radii->empty()) {
        return inputText(field().nullMeaning);
    }
    const auto [low, high] = std::minmax_element(radii->begin(), radii->end());
    const auto number = [](double value) { return printedNumber(value); };
    return tr("%n values, %1…%2 %3", nullptr, static_cast<int>(radii->size()))
        .arg(number(*low), number(*high), unitText(field().unit));
}

void RadiiEditor::show(bool) {
    m_refused.clear(); // it concerned the previous project
    m_summary->setText(summary());
    m_clear->setEnabled(field().as<std::optional<std::vector<double>>>(owner()).has_value());
}

void RadiiEditor::retranslate() {
    m_summary->setText(summary());
    m_read->setText(tr("Read from CSV…"));
    m_clear->setText(tr("Clear"));
    m_read->setAccessibleName(tr("%1: read from a CSV file").arg(inputText(field().label)));
    m_clear->setAccessibleName(tr("%1: clear").arg(inputText(field().label)));
    const QString hint = tr("A number a line in µm, or the last column of a table; the number of "
                            "values becomes the number of radii per section.");
    m_read->setToolTip(QStringLiteral("<p>%1</p>").arg(hint.toHtmlEscaped()));
    m_clear->setToolTip(m_clear->accessibleName());
}

Remark RadiiEditor::remark() const {
    return m_refused.isEmpty() ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

/// Rows of a few numbers in one line of text: "0 50; 200 80". Empty means not given.
class RowsEditor : public LineEditor {
    Q_DECLARE_TR_FUNCTIONS(sparkout::RowsEditor)

public:
    using LineEditor::LineEditor;
    [[nodiscard]] bool empty() const override { return !stored(); }

protected:
    [[nodiscard]] QString storedText() const override;
    [[nodiscard]] bool isStored(const QString& text) const override;
    [[nodiscard]] QString accept(const QString& text) override;
    [[nodiscard]] CellsText textOf(const PastedCells& cells) const override;

private:
    /// The rows of a text; empty if a row does not have the right count.
    [[nodiscard]] std::optional<NumberRows> rowsOf(const QString& text) const;
    [[nodiscard]] const NumberRows& stored() const;
};

QString joinedRows(const std::vector<std::vector<double>>& rows) {
    QStringList texts;
    for (const std::vector<double>& row : rows) {
        QStringList numbers;
        for (const double value : row) {
            numbers += showNumber(value, QLocale());
        }
        texts += numbers.join(u' ');
    }
    return texts.join(QStringLiteral("; "));
}

const NumberRows& RowsEditor::stored() const {
    return field().as<NumberRows>(owner());
}

QString RowsEditor::storedText() const {
    return stored() ? joinedRows(*stored()) : QString();
}

std::optional<NumberRows> RowsEditor::rowsOf(const QString& text) const {
    if (text.trimmed().isEmpty()) {
        return NumberRows();
    }
    std::vector<std::vector<double>> rows;
    for (const QString& line : text.split(u';', Qt::SkipEmptyParts)) {
        std::vector<double> row;
        for (const QString& number : line.simplified().split(u' ', Qt::SkipEmptyParts)) {
            const std::optional<double> value = parseNumber(number);
            if (!value) {
                return std::nullopt;
            }
            row.push_back(*value);
        }
        if (row.size() != field().count) {
            return std::nullopt;
        }
        rows.push_back(std::move(row));
    }
    return NumberRows(std::move(rows));
}

bool RowsEditor::isStored(const QString& text) const {
    const std::optional<NumberRows> rows = rowsOf(text);
    return rows && *rows == stored();
}

RowsEditor::CellsText RowsEditor::textOf(const PastedCells& cells) const {
    const PastedNumbers numbers(cells, field().stated(), "");
    return {joinedRows(numbers.rows()), numbers.fault()};
}

QString RowsEditor::accept(const QString& text) {
    const std::optional<NumberRows> rows = rowsOf(text);
    const auto set = [this, &rows](void* to) { field().as<NumberRows>(to) = *rows; };
    if (!rows) {
        return tr("rows of %n number(s) separated by semicolons, as in 0 50; 200 80", nullptr,
                  static_cast<int>(field().count));
    }
    if (!fits(set)) {
        return path().starts_with("/machine/wheel_contact/")
                   ? tr("the forces must rise from row to row, the stiffnesses lie above 0")
                   : tr("a number is out of range");
    }
    change(set);
    return {};
}

} // namespace

ProjectModel::ProjectModel(Document& document, QObject* parent)
    : FormModel(parent), m_document(document) {
    connect(&document, &Document::changed, this, &FormModel::changed);
    connect(&document, &Document::saved, this, &FormModel::saved);
}

const void* ProjectModel::ownerOf(const std::string& path) const {
    return findMember(m_document.project(), path).owner;
}

const char* ProjectModel::labelOf(const std::string& path) const {
    return findMember(m_document.project(), path).field->label;
}

std::optional<Project> ProjectModel::changedProject(const std::string& path,
                                                    const Change& set) const {
    const Project& before = m_document.project();
    Project after = before;
    const Member member = findMember(after, path, true);
    if (!member) {
        return std::nullopt;
    }
    set(member.owner);
    if (after.operation != before.operation) {
        return withOperation(before, after.operation, m_document.lastWith(after.operation));
    }
    if (after.sections != before.sections) {
        // Compares with the value before typing began: 12 must not go through 1.
        return withSections(m_document.beforeEditsOf(QString::fromStdString(path)), after.sections);
    }
    if (path.starts_with("/wheel/runout/")) {
        keepRunoutForm(after.wheel->runout, std::string_view(path).substr(path.rfind('/') + 1));
    }
    if (path != "/part/radii_per_section") {
        resolveWaves(after);
    }
    return after.part->surface != before.part->surface ? withComputable(std::move(after)) : after;
}

void ProjectModel::change(const std::string& path, const Change& set, bool merges) {
    if (auto after = changedProject(path, set)) {
        m_document.edit(std::move(*after), {"Input", labelOf(path)},
                        merges ? QString::fromStdString(path) : QString());
    }
}

void ProjectModel::endMerge() {
    m_document.endMerge();
}

bool ProjectModel::fits(const std::string& path, const Change& set) const {
    const auto after = changedProject(path, set);
    return !after || !breaksRules(m_document.project(), *after);
}

const Project* ProjectModel::project() const {
    return &m_document.project();
}

bool ProjectModel::isOpen(const std::string& path) const {
    return m_document.isOpen(path);
}

void ProjectModel::withdraw(const std::string& path) {
    m_document.withdraw(path, {"Input", labelOf(path)});
}

std::unique_ptr<FieldEditor> makeInputEditor(const std::string& path, const Field& field,
                                             ProjectModel& model, QWidget* parent) {
    if (path == "/notes") {
        auto notes = std::make_unique<NotesEditor>(path, field, model, parent);
        setTextLines(*notes->widget(), 5, 10);
        return notes;
    }
    if (path == "/part/radii_um") {
        return std::make_unique<RadiiEditor>(path, field, model, parent);
    }
    if (field.kind == Kind::optionalNumberList && field.count == 3) {
        return std::make_unique<RangeEditor>(path, field, model, parent);
    }
    if (field.kind == Kind::numberRows) {
        return std::make_unique<RowsEditor>(path, field, model, parent);
    }
    return makeEditor(path, field, model, parent);
}

} // namespace sparkout
