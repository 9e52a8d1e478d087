// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/outcome.h"
#include "ui/session/newest_job.h"

#include <QObject>

namespace sparkout {

/// Runs a project and the same with a change off the window's thread. A newer request stops the
/// older one, whose answer is dropped. Destroying it stops the work and waits for it.
class EffectFinder : public QObject {
    Q_OBJECT

public:
    explicit EffectFinder(QObject* parent = nullptr);

    void request(Project before, Project after);
    void drop();

signals:
    void found(sparkout::OutcomePtr before, sparkout::OutcomePtr after);

private:
    NewestJob m_job;
};

} // namespace sparkout
