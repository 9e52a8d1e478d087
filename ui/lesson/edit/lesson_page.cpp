// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/lesson_page.h"

#include "ui/kit/metrics.h"
#include "ui/lesson/edit/access_page.h"
#include "ui/lesson/edit/lesson_draft.h"
#include "ui/lesson/edit/lesson_form.h"
#include "ui/lesson/edit/text_preview.h"
#include "ui/text/texts.h"

#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

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
    scroll->setFocusPolicy(Qt::NoFocus); // its contents have it
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
