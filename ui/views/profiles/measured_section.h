// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include <optional>
#include <vector>

class QWidget;

namespace sparkout {

/// A cross-section recorded by a roundness machine, for comparison with the predicted ones.
struct MeasuredSection {
    Q_DECLARE_TR_FUNCTIONS(MeasuredSection)

public:
    QString name; ///< name of its file
    std::vector<double> radii_mm;

    /// Asks for a table of angles and radii and reads it; shows any error.
    [[nodiscard]] static std::optional<MeasuredSection> ask(QWidget* window,
                                                            double nominalRadius_mm);
    /// Reads a file; empty, with the reason, if it is invalid.
    [[nodiscard]] static std::optional<MeasuredSection>
    read(const QString& path, double nominalRadius_mm, QString& reason);
};

} // namespace sparkout
