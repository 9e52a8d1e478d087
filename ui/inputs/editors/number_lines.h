// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "ui/fields/number_field.h"
#include "ui/fields/refusal.h"

#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;

namespace sparkout {

class Document;
class ReasonLabel;

/// Numbers below each other in a box, each with label, unit and the reason of its mark, that read
/// and change the project by functions instead of a table's row.
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
    [[nodiscard]] bool fits(const Line& line, std::optional<double> value) const;
    void retranslate(const Row& row);

    Document& m_document;
    const char* m_editText;
    std::function<QString()> m_owner;
    QGridLayout* m_grid = nullptr;
    QWidget* m_body = nullptr;
    std::vector<Row> m_rows;
    Issues m_issues;
};

} // namespace sparkout
