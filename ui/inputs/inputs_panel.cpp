// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/inputs_panel.h"

#include "ui/metrics.h"
#include "ui/session/texts.h"
#include "ui/theme.h"

#include <QButtonGroup>
#include <QFrame>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QToolButton>

#include <array>

namespace sparkout {

namespace {

struct PageEntry {
    Page page;
    const char* name; ///< translated as the panel's own
    const char16_t* icon;
};

constexpr std::array pageEntries{
    PageEntry{Page::part, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Part"), u"part"},
    PageEntry{Page::material, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Material"), u"material"},
    PageEntry{Page::wheel, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Wheel"), u"wheel"},
    PageEntry{Page::machine, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Machine"), u"machine"},
    PageEntry{Page::gauge, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Gauge"), u"gauge"},
    PageEntry{Page::cycle, QT_TRANSLATE_NOOP("sparkout::InputsPanel", "Cycle"), u"cycle"},
};

} // namespace

InputsPanel::InputsPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_group(new QButtonGroup(this)), m_stack(new QStackedWidget(this)) {
    auto* strip = new QHBoxLayout;
    strip->setSpacing(0);
    strip->setContentsMargins(metrics::hair, metrics::hair, metrics::hair, 0);
    for (const PageEntry& entry : pageEntries) {
        auto* button = new QToolButton(this);
        button->setIcon(themeIcon(entry.icon));
        button->setIconSize({metrics::icon, metrics::icon});
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setCheckable(true);
        button->setAutoRaise(true);
        strip->addWidget(button);
        m_group->addButton(button, static_cast<int>(m_pages.size()));
        m_buttons.push_back(button);
        auto* page = new FormPage(entry.page, document, m_stack);
        m_stack->addWidget(page);
        m_pages.push_back(page);
        connect(page, &FormPage::refusalsChanged, this, &InputsPanel::refusalsChanged);
    }
    auto* line = new QFrame(this);
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(strip);
    layout->addWidget(line);
    layout->addWidget(m_stack, 1);
    connect(m_group, &QButtonGroup::idClicked, m_stack, &QStackedWidget::setCurrentIndex);
    showPage(static_cast<int>(pageEntries.size()) - 1); // the cycle: what one works on most
    retranslate();
}

void InputsPanel::showPage(int index) {
    m_buttons[std::size_t(index)]->setChecked(true);
    m_stack->setCurrentIndex(index);
}

void InputsPanel::setOutcome(const OutcomePtr& outcome) {
    for (FormPage* page : m_pages) {
        page->setIssues(outcome->issues);
    }
}

void InputsPanel::retranslate() {
    for (std::size_t i = 0; i < pageEntries.size(); ++i) {
        const QString name = tr(pageEntries[i].name);
        m_buttons[i]->setText(name);
        m_buttons[i]->setAccessibleName(name);
        m_buttons[i]->setToolTip(tr("%1 (Alt+%2)").arg(name).arg(i + 1));
        m_buttons[i]->setShortcut(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_1 + int(i))));
        m_pages[i]->setAccessibleName(name);
        m_pages[i]->retranslate();
    }
}

void InputsPanel::focusPath(const std::string& path) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        const int before = m_stack->currentIndex();
        showPage(static_cast<int>(i));
        if (m_pages[i]->focusPath(path)) {
            return;
        }
        showPage(before);
    }
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
