/// From the document to the page, by Mustache templates.
#pragma once

#include <map>
#include <string>

#include "verification/report/document.hpp"

namespace rotor {

/// Texts with numbers for their placeholders: {{peak_N.f1}} has one digit after the point,
/// {{peak_N.k1}} as well, in thousands, m1 in thousandths, p1 in percent; "none" for a result that
/// a run does not have. Throws std::invalid_argument, with the text, for a placeholder without a
/// value.
Json with_numbers(const Json& texts, const Json& values);

/// The template, rendered, with those that it includes by name. Items of lists know whether they
/// are the first one; what is null or an empty text is not there.
std::string render(const std::string& page_template,
                   const std::map<std::string, std::string>& partials, const Json& document);

}  // namespace rotor
