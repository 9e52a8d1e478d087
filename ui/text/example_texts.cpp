// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/example_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>

namespace sparkout {

namespace {

/// A shipped example: its file and the title in it.
struct ShippedExample {
    const char* file;
    const char* title;
};

/// The examples in the order of the gallery: a starting cycle, other parts of a shop, cycles bound
/// by one limit each, and the parts of the sources.
constexpr ShippedExample shippedExamples[] = {
    {"starting-cycle-35k6.sparkout",
     QT_TRANSLATE_NOOP("Example", "Bearing seat 35k6, starting cycle")},
    {"plunge-shaft-two-stage.sparkout",
     QT_TRANSLATE_NOOP("Example", "Shaft with four sections, two-stage plunge")},
    {"spark-out-until-size.sparkout", QT_TRANSLATE_NOOP("Example", "Spark-out until size")},
    {"internal-plunge.sparkout", QT_TRANSLATE_NOOP("Example", "Bore 40H7, plunge with spark-out")},
    {"through-bore.sparkout",
     QT_TRANSLATE_NOOP("Example", "Bushing with a bore, internal traverse")},
    {"slender-shaft.sparkout", QT_TRANSLATE_NOOP("Example", "Slender shaft with a soft middle")},
    {"waves-of-the-wheel.sparkout",
     QT_TRANSLATE_NOOP("Example", "Waves that no spark-out removes")},
    {"seventy-waves.sparkout", QT_TRANSLATE_NOOP("Example", "Seventy waves counted on a roll")},
    {"spindle.sparkout", QT_TRANSLATE_NOOP("Example", "Spindle of five surfaces")},
    {"wheel-sharp.sparkout", QT_TRANSLATE_NOOP("Example", "Freshly dressed wheel")},
    {"wheel-dull.sparkout", QT_TRANSLATE_NOOP("Example", "Dull wheel")},
    {"plunge-roughness-limit.sparkout",
     QT_TRANSLATE_NOOP("Example", "Roughness binds the last cut")},
    {"plunge-self-sharpening-limit.sparkout",
     QT_TRANSLATE_NOOP("Example", "Self-sharpening binds the first stage")},
    {"plunge-accuracy-limit.sparkout",
     QT_TRANSLATE_NOOP("Example", "Accuracy binds the last feed")},
    {"shaft-30h6-factory.sparkout", QT_TRANSLATE_NOOP("Example", "Shaft 30h6, factory cycle")},
    {"shaft-30h6-optimal.sparkout", QT_TRANSLATE_NOOP("Example", "Shaft 30h6, optimal cycle")},
    {"shaft-30h6-calibrated.sparkout",
     QT_TRANSLATE_NOOP("Example", "Shaft 30h6, tables 2 and 3 calibrated")},
    {"shaft-30h6-measured.sparkout",
     QT_TRANSLATE_NOOP("Example", "Shaft 30h6, measured batch of 50")},
    {"shaft-30h6-slender.sparkout",
     QT_TRANSLATE_NOOP("Example", "Shaft 30h6, table 2 by a computed compliance")},
    {"shaft-38-74h6.sparkout", QT_TRANSLATE_NOOP("Example", "Shaft 38.74h6, factory cycle")},
};

[[maybe_unused]] constexpr const char* partNames[] = {
    // parts and surfaces of the examples
    QT_TRANSLATE_NOOP("Example", "Bearing seat 35k6"),
    QT_TRANSLATE_NOOP("Example", "Bore 40H7"),
    QT_TRANSLATE_NOOP("Example", "Shaft 40k6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 30h6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 38.74h6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 25h6"),
    QT_TRANSLATE_NOOP("Example", "Shaft 50h6"),
    QT_TRANSLATE_NOOP("Example", "Bushing 50H7"),
    QT_TRANSLATE_NOOP("Example", "Roll 160h6"),
    QT_TRANSLATE_NOOP("Example", "Spindle"),
    QT_TRANSLATE_NOOP("Example", "Journal 35h6 A"),
    QT_TRANSLATE_NOOP("Example", "Bearing seat 40k6 B"),
    QT_TRANSLATE_NOOP("Example", "Bearing seat 40k6 C"),
    QT_TRANSLATE_NOOP("Example", "Journal 35h7 D"),
    QT_TRANSLATE_NOOP("Example", "Coupling seat 30n6 E"),
    // their kept runs
    QT_TRANSLATE_NOOP("Example", "Factory"),
    QT_TRANSLATE_NOOP("Example", "Factory, 92 mm"),
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

QStringList exampleFiles() {
    QStringList files;
    for (const ShippedExample& each : shippedExamples) {
        files += QString::fromLatin1(each.file);
    }
    return files;
}

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
