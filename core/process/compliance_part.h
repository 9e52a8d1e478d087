// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/compliance.h"

#include <array>

namespace sparkout {

/// The parts of γ(x), from the bottom; the part of the steady rests is subtracted.
enum class CompliancePart { wheelHead, headstock, tailstock, bending, rests };

inline constexpr std::array allComplianceParts{CompliancePart::wheelHead, CompliancePart::headstock,
                                               CompliancePart::tailstock, CompliancePart::bending,
                                               CompliancePart::rests};

[[nodiscard]] double valueOf(const ComplianceParts& parts, CompliancePart part); ///< [mm/N]
[[nodiscard]] double sumOf(const ComplianceParts& parts);                        ///< [mm/N]

} // namespace sparkout
