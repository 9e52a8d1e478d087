// SPDX-License-Identifier: GPL-3.0-or-later
// Every input of a cycle is on a page of the form: the rows are printed, for tests/one_place.
#include "tests/whole_project.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/theme.h"
#include "ui/session/document.h"

#include <QApplication>
#include <QTest>

#include <algorithm>
#include <cstdio>
#include <functional>

using namespace sparkout;

class TestInputPages : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::light); }

    // What the engine judges by can be entered: every leaf of a part's inputs is on a page.
    void everyInputHasItsPage() {
        Document document;
        InputsPanel panel(document);
        QStringList missing;
        const std::function<void(const StructInfo&, const std::string&)> look =
            [&](const StructInfo& table, const std::string& path) {
                for (const Field& field : table.fields) {
                    const std::string at = path + "/" + field.key;
                    if (field.kind == Kind::object || field.kind == Kind::optionalObject) {
                        look(*field.nested, at);
                    } else if (std::none_of(panel.pages().begin(), panel.pages().end(),
                                            [&](FormPage* page) { return page->holds(at); })) {
                        missing += QString::fromStdString(at);
                    }
                }
            };
        look(tableOf<Part>(), "/part");
        look(tableOf<Material>(), "/material");
        look(tableOf<Wheel>(), "/wheel");
        look(tableOf<Machine>(), "/machine");
        look(tableOf<Gauge>(), "/gauge");
        look(tableOf<Cycle>(), "/cycle");
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
        for (FormPage* page : panel.pages()) {
            for (const FormRow* row : page->rows()) {
                const FieldEditor& editor = row->editor();
                std::printf("%s\t%s\n", editor.path().c_str(),
                            qPrintable(editor.widget()->accessibleName()));
            }
        }
    }
};

QTEST_MAIN(TestInputPages)
#include "test_input_pages.moc"
