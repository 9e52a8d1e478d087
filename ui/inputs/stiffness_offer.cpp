// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stiffness_offer.h"

#include "core/project/machine.h"
#include "core/units.h"
#include "ui/kit/metrics.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

constexpr double nmOfMm = 1e6;
constexpr std::size_t mostGammas = 3; ///< more are shown as the least and the largest γ

bool isSameStiffness(const std::optional<Stiffness>& a, const std::optional<Stiffness>& b) {
    return a.has_value() == b.has_value()
           && (!a
               || (a->headstock == b->headstock && a->tailstock == b->tailstock
                   && a->wheel_head == b->wheel_head));
}

/// "4.1 → 5.2", with a dash for a missing run.
QString beforeAndAfter(const OutcomePtr& before, const OutcomePtr& after,
                       const std::function<QString(const Outcome&)>& of) {
    const auto shown = [&of](const OutcomePtr& outcome) {
        return outcome->ran() ? of(*outcome) : QStringLiteral("—");
    };
    return shown(before) + QStringLiteral(" → ") + shown(after);
}

/// in the unit of the view "Compliance"
QString gammasShown(const Outcome& outcome) {
    const auto& sections = outcome.result.sections;
    const auto shown = [](const auto& section) {
        return Names::significant(section.compliance_mm_per_n * nmOfMm);
    };
    QStringList texts;
    if (sections.size() <= mostGammas) {
        std::ranges::transform(sections, std::back_inserter(texts), shown);
        texts.removeDuplicates();
        return texts.join(QStringLiteral("; "));
    }
    const auto compliance = [](const auto& section) { return section.compliance_mm_per_n; };
    const auto [least, most] = std::ranges::minmax(sections, {}, compliance);
    return shown(least) == shown(most) ? shown(least) : shown(least) + u'…' + shown(most);
}

QString timeShown(const Outcome& outcome) {
    return Names::time(outcome.result.time_s, 4);
}

QString deviationsShown(const Outcome& outcome) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& section : outcome.result.sections) {
        low = std::min(low, section.diameterDeviationMin_mm);
        high = std::max(high, section.diameterDeviationMax_mm);
    }
    return Names::signedMicrometres(low * units::umPerMm) + u'…'
           + Names::signedMicrometres(high * units::umPerMm);
}

QString failingShown(const Outcome& outcome) {
    return QString::number(
        std::ranges::count(outcome.constraints, false, &ConstraintResult::holds));
}

} // namespace

StiffnessOffer::StiffnessOffer(Project project, QWidget* parent)
    : QWidget(parent)
    , m_project(std::move(project))
    , m_take(new QCheckBox(this))
    , m_effect(new QLabel(this)) {
    m_take->setObjectName(QStringLiteral("takeStiffness"));
    m_take->setText(isGiven() ? tr("&Compute the compliance from its stiffness")
                              : tr("Use its &stiffness"));
    m_take->setToolTip(isGiven()
                           ? tr("The compliance is given on the page Machine, so a stiffness is "
                                "not used there. This removes the given compliance; γ then follows "
                                "from the stiffness of the machine and from the shaft.")
                           : tr("Without it the stiffness of the project stays as it is; the other "
                                "values of the machine are applied."));
    m_effect->setObjectName(QStringLiteral("stiffnessEffect"));
    m_effect->setTextFormat(Qt::PlainText);
    m_effect->setWordWrap(true);
    m_effect->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_effect->setAccessibleName(tr("Effect of the stiffness"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addWidget(m_take);
    column->addWidget(m_effect);
    connect(m_take, &QCheckBox::toggled, this, &StiffnessOffer::chosen);
    withdraw();
}

bool StiffnessOffer::isGiven() const {
    return !std::holds_alternative<std::monostate>(m_project.machine->compliance_mm_per_n);
}

void StiffnessOffer::offer(const Project& with) {
    m_with = with;
    m_offered =
        with.machine->stiffness_n_um
        && (isGiven()
            || !isSameStiffness(with.machine->stiffness_n_um, m_project.machine->stiffness_n_um));
    m_take->setChecked(m_offered && !isGiven());
    setVisible(m_offered);
    if (m_offered) {
        askForEffect();
    } else {
        m_job.stop();
    }
}

void StiffnessOffer::withdraw() {
    m_offered = false;
    m_job.stop();
    hide();
}

bool StiffnessOffer::isTaken() const {
    return !m_offered || m_take->isChecked();
}

/// The effect of the stiffness alone: both runs have the other values of the machine.
void StiffnessOffer::askForEffect() {
    Project without = m_with, with = m_with;
    without.machine->stiffness_n_um = m_project.machine->stiffness_n_um;
    with.machine->compliance_mm_per_n = std::monostate{};
    m_effect->setText(tr("Computing its effect …"));
    m_job.start([this, without = std::move(without),
                 with = std::move(with)](const std::stop_token& stop, const NewestJob::Post& post) {
        const OutcomePtr before = evaluate(without, stop);
        if (const OutcomePtr after = before ? evaluate(with, stop) : nullptr) {
            post([this, before, after] { showEffect(before, after); });
        }
    });
}

void StiffnessOffer::showEffect(const OutcomePtr& before, const OutcomePtr& after) {
    if (!after->ran()) {
        m_effect->setText(
            tr("With it the cycle cannot be run: %1").arg(Names::refusal(after->issues, 1)));
        return;
    }
    m_effect->setText(tr("Its effect: γ %1 nm/N; machining time %2; diameter deviations %3 µm; "
                         "requirements not met %4.")
                          .arg(beforeAndAfter(before, after, gammasShown),
                               beforeAndAfter(before, after, timeShown),
                               beforeAndAfter(before, after, deviationsShown),
                               beforeAndAfter(before, after, failingShown)));
}

Project StiffnessOffer::taken(Project with) const {
    if (!m_offered) {
        return with;
    }
    if (isGiven()) {
        if (m_take->isChecked()) {
            with.machine->compliance_mm_per_n = std::monostate{};
        }
    } else if (!m_take->isChecked()) {
        with.machine->stiffness_n_um = m_project.machine->stiffness_n_um;
    }
    return with;
}

} // namespace sparkout
