// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/value_slider.h"

#include "ui/text/number_text.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

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

/// Reports the value of a ValueSlider in its own unit to screen readers; call once.
void installSliderAccessibility() {
    static const bool installed = [] {
        QAccessible::installFactory(makeInterface);
        return true;
    }();
    Q_UNUSED(installed);
}

constexpr int thickness = 14;
constexpr int usualWidth = 120;
constexpr int leastWidth = 60;
constexpr double handleRadius = 5;
constexpr double grooveHeight = 3;
constexpr int keyPause_ms = 700;
constexpr int wheelNotch = 120;

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto mix = [share](int x, int y) { return int(x + (y - x) * share); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

} // namespace

ValueSlider::ValueSlider(QWidget* parent) : QWidget(parent) {
    installSliderAccessibility();
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_pause.setSingleShot(true);
    m_pause.setInterval(keyPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &ValueSlider::settled);
}

void ValueSlider::display(const SliderSpec& spec, std::optional<double> value, const QString& unit,
                          const ShownScale& shown) {
    const bool another = value != m_value;
    if (another) {
        m_dragged.reset(); // it was changed elsewhere
    }
    m_value = value;
    m_unit = unit;
    m_shown = shown;
    const bool holds = value && *value >= m_scale.low() && *value <= m_scale.high();
    if (!dragging() && (spec != m_spec || !holds || m_scale.extended())) {
        m_spec = spec;
        m_scale = SliderScale(spec, value);
    }
    setEnabled(value.has_value());
    update();
    if (another) {
        QAccessibleValueChangeEvent changed(this, value.value_or(0));
        QAccessible::updateAccessibility(&changed);
    }
}

QSize ValueSlider::sizeHint() const {
    return {usualWidth, thickness};
}

QSize ValueSlider::minimumSizeHint() const {
    return {leastWidth, thickness};
}

QRectF ValueSlider::groove() const {
    const double margin = handleRadius + 1;
    return {margin, (double(height()) - grooveHeight) / 2, width() - 2 * margin, grooveHeight};
}

QPoint ValueSlider::handle() const {
    const QRectF along = groove();
    const double share = m_value ? m_scale.shareOf(*m_value) : 0;
    return QPointF(along.left() + share * along.width(), along.center().y()).toPoint();
}

double ValueSlider::shareAt(double x) const {
    return (x - groove().left()) / std::max(1.0, groove().width());
}

void ValueSlider::move(double value) {
    if (value == m_value) {
        return;
    }
    m_value = value;
    update();
    QAccessibleValueChangeEvent changed(this, value);
    QAccessible::updateAccessibility(&changed);
    emit valueEdited(value);
}

void ValueSlider::setByHand(double value) {
    if (isEnabled() && m_spec.allowed.contains(value)) {
        emit settled();
        move(m_spec.integer ? std::round(value) : value);
        emit settled();
    }
}

void ValueSlider::endDrag() {
    m_dragged.reset();
    update();
    emit settled();
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_value) {
        event->ignore();
        return;
    }
    m_pause.stop();
    emit settled();
    m_dragged = m_value;
    m_grip = event->position().x() - handle().x();
    if (std::abs(m_grip) > handleRadius + 1) {
        m_grip = 0; // beside the handle: the handle moves to the pointer
        move(m_scale.valueAt(shareAt(event->position().x())));
    }
    update();
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    if (dragging()) {
        move(m_scale.valueAt(shareAt(event->position().x() - m_grip)));
    }
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && dragging()) {
        endDrag();
    }
}

bool ValueSlider::event(QEvent* event) {
    // Escape belongs to the running drag, before any dialog or shortcut.
    if (event->type() == QEvent::ShortcutOverride && dragging()
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
    if (dragging()) {
        if (event->key() == Qt::Key_Escape) {
            move(*m_dragged);
            endDrag();
        }
        return; // the pointer leads
    }
    if (!m_value || (event->modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier) {
        QWidget::keyPressEvent(event);
        return;
    }
    double to = *m_value;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down: to = m_scale.stepped(to, -1); break;
    case Qt::Key_Right:
    case Qt::Key_Up: to = m_scale.stepped(to, 1); break;
    case Qt::Key_PageDown: to = m_scale.leapt(to, -1); break;
    case Qt::Key_PageUp: to = m_scale.leapt(to, 1); break;
    case Qt::Key_Home: to = m_scale.valueAt(0); break;
    case Qt::Key_End: to = m_scale.valueAt(1); break;
    default: QWidget::keyPressEvent(event); return;
    }
    m_pause.start();
    move(to);
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
    if (!hasFocus() || !m_value || dragging()) {
        event->ignore(); // the page scrolls
        return;
    }
    event->accept();
    m_wheel += event->angleDelta().y();
    const int steps = m_wheel / wheelNotch;
    m_wheel -= steps * wheelNotch;
    if (steps != 0) {
        m_pause.start();
        move(m_scale.stepped(*m_value, steps));
    }
}

void ValueSlider::focusOutEvent(QFocusEvent* event) {
    m_wheel = 0;
    if (m_pause.isActive()) {
        m_pause.stop();
        emit settled();
    }
    QWidget::focusOutEvent(event);
    update();
}

void ValueSlider::enterEvent(QEnterEvent* event) {
    QWidget::enterEvent(event);
    update();
}

void ValueSlider::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    update();
}

void ValueSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& colors = palette();
    const QColor window = colors.color(QPalette::Window);
    const QColor ink = colors.color(QPalette::WindowText);
    const QColor lead = isEnabled() ? colors.color(QPalette::Highlight) : mixed(window, ink, 0.3);
    const QRectF along = groove();
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(window, ink, 0.22));
    painter.drawRoundedRect(along, grooveHeight / 2, grooveHeight / 2);
    if (!m_value) {
        return;
    }
    const QPointF middle(handle().x(), along.center().y());
    QRectF before = along;
    before.setRight(middle.x());
    painter.setBrush(lead);
    painter.drawRoundedRect(before, grooveHeight / 2, grooveHeight / 2);
    painter.setBrush(dragging() || underMouse() ? lead : colors.color(QPalette::Base));
    painter.setPen(QPen(lead, 1.5));
    painter.drawEllipse(middle, handleRadius - 0.5, handleRadius - 0.5);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(lead, 1));
        painter.drawEllipse(middle, handleRadius + 1, handleRadius + 1);
    }
}

} // namespace sparkout
