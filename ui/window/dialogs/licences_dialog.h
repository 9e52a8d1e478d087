// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

#include <vector>

namespace sparkout {

/// The components of the program and the full texts of their licences.
class LicencesDialog : public QDialog {
    Q_OBJECT

public:
    explicit LicencesDialog(QWidget* parent = nullptr);

    struct Component {
        QString name;
        QString licence; ///< its SPDX identifier
        QString copyright;
    };
    [[nodiscard]] static std::vector<Component> components(); ///< Sparkout first

    /// The licences that an expression of SPDX names, one after the other; empty where one is
    /// missing.
    [[nodiscard]] static QString textsOf(const QString& expression);
};

} // namespace sparkout
