// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/tour_steps.h"

#include "ui/inputs/forms/row_sliders.h"
#include "ui/inputs/forms/stage_table.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/plot/view.h"
#include "ui/window/view_tabs.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QWidget>

#include <algorithm>

namespace sparkout {

namespace {

std::function<QString()> tourText(const char* text) {
    return [text] { return QCoreApplication::translate("Tour", text); };
}

/// The area of a part of the window; empty while it is hidden or detached.
QRect placeOf(const QWidget* part) {
    if (!part || !part->isVisible() || !qobject_cast<const QMainWindow*>(part->window())) {
        return {};
    }
    return {part->mapTo(part->window(), QPoint(0, 0)), part->size()};
}

/// The last button of the tool bar, or the one for the hidden ones.
QRect placeOfLastButton(const QMainWindow& window) {
    const auto* bar = window.findChild<QToolBar*>(QStringLiteral("toolBar"));
    if (!bar || bar->actions().isEmpty()) {
        return {};
    }
    const QRect button = placeOf(bar->widgetForAction(bar->actions().back()));
    return button.isEmpty()
               ? placeOf(bar->findChild<QWidget*>(QStringLiteral("qt_toolbar_ext_button")))
               : button;
}

/// The part of the window with a name.
std::function<QRect()> namedPart(QMainWindow& window, const char* name) {
    return
        [&window, name] { return placeOf(window.findChild<QWidget*>(QString::fromLatin1(name))); };
}

void showDock(QMainWindow& window, const char* name) {
    if (auto* dock = window.findChild<QDockWidget*>(QString::fromLatin1(name))) {
        dock->show();
    }
}

StageTable* shownStages(QMainWindow& window, InputsPanel& inputs) {
    showDock(window, "inputs");
    inputs.showCycle();
    return inputs.findChild<StageTable*>();
}

QRect placeOfView(ViewTabs& tabs, const char* name) {
    const auto named = [name](const View* view) {
        return view->objectName() == QLatin1String(name);
    };
    View* view = *std::ranges::find_if(tabs.views(), named);
    tabs.attach(view);
    tabs.showView(view);
    return placeOf(view);
}

QRect placeOfHelpMenu(const QMainWindow& window) {
    auto* bar = window.findChild<QMenuBar*>();
    return bar->actionGeometry(bar->actions().back()).translated(bar->mapTo(&window, QPoint()));
}

} // namespace

std::vector<TourStep> tourSteps(QMainWindow& window, InputsPanel& inputs, ViewTabs& tabs) {
    return {
        {[&window] { return placeOfLastButton(window); },
         tourText(QT_TRANSLATE_NOOP("Tour", "An example to begin with")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour",
             "The last button of the tool bar opens the shipped examples, each as a copy: change "
             "what you like. The first one begins a project of your own."))},
        {[&] { return placeOf(shownStages(window, inputs)); },
         tourText(QT_TRANSLATE_NOOP("Tour", "The stages of the cycle")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour",
             "A row is a stage: feeds, stock, spark-out, and the time it takes. Type into a "
             "cell; everything is computed again at once. The pages above hold part, "
             "material, wheel, machine, gauge and batch."))},
        {[&] { return placeOfView(tabs, "feeds"); },
         tourText(QT_TRANSLATE_NOOP("Tour", "Programmed feed and actual cut")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour", "Dashed: the feed of the program. Solid: what the part really gets, zone by "
                     "zone, because everything yields. The first tab sums the cycle up in bars; "
                     "the others show form, limits, compliance, layers, a batch and compared "
                     "runs."))},
        {[&] {
             showDock(window, "verdict");
             return namedPart(window, "verdict")();
         },
         tourText(QT_TRANSLATE_NOOP("Tour", "Does it meet the drawing?")),
         tourText(QT_TRANSLATE_NOOP("Tour",
                                    "Time of the cycle and every requirement with its margin. A "
                                    "click on a row leads to the place where the value arises."))},
        {[&] { return placeOf(shownStages(window, inputs)->findChild<RowSliders*>()); },
         tourText(QT_TRANSLATE_NOOP("Tour", "Play with the feeds")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour", "Drag a slider and watch curves, time and margins follow. Undo takes a whole "
                     "drag back."))},
        {namedPart(window, "playback"),
         tourText(QT_TRANSLATE_NOOP("Tour", "Step through the cycle")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour",
             "Play, or step by stage, double stroke, step E1…E5 or radius. All views follow; "
             "the button at the right shows the formulas with their numbers."))},
        {[&] { return placeOfHelpMenu(window); }, tourText(QT_TRANSLATE_NOOP("Tour", "Help")),
         tourText(QT_TRANSLATE_NOOP(
             "Tour", "F1 explains the field or the view in focus. This tour can be started again "
                     "from the menu Help."))},
    };
}

} // namespace sparkout
