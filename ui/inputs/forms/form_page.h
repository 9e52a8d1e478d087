// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "core/study/outcome.h"
#include "ui/fields/refusal.h"
#include "ui/inputs/forms/form_access.h"
#include "ui/inputs/forms/input_rank.h"

#include <QScrollArea>

#include <string>
#include <utility>
#include <vector>

class QGridLayout;
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

/// One page of the inputs, made from the tables: every row that names the page, structs as boxes.
/// They are built when the page is shown for the first time or something is asked of them: the
/// window begins with one page of eight.
class FormPage : public QScrollArea {
    Q_OBJECT

public:
    /// Without settings the user's own catalogues are kept as long as the page lives, and all
    /// inputs are shown.
    FormPage(Page page, Document& document, QWidget* parent = nullptr,
             Settings* settings = nullptr);
    ~FormPage() override;

    void build(); ///< its rows, once
    void setOutcome(const sparkout::OutcomePtr& outcome);
    void forgetResults();
    /// What may be changed, and what is shown.
    void setAccess(const FormAccessPtr& access);
    void setAllInputs(bool all);   ///< not the usual ones alone
    [[nodiscard]] bool hasShown(); ///< whether any input is
    void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    /// Shows the document's value where a text was refused; false when it is not on this page.
    bool dropRefusal(const std::string& path);
    /// Whether this page shows the field at a path.
    [[nodiscard]] bool holds(const std::string& path);
    /// Scrolls to the field at a path, and gives it the focus if wanted.
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

    /// Where rows go: a layout, and how many boxes deep in the page it is.
    struct Place {
        PageColumns& rows;
        int depth;
    };

    void addCatalogue(Settings* settings, Place into);
    void addHelper(RowHelper* helper, const std::string& path, Place into);
    void addStruct(const StructInfo& table, const std::string& path, Place into);
    void addRow(const Field& field, const std::string& path, Place into);
    void addInputBox(InputBox* box, const std::string& path, Place into);
    void addList(const Field& field, const std::string& path, Place into);
    void addBox(const Field& field, const std::string& path, Place into);
    void addProjectTexts(Place into);
    void connectRow(FormRow& row);
    [[nodiscard]] FormRow* rowAt(const std::string& path) const;
    [[nodiscard]] QWidget* placeToType(const FormRow& row) const; ///< what is asked for in it
    [[nodiscard]] const Box* boxAt(const std::string& path) const;
    [[nodiscard]] InputBox* inputBoxAt(const std::string& path) const;
    [[nodiscard]] bool shows(const StructInfo& table) const;
    [[nodiscard]] bool hasShown(const StructInfo& table, const std::string& path) const;
    void showProject(bool replaced);
    void showShared();
    void showRank(const InputRank& rank); ///< what is seen on demand alone
    void showAllButton();
    void want(const std::string& path);
    [[nodiscard]] bool isOnDemand(const std::string& path) const; ///< and not seen
    void showAccess();
    void giveAccess(); ///< to the rows and lists
    void toggleOptional(const Box& box, bool given);

    Page m_page;
    Document& m_document;
    Settings* m_settings;
    bool m_isBuilt = false;
    sparkout::OutcomePtr m_outcome; ///< for what is not built yet
    std::vector<FormRow*> m_rows;
    std::vector<Box> m_boxes;
    CatalogueBar* m_catalogue = nullptr;                       ///< on pages that have one
    std::vector<std::pair<RowHelper*, std::string>> m_helpers; ///< with what they fill
    std::vector<InputBox*> m_inputBoxes;
    std::vector<std::string> m_inputBoxPaths; ///< of each of them
    FormAccessPtr m_access = std::make_shared<const FormAccess>();
    std::string m_cataloguePath; ///< of the struct that it fills
    std::vector<ListTable*> m_lists;
    std::vector<std::pair<ListTable*, QLabel*>> m_sharedLists; ///< with what says that they are
    StageTable* m_stages = nullptr;                            ///< one of them
    SectionBox* m_projectBox = nullptr;
    bool m_replaced = false;
    InputRank m_rank;
    QToolButton* m_all = nullptr; ///< at the foot: all inputs, or the usual ones
};

} // namespace sparkout
