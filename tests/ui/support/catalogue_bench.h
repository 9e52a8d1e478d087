// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/new_project.h"
#include "tests/ui/support/window_bench.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/catalogue_store.h"

#include <QPushButton>
#include <QTest>

#include <array>
#include <cstddef>

/// The catalogues, and a window on the page of the inputs that uses them.
namespace sparkout::catalogue_bench {

inline constexpr std::array kinds{CatalogueKind::materials, CatalogueKind::wheels,
                                  CatalogueKind::machines};

template <class Widget>
Widget* child(const QObject& parent, const char* name) {
    return parent.findChild<Widget*>(QString::fromLatin1(name));
}

/// A window on one of the pages, with settings of its own.
struct Window {
    explicit Window(int pageNumber, Operation operation = Operation::traverse) : page(pageNumber) {
        bench.window->document().startUntitled(newProject(operation));
        bench.window->inputs().showPage(page);
        bench.settle();
    }
    [[nodiscard]] Document& document() { return bench.window->document(); }
    template <class Widget>
    [[nodiscard]] Widget* on(const char* name) {
        return child<Widget>(*bench.window->inputs().pages()[std::size_t(page)], name);
    }
    void press(const char* name) {
        auto* button = on<QPushButton>(name);
        QVERIFY(button && button->isVisible());
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
    }
    int page;
    Bench bench{QStringLiteral("en")};
};

inline constexpr int partPage = 0, materialPage = 1, wheelPage = 2, machinePage = 3;

} // namespace sparkout::catalogue_bench
