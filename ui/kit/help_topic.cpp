// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/help_topic.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextDocument>
#include <QToolTip>
#include <QVariant>
#include <QWidget>

namespace sparkout {

namespace {

constexpr const char* topicProperty = "sparkoutHelpTopic";
}

void setHelpTopic(QWidget& widget, const QString& topic) {
    widget.setProperty(topicProperty, topic);
}

QString helpTopicOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
        if (const QString topic = widget->property(topicProperty).toString(); !topic.isEmpty()) {
            return topic;
        }
    }
    return {};
}

namespace {

constexpr const char* objectName_ = "sparkoutToolTips";

/// Whether the text is paragraphs without anything that loads, links or styles.
bool isOwnMarkup(const QString& text) {
    static const QRegularExpression own(
        QStringLiteral("\\A<p>(?:[^<]++|</?(?:p|i|b|sub|sup|code)>|<br>)*\\z"));
    return own.match(text).hasMatch();
}

/// Broken between words; existing breaks are kept.
QString wrapped(const QString& text) {
    QStringList lines;
    for (const QString& given : text.split(u'\n')) {
        QString line;
        for (const QString& word : given.split(u' ')) {
            if (!line.isEmpty() && line.size() + 1 + word.size() > ToolTips::lineLength) {
                lines << line;
                line = word;
            } else {
                line += line.isEmpty() ? word : u' ' + word;
            }
        }
        lines << line;
    }
    return lines.join(u'\n');
}

struct Tip {
    QString text;
    QRect of; ///< area in the widget; empty: all of it
};

Tip headingTip(const QHeaderView& header, const QPoint& at) {
    const int section = header.logicalIndexAt(at);
    if (section < 0 || !header.model()) {
        return {};
    }
    const bool across = header.orientation() == Qt::Horizontal;
    const int from = header.sectionViewportPosition(section), size = header.sectionSize(section);
    return {header.model()->headerData(section, header.orientation(), Qt::ToolTipRole).toString(),
            across ? QRect(from, 0, size, header.height()) : QRect(0, from, header.width(), size)};
}

Tip tipAt(const QWidget& widget, const QPoint& at) {
    auto* const view = qobject_cast<QAbstractItemView*>(widget.parentWidget());
    if (view && view->viewport() == &widget) {
        if (const auto* header = qobject_cast<const QHeaderView*>(view)) {
            return headingTip(*header, at);
        }
        const QModelIndex index = view->indexAt(at);
        if (QString text = index.data(Qt::ToolTipRole).toString(); !text.isEmpty()) {
            return {text, view->visualRect(index)};
        }
    } else if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
        const int tab = tabs->tabAt(at);
        if (tab >= 0 && !tabs->tabToolTip(tab).isEmpty()) {
            return {tabs->tabToolTip(tab), tabs->tabRect(tab)};
        }
    } else if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        const QAction* const entry = menu->actionAt(at);
        if (entry && menu->toolTipsVisible()) {
            return {entry->toolTip(), menu->actionGeometry(menu->actionAt(at))};
        }
    }
    return {widget.toolTip(), {}};
}

} // namespace

void ToolTips::install() {
    const QString name = QString::fromLatin1(objectName_);
    if (!qApp->findChild<ToolTips*>(name, Qt::FindDirectChildrenOnly)) {
        auto* const tips = new ToolTips(qApp);
        tips->setObjectName(name);
        qApp->installEventFilter(tips);
    }
}

QString ToolTips::shown(const QString& text) {
    if (isOwnMarkup(text)) {
        return text; // Qt breaks its lines
    }
    const QString lines = wrapped(text);
    return Qt::mightBeRichText(lines)
               ? QStringLiteral("<p style=\"white-space:pre\">%1</p>")
                     .arg(lines.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")))
               : lines;
}

QString ToolTips::markup(const QString& text) {
    return isOwnMarkup(text) ? text : Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal);
}

/// False if there is none; a parent may have one.
bool ToolTips::show(QWidget& widget, const QHelpEvent& event) {
    const Tip tip = tipAt(widget, event.pos());
    if (tip.text.isEmpty()) {
        return false;
    }
    QToolTip::showText(event.globalPos(), shown(tip.text), &widget, tip.of,
                       widget.toolTipDuration());
    return true;
}

bool ToolTips::eventFilter(QObject* watched, QEvent* event) {
    auto* const widget =
        event->type() == QEvent::ToolTip ? qobject_cast<QWidget*>(watched) : nullptr;
    if (widget && show(*widget, *static_cast<const QHelpEvent*>(event))) {
        event->accept();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace sparkout
