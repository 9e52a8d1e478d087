// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/compliance_box.h"

#include "ui/inputs/form_row.h"
#include "ui/inputs/reason_label.h"
#include "ui/metrics.h"
#include "ui/session/document.h"
#include "ui/session/operation.h"
#include "ui/session/texts.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace sparkout {

namespace {

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
    : QGroupBox(parent)
    , m_path(std::move(path))
    , m_field(field)
    , m_document(document)
    , m_computed(new QCheckBox(this))
    , m_reason(new ReasonLabel(this))
    , m_body(new QWidget(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::margin, metrics::gap, metrics::margin, metrics::gap);
    layout->addWidget(m_computed);
    layout->addWidget(m_body);
    layout->addWidget(m_reason);
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
    m_grid->setColumnStretch(0, 1);
    static_cast<QVBoxLayout*>(layout())->insertWidget(1, m_body);
    for (const std::string& key : keys) {
        addLine(key);
    }
}

void ComplianceBox::addLine(const std::string& key) {
    NumberSpec spec = NumberSpec::of(m_field);
    spec.optional = false;
    const Line line{key, new QLabel(m_body), new NumberField(spec, m_body), new QLabel(m_body),
                    new ReasonLabel(m_body)};
    const std::size_t index = m_lines.size();
    const int row = m_grid->rowCount();
    line.label->setTextFormat(Qt::PlainText);
    line.label->setBuddy(line.field);
    line.unit->setTextFormat(Qt::PlainText);
    line.unit->setMinimumWidth(metrics::unit);
    line.field->setFixedWidth(metrics::field);
    line.field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line.field->setObjectName(QString::fromStdString(m_path + "/" + key));
    m_grid->addWidget(line.label, row, 0);
    m_grid->addWidget(line.field, row, 1);
    m_grid->addWidget(line.unit, row, 2);
    m_grid->addWidget(line.reason, row + 1, 0, 1, 3);
    connect(line.field, &NumberField::valueEdited, this, [this, index] { store(index); });
    connect(line.field, &NumberField::remarkChanged, this,
            [this, index] { showReason(m_lines[index]); });
    connect(line.field, &QLineEdit::editingFinished, this, [this] { m_document.endMerge(); });
    m_lines.push_back(line);
    retranslate(line);
}

void ComplianceBox::store(std::size_t index) {
    Project project = m_document.project();
    auto& given = project.machine.compliance_mm_per_n;
    if (index < keysOf(given).size()) {
        valueAt(given, index) = *m_lines[index].field->value();
        m_document.edit(std::move(project), {"Input", m_field.label},
                        QString::fromStdString(m_path + "/" + m_lines[index].key));
    }
}

void ComplianceBox::show(bool replaced) {
    const Project& project = m_document.project();
    GivenCompliance given = project.machine.compliance_mm_per_n;
    const auto keys = keysOf(given);
    bool same = keys.size() == m_lines.size();
    for (std::size_t i = 0; same && i < keys.size(); ++i) {
        same = keys[i] == m_lines[i].key;
    }
    if (!same) {
        build(keys);
    }
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        NumberField& field = *m_lines[i].field;
        replaced ? field.reset(valueAt(given, i)) : field.setValue(valueAt(given, i));
    }
    const bool computed = std::holds_alternative<std::monostate>(given);
    m_computed->setChecked(computed);
    m_body->setVisible(!computed);
    setIssues(m_issues);
}

void ComplianceBox::setIssues(const Issues& issues) {
    m_issues = issues;
    m_reason->showRemark(remarkAt(issues, m_path));
    for (const Line& line : m_lines) {
        line.field->setIssue(remarkFor(issues, m_path + "/" + line.key));
    }
}

void ComplianceBox::showReason(const Line& line) {
    line.reason->showRemark(line.field->remark());
}

void ComplianceBox::retranslate(const Line& line) {
    const bool section = !line.key.empty() && line.key.front() >= '0' && line.key.front() <= '9';
    const QString name =
        section ? tr("Section %1").arg(std::stoi(line.key)) : zoneText(line.key.c_str());
    line.label->setText(name);
    line.unit->setText(unitText(m_field.unit));
    line.field->setToolTip(hintMarkup(m_field));
    line.field->setAccessibleName(tr("Compliance of %1, %2").arg(name, unitText(m_field.unit)));
    line.field->retranslate();
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
    setIssues(m_issues);
}

QStringList ComplianceBox::refusals() const {
    QStringList list;
    for (const Line& line : m_lines) {
        if (line.field->refused()) {
            list += line.field->refusal();
        }
    }
    return list;
}

bool ComplianceBox::focusPath(const std::string& path) {
    if (!path.starts_with(m_path)) {
        return false;
    }
    for (const Line& line : m_lines) {
        if (path == m_path + "/" + line.key) {
            line.field->setFocus(Qt::OtherFocusReason);
            return true;
        }
    }
    if (!m_lines.empty() && m_body->isVisibleTo(this)) {
        m_lines.front().field->setFocus(Qt::OtherFocusReason);
    } else {
        m_computed->setFocus(Qt::OtherFocusReason);
    }
    return true;
}

} // namespace sparkout
