// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_text.h"

#include "core/lesson/text_markup.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

namespace sparkout {

namespace {

bool speaksRussian() {
    return QLocale().language() == QLocale::Russian;
}

} // namespace

QString LessonText::of(const Bilingual& text) {
    return unbroken(harmlessText(QString::fromStdString(text.in(speaksRussian()))));
}

QString LessonText::tagged(const Bilingual& text) {
    const std::string& shown = text.in(speaksRussian());
    return isLaidOutSoon(shown)
               ? of(text)
               : harmlessText(QString::fromStdString(shown.substr(0, limits::lessonText.bytes)))
                     .toHtmlEscaped();
}

QString LessonText::markup(const Bilingual& text) {
    const QPalette palette = QGuiApplication::palette();
    return QStringLiteral("<style>p { margin-top: 4px; margin-bottom: 4px; } "
                          "p.formula { margin-left: 12px; background-color: %1; } "
                          "td, th { padding: 2px 8px 2px 0px; }</style>%2")
        .arg(palette.color(QPalette::AlternateBase).name(), tagged(text));
}

QString LessonText::points(double points) {
    return printedNumber(points);
}

QString LessonText::mark(LessonRun::Mark mark) {
    switch (mark) {
    case LessonRun::Mark::open: return tr("open");
    case LessonRun::Mark::checked: return tr("being checked");
    case LessonRun::Mark::passed: return tr("done");
    case LessonRun::Mark::failed: return tr("not passed");
    case LessonRun::Mark::teacher: return tr("handed in");
    }
    return {};
}

} // namespace sparkout
