// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/text_checks.h"

#include "ui/chart/legend.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTabWidget>
#include <qcustomplot.h>

namespace sparkout {

namespace {

void add(QList<ShownText>& list, const QObject* object, const QString& text) {
    if (!text.isEmpty()) {
        list += {text, pathOf(object)};
    }
}

void addItems(QList<ShownText>& list, const QAbstractItemView& view) {
    const QAbstractItemModel* model = view.model();
    for (int row = 0; model && row < model->rowCount(); ++row) {
        add(list, &view, model->headerData(row, Qt::Vertical, Qt::DisplayRole).toString());
    }
    for (int column = 0; model && column < model->columnCount(); ++column) {
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole}) {
            add(list, &view, model->headerData(column, Qt::Horizontal, role).toString());
            for (int row = 0; row < model->rowCount(); ++row) {
                add(list, &view, model->index(row, column).data(role).toString());
            }
        }
    }
}

/// The names of its axes and the texts beside its cells.
void addDrawn(QList<ShownText>& list, const QCustomPlot& plot) {
    for (const QCPAxisRect* rect : plot.axisRects()) {
        for (const QCPAxis* axis : rect->axes()) {
            add(list, &plot, axis->label());
        }
    }
    for (const QCPLayoutElement* element : plot.plotLayout()->elements(true)) {
        if (const auto* caption = qobject_cast<const QCPTextElement*>(element)) {
            add(list, &plot, caption->text());
        }
    }
}

void addOwn(QList<ShownText>& list, const QWidget* widget) {
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        add(list, label, label->text());
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
        add(list, button, button->text());
    } else if (const auto* box = qobject_cast<const QGroupBox*>(widget)) {
        add(list, box, box->title());
    } else if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
        add(list, line, line->placeholderText());
    } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
        add(list, combo, combo->placeholderText());
        for (int i = 0; i < combo->count(); ++i) {
            add(list, combo, combo->itemText(i));
        }
    } else if (const auto* tabs = qobject_cast<const QTabWidget*>(widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            add(list, tabs, tabs->tabText(i));
            add(list, tabs, tabs->tabToolTip(i));
        }
    } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
        addItems(list, *view);
    } else if (const auto* plot = qobject_cast<const QCustomPlot*>(widget)) {
        if (plot->isVisible()) { // a hidden one is drawn anew when it is shown
            addDrawn(list, *plot);
        }
    } else if (const auto* legend = qobject_cast<const LegendStrip*>(widget)) {
        for (const LegendEntry& entry : legend->entries()) {
            if (legend->isVisible()) {
                add(list, legend, entry.text);
            }
        }
    }
}

} // namespace

QString pathOf(const QObject* object) {
    QStringList parts;
    for (; object; object = object->parent()) {
        const QString name = object->objectName();
        const bool telling = !name.isEmpty() && !name.startsWith(QStringLiteral("qt_"));
        parts.prepend(telling ? name : QString::fromUtf8(object->metaObject()->className()));
    }
    return parts.join(QStringLiteral(" > ")).remove(QStringLiteral("sparkout::"));
}

QList<ShownText> textsOf(const QWidget& window) {
    QList<ShownText> list;
    add(list, &window, window.windowTitle());
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        add(list, widget, widget->toolTip());
        add(list, widget, widget->accessibleName());
        add(list, widget, widget->accessibleDescription());
        add(list, widget, widget->windowTitle());
        addOwn(list, widget);
    }
    for (const QAction* action : window.findChildren<QAction*>()) {
        add(list, action, action->text());
        add(list, action, action->toolTip());
    }
    return list;
}

QString englishIn(QString text) {
    // Names in angle quotes are keys of the file and columns of tables.
    static const QRegularExpression keys(QStringLiteral("«[a-z_]+»"));
    static const QRegularExpression tags(QStringLiteral("<sub>[^<]*</sub>|<[^>]*>"));
    static const QRegularExpression word(QStringLiteral("(?<![\\w.])[A-Za-z]{3,}(?![\\w])"),
                                         QRegularExpression::UseUnicodePropertiesOption);
    static const QStringList allowed =
        QStringLiteral(
            "Sparkout English Qt QCustomPlot GNU General Public License Debian Linux bookworm "
            "Ctrl Alt Shift Ins Del Esc Home End PgUp PgDown Tab Enter Space Meta Return Backspace "
            "Excel Slurm CNC HRC Cp Cpk Pp Ppk Eigen Boost NLopt qpdf zlib Snowball "
            "GPL GCC Clang AVX SSE MODEL ISO DIN SAE FEPA UPR RONt MZC LSC MIC MCC cos sin tan exp "
            "log max min JSON HTML Markdown CSV TSV PNG JPEG SVG PDF XLSX ODT SHA Inkscape")
            .split(u' ');
    text.replace(QStringLiteral("&nbsp;"), QStringLiteral(" "));
    text.remove(keys).replace(tags, QStringLiteral(" ")).remove(u'&');
    QStringList found;
    for (auto it = word.globalMatch(text); it.hasNext();) {
        const QString one = it.next().captured();
        if (!allowed.contains(one)) {
            found += one;
        }
    }
    return found.join(u' ');
}

// --- room ---------------------------------------------------------------------------------------

QList<QWidget*> interactiveWidgets(const QWidget& window) {
    QList<QWidget*> list;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        const QString name = widget->objectName();
        const QString type = QString::fromUtf8(widget->metaObject()->className());
        const bool button = qobject_cast<const QAbstractButton*>(widget) != nullptr;
        const bool part = qobject_cast<const QScrollBar*>(widget)
                          || (name.startsWith(QStringLiteral("qt_")) && !button)
                          || type.startsWith(QStringLiteral("QComboBox")) // its list
                          || type == QStringLiteral("QComboBoxListView")
                          || type == QStringLiteral("QTableCornerButton")
                          || type == QStringLiteral("QLineEditIconButton")
                          || type == QStringLiteral("QHeaderView");
        const bool combo = type == QStringLiteral("QComboBox");
        if ((!part || combo) && (button || widget->focusPolicy() != Qt::NoFocus)) {
            list += widget;
        }
    }
    return list;
}

} // namespace sparkout
