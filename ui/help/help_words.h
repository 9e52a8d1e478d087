// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace sparkout {

/// Text to be searched: case, and е for ё, make no difference.
[[nodiscard]] QString folded(QString text);

/// The words that are looked for, folded and without the endings of the present language: so
/// "feeds" finds "feed", «подачей» finds «подача».
[[nodiscard]] QStringList searchedWords(const QString& words);

} // namespace sparkout
