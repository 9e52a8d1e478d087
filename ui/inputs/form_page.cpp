// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/form_page.h"

#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/member.h"
#include "core/setup/setup.h"
#include "core/study/batch_edits.h"
#include "core/study/search_edits.h"
#include "ui/form/input_marks.h"
#include "ui/inputs/catalogue_bar.h"
#include "ui/inputs/factor_box.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/page_columns.h"
#include "ui/inputs/row_helper.h"
#include "ui/inputs/stage_table.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace sparkout {

namespace {

constexpr const char* batchPath = "/batch";
constexpr const char* searchPath = "/optimisation";

/// For one row of the page, with fields aligned to those of the others.
QGridLayout* newGrid(QVBoxLayout& into, int depth) {
    auto* grid = new QGridLayout;
    grid->setColumnStretch(0, 1);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    const int inset = SectionBox::inset(depth);
    grid->setContentsMargins(inset, 0, inset, 0);
    into.addLayout(grid);
    return grid;
}

} // namespace

FormPage::FormPage(Page page, Document& document, QWidget* parent, Settings* settings)
    : QScrollArea(parent)
    , m_page(page)
    , m_document(document)
    , m_model(document)
    , m_settings(settings) {
    setHelpTopic(*this, fieldPageId(page));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_rank.showsAll = !settings || settings->allInputs();
    connect(&document, &Document::projectReplaced, this, [this] {
        m_replaced = true;
        m_rank.wanted.clear();
    });
    connect(&document, &Document::changed, this, [this] {
        if (m_isBuilt) {
            showProject(m_replaced);
        }
        m_replaced = false;
    });
}

FormPage::~FormPage() {
    qDeleteAll(m_rows); // before the fields are deleted and lose the focus
}

void FormPage::build() {
    if (std::exchange(m_isBuilt, true)) {
        return;
    }
    auto* body = new QWidget(this);
    auto* layout = new PageColumns(body);
    const int side = metrics::margin - SectionBox::inset(0);
    layout->setContentsMargins(side, metrics::margin, side, metrics::margin);
    addCatalogue(m_settings, {*layout, 0});
    addStruct(tableOf<Project>(), {}, {*layout, 0});
    addProjectTexts({*layout, 0});
    m_all = new QToolButton(body);
    m_all->setObjectName(QStringLiteral("allInputs"));
    m_all->setCheckable(true);
    m_all->setAutoRaise(true);
    m_all->setChecked(m_rank.showsAll);
    layout->addWide(m_all);
    connect(m_all, &QToolButton::toggled, this, [this](bool all) {
        if (m_settings) {
            m_settings->setAllInputs(all);
        }
        emit allInputsChosen(all);
    });
    retranslate();
    giveAccess();
    showProject(true);
    if (m_outcome) {
        setOutcome(m_outcome);
        m_outcome.reset();
    }
    setWidget(body);
    emit built();
}

void FormPage::showEvent(QShowEvent* event) {
    build();
    QScrollArea::showEvent(event);
}

bool FormPage::shows(const StructInfo& table) const {
    for (const Field& field : table.fields) {
        if (field.page == m_page && (!field.nested || field.kind == Kind::objectList)) {
            return true;
        }
        if (field.nested && field.kind != Kind::objectList && shows(*field.nested)) {
            return true;
        }
    }
    return false;
}

void FormPage::addCatalogue(Settings* settings, Place into) {
    const auto kind = m_page == Page::material  ? std::optional(CatalogueKind::materials)
                      : m_page == Page::wheel   ? std::optional(CatalogueKind::wheels)
                      : m_page == Page::machine ? std::optional(CatalogueKind::machines)
                                                : std::nullopt;
    if (!kind) {
        return;
    }
    m_cataloguePath = m_page == Page::material ? "/material"
                      : m_page == Page::wheel  ? "/wheel"
                                               : "/machine";
    m_catalogue = new CatalogueBar(*kind, m_document, settings, into.rows.parentWidget());
    const int inset = SectionBox::inset(into.depth);
    m_catalogue->setContentsMargins(inset, 0, inset, 0);
    into.rows.addWidget(m_catalogue);
}

void FormPage::addHelper(RowHelper* helper, const std::string& path, Place into) {
    const int inset = SectionBox::inset(into.depth);
    helper->setContentsMargins(inset, 0, inset, 0);
    into.rows.addWidget(helper);
    m_helpers.emplace_back(helper, path);
}

void FormPage::addStruct(const StructInfo& table, const std::string& path, Place into) {
    for (const Field& field : table.fields) {
        const std::string at = path + "/" + field.key;
        const bool structure = field.kind == Kind::object || field.kind == Kind::optionalObject;
        if (field.nested == &tableOf<Factor>() && field.page == m_page) {
            addInputBox(
                new FactorBox(at, field, into.depth + 1, m_document, into.rows.parentWidget()),
                into);
        } else if (structure && shows(*field.nested)) {
            if (field.page == m_page) {
                addBox(field, at, into);
            } else if (field.kind == Kind::object) {
                addStruct(*field.nested, at, into);
            }
        } else if (!structure && field.page == m_page) {
            const bool projectText = path.empty() && field.kind == Kind::text;
            if (!projectText) {
                addRow(field, at, into);
            }
        }
    }
}

void FormPage::addRow(const Field& field, const std::string& path, Place into) {
    QWidget* const parent = into.rows.parentWidget();
    if (field.kind == Kind::compliance) {
        addInputBox(new ComplianceBox(path, field, m_document, parent), into);
        return;
    }
    if (path == "/batch/correlation") {
        addInputBox(new CorrelationBox(path, field, into.depth + 1, m_document, parent), into);
        return;
    }
    if (field.kind == Kind::objectList) {
        addList(field, path, into);
        return;
    }
    auto editor = makeInputEditor(path, field, m_model, parent);
    if (!editor) {
        return;
    }
    RowHelper* const helper = makeRowHelper(path, m_document, parent);
    if (helper && helper->standsFirst()) {
        addHelper(helper, path, into);
    }
    auto* row = new FormRow(std::move(editor), *newGrid(into.rows, into.depth), parent);
    row->setParent(this);
    connectRow(*row);
    if (helper && !helper->standsFirst()) {
        addHelper(helper, path, into);
    } else if (helper) { // from top to bottom, the visual order
        setTabOrder(helper->focusProxy(), row->editor().widget());
    }
    if (auto* line = qobject_cast<QLineEdit*>(row->editor().widget()); line && helper) {
        connect(line, &QLineEdit::editingFinished, helper, [row, line, helper] {
            if (!row->editor().refusal().isEmpty() && helper->take(line->text())) {
                row->editor().dropRefusal();
            }
        });
    }
}

void FormPage::addInputBox(InputBox* box, Place into) {
    into.rows.addWidget(box);
    connect(box, &InputBox::refusalsChanged, this, &FormPage::refusalsChanged);
    m_inputBoxes.push_back(box);
}

void FormPage::addList(const Field& field, const std::string& path, Place into) {
    QWidget* const parent = into.rows.parentWidget();
    ListTable* table = nullptr;
    if (field.nested == &tableOf<Stage>()) {
        m_stages = new StageTable(m_document, parent);
        table = m_stages;
    } else {
        table = new ListTable(path, field, m_document, parent);
    }
    const int inset = SectionBox::inset(into.depth);
    table->setContentsMargins(inset, 0, inset, 0);
    if (isShared(path)) {
        auto* note = new QLabel(parent);
        note->setContentsMargins(inset, 0, inset, 0);
        note->setVisible(false);
        into.rows.addWidget(note);
        m_sharedLists.emplace_back(table, note);
    }
    if (table == m_stages) {
        into.rows.addWide(table);
    } else {
        into.rows.addWidget(table);
    }
    if (RowHelper* helper = makeRowHelper(path, m_document, parent)) {
        addHelper(helper, path, into);
    }
    connect(table, &ListTable::refusalsChanged, this, &FormPage::refusalsChanged);
    m_lists.push_back(table);
}

void FormPage::connectRow(FormRow& row) {
    connect(&row.editor(), &FieldEditor::remarkChanged, this, &FormPage::refusalsChanged);
    m_rows.push_back(&row);
}

void FormPage::addBox(const Field& field, const std::string& path, Place into) {
    if (RowHelper* helper = makeRowHelper(path, m_document, into.rows.parentWidget())) {
        addHelper(helper, path, into);
    }
    auto* box = new SectionBox(into.depth + 1, into.rows.parentWidget());
    into.rows.addWidget(box);
    auto* reason = new ReasonLabel(box);
    box->rows().addWidget(reason);
    addStruct(*field.nested, path, {box->rows(), into.depth + 1});
    m_boxes.push_back({path, &field, box, reason});
    if (field.kind == Kind::optionalObject) {
        box->setCheckable(true);
        connect(box, &QGroupBox::clicked, this,
                [this, entry = m_boxes.back()](bool given) { toggleOptional(entry, given); });
    }
}

void FormPage::addProjectTexts(Place into) {
    for (const Field& field : tableOf<Project>().fields) {
        if (field.page != m_page || field.kind != Kind::text) {
            continue;
        }
        if (!m_projectBox) {
            m_projectBox = new SectionBox(into.depth + 1, into.rows.parentWidget());
            into.rows.addWidget(m_projectBox);
        }
        addRow(field, std::string("/") + field.key, {m_projectBox->rows(), into.depth + 1});
    }
}

void FormPage::toggleOptional(const Box& box, bool given) {
    Project project = m_document.project();
    const Member member = findMember(project, box.path, true);
    if (!member) {
        return;
    }
    if (given && box.path == batchPath) {
        project = withUsualBatch(std::move(project));
    } else if (given && box.path == searchPath) {
        project = usualSearch(std::move(project));
    } else if (given) {
        box.field->object(member.owner, true);
    } else {
        box.field->reset(member.owner);
    }
    m_document.edit(std::move(project), {"Input", box.field->label});
}

void FormPage::setAllInputs(bool all) {
    m_rank.showsAll = all;
    m_rank.wanted.clear();
    if (m_isBuilt) {
        const QSignalBlocker blocker(m_all);
        m_all->setChecked(all);
        showProject(false);
    }
}

/// Shows an input that is hidden by rank, as long as the project is open.
void FormPage::want(const std::string& path) {
    m_rank.wanted.push_back(path);
    showProject(false);
}

/// Call after showing what is relevant: hides a box without visible inputs.
void FormPage::showRank(const InputRank& rank) {
    const Project& project = m_document.project();
    const auto isSeen = [&](const std::string& path, const Field& field) {
        return rank.shows(project, field, path);
    };
    for (ListTable* list : m_lists) {
        if (!isSeen(list->path(), *findMember(project, list->path()).field)) {
            list->hide();
        }
    }
    for (InputBox* box : m_inputBoxes) {
        if (!isSeen(box->path(), *findMember(project, box->path()).field)) {
            box->hide();
        }
    }
    for (const auto& [helper, path] : m_helpers) {
        const FormRow* const row = rowAt(path);
        const auto list = std::ranges::find(m_lists, path, &ListTable::path);
        FormAccess::hide(*helper,
                         row ? !row->isShown() : list != m_lists.end() && (*list)->isHidden());
    }
    if (m_projectBox) {
        m_projectBox->setVisible(std::ranges::any_of(m_rows, [](const FormRow* row) {
            return row->isShown() && row->editor().field().kind == Kind::text
                   && row->editor().path().rfind('/') == 0;
        }));
    }
    for (const Box& box : m_boxes) { // inner boxes precede outer ones
        const auto isIn = [&box](const std::string& path) {
            return path.starts_with(box.path + '/');
        };
        const auto isLeft = [&isIn](const auto* widget, const std::string& path) {
            return isIn(path) && !widget->isHidden();
        };
        bool any = box.field->kind == Kind::optionalObject && isSeen(box.path, *box.field);
        any = any || std::ranges::any_of(m_rows, [&](const FormRow* row) {
                  return isIn(row->editor().path()) && row->isShown();
              });
        any = any || std::ranges::any_of(m_lists, [&](const ListTable* list) {
                  return isLeft(list, list->path());
              });
        any = any || std::ranges::any_of(m_boxes, [&](const Box& inner) {
                  return isLeft(inner.box, inner.path);
              });
        any = any || std::ranges::any_of(m_inputBoxes, [&](const InputBox* inner) {
                  return isLeft(inner, inner->path());
              });
        if (!any && !box.reason->isVisibleTo(box.box)) {
            box.box->hide();
        }
    }
}

void FormPage::showAllButton() {
    const auto onDemand = std::ranges::count_if(m_rows, &FormRow::isOnDemand);
    const auto shown = std::ranges::count_if(
        m_rows, [](const FormRow* row) { return row->isOnDemand() && row->isShown(); });
    const QString all = tr("All inputs (%1 more)").arg(onDemand - shown);
    m_all->setText(m_rank.showsAll ? tr("Usual inputs only")
                   : shown > 0
                       ? tr("%1 · %n other(s) shown", nullptr, static_cast<int>(shown)).arg(all)
                       : all);
    m_all->setToolTip(tr("Besides the usual inputs, calibrated, refused and doubtful ones are "
                         "shown, and those that differ from both the default and the catalogue"));
    m_all->setAccessibleName(m_all->text());
    m_all->setVisible(m_access->isFree() && (m_rank.showsAll || onDemand > shown));
}

void FormPage::showProject(bool replaced) {
    const Project& project = m_document.project();
    InputRank rank = m_rank;
    rank.showsAll = rank.showsAll || !m_access->isFree(); // whatever a lesson allows is shown
    rank.asCatalogue = m_catalogue && !rank.showsAll ? m_catalogue->asInCatalogue() : std::nullopt;
    for (FormRow* row : m_rows) {
        row->show(project, replaced, rank);
    }
    for (const Box& box : m_boxes) {
        const ConstMember member = findMember(project, box.path);
        const bool given =
            member && box.field->kind == Kind::optionalObject && box.field->objectIn(member.owner);
        const bool offered =
            (box.path == batchPath || box.path == searchPath) && !given; // shown by its helper
        box.box->setVisible(member && member.relevant(project) && !offered);
        if (box.field->kind == Kind::optionalObject && member) {
            box.box->setChecked(given);
        }
    }
    for (ListTable* list : m_lists) {
        list->setVisible(findMember(project, list->path()).relevant(project));
    }
    for (InputBox* box : m_inputBoxes) {
        box->showProject(replaced);
    }
    showShared();
    showAccess();
    showRank(rank);
    showAllButton();
    emit refusalsChanged();
}

void FormPage::forgetResults() {
    for (InputBox* box : m_inputBoxes) {
        box->forgetResults();
    }
    if (m_stages) {
        m_stages->forgetResults();
    }
}

void FormPage::setAccess(const FormAccessPtr& access) {
    m_access = access;
    if (m_isBuilt) {
        giveAccess();
        showProject(false);
    }
}

void FormPage::giveAccess() {
    for (FormRow* row : m_rows) {
        row->setAccess(*m_access);
    }
    for (ListTable* list : m_lists) {
        list->setAccess(m_access);
    }
}

bool FormPage::hasShown() {
    return m_access->isFree() // every page has inputs without a lesson
           || hasShown(tableOf<Project>(), {});
}

/// Decides by the tables, since building all pages at once would take too long.
bool FormPage::hasShown(const StructInfo& table, const std::string& path) const {
    return std::ranges::any_of(table.fields, [&](const Field& field) {
        const std::string at = path + "/" + field.key;
        const bool isStruct = field.kind == Kind::object || field.kind == Kind::optionalObject;
        if (isStruct && field.nested != &tableOf<Factor>()) {
            return hasShown(*field.nested, at);
        }
        return field.page == m_page && m_access->hasShown(at);
    });
}

/// Disables boxes with only locked inputs and hides those with only hidden ones.
void FormPage::showAccess() {
    const auto show = [this](QWidget* widget, const std::string& path) {
        FormAccess::lock(*widget, !m_access->hasFree(path));
        if (!m_access->hasShown(path)) {
            widget->hide();
        }
    };
    for (const Box& box : m_boxes) {
        show(box.box, box.path);
    }
    for (InputBox* box : m_inputBoxes) {
        show(box, box->path());
    }
    for (ListTable* list : m_lists) {
        if (!m_access->hasShown(list->path())) {
            list->hide();
        }
    }
    for (const auto& [helper, path] : m_helpers) {
        const bool isFree = m_access->at(path) == Access::free;
        FormAccess::lock(*helper, !isFree);
        if (FormAccess::hide(*helper, m_access->at(path) == Access::hidden)) {
            helper->retranslate(); // some show and hide themselves
        }
    }
    if (m_catalogue) {
        const bool isFree = m_access->at(m_cataloguePath) == Access::free;
        FormAccess::lock(*m_catalogue, !isFree);
        FormAccess::hide(*m_catalogue, !m_access->hasShown(m_cataloguePath));
    }
}

/// A single surface shares nothing.
void FormPage::showShared() {
    const bool several = m_document.surfaceCount() > 1;
    for (FormRow* row : m_rows) {
        row->setShared(several && isShared(row->editor().path()));
    }
    for (const auto& [list, note] : m_sharedLists) {
        note->setText(SharedMark::text());
        note->setVisible(several && !list->isHidden());
    }
    for (const Box& box : m_boxes) {
        const QString title = inputText(box.field->label);
        box.box->setTitle(several && isShared(box.path) ? tr("%1 (shared)").arg(title) : title);
    }
}

void FormPage::setOutcome(const OutcomePtr& outcome) {
    if (!m_isBuilt) {
        m_outcome = outcome;
        return;
    }
    const Issues& issues = outcome->issues;
    for (FormRow* row : m_rows) {
        row->setIssues(issues);
    }
    for (InputBox* box : m_inputBoxes) {
        box->setOutcome(outcome);
    }
    for (ListTable* list : m_lists) {
        list->setIssues(issues);
    }
    if (m_stages) {
        m_stages->setOutcome(outcome);
    }
    for (const Box& box : m_boxes) {
        box.reason->showRemark(remarkAt(issues, box.path));
    }
    if (std::ranges::any_of(m_rows, [](const FormRow* row) {
            return row->isOnDemand() && !row->isShown()
                   && row->editor().remark().mark != Mark::none;
        })) {
        showProject(false);
    }
}

void FormPage::retranslate() {
    if (!m_isBuilt) {
        return;
    }
    if (m_catalogue) {
        m_catalogue->retranslate();
    }
    for (const auto& [helper, path] : m_helpers) {
        helper->retranslate();
    }
    for (FormRow* row : m_rows) {
        row->retranslate(m_document.project());
    }
    for (const Box& box : m_boxes) {
        box.box->setAccessibleName(inputText(box.field->label));
        box.box->setToolTip(inputText(box.field->hint));
    }
    if (m_projectBox) {
        m_projectBox->setTitle(structText(tableOf<Project>().name));
        m_projectBox->setAccessibleName(m_projectBox->title());
    }
    for (InputBox* box : m_inputBoxes) {
        box->retranslate();
    }
    for (ListTable* list : m_lists) {
        list->retranslate();
    }
    showShared();
    showAllButton();
}

std::vector<Refusal> FormPage::refusals() const {
    std::vector<Refusal> list;
    for (const FormRow* row : m_rows) {
        if (const QString reason = row->editor().refusal(); !reason.isEmpty()) {
            list.push_back({row->editor().path(), reason});
        }
    }
    for (const InputBox* box : m_inputBoxes) {
        const auto own = box->refusals();
        list.insert(list.end(), own.begin(), own.end());
    }
    for (const ListTable* own : m_lists) {
        for (const Refusal& refusal : own->refusals()) {
            list.push_back(refusal);
        }
    }
    return list;
}

bool FormPage::dropRefusal(const std::string& path) {
    for (const FormRow* row : m_rows) {
        if (row->editor().path() == path) {
            row->editor().dropRefusal();
            emit refusalsChanged();
            return true;
        }
    }
    return std::ranges::any_of(m_inputBoxes,
                               [&path](InputBox* box) { return box->dropRefusal(path); })
           || std::any_of(m_lists.begin(), m_lists.end(),
                          [&path](ListTable* list) { return list->dropRefusal(path); });
}

FormRow* FormPage::rowAt(const std::string& path) const {
    for (FormRow* row : m_rows) {
        const std::string& own = row->editor().path();
        if (path == own || path.starts_with(own + "/")) {
            return row;
        }
    }
    return nullptr;
}

const FormPage::Box* FormPage::boxAt(const std::string& path) const {
    const auto found = std::ranges::find(m_boxes, path, &Box::path);
    return found == m_boxes.end() ? nullptr : &*found;
}

InputBox* FormPage::inputBoxAt(const std::string& path) const {
    const auto found =
        std::ranges::find_if(m_inputBoxes, [&](const InputBox* box) { return box->holds(path); });
    return found == m_inputBoxes.end() ? nullptr : *found;
}

bool FormPage::holds(const std::string& path) {
    build();
    return rowAt(path) || boxAt(path) || inputBoxAt(path)
           || std::ranges::any_of(m_lists,
                                  [&](const ListTable* list) { return list->holds(path); });
}

bool FormPage::isOnDemand(const std::string& path) const {
    if (const FormRow* row = rowAt(path)) {
        return row->isOnDemand() && !row->isShown();
    }
    const auto isHidden = [&path](const auto* one) { return one->holds(path) && one->isHidden(); };
    const Box* const box = boxAt(path);
    return std::ranges::any_of(m_inputBoxes, isHidden) || std::ranges::any_of(m_lists, isHidden)
           || (box && box->box->isHidden());
}

/// Limits that are missing for a known diameter are entered by its tolerance class.
QWidget* FormPage::placeToType(const FormRow& row) const {
    const std::string& path = row.editor().path();
    const bool isLimit = path == "/part/upper_deviation_um" || path == "/part/lower_deviation_um";
    if (isLimit && m_document.isOpen(path) && !m_document.isOpen("/part/diameter_mm")) {
        for (const auto& [helper, at] : m_helpers) {
            if (helper->standsFirst()) {
                return helper->focusProxy();
            }
        }
    }
    return row.editor().widget();
}

void FormPage::showPath(const std::string& path, bool focus) {
    if (isOnDemand(path)) {
        want(path);
    }
    widget()->layout()->activate(); // it may have just become visible
    const auto show = [this, focus](QWidget* widget, QWidget* focused) {
        ensureWidgetVisible(widget);
        QTimer::singleShot(0, widget, [this, widget] { ensureWidgetVisible(widget); }); // laid out
        if (focus && focused) {
            focused->setFocus(Qt::OtherFocusReason);
        }
    };
    if (const FormRow* row = rowAt(path)) {
        QWidget* const typed = placeToType(*row);
        show(typed, typed);
        return;
    }
    if (InputBox* box = inputBoxAt(path)) {
        show(box, nullptr);
        if (focus) {
            box->focusPath(path);
        }
        return;
    }
    for (ListTable* list : m_lists) {
        if (list->holds(path)) {
            show(list, nullptr);
            list->showPath(path, focus);
            return;
        }
    }
    if (const Box* box = boxAt(path)) {
        show(box->box, box->box);
    }
}

} // namespace sparkout
