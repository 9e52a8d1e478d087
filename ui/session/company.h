// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace sparkout {

/// Who makes the documents: what their heads have beside the project. All of it may be empty.
struct Company {
    QString name;
    QString department;
    QByteArray logo;     ///< the bytes of a PNG or SVG file
    QString designation; ///< of the document
    QString part;        ///< designation of the part
    QString developed;   ///< names of those who sign
    QString checked;
    QString agreed;
    QString standards; ///< who checks against the standards
    QString approved;
    QString shop, area, place, operation; ///< numbers: Цех, Уч., РМ, Опер.

    friend bool operator==(const Company&, const Company&) = default;
};

} // namespace sparkout
