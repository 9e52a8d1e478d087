// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/card/card_form.h"
#include "ui/report/card/card_rows.h"
#include "ui/report/format/form_sheet.h"
#include "ui/session/company.h"

#include <QDate>
#include <QStringList>

#include <vector>

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
