// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/outcome.h"
#include "ui/session/job.h"

#include <QWidget>

class QCheckBox;
class QLabel;

namespace sparkout {

/// Offers the stiffness of a machine from the catalogue, with its effect on the compliance, the
/// machining time and the diameters.
class StiffnessOffer : public QWidget {
    Q_OBJECT

public:
    explicit StiffnessOffer(Project project, QWidget* parent = nullptr);

    /// Offers the machine that was put into the project; hidden if its stiffness changes nothing.
    void offer(const Project& with);
    void withdraw();
    [[nodiscard]] bool isTaken() const; ///< or if there is no choice
    /// The project with the machine, and with its stiffness if chosen.
    [[nodiscard]] Project taken(Project with) const;

signals:
    void chosen(); ///< the choice has changed

private:
    void askForEffect();
    void showEffect(const OutcomePtr& before, const OutcomePtr& after);
    [[nodiscard]] bool isGiven() const; ///< the compliance, so that no stiffness is used

    Project m_project;
    Project m_with;
    bool m_offered = false;
    QCheckBox* m_take;
    QLabel* m_effect;
    NewestJob m_job;
};

} // namespace sparkout
