/// From the document to the page, by Mustache templates.
#pragma once

#include <map>
#include <string>

#include "verification/report/document.hpp"

namespace rotor {

/// Texts with numbers for their placeholders: {{peak.f1}} has one digit after the point,
/// {{peak.s3}} three digits. Throws std::invalid_argument, with the text, for a placeholder without
/// a value.
Json with_numbers(const Json& texts, const Json& values);

/// Templates that others include, by name.
using Partials = std::map<std::string, std::string>;

/// The template, rendered. Items of lists know whether they are the first one; what is null or an
/// empty text is not there.
std::string render(const std::string& page_template, const Partials& partials,
                   const Json& document);

}  // namespace rotor
