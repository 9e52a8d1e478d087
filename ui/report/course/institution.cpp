// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/institution.h"

#include <QCoreApplication>

#include <array>

namespace sparkout::report {

namespace {

constexpr qsizetype longestText = 300;

constexpr std::array titleFields{
    InstitutionField{"ministry", &Institution::ministry,
                     QT_TRANSLATE_NOOP("Institution", "Ministry")},
    InstitutionField{"university", &Institution::university,
                     QT_TRANSLATE_NOOP("Institution", "University")},
    InstitutionField{"faculty", &Institution::faculty,
                     QT_TRANSLATE_NOOP("Institution", "Faculty or institute")},
    InstitutionField{"department", &Institution::department,
                     QT_TRANSLATE_NOOP("Institution", "Department")},
    InstitutionField{"discipline", &Institution::discipline,
                     QT_TRANSLATE_NOOP("Institution", "Discipline")},
    InstitutionField{"accepted", &Institution::acceptedBy,
                     QT_TRANSLATE_NOOP("Institution", "Accepted by (post and name)")},
    InstitutionField{"place", &Institution::place, QT_TRANSLATE_NOOP("Institution", "Town")},
};

} // namespace

std::span<const InstitutionField> institutionFields() {
    return titleFields;
}

QVariantMap Institution::kept() const {
    QVariantMap kept;
    for (const InstitutionField& field : titleFields) {
        if (const QString text = (this->*field.value).simplified(); !text.isEmpty()) {
            kept.insert(QString::fromLatin1(field.key), text);
        }
    }
    return kept;
}

Institution Institution::fromKept(const QVariantMap& kept) {
    Institution made;
    for (const InstitutionField& field : titleFields) {
        made.*field.value =
            kept.value(QString::fromLatin1(field.key)).toString().simplified().left(longestText);
    }
    return made;
}

} // namespace sparkout::report
