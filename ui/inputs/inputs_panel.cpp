// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/inputs_panel.h"

#include "ui/form/number_field.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/hint_strip.h"
#include "ui/inputs/list_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QButtonGroup>
#include <QFrame>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

struct PageEntry {
    Page page;
    const char* name; ///< in the translation context of the panel
    const char16_t* icon;
};

constexpr std::array pageEntries{
    PageEntry{Page::part, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Part"), u"part"},
    PageEntry{Page::material, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Material"), u"material"},
    PageEntry{Page::wheel, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Wheel"), u"wheel"},
    PageEntry{Page::machine, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Machine"), u"machine"},
    PageEntry{Page::gauge, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Gauge"), u"gauge"},
    PageEntry{Page::cycle, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Cycle"), u"cycle"},
    PageEntry{Page::batch, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Batch"), u"batch"},
    PageEntry{Page::search, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Search"), u"search"},
};

} // namespace

InputsPanel::InputsPanel(Document& document, QWidget* parent, Settings* settings)
    : QWidget(parent)
    , m_strip(new QHBoxLayout)
    , m_group(new QButtonGroup(this))
    , m_stack(new QStackedWidget(this))
    , m_hint(new HintStrip(this)) {
    m_strip->setSpacing(0);
    m_strip->setContentsMargins(0, metrics::hair, 0, 0);
    for (const PageEntry& entry : pageEntries) {
        auto* button = new QToolButton(this);
        button->setIcon(themeIcon(entry.icon));
        button->setIconSize({metrics::icon, metrics::icon});
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setCheckable(true);
        button->setAutoRaise(true);
        setRelativeFont(*button, noteType); // eight of them fit side by side
        m_strip->addWidget(button);
        m_group->addButton(button, static_cast<int>(m_pages.size()));
        m_buttons.push_back(button);
        auto* page = new FormPage(entry.page, document, m_stack, settings);
        m_stack->addWidget(page);
        m_pages.push_back(page);
        connect(page, &FormPage::refusalsChanged, this, [this] {
            noteRefusals();
            emit refusalsChanged();
        });
        connect(page, &FormPage::allInputsChosen, this, [this](bool all) {
            for (FormPage* one : m_pages) {
                one->setAllInputs(all);
            }
        });
        connect(page, &FormPage::built, this, [this, page] { hintAtCells(*page); });
    }
    const auto rule = [this] {
        auto* made = new QFrame(this);
        made->setFrameShape(QFrame::HLine);
        made->setFrameShadow(QFrame::Sunken);
        return made;
    };
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(m_strip);
    layout->addWidget(rule());
    layout->addWidget(m_stack, 1);
    layout->addWidget(rule());
    layout->addWidget(m_hint);
    connect(m_group, &QButtonGroup::idClicked, m_stack, &QStackedWidget::setCurrentIndex);
    connect(m_stack, &QStackedWidget::currentChanged, this, [this] {
        const QWidget* focused = QApplication::focusWidget();
        m_hint->showFieldOf(m_stack->currentWidget()->isAncestorOf(focused) ? focused : nullptr);
    });
    // Typed text is announced after a pause; this notes it when the focus moves on.
    connect(qApp, &QApplication::focusChanged, this, &InputsPanel::noteRefusals);
    showCycle(); // the page used most
    retranslate();
}

InputsPanel::~InputsPanel() {
    disconnect(qApp, nullptr, this, nullptr); // the focus moves on while the pages go …
    for (FormPage* page : m_pages) {
        disconnect(page, nullptr, this, nullptr); // … and drops the text typed there
    }
}

void InputsPanel::hintAtCells(const FormPage& page) {
    for (const ListTable* table : page.findChildren<ListTable*>()) {
        connect(table, &ListTable::currentFieldChanged, this, [this, table] {
            if (table->view().hasFocus()) {
                m_hint->showField(*hintField(&table->view()));
            }
        });
    }
}

const std::vector<FormPage*>& InputsPanel::pages() {
    for (FormPage* page : m_pages) {
        page->build();
    }
    return m_pages;
}

/// Wide enough for the forms and the names of the pages.
QSize InputsPanel::minimumSizeHint() const {
    return {std::max(panelWidth(), m_strip->minimumSize().width()),
            QWidget::minimumSizeHint().height()};
}

void InputsPanel::showPage(int index) {
    m_buttons[std::size_t(index)]->setChecked(true);
    m_stack->setCurrentIndex(index);
}

void InputsPanel::showCycle() {
    const auto cycle = std::ranges::find(pageEntries, Page::cycle, &PageEntry::page);
    showPage(static_cast<int>(cycle - pageEntries.begin()));
}

void InputsPanel::setOutcome(const OutcomePtr& outcome) {
    for (FormPage* page : m_pages) {
        page->setOutcome(outcome);
    }
}

void InputsPanel::forgetResults() {
    for (FormPage* page : m_pages) {
        page->forgetResults();
    }
}

void InputsPanel::setAccess(const FormAccessPtr& access) {
    int shown = -1;
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        m_pages[i]->setAccess(access);
        const bool isThere = m_pages[i]->hasShown();
        m_buttons[i]->setVisible(isThere);
        const bool isInFront = m_stack->currentIndex() == int(i);
        shown = isThere && (shown < 0 || isInFront) ? int(i) : shown;
    }
    m_stack->setVisible(shown >= 0);
    if (shown >= 0) {
        showPage(shown);
    }
}

void InputsPanel::retranslate() {
    for (std::size_t i = 0; i < pageEntries.size(); ++i) {
        const QString name = tr(pageEntries[i].name);
        m_buttons[i]->setText(name);
        // Leaves out the style's margins, for which the buttons have no room.
        const int width = m_buttons[i]->fontMetrics().horizontalAdvance(name) + 2 * metrics::hair;
        m_buttons[i]->setMinimumWidth(width);
        m_strip->setStretch(static_cast<int>(i), width);
        m_buttons[i]->setAccessibleName(name);
        m_buttons[i]->setToolTip(tr("%1 (Alt+%2)").arg(name).arg(i + 1));
        m_buttons[i]->setShortcut(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_1 + int(i))));
        m_pages[i]->setAccessibleName(name);
        m_pages[i]->retranslate();
    }
    m_hint->retranslate();
}

void InputsPanel::showPath(const std::string& path, bool focus) {
    const auto page = std::ranges::find_if(m_pages, [&](auto* p) { return p->holds(path); });
    if (page != m_pages.end() && (*page)->hasShown()) {
        showPage(static_cast<int>(page - m_pages.begin()));
        (*page)->showPath(path, focus);
    }
}

void InputsPanel::endTyping() {
    QWidget* const focus = QApplication::focusWidget();
    if (auto* field = qobject_cast<NumberField*>(focus)) {
        field->settle();
    } else if (auto* line = qobject_cast<QLineEdit*>(focus); line && isAncestorOf(line)) {
        emit line->editingFinished(); // as when the focus leaves it
    }
}

void InputsPanel::focusPath(const std::string& path) {
    showPath(path, true);
}

void InputsPanel::revealPath(const std::string& path) {
    showPath(path, m_stack->isAncestorOf(QApplication::focusWidget()));
}

void InputsPanel::noteRefusals() {
    std::vector<std::string> now;
    for (const Refusal& refusal : refusals()) {
        now.push_back(refusal.path);
    }
    std::erase_if(m_refused, [&](const std::string& path) {
        return std::find(now.begin(), now.end(), path) == now.end();
    });
    for (std::string& path : now) {
        if (std::find(m_refused.begin(), m_refused.end(), path) == m_refused.end()) {
            m_refused.push_back(std::move(path));
        }
    }
}

bool InputsPanel::dropNewestRefusal() {
    noteRefusals();
    if (m_refused.empty()) {
        return false;
    }
    const std::string path = m_refused.back();
    return std::any_of(m_pages.begin(), m_pages.end(),
                       [&path](FormPage* page) { return page->dropRefusal(path); });
}

std::vector<Refusal> InputsPanel::refusals() const {
    std::vector<Refusal> list;
    for (const FormPage* page : m_pages) {
        const auto own = page->refusals();
        list.insert(list.end(), own.begin(), own.end());
    }
    return list;
}

} // namespace sparkout
