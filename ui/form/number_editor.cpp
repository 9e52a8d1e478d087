// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/number_editor.h"

#include "core/project/machine_steps.h"
#include "core/project/member.h"
#include "ui/fields/value_slider.h"
#include "ui/session/slider_scale.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <utility>

namespace sparkout {

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

} // namespace sparkout
