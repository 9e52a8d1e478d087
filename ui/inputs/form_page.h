// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <QScrollArea>

#include <string>
#include <vector>

class QGridLayout;
class QGroupBox;
class QVBoxLayout;

namespace sparkout {

class ComplianceBox;
class Document;
class FormRow;
class ListTable;
class ReasonLabel;

/// A text the forms did not take: where, and why.
struct Refusal {
    std::string path;
    QString reason;
};

/// One page of the inputs, made from the tables: every row that names the page, structs as boxes.
class FormPage : public QScrollArea {
    Q_OBJECT

public:
    FormPage(Page page, Document& document, QWidget* parent = nullptr);

    void setIssues(const Issues& issues);
    void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    /// Gives the focus to the field at a path; false when it is not on this page.
    bool focusPath(const std::string& path);
    [[nodiscard]] const std::vector<FormRow*>& rows() const { return m_rows; }

signals:
    void refusalsChanged();

private:
    struct Box {
        std::string path;
        const Field* field;
        QGroupBox* box;
        ReasonLabel* reason;
    };

    void addStruct(const StructInfo& table, const std::string& path, QVBoxLayout& into);
    void addRow(const Field& field, const std::string& path, QVBoxLayout& into);
    void addList(const Field& field, const std::string& path, QVBoxLayout& into);
    void addBox(const Field& field, const std::string& path, QVBoxLayout& into);
    void addProjectTexts(QVBoxLayout& into);
    void connectRow(FormRow& row);
    [[nodiscard]] bool shows(const StructInfo& table) const;
    void showProject(bool replaced);
    void toggleOptional(const Box& box, bool given);

    Page m_page;
    Document& m_document;
    QGridLayout* m_grid = nullptr; ///< where the next plain row goes
    std::vector<FormRow*> m_rows;
    std::vector<Box> m_boxes;
    ComplianceBox* m_compliance = nullptr;
    std::vector<ListTable*> m_lists;
    QGroupBox* m_projectBox = nullptr;
    bool m_replaced = false;
};

} // namespace sparkout
