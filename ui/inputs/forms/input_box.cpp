// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/input_box.h"

#include "ui/fields/mark.h"
#include "ui/inputs/editors/hint_strip.h"
#include "ui/text/texts.h"

#include <utility>

namespace sparkout {

InputBox::InputBox(std::string path, const Field& field, int depth, Document& document,
                   QWidget* parent)
    : SectionBox(depth, parent)
    , m_path(std::move(path))
    , m_field(field)
    , m_document(document)
    , m_numbers(new NumberLines(document, field.label, this))
    , m_reason(new ReasonLabel(this)) {
    setHintField(*this, field);
    m_numbers->setNames([&field](const QString& label) {
        return tr("%1: %2", "input: number").arg(inputText(field.label), label);
    });
    connect(m_numbers, &NumberLines::refusalsChanged, this, &InputBox::refusalsChanged);
}

bool InputBox::holds(const std::string& path) const {
    return path == m_path || path.starts_with(m_path + "/");
}

} // namespace sparkout
