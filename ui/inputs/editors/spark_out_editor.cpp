// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/spark_out_editor.h"

#include "core/project/cycle.h"
#include "ui/fields/number_field.h"
#include "ui/form/choice_editor.h"
#include "ui/kit/font_size.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>

#include <utility>

namespace sparkout {

SparkOutEditor::SparkOutEditor(const Field& field, const Operation& operation, QWidget* parent)
    : QWidget(parent), m_mode(new StillComboBox(this)) {
    const bool strokes = operation->travels;
    NumberSpec spec;
    spec.hard = field.hard;
    spec.integer = true;
    m_count = new NumberField(spec, this);
    setTextWidth(*m_count, 56);
    m_count->setAccessibleName(strokes ? tr("Double strokes of spark-out")
                                       : tr("Revolutions of spark-out"));
    m_mode->addItem(tr("none"), int(SparkOut::Mode::none));
    m_mode->addItem(strokes ? tr("double strokes") : tr("revolutions"), int(SparkOut::Mode::count));
    m_mode->addItem(tr("until size"), int(SparkOut::Mode::untilSize));
    m_mode->setAccessibleName(inputText(field.label));
    m_mode->installEventFilter(this);
    setAutoFillBackground(true);
    setFocusProxy(m_mode);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_mode, 1);
    layout->addWidget(m_count);
    connect(m_mode, &QComboBox::activated, this, [this] {
        showCount();
        emit edited();
    });
    connect(m_count, &NumberField::valueEdited, this, &SparkOutEditor::edited);
    connect(m_count, &NumberField::remarkChanged, this, &SparkOutEditor::edited);
    connect(m_count, &QLineEdit::returnPressed, this, &SparkOutEditor::leave);
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (now && !holds(now)) {
            leave();
        }
    });
}

SparkOutEditor::~SparkOutEditor() {
    disconnect(qApp, nullptr, this, nullptr); // the focus moves while it is deleted
}

void SparkOutEditor::leave() {
    if (!std::exchange(m_left, true)) { // closing moves the focus, which would leave again
        if (m_count->hasFocus()) {
            setFocusProxy(m_count); // the table sets the focus here and stays at its cell
        }
        emit left();
    }
}

/// Moves from the choice to the count; the table would treat Tab as leaving the cell.
bool SparkOutEditor::focusNextPrevChild(bool next) {
    if (m_count->isVisible() && (next ? m_mode->hasFocus() : m_count->hasFocus())) {
        (next ? static_cast<QWidget*>(m_count) : m_mode)
            ->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
        return true;
    }
    return QWidget::focusNextPrevChild(next);
}

/// A digit selects a number of spark-outs, whatever was chosen.
bool SparkOutEditor::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_mode && event->type() == QEvent::KeyPress) {
        const QString text = static_cast<QKeyEvent*>(event)->text();
        if (!text.isEmpty() && text.front().isDigit()) {
            setMode(SparkOut::Mode::count);
            showCount();
            m_count->setFocus(Qt::OtherFocusReason);
            m_count->selectAll();
            QApplication::sendEvent(m_count, event);
            emit edited();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

/// Includes windows of its own, such as the list of choices.
bool SparkOutEditor::holds(const QWidget* widget) const {
    while (widget && widget != this) {
        widget = widget->parentWidget();
    }
    return widget;
}

SparkOut::Mode SparkOutEditor::mode() const {
    return static_cast<SparkOut::Mode>(m_mode->currentData().toInt());
}

void SparkOutEditor::setMode(SparkOut::Mode mode) {
    m_mode->setCurrentIndex(m_mode->findData(int(mode)));
}

void SparkOutEditor::putInto(Stage& stage) const {
    const int count = static_cast<int>(m_count->value().value_or(1));
    stage.spark_out = {mode(), mode() == SparkOut::Mode::count ? count : 0};
}

void SparkOutEditor::showStage(const Stage& stage) {
    const SparkOut& value = stage.spark_out;
    m_before = m_before.value_or(value);
    setMode(value.mode);
    if (value.mode == SparkOut::Mode::count || !m_count->value()) {
        m_count->setValue(value.count > 0 ? value.count : 3);
    }
    showCount();
}

void SparkOutEditor::revert() {
    if (m_before) {
        setMode(m_before->mode);
        m_count->reset(m_before->count > 0 ? m_before->count : m_count->value());
        showCount();
        emit edited();
    }
}

bool SparkOutEditor::refused() const {
    return mode() == SparkOut::Mode::count && m_count->refused() && !m_count->typing();
}

QString SparkOutEditor::refusedText() const {
    return m_count->text();
}

QString SparkOutEditor::refusal() const {
    return m_count->refusal();
}

void SparkOutEditor::showRefused(const QString& text) {
    m_count->setShownText(text);
}

void SparkOutEditor::showCount() {
    m_count->setVisible(mode() == SparkOut::Mode::count);
}

} // namespace sparkout
