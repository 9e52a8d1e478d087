// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/card/card_form.h"
#include "ui/report/card/card_sheets.h"
#include "ui/report/format/form_head.h"

namespace sparkout::report {

/// The head of card and sketch as cells, for an editable text; the sheets draw it with lines.
class HeadGrids {
public:
    [[nodiscard]] static FormHead of(const CardHead& head, const form::Kind& kind);

private:
    static FormGrid inventory();
    static FormGrid signers(const CardHead& head);
    static FormGrid following(const CardHead& head);
};

} // namespace sparkout::report
