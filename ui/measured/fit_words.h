// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/identification.h"
#include "core/project/measured.h"
#include "core/project/project.h"
#include "ui/dialogs/copy_table.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <vector>

class QStandardItemModel;

namespace sparkout {

struct MeasuredWords; // words/measured_words.h

/// Texts about a fit and its data in the current language.
class FitWords {
    Q_DECLARE_TR_FUNCTIONS(FitWords)
public:
    static QString parameter(const Project& project, const FittedParameter& parameter);
    static QString unit(FittedKind kind); ///< empty for a factor
    static QString source(FitSource source);
    static QString unit(FitSource source);
    static QString trace(const MeasuredTrace& trace); ///< "size at the gauge, trace.csv (n = 261)"
    static QString group(const Project& project, const FitResiduals& residuals);
    static QString status(IdentificationStatus status);
    static QString advice(Advice advice);
    static QString trial(const MeasuredWords& words); ///< text of a trial
    /// "factor of α, factor of β: record …", for undetermined parameters.
    static QString unidentified(const Project& project, const std::vector<FittedParameter>& list,
                                const Unidentified& one);
    /// The effect of an omitted time on the values.
    static QString outOfStep(const Project& project, const Identification& result,
                             const OutOfStep& one);
    /// The force law supported by the spark-out, or what would decide.
    static QString forceLaw(const ForceLawChoice& choice);
    /// The lack of fit of a trace, and its cause; empty if there is none.
    static QString lack(const Project& project, const FitResiduals& residuals);
    /// A value outside its usual range; empty if it lies within.
    static QString unusual(const Project& project, const FittedValue& value);
    /// Lone readings beyond the range of all others; empty if there are none.
    static QString overRange(const Project& project, const FitResiduals& residuals);
    static QString place(const Project& project, int place); ///< "RZ1", "Section 2"
    static QString number(double value);
    static QString interval(const Interval& interval);
    /// The number of a parameter: a diameter to 0.1 µm.
    static QString number(FittedKind kind, double value);
    static QString interval(FittedKind kind, const Interval& interval);
    /// The name of a calibration's data: "trace.csv, 12 parts".
    static std::string data(const Project& project, const std::vector<int>& traces, bool withParts);
};

/// A table of a fit, as high as its rows: the first column texts, the others numbers.
class FitTable : public CopyTable {
    Q_OBJECT

public:
    explicit FitTable(const QString& name, QWidget* parent = nullptr);

    void setCells(const QStringList& head, const std::vector<QStringList>& rows);

private:
    void fitHeight();
    [[nodiscard]] QString text() const;

    QStandardItemModel* m_model;
};

} // namespace sparkout
