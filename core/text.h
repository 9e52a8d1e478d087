// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Marks a text of the core for translation (lupdate reads it as QT_TRANSLATE_NOOP); the window
/// translates it in the same context, the command line prints it untranslated.
#define SPARKOUT_NOOP(context, text) text
