// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/hint_text.h"

#include "core/project/part.h"
#include "ui/text/defaults.h"
#include "ui/text/shown_scale.h"
#include "ui/text/size_field.h"
#include "ui/text/source_names.h"
#include "ui/text/stock_reading.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QStringList>

namespace sparkout {

namespace {

QString hintTr(const char* text) {
    return QCoreApplication::translate("Hint", text);
}

QString meaning(const Field& field) {
    const QString hint = inputText(field.hint);
    return StockReading::isOnDiameter(field)
               ? hintTr(QT_TRANSLATE_NOOP("Hint", "%1 Entered and shown on the diameter; the file "
                                                  "and all results have it per side."))
                     .arg(hint)
               : hint;
}

/// Whether its range is one of values, and not of items or letters.
bool hasLimits(const Field& field) {
    return !field.hard.unbounded() && field.kind != Kind::objectList && field.kind != Kind::text;
}

/// The facts of a hint, each with its name.
QStringList facts(const Field& field) {
    const ShownScale scale = ShownScale::ofInput(field);
    QStringList list;
    if (hasLimits(field)) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "Allowed: %1"))
                    .arg(rangeShown(scale.shown(field.stated()), field.unit));
    }
    if (!field.soft.unbounded()) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "Usual: %1"))
                    .arg(rangeShown(scale.shown(field.soft), field.unit));
    }
    if (hasDefault(field)) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "Default: %1")).arg(defaultText(field));
    }
    return list;
}

/// The facts that share a line with the limits.
QStringList moreFacts(const Field& field) {
    QStringList list;
    if (*field.nullMeaning && !hasDefault(field)) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "Empty: %1")).arg(inputText(field.nullMeaning));
    }
    if (const QString source = sourceText(field.source); !source.isEmpty()) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "Source: %1")).arg(source);
    }
    return list;
}

} // namespace

QString symbolMarkup(const Field& field) {
    QString symbol = withIndices(StockReading::symbol(field));
    symbol.replace(u' ', QStringLiteral("&nbsp;")); // in one line
    return symbol.isEmpty() ? symbol : QStringLiteral("<i>%1</i>").arg(symbol);
}

QString labelMarkup(const Field& field) {
    const QString label = StockReading::label(field).toHtmlEscaped();
    return *field.symbol ? QStringLiteral("%1&nbsp;%2").arg(label, symbolMarkup(field)) : label;
}

QString labelMarkup(const Field& field, const Project& project) {
    const auto inItalics = [](const QString& symbol) {
        return QStringLiteral("<i>%1</i>").arg(symbol);
    };
    QString label = labelMarkup(field);
    const QString usual = QString::fromUtf8(field.symbol);
    const QString own = symbolOf(field, *project.part);
    return own == usual ? label : label.replace(inItalics(usual), inItalics(own));
}

QString columnText(const Field& field) {
    const QString label = StockReading::column(field);
    return *field.unit ? QStringLiteral("%1, %2").arg(label, unitText(field.unit)) : label;
}

QString columnMarkup(const Field& field) {
    QString text = StockReading::column(field).toHtmlEscaped();
    if (*field.symbol) {
        text += u' ' + symbolMarkup(field); // on a line of its own in a narrow column
    }
    if (*field.unit) {
        QString unit = unitText(field.unit).toHtmlEscaped();
        unit.replace(u'/', QStringLiteral("\u2060/\u2060")); // never two lines
        text += QStringLiteral(", ") + unit;
    }
    return text;
}

QString hintMarkup(const Field& field) {
    QString html;
    if (*field.hint) {
        html += QStringLiteral("<p>%1</p>").arg(withIndices(meaning(field)));
    }
    if (*field.formula) {
        html += QStringLiteral("<p><i>%1</i></p>").arg(withIndices(inputText(field.formula)));
    }
    for (const QStringList& lines : {facts(field), moreFacts(field)}) {
        if (!lines.isEmpty()) {
            html +=
                QStringLiteral("<p>%1</p>")
                    .arg(lines.join(u'\n').toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
        }
    }
    return html;
}

QString hintPlain(const Field& field) {
    QStringList parts{meaning(field)};
    if (*field.formula) {
        parts += inputText(field.formula) + u'.';
    }
    for (const QString& fact : facts(field) + moreFacts(field)) {
        parts += fact + u'.';
    }
    parts.removeAll(QString());
    return parts.join(u' ');
}

QString limitsMarkup(const Field& field) {
    const ShownScale scale = ShownScale::ofInput(field);
    QStringList list;
    if (hasLimits(field)) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "allowed %1"))
                    .arg(rangeBrief(scale.shown(field.stated()), field.unit));
    }
    if (!field.soft.unbounded()) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "usual %1"))
                    .arg(rangeBrief(scale.shown(field.soft), field.unit));
    }
    if (hasDefault(field)) {
        list += hintTr(QT_TRANSLATE_NOOP("Hint", "default %1")).arg(defaultText(field));
    }
    if (list.isEmpty()) {
        return {};
    }
    list[0][0] = list[0][0].toUpper();
    return list.join(QStringLiteral(", ")).toHtmlEscaped();
}

QString meaningMarkup(const Field& field) {
    return withIndices(meaning(field));
}

} // namespace sparkout
