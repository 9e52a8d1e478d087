// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme_table.h"

#include <array>
#include <iterator>

namespace sparkout {

namespace {

/// A tone in the light, the dark and the contrast theme.
struct ToneRow {
    Tone tone;
    std::array<QRgb, 3> colours;
};

constexpr ToneRow toneRows[] = {
    {Tone::error, {0xb31d1d, 0xff8f86, 0xffa39c}},
    {Tone::warning, {0x8a5a00, 0xe3b341, 0xffd84d}},
    {Tone::outline, {0x868d96, 0x87919d, 0xd8d8d8}},
    {Tone::blue, {0x0072b2, 0x56b4e9, 0x6cc8ff}},
    {Tone::sky, {0x56b4e9, 0x56b4e9, 0x6cc8ff}},
    {Tone::vermilion, {0xd55e00, 0xff7f3a, 0xff9457}},
    {Tone::orange, {0xb07900, 0xe69f00, 0xffb81a}},
    {Tone::green, {0x009e73, 0x2cc89b, 0x3de0b0}},
    {Tone::purple, {0xb4578c, 0xe39ac6, 0xf5acd8}},
    {Tone::yellow, {0xf0e442, 0xf0e442, 0xfff25c}},
    {Tone::ink, {0x3b4754, 0xc9d1d9, 0xffffff}},
    {Tone::paper, {0xffffff, 0x1b1f24, 0x000000}},
    {Tone::steel, {0xcfe0f2, 0x3f5b79, 0x2a4a6c}},
    {Tone::abrasive, {0xf3d9c2, 0x6d5340, 0x5c4330}},
    {Tone::grain, {0xc06a1e, 0xf0a35e, 0xffb36b}},
    {Tone::sand, {0xfbe6b4, 0x6f5d2c, 0x5f4e1a}},
    {Tone::accent, {0x2f6fb0, 0x6cb0f0, 0x8cd0ff}},
    {Tone::add, {0x3c8f4e, 0x5fc27e, 0x7ee89c}},
    {Tone::remove, {0xb31d1d, 0xff7b72, 0xff8f86}},
    {Tone::amber, {0xf2b632, 0xf2b632, 0xffd84d}},
    {Tone::amberInk, {0x4a3200, 0x4a3200, 0x000000}},
};

constexpr bool isWhole() {
    std::size_t next = 0;
    for (const ToneRow& row : toneRows) {
        if (row.tone != static_cast<Tone>(next++)) {
            return false;
        }
    }
    return next == static_cast<std::size_t>(Tone::count_);
}
static_assert(isWhole(), "a row for each tone, in the order of the enumeration");

constexpr auto column(std::size_t theme) {
    std::array<QRgb, std::size(toneRows)> colours{};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        colours[i] = toneRows[i].colours[theme];
    }
    return colours;
}

constexpr ThemeColours table[] = {
    {.theme = Theme::light,
     .window = 0xf3f4f6,
     .base = 0xffffff,
     .alternate = 0xf7f8fa,
     .button = 0xeff0f2,
     .text = 0x000000,
     .placeholder = 0x626973,
     .disabled = 0x868c95,
     .highlight = 0x2f6fb0,
     .highlighted = 0xffffff,
     .tip = 0xffffe1,
     .tipText = 0x000000,
     .link = 0x1a5fa8,
     .tones = column(0)},
    {.theme = Theme::dark,
     .window = 0x252a30,
     .base = 0x1b1f24,
     .alternate = 0x20252a,
     .button = 0x30363d,
     .text = 0xe6e9ed,
     .placeholder = 0xa3adb9,
     .disabled = 0x838c97,
     .highlight = 0x3877bb,
     .highlighted = 0xffffff,
     .tip = 0x3d444d,
     .tipText = 0xf0f3f6,
     .link = 0x7db8f2,
     .tones = column(1)},
    {.theme = Theme::contrast,
     .window = 0x000000,
     .base = 0x000000,
     .alternate = 0x141414,
     .button = 0x1c1c1c,
     .text = 0xffffff,
     .placeholder = 0xd0d0d0,
     .disabled = 0x9a9a9a,
     .highlight = 0xffe14d,
     .highlighted = 0x000000,
     .tip = 0x000000,
     .tipText = 0xffffff,
     .link = 0x8cd0ff,
     .tones = column(2)},
};

} // namespace

const ThemeColours& coloursOf(Theme theme) {
    for (const ThemeColours& row : table) {
        if (row.theme == theme) {
            return row;
        }
    }
    return table[0];
}

const ThemeColours& coloursFor(const QPalette& palette) {
    const QColor base = palette.color(QPalette::Active, QPalette::Base);
    for (const ThemeColours& row : table) {
        if (base == QColor(row.base)) {
            return row;
        }
    }
    return coloursOf(base.lightness() < 128 ? Theme::dark : Theme::light);
}

} // namespace sparkout
