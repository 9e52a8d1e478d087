// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/range_editor.h"

#include "ui/fields/number_field.h"
#include "ui/inputs/editors/form_metrics.h"
#include "ui/kit/font_size.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int longestUnit = 8; ///< longest unit on one line

} // namespace

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

} // namespace sparkout
