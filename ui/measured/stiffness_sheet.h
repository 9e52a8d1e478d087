// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <vector>

class QPrinter;
class QWidget;

namespace sparkout {

/// The sheet of a stiffness trial: the steps at the machine, and a table to fill in by hand.
class StiffnessSheet {
    Q_DECLARE_TR_FUNCTIONS(StiffnessSheet)

public:
    /// @param load_n the load of the readings [N]
    StiffnessSheet(const Project& project, std::vector<double> places_mm, double load_n);

    [[nodiscard]] QStringList steps() const;
    [[nodiscard]] QString html() const; ///< the whole sheet
    void print(QWidget* window) const;  ///< asks for the printer
    void printOn(QPrinter& printer) const;

private:
    [[nodiscard]] QString facts() const;
    [[nodiscard]] QString table() const;

    QString m_title, m_part, m_machine;
    bool m_hasTailstock;
    std::vector<double> m_places_mm;
    double m_load_n;
};

} // namespace sparkout
