// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/texts.h"

#include "core/printable.h"
#include "core/project/member.h"
#include "core/project/project.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <cmath>

namespace sparkout {

namespace {

QString translated(const char* context, const char* text) {
    return *text ? QCoreApplication::translate(context, text) : QString();
}

constexpr std::array units{
    QT_TRANSLATE_NOOP("Unit", "mm/dbl stroke"),
    QT_TRANSLATE_NOOP("Unit", "mm/min"),
    QT_TRANSLATE_NOOP("Unit", "mm/N"),
    QT_TRANSLATE_NOOP("Unit", "mm²/s"),
    QT_TRANSLATE_NOOP("Unit", "mm"),
    QT_TRANSLATE_NOOP("Unit", "µm"),
    QT_TRANSLATE_NOOP("Unit", "rev/min"),
    QT_TRANSLATE_NOOP("Unit", "m/s"),
    QT_TRANSLATE_NOOP("Unit", "s"),
    QT_TRANSLATE_NOOP("Unit", "N, N/µm"),
    QT_TRANSLATE_NOOP("Unit", "N/µm"),
    QT_TRANSLATE_NOOP("Unit", "MPa"),
    QT_TRANSLATE_NOOP("Unit", "GPa"),
    QT_TRANSLATE_NOOP("Unit", "kW"),
    QT_TRANSLATE_NOOP("Unit", "HRC"),
    QT_TRANSLATE_NOOP("Unit", "W/(m·K)"),
    QT_TRANSLATE_NOOP("Unit", "J/m²"),
    QT_TRANSLATE_NOOP("Unit", "1/mm²"),
    QT_TRANSLATE_NOOP("Unit", "K"),
    QT_TRANSLATE_NOOP("Unit", "°"),
    QT_TRANSLATE_NOOP("Unit", "bytes"),
};

/// Words the core uses in the values and limits of its issues.
constexpr std::array words{
    QT_TRANSLATE_NOOP("Detail", "plunge"),
    QT_TRANSLATE_NOOP("Detail", "traverse"),
    QT_TRANSLATE_NOOP("Detail", "internal"),
    QT_TRANSLATE_NOOP("Detail", "external"),
};

/// Patterns that find each of the texts in its surroundings, made once.
template <std::size_t N>
std::array<QRegularExpression, N> patterns(const std::array<const char*, N>& texts,
                                           const QString& around) {
    std::array<QRegularExpression, N> all;
    for (std::size_t i = 0; i < N; ++i) {
        all[i] =
            QRegularExpression(around.arg(QRegularExpression::escape(QString::fromUtf8(texts[i]))),
                               QRegularExpression::UseUnicodePropertiesOption);
    }
    return all;
}

/// "L_p" → "Lₚ", where there are signs for all of an index. A key, as diameter_mm, stays as typed.
QString withSubscripts(QString text) {
    static const QString plain = QStringLiteral("0123456789aehijklmnoprstuvx");
    static const QString below = QStringLiteral("₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ");
    static const QRegularExpression index(
        QStringLiteral("(?<=\\b\\w|\\bΔ\\w|\\b\\d\\w)_([^\\W_]+)\\b"),
        QRegularExpression::UseUnicodePropertiesOption);
    qsizetype from = 0;
    for (auto found = index.match(text); found.hasMatch(); found = index.match(text, from)) {
        QString written = found.captured(1);
        for (QChar& sign : written) {
            const qsizetype at = plain.indexOf(sign);
            sign = at < 0 ? QChar() : below[at];
        }
        if (!written.contains(QChar())) {
            text.replace(found.capturedStart(), found.capturedLength(), written);
        }
        from = found.capturedStart() + written.size();
    }
    return text;
}

/// "(/part/length_mm)" → "(Ground length L_p)".
QString withLabels(QString text) {
    static const QRegularExpression pointer(QStringLiteral("(?<=\\()/[\\w/]+(?=\\))"));
    for (auto found = pointer.match(text); found.hasMatch(); found = pointer.match(text)) {
        const Field* field = nearestField(Project(), found.captured().toStdString());
        const QString label = field ? QStringLiteral("%1 %2").arg(inputText(field->label),
                                                                  QString::fromUtf8(field->symbol))
                                    : locationText(found.captured().toStdString());
        text.replace(found.capturedStart(), found.capturedLength(), label.trimmed());
    }
    return text;
}

/// "1e-05 mm" → "0.00001 mm": the core writes the shortest text of a number.
QString withoutExponents(QString text) {
    static const QRegularExpression number(QStringLiteral("\\d+(?:\\.\\d+)?e[-+]?\\d+"));
    qsizetype from = 0;
    for (auto found = number.match(text); found.hasMatch(); found = number.match(text, from)) {
        const auto value = parseNumber(found.captured());
        const QString shown = value ? showNumber(*value, QLocale::c()) : found.captured();
        text.replace(found.capturedStart(), found.capturedLength(), shown);
        from = found.capturedStart() + shown.size();
    }
    return text;
}

/// A value or limit of an issue in the present language. What quotes the file stays as it is.
std::string localised(const std::string& detail) {
    QString text = QString::fromStdString(detail);
    if (const QString whole = translated("Limit", detail.c_str()); whole != text) {
        return whole.toStdString();
    }
    if (text.contains(u'"')) {
        return detail;
    }
    static const auto wordPatterns = patterns(words, QStringLiteral("(?<![\\w])%1(?![\\w])"));
    static const auto unitPatterns = patterns(units, QStringLiteral("(?<=[\\d\\w]) %1(?![\\w/²])"));
    for (std::size_t i = 0; i < words.size(); ++i) {
        text.replace(wordPatterns[i], translated("Detail", words[i]));
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
        text.replace(unitPatterns[i], u' ' + translated("Unit", units[i]));
    }
    static const QRegularExpression point(QStringLiteral("(?<=\\d)\\.(?=\\d)"));
    static const QRegularExpression minus(QStringLiteral("(?<![\\w./-])-(?=\\d)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    text = withoutExponents(text)
               .replace(point, QLocale().decimalPoint())
               .replace(minus, QStringLiteral("−"));
    return withSubscripts(withLabels(text)).toStdString();
}

} // namespace

QString inputText(const char* text) {
    return translated("Input", text);
}
QString choiceText(const char* text) {
    return translated("Choice", text);
}
QString structText(const char* text) {
    return translated("Struct", text);
}
QString unitText(const char* unit) {
    return translated("Unit", unit);
}

QString zoneText(const char* key) {
    const QLatin1StringView name(key);
    if (name == QLatin1StringView("rz1")) {
        return QCoreApplication::translate("Zone", "RZ1");
    }
    if (name == QLatin1StringView("nz")) {
        return QCoreApplication::translate("Zone", "NZ");
    }
    return name == QLatin1StringView("rz2") ? QCoreApplication::translate("Zone", "RZ2")
                                            : QString::fromUtf8(key);
}

QString rangeShown(const Range& range, const char* unit) {
    const bool below = std::isfinite(range.low);
    const bool above = std::isfinite(range.high);
    const QString low = showNumber(range.low, QLocale()).replace(u'-', u'−');
    const QString high = showNumber(range.high, QLocale()).replace(u'-', u'−');
    QString text;
    if (below && above) {
        text = range.lowOpen ? QCoreApplication::translate("Range", "above %1, up to %2")
                             : QCoreApplication::translate("Range", "%1 to %2");
        text = text.arg(low, high);
    } else if (below) {
        text = range.lowOpen ? QCoreApplication::translate("Range", "above %1").arg(low)
                             : QCoreApplication::translate("Range", "at least %1").arg(low);
    } else if (above) {
        text = QCoreApplication::translate("Range", "at most %1").arg(high);
    }
    return text.isEmpty() || !*unit ? text : text + u'\u00a0' + unitText(unit);
}

QString rangeBrief(const Range& range, const char* unit) {
    const auto number = [](double value) {
        return showNumber(value, QLocale()).replace(u'-', QChar(0x2212));
    };
    QString text;
    if (std::isfinite(range.low)) {
        text = (range.lowOpen ? QStringLiteral(">") : QString()) + number(range.low);
        text.prepend(std::isfinite(range.high) || range.lowOpen ? QString() : QStringLiteral("≥"));
    }
    if (std::isfinite(range.high)) {
        text += (text.isEmpty() ? QStringLiteral("≤") : QStringLiteral("…")) + number(range.high);
    }
    return text.isEmpty() || !*unit ? text : text + u'\u00a0' + unitText(unit);
}

QString issueText(const Issue& issue) {
    Issue shown = issue;
    shown.value = localised(issue.value);
    shown.limit = localised(issue.limit);
    const QString sentence = translated("Issue", issueTemplate(issue.code));
    return QString::fromStdString(fillTemplate(sentence.toStdString(), shown));
}

QString locationText(const std::string& path) {
    QStringList words;
    const StructInfo* table = &tableOf<Project>();
    const Field* list = nullptr;
    const QStringList keys = QString::fromStdString(path).split(u'/', Qt::SkipEmptyParts);
    for (const QString& key : keys) {
        bool isIndex = false;
        const int index = key.toInt(&isIndex);
        const Field* field = table ? table->find(key.toStdString()) : nullptr;
        if (isIndex && list && list->nested) {
            words += QCoreApplication::translate("Location", "%1 %2")
                         .arg(structText(list->nested->name))
                         .arg(index + 1);
        } else if (isIndex && list && list->kind == Kind::compliance) {
            words += QCoreApplication::translate("Zone", "Section %1").arg(index);
        } else if (field) {
            words += inputText(field->label);
            table = field->nested;
            list = field;
        } else {
            words += zoneText(key.toUtf8().constData());
        }
    }
    return words.join(QStringLiteral(" › "));
}

QString printableText(const QString& text) {
    return QString::fromStdString(printable(text.toStdString()));
}

QString harmlessText(QString text) {
    for (QChar& c : text) {
        const bool control = (c < u' ' && c != u'\n' && c != u'\t' && c != u'\r')
                             || (c >= QChar(0x7f) && c < QChar(0xa0));
        const bool turns = c == QChar(0x061c) || c == QChar(0x200e) || c == QChar(0x200f)
                           || (c >= QChar(0x202a) && c <= QChar(0x202e))
                           || (c >= QChar(0x2066) && c <= QChar(0x2069));
        if (control || turns || c.isNonCharacter()) {
            c = QChar::ReplacementCharacter;
        }
    }
    return text;
}

QString withIndices(const QString& text) {
    static const QRegularExpression index(QStringLiteral("_(?:\\(([^)]*)\\)|(\\w+))"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    return text.toHtmlEscaped().replace(index, QStringLiteral("<sub>\\1\\2</sub>"));
}

} // namespace sparkout
