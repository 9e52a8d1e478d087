// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/hint_text.h"

#include "core/project/part.h"
#include "ui/text/designation_text.h"
#include "ui/text/field_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"
#include "words/reference_page.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <set>

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

namespace {

QString fieldsTr(const char* text) {
    return QCoreApplication::translate("Help", text);
}

class FieldWalk {
public:
    std::vector<FieldPlace> places;

    /// Adds plain rows first, so that none of them follows the heading of a struct.
    void addStruct(const StructInfo& table, const QString& path, Page inherited) {
        if (!m_described.insert(&table).second) {
            return;
        }
        for (const bool nested : {false, true}) {
            for (const Field& field : table.fields) {
                if ((field.nested != nullptr) == nested) {
                    addRow(field, table, path, inherited);
                }
            }
        }
    }

private:
    void addRow(const Field& field, const StructInfo& table, const QString& path, Page inherited) {
        const QString at =
            (path.isEmpty() ? QString() : path + u'.') + QString::fromUtf8(field.key);
        Page page = field.page == Page::none ? inherited : field.page;
        if (page == Page::none && field.nested) {
            page = pageWithin(*field.nested);
        }
        places.push_back({&field, &table, page, at});
        if (field.nested) {
            addStruct(*field.nested, at, page);
        }
    }

    /// The page of the first row with one: for a struct without a box of its own.
    static Page pageWithin(const StructInfo& table) {
        for (const Field& field : table.fields) {
            const Page page =
                field.page == Page::none && field.nested ? pageWithin(*field.nested) : field.page;
            if (page != Page::none) {
                return page;
            }
        }
        return Page::none;
    }

    std::set<const StructInfo*> m_described;
};

/// "Read with: traverse; gauge at a section".
QString whenRead(const FieldPlace& place) {
    if (!place.field->relevant) {
        return {};
    }
    QStringList groups;
    for (const auto& group : conditionAnswers(place.field->relevant, *place.table)
                                 .value_or(std::vector<std::vector<const char*>>())) {
        QStringList words;
        for (const char* word : group) {
            words += QCoreApplication::translate("Condition", word);
        }
        groups += words.join(QStringLiteral(" / "));
    }
    return groups.isEmpty() ? QString()
                            : fieldsTr(QT_TRANSLATE_NOOP("Help", "Read with: %1"))
                                  .arg(groups.join(QStringLiteral("; ")));
}

QString choicesOfField(const Field& field) {
    QStringList list;
    for (std::size_t i = 0; field.kind == Kind::choice && i < field.choices.size(); ++i) {
        list += choiceText(field.choices[i].label);
    }
    return list.isEmpty() ? QString()
                          : fieldsTr(QT_TRANSLATE_NOOP("Help", "Choices: %1"))
                                .arg(list.join(QStringLiteral("; ")));
}

/// The hint of a row; its source is a link to its description.
QString linkedHint(const Field& field) {
    static const QRegularExpression code(QStringLiteral("`([^`]*)`"));
    QString html = hintMarkup(field).replace(code, QStringLiteral("<code>\\1</code>"));
    const QString source = sourceText(field.source).toHtmlEscaped();
    const qsizetype at = source.isEmpty() ? -1 : html.lastIndexOf(source);
    if (at < 0) {
        return html;
    }
    const QString key = QString::fromUtf8(field.source);
    const QString target = key.startsWith(QStringLiteral("MODEL-"))
                               ? QStringLiteral("model#") + key.toLower()
                               : QStringLiteral("sources#") + key;
    return html.replace(at, source.size(),
                        QStringLiteral("<a href=\"help:%1\">%2</a>").arg(target, source));
}

QString fieldHead(const FieldPlace& place) {
    const Field& field = *place.field;
    QString head = labelMarkup(field);
    if (*field.unit) {
        head += QStringLiteral(", ") + unitText(field.unit).toHtmlEscaped();
    }
    return head;
}

/// For a struct that is described elsewhere: a link to it.
QString describedElsewhere(const FieldPlace& place) {
    const auto first = std::ranges::find(fieldPlaces(), place.field->nested, &FieldPlace::table);
    if (first == fieldPlaces().end() || first->anchor.startsWith(place.anchor + u'.')) {
        return {};
    }
    const QString there = first->anchor.section(u'.', 0, -2);
    return QStringLiteral("<p>%1</p>")
        .arg(fieldsTr(QT_TRANSLATE_NOOP("Help", "Its inputs are those of %1."))
                 .arg(QStringLiteral("<a href=\"help:%1#%2\"><code>%2</code></a>")
                          .arg(fieldPageId(first->page), there)));
}

QString fieldHtml(const FieldPlace& place) {
    const Field& field = *place.field;
    const bool group = field.nested != nullptr;
    QString html = QStringLiteral("<h%1 id=\"%2\">%3</h%1>")
                       .arg(group ? 2 : 3)
                       .arg(place.anchor, fieldHead(place));
    html += linkedHint(field);
    if (group) {
        html += describedElsewhere(place);
    }
    for (const QString& line : {choicesOfField(field), whenRead(place)}) {
        if (!line.isEmpty()) {
            html += QStringLiteral("<p>%1</p>").arg(line.toHtmlEscaped());
        }
    }
    return html
           + QStringLiteral("<p class=\"key\">%1</p>")
                 .arg(fieldsTr(QT_TRANSLATE_NOOP("Help", "In the project file: %1"))
                          .arg(QStringLiteral("<code>%1</code>").arg(place.anchor)));
}

} // namespace

const std::vector<FieldPlace>& fieldPlaces() {
    static const std::vector<FieldPlace> all = [] {
        FieldWalk walk;
        walk.addStruct(tableOf<Project>(), {}, Page::none);
        return walk.places;
    }();
    return all;
}

QString fieldPageId(Page page) {
    switch (page) {
    case Page::part: return QStringLiteral("inputs-part");
    case Page::material: return QStringLiteral("inputs-material");
    case Page::wheel: return QStringLiteral("inputs-wheel");
    case Page::machine: return QStringLiteral("inputs-machine");
    case Page::gauge: return QStringLiteral("inputs-gauge");
    case Page::cycle: return QStringLiteral("inputs-cycle");
    case Page::batch: return QStringLiteral("inputs-batch");
    case Page::search: return QStringLiteral("inputs-search");
    case Page::none: break;
    }
    return QStringLiteral("inputs-file");
}

QString fieldTopic(const Field& field) {
    const auto& places = fieldPlaces();
    const auto found = std::ranges::find(places, &field, &FieldPlace::field);
    return found == places.end() ? QString() : fieldPageId(found->page) + u'#' + found->anchor;
}

QString fieldsHtml(Page page) {
    QString html;
    for (const FieldPlace& place : fieldPlaces()) {
        if (place.page == page) {
            html += fieldHtml(place);
        }
    }
    return html;
}

} // namespace sparkout
