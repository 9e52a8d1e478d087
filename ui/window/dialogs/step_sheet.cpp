// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/step_sheet.h"

#include "core/quality/visit_sheet.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/report/format/form_sheet.h"
#include "ui/report/format/formula_writer.h"
#include "ui/text/formula_text.h"
#include "ui/text/names.h"

#include <QAbstractTextDocumentLayout>
#include <QComboBox>
#include <QEvent>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFragment>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {

constexpr double boxPoints = 10; ///< the boxes are laid out in this size and scaled
constexpr int numberProperty = QTextFormat::UserProperty + 1;
constexpr int textProperty = QTextFormat::UserProperty + 2;
constexpr double leastScale = 0.6; ///< least legible scale of a compressed formula

double axisHeight() {
    return QFontMetricsF(report::reportFont(boxPoints)).xHeight() / 2;
}

} // namespace

QTextCharFormat FormulaObject::add(const report::FormulaNode& node, const QString& text) {
    QTextCharFormat format;
    format.setObjectType(type);
    format.setProperty(numberProperty, int(m_pieces.size()));
    format.setProperty(textProperty, text);
    format.setVerticalAlignment(QTextCharFormat::AlignMiddle);
    m_pieces.push_back(report::formulaBox(node, boxPoints));
    return format;
}

QString FormulaObject::textOf(const QTextFormat& format) {
    return format.property(textProperty).toString();
}

const report::FormulaBox& FormulaObject::piece(const QTextFormat& format) const {
    return m_pieces[std::size_t(format.property(numberProperty).toInt())];
}

double FormulaObject::scaleOf(const report::FormulaBox& box) const {
    const double usual = m_pixels / report::reportFont(boxPoints).pixelSize();
    return std::clamp(m_room / std::max(box.width, 1.0), usual * leastScale, usual);
}

double FormulaObject::halfHeight(const report::FormulaBox& box) {
    return std::max(box.ascent - axisHeight(), box.descent + axisHeight());
}

QSizeF FormulaObject::intrinsicSize(QTextDocument*, int, const QTextFormat& format) {
    const report::FormulaBox& box = piece(format);
    return QSizeF(box.width, 2 * halfHeight(box)) * scaleOf(box);
}

void FormulaObject::drawObject(QPainter* painter, const QRectF& rect, QTextDocument*, int,
                               const QTextFormat& format) {
    const report::FormulaBox& box = piece(format);
    painter->save();
    painter->translate(rect.topLeft());
    const double scale = scaleOf(box);
    painter->scale(scale, scale);
    painter->setRenderHint(QPainter::Antialiasing);
    box.paint(*painter, 0, halfHeight(box) + axisHeight());
    painter->restore();
}

namespace {

constexpr double equationIndent = 16,
                 paragraphGap = 6; ///< gaps of lines in an equation, of paragraphs [px]
constexpr QChar mayBreak(0x200b);

const QString equalsSign = QStringLiteral(" = ");

/// A side with the equals sign before it.
report::FormulaNode withEquals(const report::FormulaNode& side) {
    using Node = report::FormulaNode;
    return {Node::Kind::row, {}, 2, side.value, {{Node::Kind::sign, equalsSign, 2, 0, {}}, side}};
}

QTextBlockFormat blockFormat(bool equation) {
    QTextBlockFormat format;
    format.setBottomMargin(paragraphGap);
    if (equation) {
        format.setLeftMargin(equationIndent);
        format.setTextIndent(-equationIndent);
    }
    return format;
}

} // namespace

FormulaView::FormulaView(QWidget* parent) : QTextEdit(parent), m_object(new FormulaObject(this)) {
    setReadOnly(true);
    setTabChangesFocus(true);
    document()->documentLayout()->registerHandler(FormulaObject::type, m_object);
    fit();
}

void FormulaView::setSheet(const FormulaSheet& sheet) {
    clearSheet();
    QTextCursor cursor(document());
    QTextCharFormat bold;
    bold.setFontWeight(QFont::Bold);
    cursor.setBlockFormat(blockFormat(false));
    cursor.insertText(formulaHead(sheet), bold);
    for (const FormulaStep& step : sheet.steps) {
        cursor.insertBlock(blockFormat(true), QTextCharFormat());
        const report::Formula formula = report::equation(step);
        for (std::size_t i = 0; i < formula.sides.size(); ++i) {
            const report::FormulaNode& side = formula.sides[i];
            const QString text = report::inOneLine(side);
            const bool first = i == 0;
            if (!first) {
                cursor.insertText(QString(mayBreak), QTextCharFormat());
            }
            cursor.insertText(
                QString(QChar::ObjectReplacementCharacter),
                m_object->add(first ? side : withEquals(side), first ? text : equalsSign + text));
        }
    }
}

void FormulaView::clearSheet() {
    clear();
    m_object->clear();
}

QString FormulaView::text() const {
    return plain(0, document()->characterCount());
}

QString FormulaView::textOf(const FormulaSheet& sheet) {
    QStringList lines{formulaHead(sheet)};
    for (const FormulaStep& step : sheet.steps) {
        lines << report::inOneLine(report::equation(step));
    }
    return lines.join(u'\n');
}

/// The text between two positions.
QString FormulaView::plain(int from, int to) const {
    QStringList lines;
    for (QTextBlock block = document()->findBlock(from); block.isValid() && block.position() < to;
         block = block.next()) {
        QString line;
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            const int begin = std::max(from, fragment.position());
            const int end = std::min(to, fragment.position() + fragment.length());
            if (begin < end) {
                const bool piece = fragment.charFormat().objectType() == FormulaObject::type;
                line += piece ? FormulaObject::textOf(fragment.charFormat())
                              : fragment.text().mid(begin - fragment.position(), end - begin);
            }
        }
        lines << line.remove(mayBreak);
    }
    return lines.join(u'\n');
}

QMimeData* FormulaView::createMimeDataFromSelection() const {
    auto* copied = new QMimeData;
    const QTextCursor selected = textCursor();
    copied->setText(plain(selected.selectionStart(), selected.selectionEnd()));
    return copied;
}

void FormulaView::fit() {
    m_object->setPixels(QFontInfo(font()).pixelSize());
    m_object->setRoom(viewport()->width() - 2 * document()->documentMargin() - equationIndent);
    document()->markContentsDirty(0, document()->characterCount());
}

void FormulaView::resizeEvent(QResizeEvent* event) {
    fit();
    QTextEdit::resizeEvent(event);
}

void FormulaView::changeEvent(QEvent* event) {
    QTextEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fit();
    }
}

StepSheet::StepSheet(CycleCursor& cycle, QWidget* parent)
    : QWidget(parent)
    , m_cycle(cycle)
    , m_zone(new QComboBox(this))
    , m_place(new QLabel(this))
    , m_sheet(new FormulaView(this)) {
    setObjectName(QStringLiteral("stepSheet"));
    setHelpTopic(*this, QStringLiteral("step"));
    m_zone->setObjectName(QStringLiteral("stepZone"));
    m_place->setObjectName(QStringLiteral("stepPlace"));
    m_sheet->setObjectName(QStringLiteral("stepFormulas"));
    m_place->setTextFormat(Qt::PlainText);
    m_place->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::gap, metrics::gap, metrics::gap, metrics::gap);
    column->setSpacing(metrics::tight);
    column->addWidget(m_place);
    column->addWidget(m_zone);
    column->addWidget(m_sheet, 1);
    connect(&m_cycle, &CycleCursor::moved, this, &StepSheet::follow);
    connect(m_zone, &QComboBox::activated, this, [this](int index) {
        m_wanted = m_zone->itemData(index).toULongLong();
        showSheet();
    });
    retranslate();
}

void StepSheet::follow() {
    if (isVisible()) {
        fillZones();
        showSheet();
    }
}

/// Lists the zones under the wheel; keeps the last chosen one while it is among them.
void StepSheet::fillZones() {
    const QSignalBlocker blocker(m_zone);
    m_zone->clear();
    const Progress done = m_cycle.progress();
    for (std::size_t i = done.open; i < done.end; ++i) {
        const Place& at = m_cycle.outcome()->trajectory.passes[i].place;
        QString name = Names::zoneFull(at.zone, at.section);
        if (at.step != Step::none) {
            name = tr("%1, %2: %3", "zone, E1, what that is")
                       .arg(name, Names::step(at.step), Names::stepMeaning(at.zone, at.step));
        }
        m_zone->addItem(name, static_cast<qulonglong>(sectionOf(at)));
        if (m_wanted == sectionOf(at)) {
            m_zone->setCurrentIndex(m_zone->count() - 1);
        }
    }
    m_zone->setEnabled(m_zone->count() > 1);
}

void StepSheet::showSheet() {
    const Progress done = m_cycle.progress();
    const bool any = !done.isBlank() && m_zone->currentIndex() >= 0;
    m_zone->setVisible(any);
    if (!any) {
        m_place->setText(m_cycle.outcome() ? tr(
                             "Grinding has not started. Step on or press Play below the views: the "
                             "formulas of each step are shown here with their numbers.")
                                           : tr("No cycle has been recorded."));
        m_sheet->clearSheet();
        return;
    }
    const Outcome& outcome = *m_cycle.outcome();
    const std::size_t pass = done.open + static_cast<std::size_t>(m_zone->currentIndex());
    const Place& at = outcome.trajectory.passes[pass].place;
    const QString when = Names::place(at, outcome.result.project.operation);
    const QString k = tr("radius k = %1").arg(m_cycle.radius());
    m_place->setText(at.step == Step::none
                         ? tr("%1, %2").arg(when, k)
                         : tr("%1, %2, %3").arg(when, tr("revolution %1").arg(at.revolution), k));
    const int scrolled = m_sheet->verticalScrollBar()->value();
    m_sheet->setSheet(visitSheet(outcome.result, outcome.trajectory, pass, m_cycle.radius()));
    m_sheet->verticalScrollBar()->setValue(scrolled);
}

void StepSheet::retranslate() {
    setAccessibleName(tr("Formulas of the step"));
    m_zone->setAccessibleName(tr("Zone or section under the wheel"));
    m_zone->setToolTip(m_zone->accessibleName());
    m_place->setAccessibleName(tr("Place in the cycle"));
    m_sheet->setAccessibleName(tr("Balance of the radius with its numbers"));
    fillZones();
    showSheet();
}

void StepSheet::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    follow();
}

void StepSheet::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_sheet) {
        retranslate();
    }
}

} // namespace sparkout
