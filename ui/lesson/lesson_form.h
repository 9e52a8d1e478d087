// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/variant_rules.h"
#include "core/project/number_input.h"
#include "ui/form/struct_form.h"

#include <string>
#include <vector>

namespace sparkout {

class LessonDraft;

/// A struct of the lesson being edited as a form: goals by their kind, what the variants vary by
/// its way, texts in both languages, and inputs, surfaces and steps by their names.
class LessonForm : public StructForm {
    Q_OBJECT

public:
    LessonForm(LessonDraft& draft, Subject subject, QWidget* parent = nullptr);

protected:
    void addStruct(QFormLayout& form, const Subject& subject) override;
    void addRow(QFormLayout& form, const Row& row) override;
    void addItem(QFormLayout& form, const Row& row, std::size_t index, std::size_t count) override;
    void addBeside(QHBoxLayout& line, const Row& row, std::optional<std::size_t> item) override;
    [[nodiscard]] QWidget* make(const Row& row) override;
    [[nodiscard]] NumberSpec specOf(const Row& row) const override;
    [[nodiscard]] Field described(const Row& row) const override;
    [[nodiscard]] std::string decisiveValue(const Leaf& leaf) const override;
    void fillNewItem(const Field& list, void* owner) const override;
    [[nodiscard]] std::size_t leastItems(const Field& list) const override;

private:
    using Option = ChoiceEditor::Option;

    void addGoal(QFormLayout& form, const Subject& subject);
    void addVaried(QFormLayout& form, const Subject& subject);
    void addTexts(QFormLayout& form, const Row& row);
    [[nodiscard]] QWidget* makeValue(const Subject& subject);
    [[nodiscard]] QWidget* optionsOf(const Row& row, const std::vector<Option>& options);
    [[nodiscard]] QWidget* placeOf(const Row& row);
    /// Names of choices that the table does not have; none: it has them.
    [[nodiscard]] static std::vector<Option> namesOf(const Field& field);
    [[nodiscard]] std::vector<Option> optionsFor(const Row& row) const; ///< of a text; none: any
    [[nodiscard]] std::vector<Option> numberedFor(const Row& row) const;
    /// The input of the project that a number of the lesson is a value of.
    [[nodiscard]] std::optional<NumberInput> inputOf(const Row& row) const;

    LessonDraft& m_draft;
};

} // namespace sparkout

/// The inputs that a lesson can refer to, and their variation.
namespace sparkout {

/// The inputs shown in the forms, and those above them: paths in the file.
[[nodiscard]] std::vector<std::string> formInputs(const Project& project);

enum class Puts { numbers, anything };

/// The inputs to which a value can be assigned, in the order of the forms.
[[nodiscard]] std::vector<std::string> inputsToPut(const Project& project, Puts puts);

/// The value of an input in a project; only the path if it has none.
[[nodiscard]] InputValue valueIn(const Project& project, const std::string& path);

/// The kind of variation of an input, in the order of the form.
enum class VariedBy { range, list, sets };

[[nodiscard]] VariedBy variedBy(const VariedInput& input);

/// Converts to the same levels in another form, as far as possible; otherwise uses the project's
/// value.
[[nodiscard]] VariedInput variedAs(const VariedInput& input, VariedBy by, const Project& project);

/// The number of variants of the rules: the product of the levels; 0 if an input has none yet.
[[nodiscard]] double variantCount(const VariantRules& rules);

} // namespace sparkout
