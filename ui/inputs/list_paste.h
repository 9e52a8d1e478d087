// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"
#include "ui/table/pasted_cells.h"

#include <QCoreApplication>
#include <QModelIndex>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

class ListModel;

/// Pastes rows of a spreadsheet into a list of the project: from a cell on, with rows added at the
/// end; or, if the first row has headings of the table, under these and replacing all rows.
/// Headings of another table are ignored. Either all cells are accepted or none.
class ListPaste {
    Q_DECLARE_TR_FUNCTIONS(ListPaste)

public:
    /// Pastes into the list at `path`, described by `list`, as displayed by the model; `at` is the
    /// selected cell.
    ListPaste(const ListModel& model, std::string path, const Field& list, const Project& project);

    void paste(PastedCells cells, const QModelIndex& at);

    /// With all cells; empty if one was refused.
    [[nodiscard]] const std::optional<Project>& project() const { return m_project; }
    /// The refused cells by row and column, with their reasons.
    [[nodiscard]] const QStringList& faults() const { return m_faults; }
    [[nodiscard]] int firstRow() const { return m_first; }

private:
    /// A column of the pasted cells and its member; null: a result, ignored.
    struct Column {
        qsizetype from;
        const Field* field;
        double factor = 1; ///< converts pasted into displayed numbers
    };

    [[nodiscard]] std::vector<Column> columnsByHeads(const QStringList& heads) const;
    [[nodiscard]] static bool hasForeignHeads(const std::vector<QStringList>& rows,
                                              const std::vector<Column>& columns);
    [[nodiscard]] std::vector<Column> columnsFrom(int first, qsizetype width);
    void makeRoom(std::size_t rows, const std::vector<Column>& columns, bool all);
    void take(const std::vector<QStringList>& rows, const std::vector<Column>& columns);
    void takeCell(int row, const Field& field, const QString& text);

    const ListModel& m_model;
    std::string m_path;
    const Field& m_list;
    std::optional<Project> m_project;
    QStringList m_faults;
    int m_first = 0;
};

} // namespace sparkout
