// SPDX-License-Identifier: GPL-3.0-or-later
// Whether visible texts have room.
#include "tests/ui/support/text_checks.h"

#include "ui/chart/legend.h"
#include "ui/inputs/column_header.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QStyleOption>
#include <QTabBar>
#include <QTest>
#include <QTextDocument>
#include <QToolButton>

#include <cmath>

namespace sparkout {

namespace {

/// The protected style options of Qt's widgets, by pointers to members: no foreign type is faked.
struct BoxOption : QGroupBox {
    static QStyleOptionGroupBox of(const QGroupBox& box) {
        QStyleOptionGroupBox option;
        (box.*(&BoxOption::initStyleOption))(&option);
        return option;
    }
};
struct ComboOption : QComboBox {
    static QStyleOptionComboBox of(const QComboBox& box) {
        QStyleOptionComboBox option;
        (box.*(&ComboOption::initStyleOption))(&option);
        return option;
    }
};
struct TabOption : QTabBar {
    static QStyleOptionTab of(const QTabBar& bar, int index) {
        QStyleOptionTab option;
        (bar.*(&TabOption::initStyleOption))(&option, index);
        return option;
    }
};
struct DockOption : QDockWidget {
    static QStyleOptionDockWidget of(const QDockWidget& dock) {
        QStyleOptionDockWidget option;
        (dock.*(&DockOption::initStyleOption))(&option);
        return option;
    }
};

/// Whether ancestors cut a widget off where nobody can scroll to.
bool cutOff(const QWidget& widget) {
    QRect rect = widget.rect();
    for (const QWidget* at = &widget; !at->isWindow() && at->parentWidget();
         at = at->parentWidget()) {
        const QWidget* parent = at->parentWidget();
        QRect room = parent->rect();
        rect.translate(at->pos());
        const auto* area = qobject_cast<const QAbstractScrollArea*>(parent->parentWidget());
        if (area && area->viewport() == parent) {
            if (area->verticalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) {
                rect.setTop(room.top());
                rect.setBottom(room.bottom());
            }
            if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) {
                rect.setLeft(room.left());
                rect.setRight(room.right());
            }
        }
        if (!room.contains(rect)) {
            return true;
        }
    }
    return false;
}

bool fits(const QSize& need, const QSize& room) {
    return need.width() <= room.width() && need.height() <= room.height();
}

bool labelFits(const QLabel& label) {
    const int margin = label.margin();
    const QSize room = label.contentsRect().adjusted(margin, margin, -margin, -margin).size();
    const bool rich = label.textFormat() == Qt::RichText
                      || (label.textFormat() == Qt::AutoText && Qt::mightBeRichText(label.text()));
    if (rich) {
        QTextDocument document;
        document.setDefaultFont(label.font());
        document.setDocumentMargin(0);
        document.setHtml(label.text());
        document.setTextWidth(label.wordWrap() ? room.width() : -1);
        const QSizeF need(std::floor(document.idealWidth()), std::floor(document.size().height()));
        return fits(need.toSize(), room);
    }
    const int flags = (label.wordWrap() ? int(Qt::TextWordWrap) : 0)
                      | (label.buddy() ? int(Qt::TextShowMnemonic) : 0);
    const QRect all(0, 0, room.width(), 100'000);
    return fits(label.fontMetrics().boundingRect(all, flags, label.text()).size(), room);
}

bool buttonFits(const QAbstractButton& button) {
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) {
        return true;
    }
    const QSize text = button.fontMetrics().size(Qt::TextShowMnemonic, button.text());
    return tool
               ? text.width() + 4 <= button.width() && button.sizeHint().height() <= button.height()
               : fits(button.sizeHint(), button.size());
}

bool boxFits(const QGroupBox& box) {
    const QStyleOptionGroupBox option = BoxOption::of(box);
    const QRect label =
        box.style()->subControlRect(QStyle::CC_GroupBox, &option, QStyle::SC_GroupBoxLabel, &box);
    return box.rect().contains(label)
           && box.fontMetrics().size(Qt::TextShowMnemonic, box.title()).width() <= label.width();
}

bool comboFits(const QComboBox& combo) {
    const QStyleOptionComboBox option = ComboOption::of(combo);
    const QRect room = combo.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                     QStyle::SC_ComboBoxEditField, &combo);
    const int icon = option.currentIcon.isNull() ? 0 : option.iconSize.width() + 4;
    const QString text = combo.currentIndex() < 0 ? combo.placeholderText() : combo.currentText();
    return combo.fontMetrics().horizontalAdvance(text) + icon <= room.width() - 2;
}

bool spinFits(const QSpinBox& spin) {
    const auto* line = spin.findChild<QLineEdit*>();
    return spin.fontMetrics().horizontalAdvance(spin.text()) + 4 <= line->width();
}

bool lineFits(const QLineEdit& line) {
    const bool longText = !line.isReadOnly() && !line.inherits("sparkout::NumberField");
    const QString text = line.text().isEmpty() ? line.placeholderText() : line.displayText();
    return (longText && !line.text().isEmpty()) || line.hasFocus()
           || line.fontMetrics().horizontalAdvance(text) + 8 <= line.width();
}

bool dockFits(const QDockWidget& dock) {
    const QStyleOptionDockWidget option = DockOption::of(dock);
    const QRect room =
        dock.style()->subElementRect(QStyle::SE_DockWidgetTitleBarText, &option, &dock);
    return dock.titleBarWidget()
           || dock.fontMetrics().horizontalAdvance(dock.windowTitle()) <= room.width();
}

void checkTabs(QStringList& without, const QTabBar& bar) {
    for (int i = 0; i < bar.count(); ++i) {
        if (TabOption::of(bar, i).text != bar.tabText(i)) {
            without += pathOf(&bar) + QStringLiteral(": ") + bar.tabText(i);
        }
    }
}

void checkHeader(QStringList& without, const QHeaderView& header) {
    const int margin = header.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &header);
    const bool across = header.orientation() == Qt::Horizontal;
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, header.orientation()).toString();
        const auto* own = qobject_cast<const ColumnHeader*>(&header);
        const QSize room = across ? QSize(header.sectionSize(i), header.height())
                                  : QSize(header.width(), header.sectionSize(i));
        const int flags = static_cast<int>(header.defaultAlignment()) & Qt::TextWordWrap;
        const QRect all(0, 0, room.width() - 2 * margin, 100'000);
        const QSize need = own ? own->needOf(i) - QSize(2 * margin, 0)
                               : header.fontMetrics().boundingRect(all, flags, text).size();
        const bool inSight =
            !own
            || (header.parentWidget()->width() >= header.sectionViewportPosition(i) + room.width());
        if (!header.isSectionHidden(i) && (!inSight || !fits(need, {all.width(), room.height()}))) {
            without += pathOf(&header) + QStringLiteral(": ") + text;
        }
    }
}

/// By the usual margins; a delegate may have narrower ones of its own.
void checkItems(QStringList& without, const QAbstractItemView& view) {
    const int margin = view.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &view) + 1;
    const bool wraps = view.property("wordWrap").toBool();
    for (int row = 0; view.model() && row < view.model()->rowCount(); ++row) {
        for (int column = 0; column < view.model()->columnCount(); ++column) {
            const QModelIndex index = view.model()->index(row, column);
            const QRect rect = view.visualRect(index);
            const bool icon = !index.data(Qt::DecorationRole).isNull();
            QSize room = rect.size() - QSize(2 * margin, 0);
            room -= QSize(icon ? view.iconSize().width() + 2 * margin : 0, 0);
            const QRect all(0, 0, room.width(), 100'000);
            const QString text = index.data().toString();
            const QVariant font = index.data(Qt::FontRole);
            const QFontMetrics metrics(font.isNull() ? view.font() : font.value<QFont>());
            const int flags = wraps ? int(Qt::TextWordWrap) : 0;
            const bool hasRoom = fits(metrics.boundingRect(all, flags, text).size(), room)
                                 || (!wraps && metrics.height() <= rect.height()
                                     && view.sizeHintForIndex(index).width() <= rect.width());
            if (!rect.isEmpty() && !text.isEmpty() && !hasRoom) {
                without += pathOf(&view) + QStringLiteral(": ") + text;
            }
        }
    }
}

/// Whether a widget's own text fits; true for those that have none.
bool ownTextFits(const QWidget* widget, QString& text) {
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        text = label->text();
        return text.isEmpty() || (labelFits(*label) && !cutOff(*label));
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
        text = button->text().isEmpty() ? button->accessibleName() : button->text();
        return (button->text().isEmpty() || buttonFits(*button)) && !cutOff(*button);
    }
    if (const auto* box = qobject_cast<const QGroupBox*>(widget)) {
        text = box->title();
        return text.isEmpty() || (boxFits(*box) && !cutOff(*box));
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
        text = combo->currentText();
        return comboFits(*combo) && !cutOff(*combo);
    }
    if (const auto* spin = qobject_cast<const QSpinBox*>(widget)) {
        text = spin->text();
        return spinFits(*spin) && !cutOff(*spin);
    }
    if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
        text = line->text();
        return lineFits(*line) && !cutOff(*line);
    }
    if (const auto* dock = qobject_cast<const QDockWidget*>(widget)) {
        text = dock->windowTitle();
        return dockFits(*dock);
    }
    if (const auto* strip = qobject_cast<const LegendStrip*>(widget)) {
        for (int i = 0; i < static_cast<int>(strip->entries().size()); ++i) {
            text = strip->entries()[static_cast<std::size_t>(i)].text;
            const QSize room = strip->entryRect(i).size() - QSize(27, 0); // beside its sample
            const QSize needed =
                strip->fontMetrics()
                    .boundingRect(QRect(0, 0, room.width(), 10'000), Qt::TextWordWrap, text)
                    .size();
            if (needed.width() > room.width() || needed.height() > room.height()) {
                return false;
            }
        }
        return !cutOff(*strip);
    }
    return true;
}

QStringList withoutRoomNow(const QWidget& window) {
    QStringList without;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const QString name = widget->objectName();
        if (!widget->isVisible() || name.startsWith(QStringLiteral("Scroll"))
            || name == QStringLiteral("qt_toolbar_ext_button")) {
            continue;
        }
        QString text;
        if (!ownTextFits(widget, text)) {
            without += QStringLiteral("%1 (%2×%3): %4")
                           .arg(pathOf(widget))
                           .arg(widget->width())
                           .arg(widget->height())
                           .arg(text);
        }
        if (const auto* bar = qobject_cast<const QTabBar*>(widget)) {
            checkTabs(without, *bar);
        } else if (const auto* header = qobject_cast<const QHeaderView*>(widget)) {
            checkHeader(without, *header);
        } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
            checkItems(without, *view);
        }
    }
    return without;
}

} // namespace

QStringList textsWithoutRoom(const QWidget& window) {
    constexpr int tries = 20, wait_ms = 50;
    QStringList without = withoutRoomNow(window);
    for (int i = 0; i < tries && !without.isEmpty(); ++i) {
        QTest::qWait(wait_ms);
        without = withoutRoomNow(window);
    }
    return without;
}

} // namespace sparkout
