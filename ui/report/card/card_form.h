// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <cstddef>

/// The form of operation card and sketch sheet: captions, widths and numbers, reconstructed from
/// the standards [ГОСТ 3.1103, 3.1105, 3.1404]. They are defined here alone.
namespace sparkout::report::form {

/// A cell with its caption and its width [mm].
struct Cell {
    const char* caption; ///< in English, translated in the context CardForm
    double width_mm;
};

/// The paper, A4 landscape, and the elements of every sheet [mm].
inline constexpr double paperWidth = 297, paperHeight = 210;
inline constexpr double left = 20, top = 5, right = 292, bottom = 205;
inline constexpr double width = right - left;
inline constexpr double pitch = 8.5, halfPitch = 4.25; ///< height of lines
inline constexpr double thin = 0.3, thick = 0.7;       ///< widths of rules
inline constexpr double footTop = 192, footBottom = 200.5;
inline constexpr double pad = 1;
inline constexpr double captionPoints = 6, valuePoints = 9, smallPoints = 7.5;

// Head: inventory, changes and sheets; signatures; product.
extern const std::array<const char*, 3> inventory; ///< Дубл., Взам., Подл.
inline constexpr std::array inventoryWidths{12.0, 25.0, 15.0, 15.0};
extern const std::array<Cell, 5> changes;        ///< two side by side
extern const std::array<const char*, 5> signers; ///< Разраб. … Утв.
inline constexpr std::array signerWidths{20.0, 30.0, 16.0, 14.0};
extern const std::array<Cell, 3> designations; ///< organisation, part, document
extern const std::array<Cell, 6> names;        ///< name of the part … operation
extern const std::array<Cell, 4> continued;    ///< the names on further sheets
extern const std::array<Cell, 8> operationRow; ///< row 1: operation, material, …
extern const std::array<Cell, 7> equipmentRow; ///< row 2: equipment, times, coolant
extern const std::array<Cell, 12> columns;     ///< columns of the lines
inline constexpr std::size_t contentColumn = 1, firstValue = 2, mainColumn = 10;

extern const char* const dateFormat; ///< in the notation of QLocale

struct Kind {
    const char* symbol; ///< ОК, in the context CardForm
    const char* name;
    const char* first;     ///< number of the form for the first sheet
    const char* following; ///< for the other sheets
    const char* note;      ///< the standard it follows
};
extern const Kind card, sketch;

[[nodiscard]] QString text(const char* caption); ///< translated

} // namespace sparkout::report::form
