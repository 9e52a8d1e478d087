// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_view.h"
#include "ui/session/document.h"
#include "ui/session/studies.h"

#include <functional>
#include <memory>

namespace sparkout {

/// A view of a study that is computed on demand and shown until the next one, faint when the inputs
/// have changed.
class StudyView : public PlotView {
    Q_OBJECT
public:
    /// The notice over outdated results; `button` computes new ones.
    [[nodiscard]] static QString staleText(bool isRunning, const QString& button) {
        return isRunning ? tr("These results are for the inputs before the last edit; those for "
                              "the current inputs are being computed.")
                         : tr("These results are for the inputs before the last edit. Press “%1” "
                              "to compute them for the current inputs.")
                               .arg(button);
    }

signals:
    /// An edit of the document is requested.
    void editWanted(const std::function<sparkout::Project(sparkout::Project)>& edit,
                    const sparkout::EditText& text);
    void ended(); ///< the result, or its refusal, has been drawn

protected:
    /// Without studies of the window it creates its own.
    StudyView(const QString& name, QWidget* parent, Settings* settings, Studies* studies)
        : PlotView(name, parent, settings)
        , m_own(studies ? nullptr : std::make_unique<Studies>())
        , m_studies(studies ? *studies : *m_own) {}

    [[nodiscard]] Studies& studies() const { return m_studies; }

private:
    std::unique_ptr<Studies> m_own;
    Studies& m_studies;
};

} // namespace sparkout
