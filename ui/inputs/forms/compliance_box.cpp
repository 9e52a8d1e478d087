// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/compliance_box.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/machine.h"
#include "core/study/operation.h"
#include "ui/fields/mark.h"
#include "ui/inputs/forms/page_columns.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/text/calibration_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QLabel>

#include <algorithm>
#include <initializer_list>
#include <utility>

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
    : InputBox(std::move(path), field, 1, document, parent)
    , m_computed(new QCheckBox(this))
    , m_gammas(new QLabel(this))
    , m_calibration(new QLabel(this)) {
    numbers().setNames([](const QString& label) { return tr("Compliance of %1").arg(label); });
    rows().setContentsMargins(inset(1), metrics::row, inset(1), metrics::tight);
    for (QWidget* part : std::initializer_list<QWidget*>{m_computed, &numbers(), m_gammas,
                                                         m_calibration, &reason()}) {
        rows().addWidget(part);
    }
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
    connect(m_computed, &QCheckBox::clicked, this, [this](bool computed) {
        this->document().edit(withGivenCompliance(this->document().project(), !computed),
                              {"Input", this->field().label});
    });
}

NumberLines::Line ComplianceBox::lineOf(const std::string& key, std::size_t index) const {
    NumberLines::Line line;
    line.path = path() + "/" + key;
    line.spec = NumberSpec::of(field());
    line.spec.optional = false;
    line.get = [index](const Project& project) -> std::optional<double> {
        GivenCompliance given = project.machine->compliance_mm_per_n;
        return index < keysOf(given).size() ? std::optional(valueAt(given, index)) : std::nullopt;
    };
    line.set = [index](Project& project, std::optional<double> value) {
        GivenCompliance& given = project.machine->compliance_mm_per_n;
        if (value && index < keysOf(given).size()) {
            valueAt(given, index) = *value;
        }
    };
    line.label = [key] {
        const bool section = key.front() >= '0' && key.front() <= '9';
        return section ? tr("Section %1").arg(std::stoi(key) + 1) : zoneText(key.c_str());
    };
    line.hint = [&of = field()] { return hintPlain(of); };
    line.tip = [&of = field()] { return hintMarkup(of); };
    if (field().slider) {
        line.slider = [path = line.path, &of = field()](const Project& project) {
            return sliderSpec(project, path, of);
        };
    }
    return line;
}

void ComplianceBox::showProject(bool replaced) {
    const Project& project = document().project();
    const GivenCompliance& given = project.machine->compliance_mm_per_n;
    std::vector<NumberLines::Line> lines;
    for (const std::string& key : keysOf(given)) {
        lines.push_back(lineOf(key, lines.size()));
    }
    numbers().setLines(std::move(lines));
    numbers().showProject(replaced);
    const bool computed = std::holds_alternative<std::monostate>(given);
    m_computed->setChecked(computed);
    numbers().setVisible(!computed);
    showComputed();
    showCalibration(project);
}

/// One line for all inputs that were found from the same data; values changed since come first.
void ComplianceBox::showCalibration(const Project& project) {
    const Calibration *first = nullptr, *changed = nullptr;
    for (const std::string& key : keysOf(project.machine->compliance_mm_per_n)) {
        const Calibration* const record = calibrationOf(project, path() + "/" + key);
        const bool holds = record && hasCalibratedValue(project, *record);
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
                          : values.join(QStringLiteral("; ")) + u' ' + unitText(field().unit));
    m_gammas->setVisible(!values.isEmpty());
}

void ComplianceBox::setIssues(const Issues& issues) {
    m_issues = issues;
    reason().showRemark(remarkAt(m_issues, path()));
    numbers().setIssues(m_issues);
}

void ComplianceBox::retranslate() {
    setTitle(tr("%1 %2").arg(inputText(field().label), QString::fromUtf8(field().symbol)));
    setToolTip(hintMarkup(field()));
    setAccessibleName(inputText(field().label));
    m_computed->setText(inputText(field().nullMeaning));
    m_computed->setAccessibleName(m_computed->text());
    numbers().retranslate();
    m_gammas->setAccessibleName(tr("Computed compliance"));
    showComputed();
    showCalibration(document().project());
    setIssues(Issues(m_issues));
}

void ComplianceBox::focusPath(const std::string& path) {
    if (!numbers().focusPath(path) && !numbers().focusPath(this->path())) {
        m_computed->setFocus(Qt::OtherFocusReason);
    }
}

} // namespace sparkout
