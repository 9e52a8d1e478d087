// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "core/study/outcome.h"
#include "ui/form/mark.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/project_model.h"

#include <QScrollArea>

#include <string>
#include <utility>
#include <vector>

class QLabel;
class QToolButton;

namespace sparkout {

class CatalogueBar;
class Document;
class FormRow;
class InputBox;
class ListTable;
class PageColumns;
class ReasonLabel;
class RowHelper;
class SectionBox;
class Settings;
class StageTable;

/// One page of the inputs, made from the tables: every row with that page, structs as boxes. It is
/// built when first shown or used: the window begins with one page of eight.
class FormPage : public QScrollArea {
    Q_OBJECT

public:
    /// Without settings the user's catalogues last as long as the page, and all inputs are shown.
    FormPage(Page page, Document& document, QWidget* parent = nullptr,
             Settings* settings = nullptr);
    ~FormPage() override;

    void build(); ///< builds the rows, once
    void setOutcome(const sparkout::OutcomePtr& outcome);
    void forgetResults();
    /// Sets which inputs may be changed and which are shown.
    void setAccess(const FormAccessPtr& access);
    void setAllInputs(bool all);   ///< all inputs, or the usual ones
    [[nodiscard]] bool hasShown(); ///< whether any input is shown
    void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    /// Restores the document's value in a refused field; false if it is not on this page.
    bool dropRefusal(const std::string& path);
    /// Whether this page shows the field at a path.
    [[nodiscard]] bool holds(const std::string& path);
    /// Scrolls to the field at a path and optionally gives it the focus.
    void showPath(const std::string& path, bool focus);
    [[nodiscard]] const std::vector<FormRow*>& rows() const { return m_rows; } ///< once built

signals:
    void built();
    void allInputsChosen(bool all);
    void refusalsChanged();

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Box {
        std::string path;
        const Field* field;
        SectionBox* box;
        ReasonLabel* reason;
    };

    /// The destination of rows: a layout, and its depth in boxes.
    struct Place {
        PageColumns& rows;
        int depth;
    };

    void addCatalogue(Settings* settings, Place into);
    void addHelper(RowHelper* helper, const std::string& path, Place into);
    void addStruct(const StructInfo& table, const std::string& path, Place into);
    void addRow(const Field& field, const std::string& path, Place into);
    void addInputBox(InputBox* box, Place into);
    void addList(const Field& field, const std::string& path, Place into);
    void addBox(const Field& field, const std::string& path, Place into);
    void addProjectTexts(Place into);
    void connectRow(FormRow& row);
    [[nodiscard]] FormRow* rowAt(const std::string& path) const;
    [[nodiscard]] QWidget* placeToType(const FormRow& row) const; ///< the field for its value
    [[nodiscard]] const Box* boxAt(const std::string& path) const;
    [[nodiscard]] InputBox* inputBoxAt(const std::string& path) const;
    [[nodiscard]] bool shows(const StructInfo& table) const;
    [[nodiscard]] bool hasShown(const StructInfo& table, const std::string& path) const;
    void showProject(bool replaced);
    void showShared();
    void showRank(const InputRank& rank); ///< applies the ranks of inputs
    void showAllButton();
    void want(const std::string& path);
    [[nodiscard]] bool isOnDemand(const std::string& path) const; ///< and currently hidden
    void showAccess();
    void giveAccess(); ///< to rows and lists
    void toggleOptional(const Box& box, bool given);

    Page m_page;
    Document& m_document;
    ProjectModel m_model;
    Settings* m_settings;
    bool m_isBuilt = false;
    sparkout::OutcomePtr m_outcome; ///< for parts not built yet
    std::vector<FormRow*> m_rows;
    std::vector<Box> m_boxes;
    CatalogueBar* m_catalogue = nullptr;                       ///< on pages with a catalogue
    std::vector<std::pair<RowHelper*, std::string>> m_helpers; ///< with the paths of their rows
    std::vector<InputBox*> m_inputBoxes;
    FormAccessPtr m_access = std::make_shared<const FormAccess>();
    std::string m_cataloguePath; ///< path of the struct that it fills
    std::vector<ListTable*> m_lists;
    std::vector<std::pair<ListTable*, QLabel*>> m_sharedLists; ///< with their labels
    StageTable* m_stages = nullptr;                            ///< one of the lists
    SectionBox* m_projectBox = nullptr;
    bool m_replaced = false;
    InputRank m_rank;
    QToolButton* m_all = nullptr; ///< at the bottom: all inputs, or the usual ones
};

} // namespace sparkout
