// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/value_slider_accessible.h"

#include "ui/fields/value_slider.h"
#include "ui/text/number_text.h"

#include <QAccessibleWidget>

namespace sparkout {

namespace {

class SliderInterface : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    explicit SliderInterface(ValueSlider* slider)
        : QAccessibleWidget(slider, QAccessible::Slider), m_slider(slider) {}

    QString text(QAccessible::Text kind) const override {
        if (kind == QAccessible::Value && m_slider->value()) {
            const QString number = printedNumber(shown(*m_slider->value()));
            return m_slider->unit().isEmpty() ? number : number + u' ' + m_slider->unit();
        }
        return QAccessibleWidget::text(kind);
    }

    void* interface_cast(QAccessible::InterfaceType type) override {
        return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface*>(this)
                                                   : QAccessibleWidget::interface_cast(type);
    }

    QVariant currentValue() const override { return shown(m_slider->value().value_or(0)); }
    void setCurrentValue(const QVariant& value) override {
        m_slider->setByHand(m_slider->shown().kept(value.toDouble()));
    }
    QVariant maximumValue() const override { return shown(m_slider->scale().high()); }
    QVariant minimumValue() const override { return shown(m_slider->scale().low()); }
    QVariant minimumStepSize() const override {
        const double value = m_slider->value().value_or(0);
        return shown(m_slider->scale().stepped(value, 1)) - shown(value);
    }

private:
    double shown(double value) const { return m_slider->shown().shown(value); }

    ValueSlider* m_slider;
};

QAccessibleInterface* makeInterface(const QString&, QObject* object) {
    auto* slider = qobject_cast<ValueSlider*>(object);
    return slider ? new SliderInterface(slider) : nullptr;
}

} // namespace

void installSliderAccessibility() {
    static const bool installed = [] {
        QAccessible::installFactory(makeInterface);
        return true;
    }();
    Q_UNUSED(installed);
}

} // namespace sparkout
