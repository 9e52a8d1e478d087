// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/compliance_box.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/machine.h"
#include "core/study/operation.h"
#include "ui/fields/calibrated_mark.h"
#include "ui/fields/reason_label.h"
#include "ui/fields/value_slider.h"
#include "ui/inputs/editors/form_metrics.h"
#include "ui/inputs/editors/hint_strip.h"
#include "ui/inputs/forms/page_columns.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/text/calibration_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace sparkout {

namespace {

constexpr std::size_t mostListed = 6; ///< sections whose computed γ is listed

std::vector<std::string> keysOf(const GivenCompliance& given) {
    if (std::holds_alternative<ZoneCompliance>(given)) {
        return {"rz1", "nz", "rz2"};
    }
    std::vector<std::string> keys;
    if (const auto* sections = std::get_if<std::vector<double>>(&given)) {
        for (std::size_t i = 0; i < sections->size(); ++i) {
            keys.push_back(std::to_string(i));
        }
    }
    return keys;
}

double& valueAt(GivenCompliance& given, std::size_t index) {
    if (auto* zones = std::get_if<ZoneCompliance>(&given)) {
        return index == 0 ? zones->rz1 : index == 1 ? zones->nz : zones->rz2;
    }
    return std::get<std::vector<double>>(given)[index];
}

} // namespace

ComplianceBox::ComplianceBox(std::string path, const Field& field, Document& document,
                             QWidget* parent)
    : InputBox(1, parent)
    , m_path(std::move(path))
    , m_field(field)
    , m_document(document)
    , m_computed(new QCheckBox(this))
    , m_reason(new ReasonLabel(this))
    , m_body(new QWidget(this))
    , m_gammas(new QLabel(this))
    , m_calibration(new QLabel(this)) {
    rows().setContentsMargins(inset(1), metrics::row, inset(1), metrics::tight);
    rows().addWidget(m_computed);
    rows().addWidget(m_body);
    rows().addWidget(m_gammas);
    rows().addWidget(m_calibration);
    rows().addWidget(m_reason);
    m_calibration->setObjectName(QStringLiteral("complianceCalibration"));
    m_calibration->setTextFormat(Qt::PlainText);
    m_calibration->setWordWrap(true);
    m_calibration->setForegroundRole(QPalette::PlaceholderText);
    m_calibration->setVisible(false);
    m_gammas->setObjectName(QStringLiteral("computedCompliance"));
    m_gammas->setTextFormat(Qt::PlainText);
    m_gammas->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_gammas->setWordWrap(true);
    m_gammas->setForegroundRole(QPalette::PlaceholderText);
    setHintField(*this, field);
    connect(m_computed, &QCheckBox::clicked, this, [this](bool computed) {
        m_document.edit(withGivenCompliance(m_document.project(), !computed),
                        {"Input", m_field.label});
    });
}

void ComplianceBox::build(const std::vector<std::string>& keys) {
    m_lines.clear();
    delete m_body;
    m_body = new QWidget(this);
    m_grid = new QGridLayout(m_body);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(metrics::gap);
    m_grid->setVerticalSpacing(metrics::row);
    m_grid->setColumnStretch(1, 1);
    rows().insertWidget(1, m_body);
    for (const std::string& key : keys) {
        addLine(key);
    }
}

void ComplianceBox::addLine(const std::string& key) {
    NumberSpec spec = NumberSpec::of(m_field);
    spec.optional = false;
    const Line line{key,
                    new QLabel(m_body),
                    new CalibratedMark(m_body),
                    new NumberField(spec, m_body),
                    new ValueSlider(m_body),
                    new QLabel(m_body),
                    new ReasonLabel(m_body)};
    line.label->setTextFormat(Qt::PlainText);
    line.label->setBuddy(line.field);
    line.unit->setTextFormat(Qt::PlainText);
    setTextWidth(*line.unit, unitColumn);
    setTextWidth(*line.field, metrics::field);
    line.field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line.field->setObjectName(QString::fromStdString(pathOf(line)));
    line.slider->setObjectName(line.field->objectName() + QStringLiteral("/slider"));
    line.slider->setVisible(m_field.slider);
    place(line);
    m_lines.push_back(line);
    connectLine(m_lines.size() - 1);
    retranslate(line);
}

void ComplianceBox::place(const Line& line) {
    const int row = m_grid->rowCount();
    auto* const head = new QHBoxLayout;
    head->setSpacing(metrics::hair);
    head->addWidget(line.label);
    head->addWidget(line.calibrated);
    m_grid->addLayout(head, row, 0);
    m_grid->addWidget(line.slider, row, 1);
    m_grid->addWidget(line.field, row, 2);
    m_grid->addWidget(line.unit, row, 3);
    m_grid->addWidget(line.reason, row + 1, 0, 1, 4);
}

void ComplianceBox::connectLine(std::size_t index) {
    NumberField* const field = m_lines[index].field;
    connect(field, &NumberField::valueEdited, this,
            [this, index, field] { store(index, *field->value()); });
    connect(field, &NumberField::remarkChanged, this, [this, index] {
        showReason(m_lines[index]);
        emit refusalsChanged();
    });
    connect(field, &QLineEdit::editingFinished, this, [this] { m_document.endMerge(); });
    connect(m_lines[index].slider, &ValueSlider::valueEdited, this,
            [this, index, field](double value) {
                field->reset(value); // discards a refused text
                store(index, value);
            });
    connect(m_lines[index].slider, &ValueSlider::settled, this, [this] { m_document.endMerge(); });
}

void ComplianceBox::store(std::size_t index, double value) {
    Project project = m_document.project();
    auto& given = project.machine->compliance_mm_per_n;
    if (index < keysOf(given).size()) {
        valueAt(given, index) = value;
        m_document.edit(std::move(project), {"Input", m_field.label},
                        QString::fromStdString(pathOf(m_lines[index])));
    }
}

void ComplianceBox::showProject(bool replaced) {
    const Project& project = m_document.project();
    GivenCompliance given = project.machine->compliance_mm_per_n;
    const auto keys = keysOf(given);
    const bool same =
        std::equal(keys.begin(), keys.end(), m_lines.begin(), m_lines.end(),
                   [](const std::string& key, const Line& line) { return key == line.key; });
    if (!same) {
        build(keys);
    }
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const Line& line = m_lines[i];
        const double value = valueAt(given, i);
        replaced ? line.field->reset(value) : line.field->setValue(value);
        line.slider->display(sliderSpec(project, pathOf(line), m_field), value,
                             unitText(m_field.unit));
    }
    const bool computed = std::holds_alternative<std::monostate>(given);
    m_computed->setChecked(computed);
    m_body->setVisible(!computed);
    showComputed();
    showCalibration(project);
    setIssues(m_issues);
}

/// One line for all inputs that were found from the same data; values changed since come first.
void ComplianceBox::showCalibration(const Project& project) {
    const Calibration *first = nullptr, *changed = nullptr;
    for (const Line& line : m_lines) {
        const Calibration* const record = calibrationOf(project, pathOf(line));
        const bool holds = record && hasCalibratedValue(project, *record);
        line.calibrated->showCalibration(holds, record ? CalibrationText::details(project, *record)
                                                       : QString());
        first = first ? first : record;
        changed = changed || holds ? changed : record;
    }
    const Calibration* const named = changed ? changed : first;
    m_calibration->setText(named ? CalibrationText::state(project, *named) : QString());
    m_calibration->setVisible(named && !m_computed->isChecked());
}

void ComplianceBox::setOutcome(const OutcomePtr& outcome) {
    if (outcome->ran()) {
        m_good = outcome;
    }
    setIssues(outcome->issues);
    showComputed();
}

void ComplianceBox::forgetResults() {
    m_good.reset();
    showComputed();
}

/// Shows γ zone by zone, or the least and the largest of many sections.
void ComplianceBox::showComputed() {
    QStringList values;
    if (m_computed->isChecked() && m_good
        && std::holds_alternative<std::monostate>(
            m_good->result.project.machine->compliance_mm_per_n)) {
        const std::vector<SectionResult>& sections = m_good->result.sections;
        const auto value = [&](std::size_t i) {
            return tr("%1: %2", "zone: compliance")
                .arg(Names::zone(sections[i].zone, static_cast<int>(i)),
                     Names::significant(sections[i].compliance_mm_per_n));
        };
        if (sections.size() <= mostListed) {
            for (std::size_t i = 0; i < sections.size(); ++i) {
                values << value(i);
            }
        } else {
            const auto [low, high] =
                std::ranges::minmax_element(sections, {}, &SectionResult::compliance_mm_per_n);
            values << value(static_cast<std::size_t>(low - sections.begin()))
                   << value(static_cast<std::size_t>(high - sections.begin()));
        }
    }
    m_gammas->setText(values.isEmpty()
                          ? QString()
                          : values.join(QStringLiteral("; ")) + u' ' + unitText(m_field.unit));
    m_gammas->setVisible(!values.isEmpty());
}

void ComplianceBox::setIssues(const Issues& issues) {
    m_issues = issues;
    m_reason->showRemark(remarkAt(issues, m_path));
    for (const Line& line : m_lines) {
        line.field->setIssue(remarkFor(issues, pathOf(line)));
    }
}

void ComplianceBox::showReason(const Line& line) {
    line.reason->showRemark(line.field->remark());
}

void ComplianceBox::retranslate(const Line& line) {
    const bool section = !line.key.empty() && line.key.front() >= '0' && line.key.front() <= '9';
    const QString name =
        section ? tr("Section %1").arg(std::stoi(line.key) + 1) : zoneText(line.key.c_str());
    const QString hint = hintMarkup(m_field);
    line.label->setText(name);
    line.unit->setText(unitText(m_field.unit));
    line.field->setToolTip(hint);
    line.field->setHint(hintPlain(m_field));
    line.field->setAccessibleName(tr("Compliance of %1, %2").arg(name, unitText(m_field.unit)));
    line.field->retranslate();
    line.slider->setToolTip(hint);
    line.slider->setAccessibleName(tr("Compliance of %1, slider").arg(name));
}

void ComplianceBox::retranslate() {
    setTitle(tr("%1 %2").arg(inputText(m_field.label), QString::fromUtf8(m_field.symbol)));
    setToolTip(hintMarkup(m_field));
    setAccessibleName(inputText(m_field.label));
    m_computed->setText(inputText(m_field.nullMeaning));
    m_computed->setAccessibleName(m_computed->text());
    for (const Line& line : m_lines) {
        retranslate(line);
    }
    m_gammas->setAccessibleName(tr("Computed compliance"));
    showComputed();
    showCalibration(m_document.project());
    setIssues(m_issues);
}

std::vector<Refusal> ComplianceBox::refusals() const {
    std::vector<Refusal> list;
    for (const Line& line : m_lines) {
        if (line.field->refused()) {
            list.push_back({pathOf(line), line.field->refusal()});
        }
    }
    return list;
}

bool ComplianceBox::dropRefusal(const std::string& path) {
    for (const Line& line : m_lines) {
        if (path == pathOf(line) && line.field->refused()) {
            line.field->reset(line.field->value());
            return true;
        }
    }
    return false;
}

void ComplianceBox::focusPath(const std::string& path) {
    for (const Line& line : m_lines) {
        if (path == pathOf(line)) {
            line.field->setFocus(Qt::OtherFocusReason);
            return;
        }
    }
    if (!m_lines.empty() && m_body->isVisibleTo(this)) {
        m_lines.front().field->setFocus(Qt::OtherFocusReason);
    } else {
        m_computed->setFocus(Qt::OtherFocusReason);
    }
}

} // namespace sparkout
