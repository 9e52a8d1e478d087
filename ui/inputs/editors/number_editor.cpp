// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/number_editor.h"

#include "core/project/machine_steps.h"
#include "core/project/member.h"
#include "ui/fields/value_slider.h"
#include "ui/session/document.h"
#include "ui/text/shown_scale.h"
#include "ui/text/stock_reading.h"
#include "ui/text/texts.h"

namespace sparkout {

NumberEditor::NumberEditor(const std::string& path, const Field& field, Document& document,
                           QWidget* parent)
    : FieldEditor(path, field, document), m_field(new NumberField(NumberSpec::of(field), parent)) {
    m_field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(m_field, &NumberField::valueEdited, this, [this] { store(m_field->value()); });
    m_field->setFits([this](std::optional<double> value) {
        return fits([this, value](void* to) { setNumberIn(this->field(), to, value); });
    });
    m_field->setSteps([this](double value, int steps) {
        return steppedOnMachine(this->document().project(), this->path(), value, steps);
    });
    connect(m_field, &NumberField::remarkChanged, this, &FieldEditor::remarkChanged);
    connect(m_field, &QLineEdit::editingFinished, this, [this] { this->document().endMerge(); });
    if (field.slider) {
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
    connect(m_slider, &ValueSlider::settled, this, [this] { document().endMerge(); });
}

QWidget* NumberEditor::slider() const {
    return m_slider;
}

std::optional<double> NumberEditor::stored() const {
    return document().isOpen(path()) ? std::nullopt : numberIn(field(), owner());
}

void NumberEditor::store(std::optional<double> value) {
    const bool needed = field().kind == Kind::number || field().kind == Kind::integer;
    if (!value && needed) { // typed and deleted again
        document().withdraw(path(), {"Input", field().label});
        return;
    }
    change([this, value](void* to) { setNumberIn(field(), to, value); });
}

void NumberEditor::show(bool replaced) {
    replaced ? m_field->reset(stored()) : m_field->setValue(stored());
    if (m_slider) {
        m_slider->display(sliderSpec(document().project(), path(), field()), stored(),
                          unitText(field().unit), ShownScale::ofInput(field()));
    }
}

void NumberEditor::retranslate() {
    m_field->setSpec(NumberSpec::of(field()));
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

} // namespace sparkout
