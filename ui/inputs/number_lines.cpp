// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/number_lines.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/batch.h"
#include "ui/form/input_marks.h"
#include "ui/form/pasted_numbers.h"
#include "ui/form/value_slider.h"
#include "ui/inputs/form_metrics.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"
#include "ui/text/calibration_text.h"
#include "ui/text/texts.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

NumberLines::NumberLines(Document& document, const char* editText, QWidget* parent)
    : QWidget(parent), m_document(document), m_editText(editText) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    connect(&document, &Document::changed, this, &NumberLines::forgetPaste);
    connect(&document, &Document::saved, this, &NumberLines::forgetPaste);
}

void NumberLines::setLines(std::vector<Line> lines) {
    const bool same = std::ranges::equal(lines, m_rows, [](const Line& line, const Row& row) {
        return line.path == row.line.path && line.label() == row.line.label()
               && line.spec.hard.low == row.line.spec.hard.low
               && line.spec.hard.high == row.line.spec.hard.high;
    });
    if (same) {
        return;
    }
    for (const Row& row : m_rows) {
        row.field->disconnect(this); // it loses the focus when deleted
    }
    m_rows.clear();
    delete m_body;
    m_body = new QWidget(this);
    m_grid = new QGridLayout(m_body);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(metrics::gap);
    m_grid->setVerticalSpacing(metrics::row);
    m_grid->setColumnStretch(!lines.empty() && lines.front().slider ? 1 : 0, 1);
    layout()->addWidget(m_body);
    for (Line& line : lines) {
        addRow(std::move(line));
    }
    setIssues(Issues(m_issues));
}

void NumberLines::addRow(Line line) {
    const NumberSpec spec = line.spec;
    const bool slides = static_cast<bool>(line.slider);
    Row& added = m_rows.emplace_back(Row{std::move(line), new QLabel(m_body),
                                         new CalibratedMark(m_body), new NumberField(spec, m_body),
                                         slides ? new ValueSlider(m_body) : nullptr,
                                         new QLabel(m_body), new ReasonLabel(m_body)});
    added.label->setTextFormat(Qt::PlainText);
    added.label->setWordWrap(!slides);
    added.label->setBuddy(added.field);
    added.unit->setTextFormat(Qt::PlainText);
    setTextWidth(*added.unit, unitColumn);
    setTextWidth(*added.field, metrics::field);
    added.field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    added.field->setObjectName(QString::fromStdString(added.line.path));
    const int at = m_grid->rowCount();
    auto* head = new QHBoxLayout;
    head->setSpacing(metrics::hair);
    head->addWidget(added.label, slides ? 0 : 1);
    head->addWidget(added.calibrated);
    m_grid->addLayout(head, at, 0);
    if (slides) {
        added.slider->setObjectName(added.field->objectName() + QStringLiteral("/slider"));
        m_grid->addWidget(added.slider, at, 1);
    }
    m_grid->addWidget(added.field, at, 2);
    m_grid->addWidget(added.unit, at, 3);
    m_grid->addWidget(added.reason, at + 1, 0, 1, 4);
    connectRow(m_rows.size() - 1);
    retranslate(added);
}

void NumberLines::connectRow(std::size_t index) {
    NumberField* const field = m_rows[index].field;
    field->setFits([this, index](std::optional<double> value) {
        return index >= m_rows.size() || fits(m_rows[index].line, value);
    });
    field->setTakesCells([this, index](const PastedCells& cells) { paste(index, cells); });
    connect(field, &NumberField::valueEdited, this,
            [this, index, field] { store(m_rows[index].line, field->value()); });
    connect(field, &NumberField::remarkChanged, this, [this, index, field] {
        m_rows[index].reason->showRemark(field->remark());
        emit refusalsChanged();
    });
    connect(field, &QLineEdit::editingFinished, this, [this] { m_document.endMerge(); });
    if (const ValueSlider* const slider = m_rows[index].slider) {
        connect(slider, &ValueSlider::valueEdited, this, [this, index, field](double value) {
            field->reset(value); // discards a refused text
            store(m_rows[index].line, value);
        });
        connect(slider, &ValueSlider::settled, this, [this] { m_document.endMerge(); });
    }
}

void NumberLines::store(const Line& line, std::optional<double> value) {
    Project project = m_document.project();
    line.set(project, value);
    m_document.edit(std::move(project), {"Input", m_editText}, QString::fromStdString(line.path));
}

void NumberLines::forgetPaste() {
    for (const Row& row : m_rows) {
        row.reason->showRemark(row.field->remark());
    }
}

void NumberLines::paste(std::size_t index, const PastedCells& cells) {
    forgetPaste();
    QString fault;
    const std::vector<QString> texts = m_order(cells, fault);
    Project project = m_document.project();
    if (fault.isEmpty()) {
        fault = pasteInto(project, texts.size() == m_rows.size() ? 0 : index, texts);
    }
    if (fault.isEmpty()) {
        m_document.endMerge();
        m_document.edit(std::move(project), {"Input", m_editText});
        showProject(true);
    } else {
        m_rows[index].reason->showRemark({Mark::error, tr("Not pasted: %1").arg(fault)});
    }
}

QString NumberLines::pasteInto(Project& project, std::size_t first,
                               const std::vector<QString>& cells) const {
    if (first + cells.size() > m_rows.size()) {
        return tr("%n cell(s) too many", nullptr,
                  static_cast<int>(first + cells.size() - m_rows.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Line& line = m_rows[first + i].line;
        const PastedNumbers number({{{cells[i]}}}, line.spec.hard, line.spec.unit);
        if (!number.fault().isEmpty()) {
            return tr("%1: %2", "label of a number: reason").arg(line.label(), number.fault());
        }
        line.set(project, number.rows()[0][0]);
    }
    return {};
}

/// Whether a value adds no fault to those of the batch.
bool NumberLines::fits(const Line& line, std::optional<double> value) const {
    Project project = m_document.project();
    const std::size_t before = batchFaults(project).size();
    line.set(project, value);
    return batchFaults(project).size() <= before;
}

void NumberLines::showProject(bool replaced) {
    const Project& project = m_document.project();
    for (const Row& row : m_rows) {
        const std::optional<double> value = row.line.get(project);
        replaced ? row.field->reset(value) : row.field->setValue(value);
        if (row.slider) {
            row.slider->display(row.line.slider(project), value, unitText(row.line.spec.unit));
        }
        const Calibration* const record = calibrationOf(project, row.line.path);
        row.calibrated->showCalibration(record && hasCalibratedValue(project, *record),
                                        record ? CalibrationText::details(project, *record)
                                               : QString());
    }
}

void NumberLines::setIssues(const Issues& issues) {
    m_issues = issues;
    for (const Row& row : m_rows) {
        row.field->setIssue(remarkFor(m_issues, row.line.path));
    }
}

void NumberLines::retranslate(const Row& row) {
    const QString name = row.line.label();
    const QString unit = unitText(row.line.spec.unit);
    row.label->setText(name);
    row.unit->setText(unit);
    row.field->retranslate();
    const QString full = m_names ? m_names(name) : name;
    row.field->setAccessibleName(unit.isEmpty() ? full : QStringLiteral("%1, %2").arg(full, unit));
    const QString hint = row.line.hint();
    row.field->setHint(hint);
    row.field->setToolTip(row.line.tip ? row.line.tip()
                                       : QStringLiteral("<p>%1</p>").arg(hint.toHtmlEscaped()));
    row.label->setToolTip(row.field->toolTip());
    if (row.slider) {
        row.slider->setToolTip(row.field->toolTip());
        row.slider->setAccessibleName(tr("%1, slider").arg(full));
    }
}

void NumberLines::retranslate() {
    forgetPaste();
    for (const Row& row : m_rows) {
        retranslate(row);
    }
    setIssues(Issues(m_issues));
}

std::vector<Refusal> NumberLines::refusals() const {
    std::vector<Refusal> list;
    for (const Row& row : m_rows) {
        if (row.field->refused()) {
            list.push_back({row.line.path, row.field->refusal()});
        }
    }
    return list;
}

bool NumberLines::dropRefusal(const std::string& path) {
    for (const Row& row : m_rows) {
        if (path == row.line.path && row.field->refused()) {
            row.field->reset(row.line.get(m_document.project()));
            return true;
        }
    }
    return false;
}

bool NumberLines::focusPath(const std::string& path) {
    for (const Row& row : m_rows) {
        if (row.line.path == path || row.line.path.starts_with(path + "/")) {
            row.field->setFocus(Qt::OtherFocusReason);
            return true;
        }
    }
    return false;
}

} // namespace sparkout
