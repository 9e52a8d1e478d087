// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/validate.h"
#include "core/study/new_project.h"
#include "tests/whole_project.h"
#include "ui/form/number_field.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/document.h"

#include <QTest>

#include <memory>
#include <string>
#include <utility>

/// The inputs beside a document of their own.
namespace sparkout::inputs_bench {

inline constexpr int partPage = 0, materialPage = 1, machinePage = 3, cyclePage = 5;

struct Bench {
    explicit Bench(Project project = newProject(Operation::traverse), int page = -1)
        : panel(document) {
        panel.resize(360, 640);
        panel.show();
        document.startUntitled(std::move(project));
        if (page >= 0) {
            panel.showPage(page);
        }
    }
    explicit Bench(int page) : Bench(newProject(Operation::traverse), page) {}
    template <class T>
    [[nodiscard]] T* find(const char* path) const {
        return panel.findChild<T*>(QString::fromLatin1(path));
    }
    [[nodiscard]] NumberField* field(const char* path) const { return find<NumberField>(path); }
    [[nodiscard]] FormRow* row(const std::string& path) {
        for (const FormPage* page : panel.pages()) {
            for (FormRow* row : page->rows()) {
                if (row->editor().path() == path) {
                    return row;
                }
            }
        }
        return nullptr;
    }
    [[nodiscard]] const Project& project() const { return document.project(); }
    [[nodiscard]] const Part& part() const { return *project().part; }
    void showIssues() {
        auto outcome = std::make_shared<Outcome>();
        outcome->issues = validate(project());
        panel.setOutcome(outcome);
    }
    Document document;
    InputsPanel panel;
};

} // namespace sparkout::inputs_bench
