// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/hint_strip.h"

#include "ui/inputs/form_metrics.h"
#include "ui/kit/help_topic.h"
#include "ui/text/hint_text.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

namespace sparkout {

namespace {

constexpr const char* fieldProperty = "sparkoutField";
constexpr int lines = 4;

/// The widget or its nearest parent on the page with a tool tip. Buttons show their own.
const QWidget* withToolTip(const QWidget* widget) {
    if (qobject_cast<const QAbstractButton*>(widget)) {
        return nullptr;
    }
    for (; widget && !qobject_cast<const QAbstractScrollArea*>(widget);
         widget = widget->parentWidget()) {
        if (!widget->toolTip().isEmpty()) {
            return widget;
        }
    }
    return nullptr;
}

} // namespace

void setHintField(QWidget& widget, const Field& field) {
    widget.setProperty(fieldProperty, QVariant::fromValue(static_cast<const void*>(&field)));
    setHelpTopic(widget, fieldTopic(field));
}

const Field* hintField(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
        if (const QVariant found = widget->property(fieldProperty); found.isValid()) {
            return static_cast<const Field*>(found.value<const void*>());
        }
    }
    return nullptr;
}

HintStrip::HintStrip(QWidget* parent) : QFrame(parent), m_text(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::margin, metrics::row, metrics::margin, metrics::row);
    setObjectName(QStringLiteral("hintStrip"));
    m_text->setTextFormat(Qt::RichText);
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    layout->addWidget(m_text);
    fitFont();
    connect(qApp, &QApplication::focusChanged, this,
            [this](const QWidget*, const QWidget* now) { follow(now); });
    retranslate();
}

HintStrip::~HintStrip() {
    disconnect(qApp, nullptr, this, nullptr);
}

void HintStrip::fitFont() {
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * noteType);
    m_text->setFont(small);
    m_text->setMinimumHeight(lines * QFontMetrics(small).lineSpacing());
}

void HintStrip::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fitFont();
    }
}

void HintStrip::follow(const QWidget* focused) {
    if (!focused || !parentWidget()->isAncestorOf(focused) || focused == m_helper) {
        return;
    }
    if (const Field* field = hintField(focused)) {
        showField(*field);
    } else if (const QWidget* helper = withToolTip(focused)) {
        m_field = nullptr;
        m_helper = helper;
        fill();
    }
}

void HintStrip::showField(const Field& field) {
    if (&field != m_field) {
        m_field = &field;
        m_helper = nullptr;
        fill();
    }
}

void HintStrip::showFieldOf(const QWidget* widget) {
    m_field = hintField(widget);
    m_helper = m_field || !widget ? nullptr : withToolTip(widget);
    fill();
}

void HintStrip::fill() {
    if (m_helper) {
        m_text->setText(ToolTips::markup(m_helper->toolTip()));
        return;
    }
    if (!m_field) {
        m_text->setText(tr("Help on the selected input appears here."));
        return;
    }
    const QString limits = limitsMarkup(*m_field);
    const QString meaning = meaningMarkup(*m_field);
    m_text->setText(limits.isEmpty() ? meaning : QStringLiteral("%1<br>%2").arg(limits, meaning));
}

void HintStrip::retranslate() {
    setAccessibleName(tr("About the input in focus"));
    fill();
}

} // namespace sparkout
