// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_delegate.h"

#include "core/project/cycle.h"
#include "core/study/stage_edits.h"
#include "ui/form/choice_editor.h"
#include "ui/form/number_field.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/stage_model.h"
#include "ui/kit/font_size.h"
#include "ui/session/document.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
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

namespace {

constexpr int sparkOutWidth = 200;

QFont barFont(QFont font) {
    font.setPointSizeF(font.pointSizeF() * noteType);
    return font;
}

int barHeight(const QFontMetrics& font) {
    return int(font.height() * noteType);
}

/// The cell's font, reduced down to a limit if the text is longer than the cell.
QFont fitting(const QFont& font, const QString& text, int width) {
    constexpr double least = 0.7;
    const int wanted = QFontMetrics(font).horizontalAdvance(text);
    return wanted > width ? enlarged(font, std::max(least, double(width) / wanted)) : font;
}

/// Draws a bar with the length of the share and its percentage.
void drawShare(QPainter& painter, const QRect& bar, double share, const QColor& ink,
               const QStyleOptionViewItem& item, bool stale) {
    QColor fill = stale ? ink : item.palette.color(QPalette::Highlight);
    if (item.state & QStyle::State_Selected) {
        fill = item.palette.color(QPalette::HighlightedText);
    }
    QColor ground = ink;
    fill.setAlphaF(stale ? 0.18F : 0.35F);
    ground.setAlphaF(0.08F);
    QRect part = bar;
    part.setWidth(int(std::lround(bar.width() * std::clamp(share, 0.0, 1.0))));
    painter.fillRect(bar, ground);
    painter.fillRect(part, fill);
    painter.setFont(barFont(item.font));
    QColor text = ink;
    text.setAlphaF(stale ? 0.5F : 1.0F);
    painter.setPen(text);
    painter.drawText(bar.adjusted(0, 0, -metrics::hair, 0), int(Qt::AlignRight | Qt::AlignVCenter),
                     percentText(share));
}

const StageModel& stagesOf(const QModelIndex& index) {
    return *static_cast<const StageModel*>(index.model());
}

} // namespace

/// Whether the mark and the text do not fit side by side.
bool StageDelegate::needsTwoLines(const QStyleOptionViewItem& item) {
    const int text = item.fontMetrics.horizontalAdvance(item.text) + 2 * metrics::row;
    const int mark = item.icon.isNull() ? 0 : item.decorationSize.width() + 2 * metrics::row;
    return !item.text.isEmpty() && text + mark > item.rect.width();
}

/// The mark above the text: rows are high enough for both.
void StageDelegate::paintInTwoLines(QPainter& painter, QStyleOptionViewItem item) {
    const QString text = std::exchange(item.text, QString());
    const QIcon mark = std::exchange(item.icon, QIcon());
    item.features &= ~(QStyleOptionViewItem::HasDecoration | QStyleOptionViewItem::HasDisplay);
    QStyle& style = *(item.widget ? item.widget->style() : QApplication::style());
    style.drawControl(QStyle::CE_ItemViewItem, &item, &painter, item.widget); // ground
    const QRect inside =
        item.rect.adjusted(metrics::hair, metrics::hair, -metrics::row, -metrics::hair);
    QRect line = inside;
    line.setTop(inside.bottom() + 1 - item.fontMetrics.height());
    if (mark.isNull()) {
        line = inside;
    } else {
        mark.paint(&painter,
                   QRect(inside.topLeft(), QSize(inside.width(), line.top() - inside.top())),
                   Qt::AlignRight | Qt::AlignVCenter);
    }
    painter.save();
    painter.setFont(fitting(item.font, text, line.width()));
    painter.setPen(item.palette.color(
        item.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text));
    painter.drawText(line, int(Qt::AlignRight | Qt::AlignVCenter), text);
    painter.restore();
}

/// A feed, and below it in a small font the feed in another unit.
void StageDelegate::paintWithForm(QPainter& painter, QStyleOptionViewItem item,
                                  const QString& form) {
    const QString text = std::exchange(item.text, QString());
    QStyle& style = *(item.widget ? item.widget->style() : QApplication::style());
    style.drawControl(QStyle::CE_ItemViewItem, &item, &painter, item.widget); // ground
    const QRect inside =
        item.rect.adjusted(metrics::row, metrics::hair, -metrics::row, -metrics::hair);
    const QRect below(inside.left(), inside.bottom() + 1 - barHeight(item.fontMetrics),
                      inside.width(), barHeight(item.fontMetrics));
    QColor ink = item.palette.color(item.state & QStyle::State_Selected ? QPalette::HighlightedText
                                                                        : QPalette::Text);
    painter.save();
    painter.setPen(ink);
    painter.setFont(fitting(item.font, text, inside.width()));
    painter.drawText(inside.adjusted(0, 0, 0, -below.height()),
                     int(Qt::AlignRight | Qt::AlignVCenter), text);
    painter.setFont(fitting(barFont(item.font), form, inside.width()));
    painter.drawText(below, int(Qt::AlignRight | Qt::AlignVCenter), form);
    painter.restore();
}

QWidget* StageDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                     const QModelIndex& index) const {
    const Field& field = stagesOf(index).field(index);
    if (field.kind != Kind::countOrWord) {
        QWidget* made = ListDelegate::createEditor(parent, option, index);
        static_cast<NumberField*>(made)->setReads([this, &field](const QString& text) {
            return feedFromForm(document().project(), field, text.toStdString());
        });
        return made;
    }
    auto* self = const_cast<StageDelegate*>(this);
    auto* editor = new SparkOutEditor(field, document().project().operation, parent);
    setCell(*editor, index);
    connect(editor, &SparkOutEditor::edited, self, [self, editor] { self->commit(editor); });
    connect(editor, &SparkOutEditor::left, self, [self, editor] { self->close(editor); });
    if (const QString refused = stagesOf(index).refusedText(index); !refused.isNull()) {
        editor->showStage(stagesOf(index).stage(index));
        editor->showRefused(refused);
    }
    return editor;
}

void StageDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    if (auto* sparkOut = qobject_cast<SparkOutEditor*>(editor)) {
        sparkOut->showStage(stagesOf(index).stage(index));
    } else {
        ListDelegate::setEditorData(editor, index);
    }
}

void StageDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                 const QModelIndex& index) const {
    auto* sparkOut = qobject_cast<SparkOutEditor*>(editor);
    if (!sparkOut) {
        ListDelegate::setModelData(editor, model, index);
        return;
    }
    auto* stages = static_cast<StageModel*>(model);
    Stage edited = stages->stage(index);
    sparkOut->putInto(edited);
    stages->setSparkOut(index, std::move(edited));
    if (sparkOut->refused()) {
        stages->refuse(index, sparkOut->refusedText(), sparkOut->refusal());
    } else {
        stages->accept(index);
    }
}

bool StageDelegate::eventFilter(QObject* watched, QEvent* event) {
    auto* sparkOut = qobject_cast<SparkOutEditor*>(watched);
    if (sparkOut && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        sparkOut->revert();
    }
    return ListDelegate::eventFilter(watched, event);
}

int StageDelegate::rowHeight(const QFontMetrics& font) {
    return font.height() + barHeight(font) + 2 * metrics::tight;
}

void StageDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    const QVariant share = index.data(StageModel::shareRole);
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    if (!share.isValid()) {
        if (const QString form = index.data(StageModel::formRole).toString(); !form.isEmpty()) {
            paintWithForm(*painter, item, form);
        } else if (needsTwoLines(item)) {
            paintInTwoLines(*painter, item);
        } else {
            ListDelegate::paint(painter, option, index);
        }
        return;
    }
    const QString text = item.text;
    const QRect place = item.rect;
    const QColor ink = item.palette.color(
        item.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text);
    item.text.clear();
    QStyle& style = *(item.widget ? item.widget->style() : QApplication::style());
    style.drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget); // ground and mark
    const QRect inside = place.adjusted(metrics::row, metrics::hair, -metrics::row, -metrics::hair);
    const QRect bar(inside.left(), inside.bottom() + 1 - barHeight(item.fontMetrics),
                    inside.width(), barHeight(item.fontMetrics));
    const bool stale = index.data(StageModel::staleRole).toBool();
    painter->save();
    painter->setFont(fitting(item.font, text, inside.width()));
    painter->setPen(ink);
    painter->drawText(inside.adjusted(0, 0, 0, -bar.height()),
                      int(Qt::AlignRight | Qt::AlignVCenter), text);
    drawShare(*painter, bar, share.toDouble(), ink, item, stale);
    painter->restore();
}

void StageDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex& index) const {
    if (!qobject_cast<SparkOutEditor*>(editor)) {
        QStyledItemDelegate::updateEditorGeometry(editor, option, index);
        return;
    }
    QRect place = option.rect; // over its neighbours, since a cell is too narrow
    place.setLeft(qMax(0, place.right() - sparkOutWidth));
    editor->setGeometry(place);
}

} // namespace sparkout
