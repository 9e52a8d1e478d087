// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/compliance_part.h"

namespace sparkout {

double sumOf(const ComplianceParts& parts) {
    double sum = 0;
    for (const CompliancePart part : allComplianceParts) {
        sum += valueOf(parts, part);
    }
    return sum;
}

double valueOf(const ComplianceParts& parts, CompliancePart part) {
    switch (part) {
    case CompliancePart::wheelHead: return parts.wheelHead;
    case CompliancePart::headstock: return parts.headstock;
    case CompliancePart::tailstock: return parts.tailstock;
    case CompliancePart::bending: return parts.bending;
    case CompliancePart::rests: return parts.rests;
    }
    return 0;
}

} // namespace sparkout
