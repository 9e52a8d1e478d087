// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "ui/fields/number_field.h"
#include "ui/fields/refusal.h"
#include "ui/tables/pasted_cells.h"

#include <QWidget>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class QGridLayout;
class QLabel;

namespace sparkout {

class Document;
class ReasonLabel;

/// Numbers below each other in a box, each with label, unit and the reason of its mark, that read
/// and change the project by functions instead of a table's row. Cells pasted into one fill it and
/// those below it.
class NumberLines : public QWidget {
    Q_OBJECT

public:
    /// One of the numbers.
    struct Line {
        std::string path; ///< in the project
        NumberSpec spec;
        std::function<std::optional<double>(const Project&)> get;
        std::function<void(Project&, std::optional<double>)> set;
        std::function<QString()> label;
        std::function<QString()> hint;
    };

    NumberLines(Document& document, const char* editText, QWidget* parent = nullptr);

    /// How pasted cells are put into the order of the lines; otherwise row by row. A matrix may
    /// have a fault of its own.
    using Order = std::function<std::vector<QString>(const PastedCells& cells, QString& fault)>;
    void setOrder(Order order) { m_order = std::move(order); }
    void setOwner(std::function<QString()> owner); ///< whose numbers, for their accessible names
    /// Builds the lines anew unless they are those that stand there.
    void setLines(std::vector<Line> lines);
    void showProject(bool replaced);
    void setIssues(const Issues& issues);
    void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    bool dropRefusal(const std::string& path);
    bool focusPath(const std::string& path); ///< false: none of the lines is at the path or below
    [[nodiscard]] bool empty() const { return m_rows.empty(); }

signals:
    void refusalsChanged();

private:
    struct Row {
        Line line;
        QLabel* label;
        NumberField* field;
        QLabel* unit;
        ReasonLabel* reason;
    };
    void addRow(Line line);
    void connectRow(std::size_t index);
    void forgetPaste(); ///< what was said of cells that were not taken
    void paste(std::size_t index, const PastedCells& cells); ///< all or, with a reason, none
    [[nodiscard]] QString pasteInto(Project& project, std::size_t first,
                                    const std::vector<QString>& cells) const;
    [[nodiscard]] bool fits(const Line& line, std::optional<double> value) const;
    void retranslate(const Row& row);

    Document& m_document;
    const char* m_editText;
    std::function<QString()> m_owner;
    Order m_order = [](const PastedCells& cells, QString&) { return cells.inOrder(); };
    QGridLayout* m_grid = nullptr;
    QWidget* m_body = nullptr;
    std::vector<Row> m_rows;
    Issues m_issues;
};

} // namespace sparkout
