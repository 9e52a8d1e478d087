// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_axis_box.h"

#include "core/project/sweep.h"
#include "ui/fields/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/search_combo.h"
#include "ui/kit/tool_row.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"
#include "ui/views/sweep/sweep_shown.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int sweepFieldWidth = 74; ///< [px]

} // namespace

SweepAxisBox::SweepAxisBox(std::size_t place, QWidget* parent)
    : QWidget(parent)
    , m_place(place)
    , m_input(new SearchCombo(this))
    , m_from(new NumberField({}, this))
    , m_to(new NumberField({}, this))
    , m_dash(new QLabel(QStringLiteral("…"), this))
    , m_unit(new QLabel(this))
    , m_points(new QSpinBox(this))
    , m_ratios(new QCheckBox(this)) {
    m_input->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_unit->setTextFormat(Qt::PlainText);
    const Field& points = *tableOf<SweepAxis>().find("points");
    m_points->setRange(static_cast<int>(points.hard.low), static_cast<int>(points.hard.high));
    m_points->setKeyboardTracking(false);
    auto* row = new ToolRow(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_input, 1);
    for (NumberField* field : {m_from, m_to}) {
        setTextWidth(*field, sweepFieldWidth);
        row->addWidget(field);
        connect(field, &QLineEdit::editingFinished, this, &SweepAxisBox::onRange);
        if (field == m_from) {
            row->addWidget(m_dash);
        }
    }
    row->addWidget(m_unit);
    row->addWidget(m_points);
    row->addWidget(m_ratios);
    const QString name = QStringLiteral("sweep%1").arg(m_place + 1);
    m_input->setObjectName(name + QStringLiteral("Input"));
    m_from->setObjectName(name + QStringLiteral("From"));
    m_to->setObjectName(name + QStringLiteral("To"));
    m_points->setObjectName(name + QStringLiteral("Points"));
    m_ratios->setObjectName(name + QStringLiteral("Ratios"));
    connect(m_input, &QComboBox::activated, this, &SweepAxisBox::onInput);
    connect(m_points, &QSpinBox::valueChanged, this, &SweepAxisBox::onRange);
    connect(m_ratios, &QCheckBox::clicked, this, &SweepAxisBox::onRange);
    m_input->addItem(QString());
    showAxis({});
}

void SweepAxisBox::show(const Project& project) {
    const auto* const axes = project.sweep ? &project.sweep->inputs : nullptr;
    m_axis = axes && m_place < axes->size() ? std::optional((*axes)[m_place]) : std::nullopt;
    m_of = m_axis ? numberInput(project, m_axis->input) : std::nullopt;
    fillInputs(numberInputs(project));
    m_input->setEnabled(m_place == 0 || axes);
    showAxis(m_of);
}

/// Its English name in any language, its symbol and its key.
QString SweepAxisBox::wordsOf(const NumberInput& input) {
    const QString symbol = QString::fromUtf8(input.field->symbol);
    return QStringList{QString::fromUtf8(input.field->label), symbol, QString(symbol).remove(u'_'),
                       QString::fromStdString(input.path)}
        .join(u'\n');
}

/// Updates only after a change, since the list may be open. A removed input stays while it is
/// varied.
void SweepAxisBox::fillInputs(const std::vector<NumberInput>& inputs) {
    std::vector<std::string> paths;
    for (const NumberInput& input : inputs) {
        paths.push_back(input.path);
    }
    if (m_axis && !m_of) {
        paths.push_back(m_axis->input);
    }
    const QSignalBlocker blocker(m_input);
    if (paths != m_paths || m_input->count() != static_cast<int>(paths.size()) + 1) {
        m_paths = std::move(paths);
        m_input->clear();
        m_input->addItem(m_place == 0 ? tr("Choose an input to vary") : tr("no second input"));
        for (std::size_t i = 0; i < m_paths.size(); ++i) {
            const std::string& path = m_paths[i];
            const bool there = i < inputs.size();
            m_input->addItem(there ? SweepText::input(path)
                                   : tr("%1 (not in this project)").arg(SweepText::input(path)));
            if (there) {
                m_input->setItemData(int(i) + 1, wordsOf(inputs[i]), SearchCombo::wordsRole);
            }
        }
    }
    const auto at = m_axis ? std::ranges::find(m_paths, m_axis->input) : m_paths.end();
    m_input->setCurrentIndex(at == m_paths.end() ? 0 : static_cast<int>(at - m_paths.begin()) + 1);
    m_input->setToolTip(m_axis ? m_input->currentText() : m_input->accessibleName());
}

void SweepAxisBox::showAxis(const std::optional<NumberInput>& input) {
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_from, m_dash, m_to, m_unit, m_points, m_ratios}) {
        part->setVisible(m_axis.has_value());
    }
    if (!m_axis) {
        return;
    }
    NumberSpec spec;
    if (input) {
        spec.hard = input->allowed;
        spec.soft = input->field->soft;
        spec.unit = input->field->unit;
        spec.integer = input->integer;
        spec.scale = ShownScale::of(*input->field);
    }
    const QSignalBlocker points(m_points), ratios(m_ratios);
    const auto set = [&spec](NumberField& field, double value) {
        if (!field.typing()) { // otherwise typed text is applied when complete
            field.setSpec(spec);
            field.setValue(value);
        }
    };
    set(*m_from, m_axis->from);
    set(*m_to, m_axis->to);
    m_unit->setText(unitText(spec.unit));
    m_unit->setVisible(*spec.unit);
    m_points->setValue(m_axis->points);
    m_ratios->setChecked(m_axis->spacing == SweepSpacing::logarithmic);
}

void SweepAxisBox::onInput() {
    const auto index = static_cast<std::size_t>(m_input->currentIndex());
    const std::string path = index == 0 ? std::string() : m_paths[index - 1];
    if (path != (m_axis ? m_axis->input : std::string())) {
        emit inputChosen(path);
    }
}

void SweepAxisBox::onRange() {
    if (!m_axis) {
        return;
    }
    SweepAxis axis = *m_axis;
    axis.from = m_from->value().value_or(axis.from);
    axis.to = m_to->value().value_or(axis.to);
    axis.points = m_points->value();
    axis.spacing = m_ratios->isChecked() ? SweepSpacing::logarithmic : SweepSpacing::linear;
    if (axis.from != m_axis->from || axis.to != m_axis->to || axis.points != m_axis->points
        || axis.spacing != m_axis->spacing) {
        m_axis = axis;
        emit axisEdited(axis);
    }
}

void SweepAxisBox::retranslate() {
    const bool first = m_place == 0;
    const auto name = [](QWidget& widget, const QString& text) {
        widget.setAccessibleName(text);
        widget.setToolTip(text);
    };
    name(*m_input, first ? tr("First input varied") : tr("Second input varied"));
    name(*m_from, first ? tr("First input: from") : tr("Second input: from"));
    name(*m_to, first ? tr("First input: to") : tr("Second input: to"));
    name(*m_points,
         first ? tr("First input: number of points") : tr("Second input: number of points"));
    name(*m_ratios, first ? tr("First input: points at equal ratios instead of equal steps")
                          : tr("Second input: points at equal ratios instead of equal steps"));
    m_points->setPrefix(tr("points: "));
    m_ratios->setText(tr("log", "scale of a sweep"));
    m_paths.clear(); // their names have changed
    m_from->retranslate();
    m_to->retranslate();
}

} // namespace sparkout
