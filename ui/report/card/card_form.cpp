// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card/card_form.h"

#include <QCoreApplication>

namespace sparkout::report::form {

const std::array<const char*, 3> inventory{QT_TRANSLATE_NOOP("CardForm", "Copy"),
                                           QT_TRANSLATE_NOOP("CardForm", "Repl."),
                                           QT_TRANSLATE_NOOP("CardForm", "Orig.")};
const std::array<Cell, 5> changes{{{QT_TRANSLATE_NOOP("CardForm", "Rev."), 10},
                                   {QT_TRANSLATE_NOOP("CardForm", "Sheet"), 10},
                                   {QT_TRANSLATE_NOOP("CardForm", "Doc. no."), 22},
                                   {QT_TRANSLATE_NOOP("CardForm", "Sign."), 14},
                                   {QT_TRANSLATE_NOOP("CardForm", "Date"), 12}}};
const std::array<const char*, 5> signers{
    QT_TRANSLATE_NOOP("CardForm", "Prepared"), QT_TRANSLATE_NOOP("CardForm", "Checked"),
    QT_TRANSLATE_NOOP("CardForm", "Agreed"), QT_TRANSLATE_NOOP("CardForm", "Standards"),
    QT_TRANSLATE_NOOP("CardForm", "Approved")};
const std::array<Cell, 3> designations{{{QT_TRANSLATE_NOOP("CardForm", "Company, department"), 72},
                                        {QT_TRANSLATE_NOOP("CardForm", "Part designation"), 60},
                                        {QT_TRANSLATE_NOOP("CardForm", "Document number"), 60}}};
const std::array<Cell, 6> names{{{QT_TRANSLATE_NOOP("CardForm", "Name of the part"), 120},
                                 {QT_TRANSLATE_NOOP("CardForm", "Letter"), 12},
                                 {QT_TRANSLATE_NOOP("CardForm", "Shop"), 15},
                                 {QT_TRANSLATE_NOOP("CardForm", "Area"), 15},
                                 {QT_TRANSLATE_NOOP("CardForm", "Workpl."), 15},
                                 {QT_TRANSLATE_NOOP("CardForm", "Oper."), 15}}};
const std::array<Cell, 4> continued{{{QT_TRANSLATE_NOOP("CardForm", "Name of the part"), 120},
                                     {QT_TRANSLATE_NOOP("CardForm", "Part designation"), 68},
                                     {QT_TRANSLATE_NOOP("CardForm", "Document number"), 69},
                                     {QT_TRANSLATE_NOOP("CardForm", "Oper."), 15}}};
const std::array<Cell, 8> operationRow{
    {{QT_TRANSLATE_NOOP("CardForm", "Name of the operation"), 72},
     {QT_TRANSLATE_NOOP("CardForm", "Material"), 46},
     {QT_TRANSLATE_NOOP("CardForm", "Hardness"), 24},
     {QT_TRANSLATE_NOOP("CardForm", "Unit"), 13},
     {QT_TRANSLATE_NOOP("CardForm", "Part mass"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Profile and sizes"), 60},
     {QT_TRANSLATE_NOOP("CardForm", "Raw mass"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "At once"), 17}}};
const std::array<Cell, 7> equipmentRow{
    {{QT_TRANSLATE_NOOP("CardForm", "Equipment, NC control"), 82},
     {QT_TRANSLATE_NOOP("CardForm", "NC program number"), 50},
     {QT_TRANSLATE_NOOP("CardForm", "Main, min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Auxil., min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Setting, min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Piece, min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Coolant"), 60}}};
const std::array<Cell, 12> columns{{{QT_TRANSLATE_NOOP("CardForm", "R"), 12},
                                    {QT_TRANSLATE_NOOP("CardForm", "Step, settings"), 88},
                                    {QT_TRANSLATE_NOOP("CardForm", "Pos."), 10},
                                    {QT_TRANSLATE_NOOP("CardForm", "D or B, mm"), 20},
                                    {QT_TRANSLATE_NOOP("CardForm", "L, mm"), 18},
                                    {QT_TRANSLATE_NOOP("CardForm", "t, mm"), 18},
                                    {QT_TRANSLATE_NOOP("CardForm", "i"), 14},
                                    {QT_TRANSLATE_NOOP("CardForm", "S"), 28},
                                    {QT_TRANSLATE_NOOP("CardForm", "n, rev/min"), 18},
                                    {QT_TRANSLATE_NOOP("CardForm", "V, m/min"), 16},
                                    {QT_TRANSLATE_NOOP("CardForm", "Main, min"), 15},
                                    {QT_TRANSLATE_NOOP("CardForm", "Auxil., min"), 15}}};

const char* const dateFormat = QT_TRANSLATE_NOOP("CardForm", "d MMM yy");

const Kind card{
    QT_TRANSLATE_NOOP("CardForm", "OC"), QT_TRANSLATE_NOOP("CardForm", "Operation card, machining"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1404-86, form 2"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1404-86, form 2a"),
    QT_TRANSLATE_NOOP("CardForm",
                      "The form is modelled on GOST 3.1404-86 and 3.1103: check it against the "
                      "current edition. The numbers are predictions of a model, to be confirmed at "
                      "the machine.")};
const Kind sketch{
    QT_TRANSLATE_NOOP("CardForm", "SK"), QT_TRANSLATE_NOOP("CardForm", "Sketch sheet"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1105-84, form 7"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1105-84, form 7a"),
    QT_TRANSLATE_NOOP("CardForm",
                      "The form is modelled on GOST 3.1105-84 and 3.1103: check it against the "
                      "current edition. Not to scale.")};

QString text(const char* caption) {
    return QCoreApplication::translate("CardForm", caption);
}

} // namespace sparkout::report::form
