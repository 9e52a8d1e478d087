// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/factor_box.h"

#include "core/file/blanks_csv.h"
#include "core/file/safe_file.h"
#include "core/project/batch.h"
#include "core/project/given_factors.h"
#include "core/project/member.h"
#include "core/study/batch_edits.h"
#include "ui/form/choice_editor.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/number_lines.h"
#include "ui/inputs/page_columns.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

/// The numbers of a factor in one of its forms, with the range of its input.
[[nodiscard]] std::vector<NumberLines::Line> factorLines(const std::string& path,
                                                         const Field& field,
                                                         const GivenFactor& factor,
                                                         FactorForm form);

using Values = std::optional<std::vector<double>>;

const Factor* lawIn(const Field& field, const Project& project) {
    return project.batch ? static_cast<const Factor*>(field.objectIn(&project.batch->factors))
                         : nullptr;
}

Factor* lawIn(const Field& field, Project& project) {
    return const_cast<Factor*>(lawIn(field, std::as_const(project)));
}

class FactorLines {
    Q_DECLARE_TR_FUNCTIONS(FactorLines)

    using Line = NumberLines::Line;

public:
    FactorLines(const std::string& path, const Field& field, const GivenFactor& factor)
        : m_path(path), m_field(field), m_allowed(factor.allowed) {}

    std::vector<Line> of(FactorForm form, bool truncated) {
        switch (form) {
        case FactorForm::constant: addConstant(); break;
        case FactorForm::uniform:
            add(&Factor::uniform, "uniform", 0, QT_TR_NOOP("Minimum"));
            add(&Factor::uniform, "uniform", 1, QT_TR_NOOP("Maximum"));
            break;
        case FactorForm::normal:
            add(&Factor::normal, "normal", 0, QT_TR_NOOP("Mean"));
            add(&Factor::normal, "normal", 1, QT_TR_NOOP("Standard deviation"));
            m_lines.back().spec.hard = {0, std::numeric_limits<double>::infinity()};
            if (truncated) {
                add(&Factor::within, "within", 0, QT_TR_NOOP("Minimum"));
                add(&Factor::within, "within", 1, QT_TR_NOOP("Maximum"));
            }
            break;
        case FactorForm::triangular:
            add(&Factor::triangular, "triangular", 0, QT_TR_NOOP("Minimum"));
            add(&Factor::triangular, "triangular", 1, QT_TR_NOOP("Most frequent"));
            add(&Factor::triangular, "triangular", 2, QT_TR_NOOP("Maximum"));
            break;
        case FactorForm::measured: break;
        case FactorForm::grows:
            add(&Factor::grows, "grows", 0, QT_TR_NOOP("First part"));
            add(&Factor::grows, "grows", 1, QT_TR_NOOP("Last part"));
            addBetweenDressings();
            break;
        }
        return std::move(m_lines);
    }

private:
    Line& addLine(const std::string& key, const char* label, const char* hintRow) {
        Line line;
        line.path = m_path + "/" + key;
        line.spec.hard = m_allowed;
        line.spec.unit = m_field.unit;
        line.label = [label] { return tr(label); };
        const Field* row = tableOf<Factor>().find(hintRow);
        line.hint = [row, range = m_allowed, unit = m_field.unit] {
            return inputText(row->hint) + QStringLiteral(" ")
                   + tr("Allowed: %1.").arg(rangeBrief(range, unit));
        };
        m_lines.push_back(std::move(line));
        return m_lines.back();
    }

    void add(Values Factor::*values, const char* key, std::size_t index, const char* label) {
        Line& line = addLine(std::string(key) + "/" + std::to_string(index), label, key);
        line.get = [&field = m_field, values,
                    index](const Project& project) -> std::optional<double> {
            const Factor* law = lawIn(field, project);
            return law && law->*values && index < (law->*values)->size()
                       ? std::optional((*(law->*values))[index])
                       : std::nullopt;
        };
        line.set = [&field = m_field, values, index](Project& project,
                                                     std::optional<double> value) {
            Factor* law = lawIn(field, project);
            if (law && law->*values && index < (law->*values)->size() && value) {
                (*(law->*values))[index] = *value;
            }
        };
    }

    void addConstant() {
        add(&Factor::uniform, "uniform", 0, QT_TR_NOOP("Value"));
        m_lines.back().set = [&field = m_field](Project& project, std::optional<double> value) {
            if (Factor* law = lawIn(field, project); law && value) {
                law->uniform = {*value, *value};
            }
        };
    }

    void addBetweenDressings() {
        const Field& row = *tableOf<Factor>().find("parts_between_dressings");
        Line& line = addLine(row.key, "", row.key);
        line.spec = NumberSpec::of(row);
        line.label = [&row] { return inputText(row.label); };
        line.hint = [&row] {
            return inputText(row.hint) + u' ' + tr("Empty: %1.").arg(inputText(row.nullMeaning));
        };
        line.get = [&field = m_field, &row](const Project& project) {
            const Factor* law = lawIn(field, project);
            return law ? numberIn(row, law) : std::nullopt;
        };
        line.set = [&field = m_field, &row](Project& project, std::optional<double> value) {
            if (Factor* law = lawIn(field, project)) {
                setNumberIn(row, law, value);
            }
        };
    }

    std::string m_path;
    const Field& m_field;
    Range m_allowed;
    std::vector<Line> m_lines;
};

std::vector<NumberLines::Line> factorLines(const std::string& path, const Field& field,
                                           const GivenFactor& factor, FactorForm form) {
    return FactorLines(path, field, factor).of(form, factor.law.within.has_value());
}

constexpr std::size_t largestTable = 8u << 20; // bytes

/// in the order of the forms
constexpr std::array formNames{QT_TRANSLATE_NOOP("sparkout::FactorBox", "constant"),
                               QT_TRANSLATE_NOOP("sparkout::FactorBox", "uniform"),
                               QT_TRANSLATE_NOOP("sparkout::FactorBox", "normal"),
                               QT_TRANSLATE_NOOP("sparkout::FactorBox", "triangular"),
                               QT_TRANSLATE_NOOP("sparkout::FactorBox", "as measured"),
                               QT_TRANSLATE_NOOP("sparkout::FactorBox", "growing part by part")};

} // namespace

FactorBox::FactorBox(std::string path, const Field& field, int depth, Document& document,
                     QWidget* parent)
    : InputBox(std::move(path), field, depth, document, parent)
    , m_kind(static_cast<FactorKind>(&field - tableOf<Factors>().fields.data()))
    , m_body(new QWidget(this))
    , m_formLabel(new QLabel(m_body))
    , m_form(new StillComboBox(m_body))
    , m_truncated(new QCheckBox(m_body))
    , m_measured(new QLabel(m_body))
    , m_read(new QPushButton(m_body)) {
    setCheckable(true);
    build();
    connectParts();
}

void FactorBox::build() {
    const QString name = QString::fromStdString(path());
    setObjectName(name);
    m_form->setObjectName(name + QStringLiteral("/form"));
    m_truncated->setObjectName(name + QStringLiteral("/truncated"));
    m_read->setObjectName(name + QStringLiteral("/read"));
    m_read->setAutoDefault(false);
    m_measured->setTextFormat(Qt::PlainText);
    m_measured->setWordWrap(true);
    m_formLabel->setTextFormat(Qt::PlainText);
    m_formLabel->setBuddy(m_form);
    setTextWidth(*m_form, wideField);
    auto* choice = new QHBoxLayout;
    choice->setSpacing(metrics::gap);
    choice->addWidget(m_formLabel, 1);
    choice->addWidget(m_form);
    auto* column = new QVBoxLayout(m_body);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::row);
    column->addLayout(choice);
    column->addWidget(&numbers());
    column->addWidget(m_truncated);
    column->addWidget(m_measured);
    column->addWidget(m_read, 0, Qt::AlignLeft);
    rows().setSpacing(metrics::row);
    rows().addWidget(m_body);
    rows().addWidget(&reason());
    for (std::size_t i = 0; i < formNames.size(); ++i) {
        m_form->addItem(QString(), static_cast<int>(i));
    }
}

void FactorBox::connectParts() {
    connect(this, &QGroupBox::clicked, this, [this](bool given) {
        edit(given ? std::optional(usualFactor(m_kind, document().project())) : std::nullopt);
    });
    connect(&document(), &Document::stepped, this, [this] {
        m_shown.reset(); // undone together with the edit that chose it
        showProject(false);
    });
    connect(m_form, &QComboBox::activated, this, &FactorBox::chooseForm);
    connect(m_truncated, &QCheckBox::clicked, this, &FactorBox::setTruncated);
    connect(m_read, &QPushButton::clicked, this, &FactorBox::askForFile);
}

const std::optional<Factor>& FactorBox::law() const {
    static const std::optional<Factor> none;
    const auto& batch = document().project().batch;
    return batch ? field().as<std::optional<Factor>>(&batch->factors) : none;
}

FactorForm FactorBox::shownForm(const Factor& law) const {
    const FactorForm form = formOf(law);
    const bool twoEnds = form == FactorForm::constant && m_shown == FactorForm::uniform;
    return twoEnds ? FactorForm::uniform : form;
}

// --- editing ------------------------------------------------------------------------------------

void FactorBox::edit(std::optional<Factor> law) {
    m_fileFault = {};
    document().endMerge();
    document().edit(withFactor(document().project(), m_kind, std::move(law)),
                    {"Input", field().label});
}

void FactorBox::chooseForm() {
    const auto form = static_cast<FactorForm>(m_form->currentIndex());
    if (law() && form != shownForm(*law())) {
        m_shown = form;
        edit(withForm(document().project(), m_kind, form));
    }
}

void FactorBox::setTruncated(bool truncated) {
    edit(withTruncation(document().project(), m_kind, truncated));
}

void FactorBox::askForFile() {
    const QString path =
        FileDialog::openPath(window(), tr("Read measured blanks"), {},
                             tr("Tables (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (!path.isEmpty()) {
        readFrom(path);
    }
}

void FactorBox::readFrom(const QString& path) {
    const auto refuse = [this, name = printableText(QFileInfo(path).fileName())](auto reason) {
        m_fileFault = [name, reason] { return tr("“%1” was not read: %2").arg(name, reason()); };
        showRemark();
    };
    const auto read = readFile(systemPath(path), largestTable);
    if (const auto* error = std::get_if<FileError>(&read)) {
        refuse([error = *error] { return readErrorText(error); });
        return;
    }
    const auto table = readMeasuredBlanks(std::get<std::string>(read));
    const QString key = QString::fromUtf8(field().key);
    if (const auto* fault = std::get_if<TableFault>(&table)) {
        refuse([key, fault = *fault] {
            return fault.text.empty() ? tr("no column is headed “%1”").arg(key)
                                      : tr("line %1: “%2” is not a number")
                                            .arg(fault.line)
                                            .arg(QString::fromStdString(fault.text));
        });
        return;
    }
    const auto& columns = std::get<std::vector<MeasuredColumn>>(table);
    const auto own = std::ranges::find(columns, m_kind, &MeasuredColumn::kind);
    if (own == columns.end() || own->values.empty()) {
        refuse([key] { return tr("no column is headed “%1”").arg(key); });
        return;
    }
    Factor measured;
    measured.measured = own->values;
    edit(std::move(measured));
}

// --- showing ------------------------------------------------------------------------------------

void FactorBox::showProject(bool replaced) {
    const std::optional<Factor>& law = this->law();
    if (replaced || !law) {
        m_shown.reset();
        m_fileFault = {};
    }
    setChecked(law.has_value());
    m_body->setVisible(law.has_value());
    if (law) {
        const FactorForm form = shownForm(*law);
        m_shown = form;
        const std::vector<GivenFactor> given = givenFactors(document().project());
        numbers().setLines(factorLines(
            path(), field(), *std::ranges::find(given, m_kind, &GivenFactor::kind), form));
        const QSignalBlocker blocker(m_form);
        m_form->setCurrentIndex(static_cast<int>(form));
        m_truncated->setVisible(form == FactorForm::normal);
        m_truncated->setChecked(law->within.has_value());
        m_measured->setVisible(form == FactorForm::measured);
        m_read->setVisible(form == FactorForm::measured);
        m_measured->setText(measuredText(*law));
    } else {
        numbers().setLines({});
    }
    numbers().showProject(replaced);
    showRemark();
}

QString FactorBox::measuredText(const Factor& law) const {
    if (!law.measured || law.measured->empty()) {
        return tr("no values yet");
    }
    const auto [low, high] = std::ranges::minmax_element(*law.measured);
    return tr("%n values, %1…%2 %3", nullptr, static_cast<int>(law.measured->size()))
        .arg(printedNumber(*low), printedNumber(*high), unitText(field().unit))
        .trimmed();
}

void FactorBox::setOutcome(const OutcomePtr& outcome) {
    m_issue = remarkAt(outcome->issues, path());
    if (m_issue.mark == Mark::none) {
        m_issue = remarkFor(outcome->issues, path() + "/measured");
    }
    numbers().setIssues(outcome->issues);
    showRemark();
}

void FactorBox::showRemark() {
    reason().showRemark(m_fileFault ? Remark{Mark::error, m_fileFault()} : m_issue);
}

void FactorBox::retranslate() {
    const QString label = inputText(field().label);
    setTitle(label);
    setAccessibleName(label);
    setToolTip(field().hint && *field().hint ? hintMarkup(field())
                                             : tr("Ticked: it scatters from part to part."));
    m_formLabel->setText(tr("Distribution"));
    m_form->setAccessibleName(tr("%1: distribution").arg(label));
    m_form->setToolTip(m_form->accessibleName());
    for (std::size_t i = 0; i < formNames.size(); ++i) {
        m_form->setItemText(static_cast<int>(i), tr(formNames[i]));
    }
    m_truncated->setText(tr("truncated"));
    m_truncated->setAccessibleName(tr("%1: truncated").arg(label));
    m_truncated->setToolTip(inputText(tableOf<Factor>().find("within")->hint));
    m_read->setText(tr("Read from CSV…"));
    m_read->setAccessibleName(tr("%1: read from a CSV file").arg(label));
    m_read->setToolTip(
        tr("A table whose column “%1” has one value per line").arg(QString::fromUtf8(field().key)));
    numbers().retranslate();
    if (law()) {
        m_measured->setText(measuredText(*law()));
    }
    showRemark();
}

void FactorBox::focusPath(const std::string& path) {
    if (!numbers().focusPath(path)) {
        (law() ? static_cast<QWidget*>(m_form) : this)->setFocus(Qt::OtherFocusReason);
    }
}

} // namespace sparkout
