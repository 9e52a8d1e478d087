// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/wave_text.h"

#include "ui/text/names.h"
#include "words/wave_words.h"

#include <QCoreApplication>

#include <cmath>

namespace sparkout {

QString WaveText::cause(const WaveCause& cause) {
    const QString text = QCoreApplication::translate("Waves", textOf(cause));
    const double number = numberOf(cause);
    return text.contains(QStringLiteral("%1"))
               ? text.arg(Names::fixed(number, number == std::floor(number) ? 0 : 1))
               : text;
}

QString WaveText::howToTell() {
    return QCoreApplication::translate("Waves", waveTestText());
}

} // namespace sparkout
