// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_page.h"

#include "core/lesson/lesson.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_draft.h"
#include "ui/lesson/lesson_form.h"
#include "ui/lesson/lesson_text.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

/// Sets a student's access to the inputs in a step: a searchable tree of all inputs with their
/// names in the forms; a choice applies to the selected ones and those below them.
class AccessPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(sparkout::AccessPage)

public:
    AccessPage(LessonDraft& draft, std::size_t step, QWidget* parent = nullptr);

private:
    [[nodiscard]] const LessonStep* now() const; ///< null: the step was removed
    void fill();
    void addInput(const std::string& path);
    void show();
    void search(const QString& text);
    void give(std::optional<Access> access);

    LessonDraft& m_draft;
    std::size_t m_step;
    LessonForm* m_others; ///< what holds for the inputs that are not named
    QLineEdit* m_search;
    QTreeWidget* m_tree;
    QComboBox* m_access; ///< access to the selected inputs
    std::map<std::string, QTreeWidgetItem*> m_items;
};

constexpr int pathRole = Qt::UserRole, wordsRole = Qt::UserRole + 1;
enum AccessColumn { inputColumn, accessColumn, accessColumns };

QString accessName(Access access) {
    return choiceText(choicesOf<Access>()[static_cast<std::size_t>(access)].label);
}

std::string pathOf(const QTreeWidgetItem& item) {
    return item.data(inputColumn, pathRole).toString().toStdString();
}

AccessPage::AccessPage(LessonDraft& draft, std::size_t step, QWidget* parent)
    : QWidget(parent)
    , m_draft(draft)
    , m_step(step)
    , m_others(new LessonForm(
          draft, {tableOf<LessonStep>(), "/steps/" + std::to_string(step), {"others"}}, this))
    , m_search(new QLineEdit(this))
    , m_tree(new QTreeWidget(this))
    , m_access(new QComboBox(this)) {
    m_search->setObjectName(QStringLiteral("inputSearch"));
    m_tree->setObjectName(QStringLiteral("inputTree"));
    m_access->setObjectName(QStringLiteral("inputAccess"));
    m_access->addItem(tr("as the inputs around them"), -1);
    for (std::size_t i = 0; i < choicesOf<Access>().size(); ++i) {
        m_access->addItem(accessName(static_cast<Access>(i)), static_cast<int>(i));
    }
    m_search->setPlaceholderText(tr("Search the inputs"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_search->setClearButtonEnabled(true);
    m_tree->setAccessibleName(tr("Inputs"));
    m_tree->setColumnCount(accessColumns);
    m_tree->setHeaderLabels({tr("Input"), tr("For the student")});
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setUniformRowHeights(true);
    auto* below = new QFormLayout;
    below->addRow(tr("Selected inputs"), m_access);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::gap);
    layout->addWidget(m_others);
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    layout->addLayout(below);
    fill();
    connect(m_search, &QLineEdit::textChanged, this, &AccessPage::search);
    connect(m_access, &QComboBox::activated, this, [this](int index) {
        const int access = m_access->itemData(index).toInt();
        give(access < 0 ? std::nullopt : std::optional(static_cast<Access>(access)));
    });
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &AccessPage::show);
    connect(&m_draft, &LessonDraft::changed, this, &AccessPage::show);
}

const LessonStep* AccessPage::now() const {
    const auto& steps = m_draft.lesson().steps;
    return m_step < steps.size() ? &steps[m_step] : nullptr;
}

void AccessPage::fill() {
    for (const std::string& path :
         formInputs(m_draft.projectAt("/steps/" + std::to_string(m_step)))) {
        addInput(path);
    }
    m_tree->header()->setSectionResizeMode(inputColumn, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(accessColumn, QHeaderView::ResizeToContents);
    m_tree->header()->setStretchLastSection(false);
    show();
}

void AccessPage::addInput(const std::string& path) {
    if (m_items.contains(path)) {
        return;
    }
    const auto above = m_items.find(path.substr(0, path.rfind('/')));
    auto* item =
        above == m_items.end() ? new QTreeWidgetItem(m_tree) : new QTreeWidgetItem(above->second);
    const QString place = inputLocation(path);
    item->setText(inputColumn, place.section(QStringLiteral(" › "), -1));
    item->setData(inputColumn, pathRole, QString::fromStdString(path));
    item->setData(inputColumn, wordsRole, place);
    item->setToolTip(inputColumn, place);
    m_items[path] = item;
}

void AccessPage::show() {
    const LessonStep* const step = now();
    if (!step) {
        return;
    }
    for (const InputAccess& each : step->inputs) { // what the project does not have, too
        addInput(each.path);
    }
    for (const auto& [path, item] : m_items) {
        const bool isNamed = std::ranges::any_of(
            step->inputs, [&path = path](const InputAccess& each) { return each.path == path; });
        item->setText(accessColumn, accessName(accessTo(*step, path)));
        QFont font = m_tree->font();
        font.setBold(isNamed);
        item->setFont(accessColumn, font);
    }
    const auto selected = m_tree->selectedItems();
    m_access->setEnabled(!selected.empty());
    if (!selected.empty()) {
        const std::string path = pathOf(*selected.front());
        const auto named = std::ranges::find(step->inputs, path, &InputAccess::path);
        m_access->setCurrentIndex(
            named == step->inputs.end() ? 0 : 1 + static_cast<int>(named->access));
    }
}

void AccessPage::search(const QString& text) {
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    for (const auto& [path, item] : m_items) {
        item->setHidden(!words.empty());
    }
    if (words.empty()) {
        m_tree->collapseAll();
        return;
    }
    for (const auto& [path, item] : m_items) {
        const QString place = item->data(inputColumn, wordsRole).toString();
        if (std::ranges::all_of(words, [&place](const QString& word) {
                return place.contains(word, Qt::CaseInsensitive);
            })) {
            for (QTreeWidgetItem* up = item; up; up = up->parent()) {
                up->setHidden(false);
                up->setExpanded(up != item || up->isExpanded());
            }
        }
    }
}

void AccessPage::give(std::optional<Access> access) {
    std::vector<std::string> paths;
    for (const QTreeWidgetItem* item : m_tree->selectedItems()) {
        paths.push_back(pathOf(*item));
    }
    std::string key =
        "/steps/" + std::to_string(m_step) + "/inputs"; // a choice by arrow keys is one
    for (const std::string& path : paths) {
        key += path;
    }
    m_draft.edit(key, [&](Lesson& lesson) {
        LessonStep& step = lesson.steps[m_step];
        for (const std::string& path : paths) {
            const auto named = std::ranges::find(step.inputs, path, &InputAccess::path);
            if (!access) {
                std::erase_if(step.inputs,
                              [&path](const InputAccess& each) { return each.path == path; });
            } else if (named == step.inputs.end()) {
                step.inputs.push_back({path, *access});
            } else {
                named->access = *access;
            }
        }
    });
}

/// A text of the lesson as shown to students, in a chosen language.
class TextPreview : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(sparkout::TextPreview)

public:
    using TextOf = std::function<Bilingual(const Lesson& lesson)>;
    TextPreview(LessonDraft& draft, TextOf text, QWidget* parent = nullptr);

private:
    void show();

    LessonDraft& m_draft;
    TextOf m_text;
    QComboBox* m_language;
    QTextBrowser* m_shown;
};

constexpr int leastLines = 7; ///< visible

TextPreview::TextPreview(LessonDraft& draft, TextOf text, QWidget* parent)
    : QWidget(parent)
    , m_draft(draft)
    , m_text(std::move(text))
    , m_language(new QComboBox(this))
    , m_shown(new QTextBrowser(this)) {
    m_language->setObjectName(QStringLiteral("previewLanguage"));
    m_language->setAccessibleName(tr("Language of the preview"));
    m_language->addItems({QStringLiteral("Русский"), QStringLiteral("English")});
    m_language->setCurrentIndex(QLocale().language() == QLocale::Russian ? 0 : 1);
    m_shown->setObjectName(QStringLiteral("lessonPreview"));
    m_shown->setAccessibleName(tr("As the student reads it"));
    m_shown->setOpenLinks(false);
    m_shown->setMinimumHeight(leastLines * fontMetrics().lineSpacing());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_language, 0, Qt::AlignLeft);
    layout->addWidget(m_shown, 1);
    connect(m_language, &QComboBox::activated, this, &TextPreview::show);
    connect(&m_draft, &LessonDraft::changed, this, &TextPreview::show);
    show();
}

void TextPreview::show() {
    Bilingual text = m_text(m_draft.lesson());
    (m_language->currentIndex() == 0 ? text.en : text.ru).clear();
    const int scrolled = m_shown->verticalScrollBar()->value();
    m_shown->setHtml(LessonText::markup(text));
    m_shown->verticalScrollBar()->setValue(scrolled);
}

/// A form, and the preview of its text with the room that is left.
QWidget* formPage(LessonForm* form, TextPreview* preview = nullptr) {
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setSpacing(metrics::margin);
    layout->addWidget(form);
    if (preview) {
        layout->addWidget(preview, 1);
    } else {
        layout->addStretch(1);
    }
    return page;
}

/// The first focusable widget of a group; any other widget itself.
QWidget* focusIn(QWidget& widget) {
    if (widget.focusPolicy() != Qt::NoFocus) {
        return &widget;
    }
    for (QWidget* part : widget.findChildren<QWidget*>()) {
        if ((part->focusPolicy() & Qt::TabFocus) && part->isEnabled() && !part->isHidden()) {
            return part;
        }
    }
    return &widget;
}

LessonForm* formOfWork(LessonDraft& draft, std::vector<std::string_view> keys) {
    return new LessonForm(draft, {tableOf<LessonSheet>(), {}, std::move(keys)});
}

LessonForm* formOfStep(LessonDraft& draft, const std::string& step,
                       std::vector<std::string_view> keys) {
    return new LessonForm(draft, {tableOf<LessonStep>(), step, std::move(keys)});
}

} // namespace

LessonPage::LessonPage(LessonDraft& draft, QWidget* parent) : QTabWidget(parent) {
    add(formPage(formOfWork(draft, {"title", "aim", "theory"}),
                 new TextPreview(draft, [](const Lesson& lesson) { return lesson.theory; })),
        tr("Title, aim, theory"), {"/title", "/aim", "/theory"});
    add(variants(draft), tr("Variants"), {"/variants"});
    add(formPage(formOfWork(draft, {"guide"})), tr("For the teacher"), {"/guide"});
}

LessonPage::LessonPage(LessonDraft& draft, std::size_t step, QWidget* parent) : QTabWidget(parent) {
    const std::string at = "/steps/" + std::to_string(step);
    add(formPage(formOfStep(draft, at, {"task", "points", "surface"}),
                 new TextPreview(draft,
                                 [step](const Lesson& lesson) {
                                     return step < lesson.steps.size() ? lesson.steps[step].task
                                                                       : Bilingual();
                                 })),
        tr("Task"), {at + "/task", at + "/points", at + "/surface"});
    add(new AccessPage(draft, step), tr("Inputs"), {at + "/inputs", at + "/others"});
    add(formPage(formOfStep(draft, at, {"values"})), tr("Values"), {at + "/values"});
    add(hiddenThings(draft, step), tr("Hidden"), {at + "/hidden"});
    add(formPage(new LessonForm(draft, {tableOf<Goal>(), at + "/goal"})), tr("Goal"),
        {at + "/goal"});
    add(formPage(formOfStep(draft, at, {"hints"})), tr("Hints"), {at + "/hints"});
    add(formPage(formOfStep(draft, at, {"moment"})), tr("Moment"), {at + "/moment"});
}

void LessonPage::add(QWidget* page, const QString& title, std::vector<std::string> shows) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // its contents take the focus
    addTab(scroll, title);
    m_shown.push_back(std::move(shows));
}

/// The rules of the variants, and a preview of some.
QWidget* LessonPage::variants(LessonDraft& draft) {
    auto* check = new QPushButton(tr("Chec&k variants…"));
    check->setObjectName(QStringLiteral("checkVariants"));
    check->setToolTip(tr("Make some of the variants and see their best answers, or why one is "
                         "refused; nothing is saved"));
    check->setAutoDefault(false);
    connect(check, &QPushButton::clicked, this, &LessonPage::checkWanted);
    const auto show = [check, &draft] { check->setEnabled(draft.lesson().variants.has_value()); };
    show();
    connect(&draft, &LessonDraft::changed, check, show);
    QWidget* page = formPage(formOfWork(draft, {"variants"}));
    auto* line = new QHBoxLayout;
    line->addWidget(check);
    line->addStretch(1);
    static_cast<QVBoxLayout*>(page->layout())->insertLayout(0, line);
    return page;
}

/// Views, panels and commands, each with a box to hide it.
QWidget* LessonPage::hiddenThings(LessonDraft& draft, std::size_t step) {
    auto* list = new QListWidget;
    list->setObjectName(QStringLiteral("hiddenThings"));
    list->setAccessibleName(tr("Views, panels and commands that the step hides"));
    for (const Choice& choice : choicesOf<Hideable>()) {
        auto* item = new QListWidgetItem(choiceText(choice.label), list);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    }
    const auto show = [list, &draft, step] {
        if (step >= draft.lesson().steps.size()) {
            return;
        }
        const QSignalBlocker quiet(list);
        const auto& hidden = draft.lesson().steps[step].hidden;
        for (int i = 0; i < list->count(); ++i) {
            const HiddenThing thing{static_cast<Hideable>(i)};
            list->item(i)->setCheckState(std::ranges::count(hidden, thing) > 0 ? Qt::Checked
                                                                               : Qt::Unchecked);
        }
        list->viewport()->update();
    };
    show();
    connect(&draft, &LessonDraft::changed, list, show);
    connect(list, &QListWidget::itemChanged, list, [list, &draft, step](QListWidgetItem* item) {
        const HiddenThing thing{static_cast<Hideable>(list->row(item))};
        const bool isHidden = item->checkState() == Qt::Checked;
        draft.edit({}, [&](Lesson& lesson) {
            auto& hidden = lesson.steps[step].hidden;
            std::erase(hidden, thing);
            if (isHidden) {
                hidden.push_back(thing);
            }
        });
    });
    return list;
}

void LessonPage::goTo(const std::string& path) {
    for (std::size_t tab = 0; tab < m_shown.size(); ++tab) {
        if (std::ranges::any_of(m_shown[tab], [&path](const std::string& each) {
                return path.starts_with(each);
            })) {
            setCurrentIndex(static_cast<int>(tab));
        }
    }
    for (std::string at = path; !at.empty(); at.resize(at.rfind('/'))) {
        if (auto* widget = currentWidget()->findChild<QWidget*>(QString::fromStdString(at))) {
            widget = focusIn(*widget);
            widget->setFocus();
            static_cast<QScrollArea*>(currentWidget())->ensureWidgetVisible(widget);
            return;
        }
    }
}

} // namespace sparkout
