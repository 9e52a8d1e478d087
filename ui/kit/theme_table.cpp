// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme_table.h"

namespace sparkout {

namespace {

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
     .tones = {0xb31d1d, 0x8a5a00, 0x868d96,                                         //
               0x0072b2, 0x56b4e9, 0xd55e00, 0xb07900, 0x009e73, 0xb4578c, 0xf0e442, //
               0x3b4754, 0xffffff, 0xcfe0f2, 0xf3d9c2, 0xc06a1e, 0xfbe6b4, 0x2f6fb0,
               0x3c8f4e, 0xb31d1d, 0xf2b632, 0x4a3200}},
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
     .tones = {0xff8f86, 0xe3b341, 0x87919d,                                         //
               0x56b4e9, 0x56b4e9, 0xff7f3a, 0xe69f00, 0x2cc89b, 0xe39ac6, 0xf0e442, //
               0xc9d1d9, 0x1b1f24, 0x3f5b79, 0x6d5340, 0xf0a35e, 0x6f5d2c, 0x6cb0f0,
               0x5fc27e, 0xff7b72, 0xf2b632, 0x4a3200}},
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
     .tones = {0xffa39c, 0xffd84d, 0xd8d8d8,                                         //
               0x6cc8ff, 0x6cc8ff, 0xff9457, 0xffb81a, 0x3de0b0, 0xf5acd8, 0xfff25c, //
               0xffffff, 0x000000, 0x2a4a6c, 0x5c4330, 0xffb36b, 0x5f4e1a, 0x8cd0ff,
               0x7ee89c, 0xff8f86, 0xffd84d, 0x000000}},
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
