// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/number_field.h"

#include "ui/text/calculation.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QToolTip>

#include <cmath>

namespace sparkout {

/// A line of text is not a block of cells, whatever separates its words.
bool CellsLineEdit::takeCells() {
    const QMimeData* const copied = QGuiApplication::clipboard()->mimeData();
    const QString text = copied ? copied->text().trimmed() : QString();
    const bool block = text.isEmpty() || text.contains(u'\n') || text.contains(u'\t');
    const PastedCells cells = PastedCells::of(copied);
    if (!m_take || isReadOnly() || !block || cells.empty() || cells.single()) {
        return false;
    }
    m_take(cells);
    return true;
}

void CellsLineEdit::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Paste) && takeCells()) {
        event->accept();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void CellsLineEdit::contextMenuEvent(QContextMenuEvent* event) {
    QMenu* const menu = createStandardContextMenu();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (auto* paste = menu->findChild<QAction*>(QStringLiteral("edit-paste")); paste && m_take) {
        paste->disconnect(SIGNAL(triggered()));
        paste->disconnect(SIGNAL(triggered(bool)));
        connect(paste, &QAction::triggered, this, [this] {
            if (!takeCells()) {
                QLineEdit::paste();
            }
        });
    }
    menu->popup(event->globalPos());
    event->accept();
}

namespace {

constexpr int typingPause_ms = 800;

} // namespace

NumberSpec NumberSpec::of(const Field& field) {
    NumberSpec spec{field.stated(), field.soft, field.unit, false, false, field.nullMeaning};
    spec.integer = field.kind == Kind::integer || field.kind == Kind::optionalInteger;
    spec.scale = ShownScale::ofInput(field);
    spec.optional = field.kind == Kind::optionalNumber || field.kind == Kind::optionalInteger;
    return spec;
}

NumberSpec NumberSpec::of(const Field& field, const Project& project, const void* owner) {
    NumberSpec spec = of(field);
    spec.hard = field.allowed(project, owner);
    return spec;
}

NumberField::NumberField(const NumberSpec& spec, QWidget* parent)
    : CellsLineEdit(parent), m_spec(spec), m_icon(addAction(QIcon(), TrailingPosition)) {
    m_icon->setVisible(false);
    m_typing.setSingleShot(true);
    m_typing.setInterval(typingPause_ms);
    connect(&m_typing, &QTimer::timeout, this, &NumberField::endTyping);
    connect(this, &QLineEdit::textEdited, this, [this] {
        m_typing.start();
        evaluate();
        showResult();
    });
    connect(this, &QLineEdit::returnPressed, this, &NumberField::settle);
    retranslate();
}

void NumberField::setValue(std::optional<double> value) {
    if (value != m_value) {
        reset(value);
        return;
    }
    if (!refused() && !m_waits && read() != value) {
        showValue();
    }
}

void NumberField::reset(std::optional<double> value) {
    const bool asTyped = !refused() && value && read() == value;
    m_value = value;
    m_settled = value;
    m_waits = false;
    if (!asTyped) {
        showValue();
    }
    std::optional<double> same;
    m_own = judge(same);
    updateRemark();
}

QString NumberField::written(double value) const {
    return showNumber(m_spec.scale.shown(value), QLocale());
}

void NumberField::showValue() {
    m_typing.stop();
    setText(m_value ? written(*m_value) : QString());
    describe();
}

void NumberField::setShownText(const QString& text) {
    setText(text);
    m_typing.stop();
    evaluate();
}

void NumberField::setSpec(const NumberSpec& spec) {
    if (spec == m_spec) {
        return;
    }
    const bool another = spec.scale != m_spec.scale;
    if (another && typing()) {
        settle(); // it was typed in the old one
    }
    m_spec = spec;
    if (another && !refused()) {
        showValue();
    }
    if (m_value || refused()) {
        evaluate();
    }
}

void NumberField::setHint(const QString& hint) {
    m_hint = hint;
    describe();
}

void NumberField::describe() {
    QStringList said{result(), m_shown.reason, m_hint};
    setAccessibleDescription(joined(said, QStringLiteral(". ")));
}

void NumberField::setIssue(const Remark& issue) {
    m_issue = issue;
    updateRemark();
}

Remark NumberField::remark() const {
    if (typing()) {
        return {};
    }
    if (refused()) {
        return m_own;
    }
    return m_issue.mark >= m_own.mark && m_issue.mark != Mark::none ? m_issue : m_own;
}

Remark NumberField::judge(std::optional<double>& value) const {
    if (text().trimmed().isEmpty()) { // the inputs report a value never given
        return m_spec.optional || !m_settled ? Remark{}
                                             : Remark{Mark::error, tr("a number is needed here")};
    }
    const auto calculation = Calculation::of(text());
    value = read();
    if (value) {
        return judgeNumber(*value);
    }
    return {Mark::error,
            calculation ? calculation->fault() : tr("“%1” is not a number").arg(text().trimmed())};
}

Remark NumberField::judgeNumber(double value) const {
    if (m_spec.integer && value != std::floor(value)) {
        return {Mark::error, tr("a whole number is needed here")};
    }
    if (!m_spec.hard.contains(value)) {
        return {Mark::error, tr("out of range; allowed: %1")
                                 .arg(rangeShown(m_spec.scale.shown(m_spec.hard), m_spec.unit))};
    }
    const bool isDrawnBack = value < 0 && m_spec.soft.low > 0; // if that is allowed
    if (!m_spec.soft.contains(value) && !isDrawnBack) {
        return {
            Mark::warning,
            tr("unusual; usual: %1").arg(rangeShown(m_spec.scale.shown(m_spec.soft), m_spec.unit))};
    }
    return {};
}

std::optional<double> NumberField::readForm() const {
    return m_reads && !parseNumber(text()) ? m_reads(text()) : std::nullopt;
}

std::optional<double> NumberField::read() const {
    if (const auto value = readForm()) {
        return value;
    }
    const auto calculation = Calculation::of(text());
    return m_spec.scale.kept(calculation ? calculation->value() : parseNumber(text()));
}

QString NumberField::result() const {
    const auto calculation = Calculation::of(text());
    const auto form = readForm();
    if (!form && (!calculation || !calculation->value())) {
        return {};
    }
    const QString unit = unitText(m_spec.unit);
    return QStringLiteral("= ")
           + printedNumber(form ? m_spec.scale.shown(*form) : *calculation->value())
           + (unit.isEmpty() ? QString() : QStringLiteral("\u00a0") + unit);
}

void NumberField::showResult() {
    const QString shown = result();
    if (!shown.isEmpty() && hasFocus()) {
        QToolTip::showText(mapToGlobal(rect().bottomLeft()), shown, this);
    } else if (QToolTip::isVisible()) {
        QToolTip::hideText();
    }
    describe();
}

void NumberField::evaluate() {
    std::optional<double> value;
    m_own = judge(value);
    m_waits = !refused() && typing() && value != m_settled
              && (!result().isEmpty() || (m_fits && !m_fits(value)));
    if (refused() || m_waits) {
        value = m_settled; // never the beginning of a number that did not become one
    }
    const bool another = value != m_value;
    m_value = value;
    updateRemark();
    if (another) {
        emit valueEdited();
    }
}

void NumberField::revert() {
    const bool another = unsettled();
    m_value = m_settled;
    m_waits = false;
    m_own = {};
    showValue();
    std::optional<double> same;
    m_own = judge(same);
    updateRemark();
    if (another) {
        emit valueEdited();
    }
}

void NumberField::clearText() {
    selectAll();
    del();
    m_typing.start();
    evaluate();
}

void NumberField::endTyping() {
    m_typing.stop();
    m_waits ? evaluate() : updateRemark();
}

bool NumberField::unsettled() const {
    return refused() || m_waits || m_value != m_settled;
}

void NumberField::settle() {
    endTyping();
    if (!refused()) {
        m_settled = m_value;
    }
    if (!refused() && m_value && text() != written(*m_value)) {
        showValue();
    }
    if (QToolTip::isVisible() && hasFocus()) {
        QToolTip::hideText(); // the result is in the field
    }
    updateRemark();
}

QString NumberField::stepped(int steps) const {
    const auto value = read();
    const auto next = m_steps && value ? m_steps(*value, steps) : std::nullopt;
    return next ? written(*next)
                : stepNumber(text(), steps, m_spec.integer || m_spec.hard.contains(0));
}

void NumberField::step(int steps) {
    if (refused()) {
        return;
    }
    if (!result().isEmpty()) {
        settle();
    }
    if (text().trimmed().isEmpty()) {
        return;
    }
    const QString after = stepped(steps);
    const auto value = m_spec.scale.kept(parseNumber(after));
    if (value && m_spec.hard.contains(*value)) {
        setText(after);
        evaluate();
        selectAll();
    }
}

void NumberField::updateRemark() {
    const Remark shown = remark();
    if (shown.mark == m_shown.mark && shown.reason == m_shown.reason) {
        return;
    }
    m_shown = shown;
    m_icon->setVisible(shown.mark == Mark::warning || shown.mark == Mark::error);
    m_icon->setIcon(markIcon(shown.mark));
    m_icon->setToolTip(shown.reason);
    describe();
    update();
    emit remarkChanged();
}

void NumberField::retranslate() {
    setPlaceholderText(m_spec.optional ? inputText(m_spec.nullMeaning) : QString());
    if (!refused() && !m_waits) {
        showValue();
    }
    std::optional<double> same;
    if (m_value || m_spec.optional || refused()) {
        m_own = judge(same);
    }
    updateRemark();
}

bool NumberField::event(QEvent* event) {
    // Undo and redo belong to the document; only a refused text is undone here.
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->setAccepted((refused() || m_waits) && key->matches(QKeySequence::Undo));
            return true;
        }
    }
    return CellsLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if ((unsettled() && event->key() == Qt::Key_Escape)
        || ((refused() || m_waits) && event->matches(QKeySequence::Undo))) {
        revert();
    } else if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        step(event->key() == Qt::Key_Up ? 1 : -1);
    } else {
        CellsLineEdit::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event) {
    event->ignore();
} // the page scrolls

void NumberField::focusOutEvent(QFocusEvent* event) {
    settle();
    CellsLineEdit::focusOutEvent(event);
}

void NumberField::paintEvent(QPaintEvent* event) {
    CellsLineEdit::paintEvent(event);
    const Mark mark = remark().mark;
    if (mark != Mark::none) {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(markColor(mark, palette()), 2,
                            mark == Mark::missing ? Qt::DashLine : Qt::SolidLine));
        painter.drawRoundedRect(rect().adjusted(1, 1, -1, -1), 2, 2);
    }
}

} // namespace sparkout
