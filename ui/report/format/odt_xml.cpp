// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/odt_xml.h"

#include "ui/text/texts.h"

#include <QRegularExpression>
#include <QStringList>

namespace sparkout::report {

namespace {

const std::pair<const char*, const char*> namespaces[] = {
    {"office", "urn:oasis:names:tc:opendocument:xmlns:office:1.0"},
    {"style", "urn:oasis:names:tc:opendocument:xmlns:style:1.0"},
    {"text", "urn:oasis:names:tc:opendocument:xmlns:text:1.0"},
    {"table", "urn:oasis:names:tc:opendocument:xmlns:table:1.0"},
    {"draw", "urn:oasis:names:tc:opendocument:xmlns:drawing:1.0"},
    {"fo", "urn:oasis:names:tc:opendocument:xmlns:xsl-fo-compatible:1.0"},
    {"svg", "urn:oasis:names:tc:opendocument:xmlns:svg-compatible:1.0"},
    {"xlink", "http://www.w3.org/1999/xlink"},
    {"dc", "http://purl.org/dc/elements/1.1/"},
    {"meta", "urn:oasis:names:tc:opendocument:xmlns:meta:1.0"},
    {"manifest", "urn:oasis:names:tc:opendocument:xmlns:manifest:1.0"},
};

} // namespace

QString OdtXml::millimetres(double value) {
    return QString::number(value, 'f', 2) + QStringLiteral("mm");
}

OdtXml::OdtXml(const char* root) : m_writer(&m_bytes) {
    m_writer.writeStartDocument();
    begin(root);
    for (const auto& [prefix, uri] : namespaces) {
        m_writer.writeAttribute(QStringLiteral("xmlns:") + QString::fromLatin1(prefix),
                                QString::fromLatin1(uri));
    }
}

void OdtXml::attribute(const char* name, const QString& value) {
    m_writer.writeAttribute(QString::fromLatin1(name), value);
}

void OdtXml::begin(const char* name) {
    m_writer.writeStartElement(QString::fromLatin1(name));
}

void OdtXml::end() {
    m_writer.writeEndElement();
}

void OdtXml::text(const QString& text) {
    m_writer.writeCharacters(harmlessText(text));
}

void OdtXml::empty(const char* name, const Attributes& attributes) {
    begin(name);
    for (const auto& [key, value] : attributes) {
        m_writer.writeAttribute(key, value);
    }
    end();
}

void OdtXml::paragraph(const char* style, const QString& text, const char* element) {
    begin(element);
    attribute("text:style-name", QString::fromLatin1(style));
    if (qstrcmp(element, "text:h") == 0) {
        attribute("text:outline-level", QStringLiteral("1"));
    }
    const QStringList lines = text.split(u'\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            empty("text:line-break", {});
        }
        this->text(lines[i]);
    }
    end();
}

void OdtXml::symbols(const char* style, const QString& text) {
    static const QRegularExpression index(QStringLiteral("_(\\w+)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    begin("text:p");
    attribute("text:style-name", QString::fromLatin1(style));
    const QStringList lines = text.split(u'\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            empty("text:line-break", {});
        }
        qsizetype from = 0;
        for (auto it = index.globalMatch(lines[i]); it.hasNext();) {
            const auto match = it.next();
            this->text(lines[i].mid(from, match.capturedStart() - from));
            begin("text:span");
            attribute("text:style-name", QStringLiteral("Index"));
            this->text(match.captured(1));
            end();
            from = match.capturedEnd();
        }
        this->text(lines[i].mid(from));
    }
    end();
}

void OdtXml::paragraphStyle(const char* name, const Attributes& paragraph, const Attributes& text) {
    begin("style:style");
    attribute("style:name", QString::fromLatin1(name));
    attribute("style:family", QStringLiteral("paragraph"));
    empty("style:paragraph-properties", paragraph);
    empty("style:text-properties", text);
    end();
}

QByteArray OdtXml::finish() {
    m_writer.writeEndDocument();
    return m_bytes;
}

} // namespace sparkout::report
