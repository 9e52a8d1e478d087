// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QXmlStreamWriter>

#include <utility>
#include <vector>

namespace sparkout::report {

/// A file of an OpenDocument text that is being written.
class OdtXml {
public:
    using Attributes = std::vector<std::pair<QString, QString>>;

    explicit OdtXml(const char* root);
    void attribute(const char* name, const QString& value);
    void begin(const char* name);
    void end();
    void text(const QString& text);
    void empty(const char* name, const Attributes& attributes);
    /// A paragraph or heading; line breaks are kept.
    void paragraph(const char* style, const QString& text, const char* element = "text:p");
    /// A text with symbols: the index of "k_s" is lowered.
    void symbols(const char* style, const QString& text);
    void paragraphStyle(const char* name, const Attributes& paragraph, const Attributes& text);
    /// Ends all open elements.
    [[nodiscard]] QByteArray finish();

    [[nodiscard]] static QString millimetres(double value);

private:
    QByteArray m_bytes;
    QXmlStreamWriter m_writer;
};

} // namespace sparkout::report
