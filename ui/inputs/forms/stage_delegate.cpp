// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/stage_delegate.h"

#include "core/project/cycle.h"
#include "ui/inputs/editors/form_metrics.h"
#include "ui/inputs/editors/spark_out_editor.h"
#include "ui/inputs/forms/stage_model.h"
#include "ui/session/document.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr int sparkOutWidth = 200;

QFont barFont(QFont font) {
    font.setPointSizeF(font.pointSizeF() * noteType);
    return font;
}

int barHeight(const QFontMetrics& font) {
    return int(font.height() * noteType);
}

/// A bar of the share's length with its percents in it.
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

QWidget* StageDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                     const QModelIndex& index) const {
    const Field& field = stagesOf(index).field(index);
    if (field.kind != Kind::countOrWord) {
        return ListDelegate::createEditor(parent, option, index);
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
    if (!share.isValid()) {
        ListDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
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
    painter->setFont(item.font);
    painter->setPen(ink);
    painter->drawText(inside.adjusted(0, 0, 0, -bar.height()),
                      int(Qt::AlignRight | Qt::AlignVCenter),
                      item.fontMetrics.elidedText(text, Qt::ElideRight, inside.width()));
    drawShare(*painter, bar, share.toDouble(), ink, item, stale);
    painter->restore();
}

void StageDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex& index) const {
    if (!qobject_cast<SparkOutEditor*>(editor)) {
        QStyledItemDelegate::updateEditorGeometry(editor, option, index);
        return;
    }
    QRect place = option.rect; // over its neighbours: a cell is too narrow for it
    place.setLeft(qMax(0, place.right() - sparkOutWidth));
    editor->setGeometry(place);
}

} // namespace sparkout
