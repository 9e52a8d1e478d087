// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/remedy_finder.h"

#include <QObject>

#include <functional>
#include <string>

namespace sparkout {

class Document;
class RemedySection;

/// Offers remedies beside the verdict: searches them after each run, and applies one as an edit
/// that can be undone.
class RemedyOffers : public QObject {
    Q_OBJECT

public:
    /// `reveal` shows the input that was changed.
    RemedyOffers(Document& document, RemedySection& section,
                 std::function<void(const std::string& path)> reveal, QObject* parent);

    void setOutcome(const OutcomePtr& outcome); ///< of the current document
    void offer(bool offered);                   ///< or stops offering

private:
    void take(const Remedy& remedy);

    Document& m_document;
    RemedySection& m_section;
    std::function<void(const std::string& path)> m_reveal;
    RemedyFinder* m_finder;
    bool m_isOffered = true;
};

} // namespace sparkout
