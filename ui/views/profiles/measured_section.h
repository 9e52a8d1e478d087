// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include <optional>
#include <vector>

class QWidget;

namespace sparkout {

/// A cross-section as a roundness machine recorded it, to stand beside the predicted ones.
struct MeasuredSection {
    Q_DECLARE_TR_FUNCTIONS(MeasuredSection)

public:
    QString name; ///< of its file
    std::vector<double> radii_mm;

    /// Asks for a table of angles and radii and reads it; what is wrong with it is said.
    [[nodiscard]] static std::optional<MeasuredSection> ask(QWidget* window,
                                                            double nominalRadius_mm);
    /// The same of a file; nothing where it cannot be read, with the reason.
    [[nodiscard]] static std::optional<MeasuredSection>
    read(const QString& path, double nominalRadius_mm, QString& reason);
};

} // namespace sparkout
