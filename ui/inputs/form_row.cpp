// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/form_row.h"

#include "ui/inputs/number_field.h"
#include "ui/metrics.h"
#include "ui/session/member.h"
#include "ui/session/texts.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>

namespace sparkout {

namespace {

constexpr int fieldWidth = metrics::field;
constexpr int unitWidth = metrics::unit;
constexpr int wideWidth = metrics::fieldWide;

} // namespace

QString labelMarkup(const Field& field) {
    QString symbol = QString::fromUtf8(field.symbol).toHtmlEscaped();
    static const QRegularExpression index(QStringLiteral("_(\\w+)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    symbol.replace(index, QStringLiteral("<sub>\\1</sub>"));
    const QString label = inputText(field.label).toHtmlEscaped();
    return symbol.isEmpty() ? label : QStringLiteral("%1 <i>%2</i>").arg(label, symbol);
}

QString hintMarkup(const Field& field) {
    QString html = QStringLiteral("<p>%1</p>").arg(inputText(field.hint).toHtmlEscaped());
    const auto line = [&html](const QString& text) {
        html += QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
    };
    if (!field.hard.unbounded()) {
        line(FormRow::tr("Allowed: %1").arg(rangeShown(field.hard, field.unit)));
    }
    if (!field.soft.unbounded()) {
        line(FormRow::tr("Usual: %1").arg(rangeShown(field.soft, field.unit)));
    }
    if (*field.nullMeaning) {
        line(FormRow::tr("Empty: %1").arg(inputText(field.nullMeaning)));
    }
    if (*field.source) {
        line(FormRow::tr("Source: %1").arg(QString::fromUtf8(field.source)));
    }
    return html;
}

FormRow::FormRow(std::unique_ptr<FieldEditor> editor, QGridLayout& grid, QWidget* parent)
    : m_editor(std::move(editor))
    , m_label(new QLabel(parent))
    , m_unit(new QLabel(parent))
    , m_reason(new QLabel(parent)) {
    m_label->setTextFormat(Qt::RichText);
    m_label->setWordWrap(true);
    m_label->setBuddy(m_editor->widget());
    m_unit->setTextFormat(Qt::PlainText);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setWordWrap(true);
    m_reason->setVisible(false);
    m_editor->widget()->setObjectName(QString::fromStdString(m_editor->path()));
    connect(m_editor.get(), &FieldEditor::remarkChanged, this, &FormRow::showRemark);
    addTo(grid);
}

void FormRow::addTo(QGridLayout& grid) {
    const int row = grid.rowCount();
    QWidget* const field = m_editor->widget();
    if (m_editor->tall()) {
        grid.addWidget(m_label, row, 0, 1, 3);
        grid.addWidget(field, row + 1, 0, 1, 3);
    } else if (m_editor->wide()) {
        field->setFixedWidth(wideWidth);
        grid.addWidget(m_label, row, 0);
        grid.addWidget(field, row, 1, 1, 2);
    } else {
        field->setFixedWidth(fieldWidth);
        m_unit->setMinimumWidth(unitWidth);
        grid.addWidget(m_label, row, 0);
        grid.addWidget(field, row, 1);
        grid.addWidget(m_unit, row, 2);
    }
    grid.addWidget(m_reason, row + 2, 0, 1, 3);
    m_unit->setVisible(!m_editor->wide());
}

void FormRow::show(const Project& project, bool replaced) {
    const ConstMember member = findMember(project, m_editor->path());
    m_relevant = member && member.relevant(project);
    for (QWidget* widget : {static_cast<QWidget*>(m_label), m_editor->widget()}) {
        widget->setVisible(m_relevant);
    }
    m_unit->setVisible(m_relevant && !m_editor->wide());
    m_editor->show(replaced);
    showRemark();
}

void FormRow::setIssues(const Issues& issues) {
    m_editor->setIssue(remarkFor(issues, m_editor->path()));
}

bool FormRow::meaningIsLong() const {
    const QString meaning = inputText(m_editor->field().nullMeaning);
    return m_editor->widget()->fontMetrics().horizontalAdvance(meaning) > fieldWidth - 12;
}

QString FormRow::emptyCaption() const {
    const auto* line = qobject_cast<QLineEdit*>(m_editor->widget());
    if (!line || !m_editor->empty()) {
        return {};
    }
    return meaningIsLong() ? tr("empty: %1").arg(inputText(m_editor->field().nullMeaning))
                           : QString();
}

void FormRow::showRemark() {
    const Remark remark = m_editor->remark();
    const QString text = remark.mark == Mark::none ? emptyCaption() : remark.reason;
    QPalette colors = m_label->palette();
    colors.setColor(QPalette::WindowText, remark.mark == Mark::none
                                              ? colors.color(QPalette::PlaceholderText)
                                              : markColor(remark.mark, colors));
    m_reason->setPalette(colors);
    m_reason->setText(text);
    m_reason->setVisible(m_relevant && !text.isEmpty());
}

void FormRow::retranslate() {
    const Field& field = m_editor->field();
    m_editor->retranslate();
    m_label->setText(labelMarkup(field));
    m_unit->setText(unitText(field.unit));
    const QString hint = hintMarkup(field);
    m_label->setToolTip(hint);
    QWidget* const widget = m_editor->widget();
    widget->setToolTip(hint);
    widget->setAccessibleName(*field.unit
                                  ? tr("%1, %2").arg(inputText(field.label), unitText(field.unit))
                                  : inputText(field.label));
    if (auto* line = qobject_cast<NumberField*>(widget); line && meaningIsLong()) {
        line->setPlaceholderText(QStringLiteral("—")); // its meaning stands below
    }
    showRemark();
}

} // namespace sparkout
