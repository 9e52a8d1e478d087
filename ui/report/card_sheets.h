// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/card_rows.h"
#include "ui/report/format/form_sheet.h"
#include "ui/session/settings.h"

#include <QDate>
#include <QString>
#include <QStringList>

#include <array>
#include <cstddef>
#include <vector>

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

namespace sparkout::report {

/// The contents of the heads of card and sketch.
struct CardHead {
    Company company;
    QString part;   ///< its name
    QString letter; ///< letter of the document
    QString author; ///< prepared it, unless the company names somebody
    QDate date;
    QStringList operation; ///< values of form::operationRow
    QStringList equipment; ///< values of form::equipmentRow

    [[nodiscard]] QString maker() const;            ///< company and department
    [[nodiscard]] QStringList people() const;       ///< by form::signers
    [[nodiscard]] QStringList designations() const; ///< by form::designations
    [[nodiscard]] QStringList names() const;        ///< by form::names
    [[nodiscard]] QStringList following() const;    ///< by form::continued
};

/// Draws the form: its sheets with head and foot, and the rows of an operation card.
class CardSheets {
public:
    explicit CardSheets(CardHead head) : m_head(std::move(head)) {}

    /// Wraps rows to their cells, on as many sheets as needed; `others` further sheets are counted
    /// with them.
    [[nodiscard]] std::vector<FormSheet> card(const std::vector<CardRow>& rows,
                                              std::size_t following = 0) const;
    /// The sheet of the sketch, empty between head and foot, with its number in the document.
    [[nodiscard]] FormSheet sketch(int number, int count) const;
    /// The free area of a sheet [mm].
    [[nodiscard]] static QRectF sketchRoom(bool first);

private:
    /// A line of the form, part of a wrapped row.
    struct Line {
        CardRow row;
        bool keeps; ///< whether it stays on the page of the next line
    };
    [[nodiscard]] static std::vector<Line> wrapped(const std::vector<CardRow>& rows);
    /// The number of lines from one on that fit on a sheet without separating lines that belong
    /// together.
    [[nodiscard]] static std::size_t taken(const std::vector<Line>& lines, std::size_t from,
                                           std::size_t room);
    [[nodiscard]] FormSheet begun(const form::Kind& kind, bool isFirst, int number,
                                  int count) const;
    void addInventory(FormSheet& sheet, int number, int count) const;
    void addSigners(FormSheet& sheet) const;
    void addDesignations(FormSheet& sheet) const;
    void addCompany(FormSheet& sheet, const QRectF& cell) const;
    static void addFoot(FormSheet& sheet, const form::Kind& kind);
    static void addLine(FormSheet& sheet, const Line& line, double y, std::size_t number,
                        int tableRow);

    CardHead m_head;
};

} // namespace sparkout::report
