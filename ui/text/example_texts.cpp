// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/example_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>

namespace sparkout {

namespace {

[[maybe_unused]] constexpr const char* titles[] = {
    QT_TRANSLATE_NOOP("Example", "Bore 40H7, plunge with spark-out"),
    QT_TRANSLATE_NOOP("Example", "Shaft with four sections, two-stage plunge"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6, factory cycle"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6, optimal cycle"),
    QT_TRANSLATE_NOOP("Example", "Shaft 38.74h6, factory cycle"),
    QT_TRANSLATE_NOOP("Example", "Slender shaft with a soft middle"),
    QT_TRANSLATE_NOOP("Example", "Spark-out until size"),
    QT_TRANSLATE_NOOP("Example", "Dull wheel"),
    QT_TRANSLATE_NOOP("Example", "Freshly dressed wheel"),
    QT_TRANSLATE_NOOP("Example", "Spindle of five surfaces"),
    QT_TRANSLATE_NOOP("Example", "Bushing with a bore, internal traverse"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6, measured batch of 50"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6, tables 2 and 3 calibrated"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6, table 2 by a computed compliance"),
    QT_TRANSLATE_NOOP("Example", "Roughness binds the last cut"),
    QT_TRANSLATE_NOOP("Example", "Self-sharpening binds the first stage"),
    QT_TRANSLATE_NOOP("Example", "Accuracy binds the last feed"),
    // the names of their parts and surfaces
    QT_TRANSLATE_NOOP("Example", "Bore 40H7"),
    QT_TRANSLATE_NOOP("Example", "Shaft 40k6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 38.74h6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 25h6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 50h6"),
    QT_TRANSLATE_NOOP("Example", "Bushing 50H7"),
    QT_TRANSLATE_NOOP("Example", "Spindle"),
    QT_TRANSLATE_NOOP("Example", "Journal 35h6 A"),
    QT_TRANSLATE_NOOP("Example", "Bearing seat 40k6 B"),
    QT_TRANSLATE_NOOP("Example", "Bearing seat 40k6 C"),
    QT_TRANSLATE_NOOP("Example", "Journal 35h7 D"),
    QT_TRANSLATE_NOOP("Example", "Coupling seat 30n6 E"),
    // names of their kept runs
    QT_TRANSLATE_NOOP("Example", "Factory"),
    QT_TRANSLATE_NOOP("Example", "Optimal"),
};

// in the order of GivenName
constexpr const char* givenNames[] = {
    QT_TRANSLATE_NOOP("RunName", "Run %1"),
    QT_TRANSLATE_NOOP("RunName", "Worst part, no. %1"),
};

/// Matches such a name with its number and its repetition.
QRegularExpression wholeOf(const char* given) {
    QString pattern = QRegularExpression::escape(QLatin1StringView(given));
    pattern.replace(QStringLiteral("\\%1"), QStringLiteral("([0-9]+)"));
    return QRegularExpression(
        QRegularExpression::anchoredPattern(pattern + QStringLiteral("( \\([0-9]+\\))?")));
}

/// Whether most letters are Cyrillic.
bool isRussian(const QString& text) {
    const auto of = [&](QChar::Script script) {
        return std::ranges::count_if(text, [script](QChar c) { return c.script() == script; });
    };
    return of(QChar::Script_Cyrillic) > of(QChar::Script_Latin);
}

} // namespace

QString exampleTitle(const std::string& title) {
    const bool cut = title.find('\0') != std::string::npos; // translations end there, titles do not
    return cut ? QString::fromStdString(title)
               : QCoreApplication::translate("Example", title.c_str());
}

std::string givenRunName(GivenName kind, const QString& number) {
    return QString(QLatin1StringView(givenNames[static_cast<std::size_t>(kind)]))
        .arg(number)
        .toStdString();
}

QString runName(const std::string& name) {
    static const QRegularExpression patterns[] = {wholeOf(givenNames[0]), wholeOf(givenNames[1])};
    const QString text = QString::fromStdString(name);
    for (std::size_t kind = 0; kind < std::size(givenNames); ++kind) {
        if (const auto match = patterns[kind].match(text); match.hasMatch()) {
            return QCoreApplication::translate("RunName", givenNames[kind]).arg(match.captured(1))
                   + match.captured(2);
        }
    }
    return exampleTitle(name);
}

QString exampleNotes(const std::string& notes) {
    const bool russian = QLocale().language() == QLocale::Russian;
    QStringList shown;
    const QString all = QString::fromStdString(notes);
    for (const QString& paragraph : all.split(QStringLiteral("\n\n"))) {
        if (isRussian(paragraph) == russian && !paragraph.startsWith(u"Verdict: ")) {
            shown += paragraph;
        }
    }
    return shown.isEmpty() ? all : shown.join(QStringLiteral("\n\n"));
}

} // namespace sparkout
