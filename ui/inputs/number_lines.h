// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "ui/form/mark.h"
#include "ui/form/number_field.h"
#include "ui/session/slider_scale.h"
#include "ui/table/pasted_cells.h"

#include <QWidget>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class QGridLayout;
class QLabel;

namespace sparkout {

class CalibratedMark;
class Document;
class ReasonLabel;
class ValueSlider;

/// Numbers in a box, one below the other, each with label, unit, perhaps a slider, and the reason
/// of its mark, that read and change the project by functions instead of a table's row. Cells
/// pasted into one fill it and the following ones.
class NumberLines : public QWidget {
    Q_OBJECT

public:
    struct Line {
        std::string path; ///< path in the project
        NumberSpec spec;
        std::function<std::optional<double>(const Project&)> get;
        std::function<void(Project&, std::optional<double>)> set;
        std::function<QString()> label;
        std::function<QString()> hint;
        std::function<QString()> tip = {};                     ///< the hint as rich text
        std::function<SliderSpec(const Project&)> slider = {}; ///< without it there is none
    };

    NumberLines(Document& document, const char* editText, QWidget* parent = nullptr);

    /// Puts pasted cells into the order of the lines, by default row by row. A matrix may report an
    /// error.
    using Order = std::function<std::vector<QString>(const PastedCells& cells, QString& fault)>;
    void setOrder(Order order) { m_order = std::move(order); }
    /// Sets the accessible names, by the labels; without it they are the labels.
    void setNames(std::function<QString(const QString& label)> names) {
        m_names = std::move(names);
    }
    /// Builds the lines again unless they are the same.
    void setLines(std::vector<Line> lines);
    void showProject(bool replaced);
    void setIssues(const Issues& issues);
    void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    bool dropRefusal(const std::string& path);
    bool focusPath(const std::string& path); ///< false if no line is at the path or below it
    [[nodiscard]] bool empty() const { return m_rows.empty(); }

signals:
    void refusalsChanged();

private:
    struct Row {
        Line line;
        QLabel* label;
        CalibratedMark* calibrated;
        NumberField* field;
        ValueSlider* slider; ///< null: none
        QLabel* unit;
        ReasonLabel* reason;
    };
    void addRow(Line line);
    void connectRow(std::size_t index);
    void store(const Line& line, std::optional<double> value);
    void forgetPaste(); ///< drops the message about refused cells
    void paste(std::size_t index, const PastedCells& cells); ///< all or, with a reason, none
    [[nodiscard]] QString pasteInto(Project& project, std::size_t first,
                                    const std::vector<QString>& cells) const;
    [[nodiscard]] bool fits(const Line& line, std::optional<double> value) const;
    void retranslate(const Row& row);

    Document& m_document;
    const char* m_editText;
    std::function<QString(const QString&)> m_names;
    Order m_order = [](const PastedCells& cells, QString&) { return cells.inOrder(); };
    QGridLayout* m_grid = nullptr;
    QWidget* m_body = nullptr;
    std::vector<Row> m_rows;
    Issues m_issues;
};

} // namespace sparkout
