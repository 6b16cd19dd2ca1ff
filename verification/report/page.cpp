#include "verification/report/page.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <regex>

namespace rotor {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::list;
using kainjow::mustache::mustache;
using kainjow::mustache::object;

constexpr const char* minus = "\u2212";

/// Symbols as printed: F_n with an index, mu and rho in Greek, a number beside its unit.
/// Texts of several lines are sources, and do not change.
std::string in_html(const std::string& text) {
  std::string html = kainjow::mustache::html_escape(text);
  if (text.find('\n') != std::string::npos) return html;
  for (const auto& [plain, symbol] :
       {std::pair("\\bDelta", "\u0394"),
        {"\\bmu\\b", "\u03bc"},
        {"\\brho\\b", "\u03c1"},
        {"\\bum\\b", "\u03bcm"},
        {"\\bpi\\b", "\u03c0"},
        {"\\^2\\b", "\u00b2"},
        {"\\+-", "\u00b1"},
        {"\\bx (?=\\d)", "\u00d7 "},
        {"(\\d) (?=(k?N|k?Hz|J|mm|m?s|%)(?![A-Za-z]))", "$1\u00a0"},
        {"(\\b[A-Za-z]|\u0394)_([A-Za-z0-9]{1,4})(?![A-Za-z0-9_])", "$1<sub>$2</sub>"}})
    html = std::regex_replace(html, std::regex(plain), symbol);
  return html;
}

/// A number in text, with a typographic minus sign.
std::string in_print(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, minus);
  return number;
}

/// A number in all forms that a text may use.
data forms_of(double number) {
  object forms;
  for (const char digits : std::string("01234")) {
    const int count = digits - '0';
    forms[std::string("f") + digits] = in_print(fmt::format("{:.{}f}", number, count));
    forms[std::string("p") + digits] = in_print(fmt::format("{:.{}f}", 100 * number, count));
    if (count > 0)
      forms[std::string("s") + digits] = in_print(fmt::format("{:.{}g}", number, count));
  }
  return forms;
}

data for_texts(const Json& value) {
  if (value.is_number()) return forms_of(value.get<double>());
  if (value.is_string()) return value.get<std::string>();
  object all;
  if (!value.is_object()) return all;  // no text uses it
  for (const auto& [key, item] : value.items())
    if (!item.is_null()) all[key] = for_texts(item);
  return all;
}

/// Whether a placeholder of a text, such as published.peak_kN.f1, has a value.
bool has_value(const data& values, const std::string& place) {
  const data* at = &values;
  std::istringstream names(place);
  for (std::string name; at && std::getline(names, name, '.');)
    at = at->is_object() ? at->get(name) : nullptr;
  return at && at->is_string();
}

std::string with_numbers(const std::string& text, const data& values) {
  static const std::regex place("\\{\\{([^}]*)\\}\\}");
  for (std::sregex_iterator at(text.begin(), text.end(), place), end; at != end; ++at)
    if (!has_value(values, (*at)[1]))
      throw std::invalid_argument(fmt::format("nothing is known of {} in: {}", (*at).str(), text));
  mustache with_places(text);
  with_places.set_custom_escape([](const std::string& plain) { return plain; });
  return with_places.render(values);
}

Json with_numbers(const Json& texts, const data& values) {
  if (texts.is_string()) return with_numbers(texts.get<std::string>(), values);
  Json all = texts;
  for (auto& item : all) item = with_numbers(item, values);
  return all;
}

data for_page(const Json& value) {
  if (value.is_object()) {
    object all;
    for (const auto& [key, item] : value.items()) all[key] = for_page(item);
    return all;
  }
  if (value.is_array()) {
    list all;
    for (const Json& item : value) all.push_back(for_page(item));
    return all;
  }
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_null()) return false;
  if (value.is_number_float()) return in_print(fmt::format("{:.5g}", value.get<double>()));
  if (!value.is_string()) return value.dump();
  const auto text = value.get<std::string>();
  return text.empty() ? data(false) : data(text);  // there is nothing to say
}

}  // namespace

Json with_numbers(const Json& texts, const Json& values) {
  return with_numbers(texts, for_texts(values));
}

std::string render(const std::string& page_template,
                   const std::map<std::string, std::string>& partials, const Json& document) {
  mustache page(page_template);
  if (!page.is_valid()) throw std::invalid_argument(page.error_message());
  data all = for_page(document);
  for (const auto& [name, text] : partials)
    all.set(name, kainjow::mustache::partial([text = text] { return text; }));
  page.set_custom_escape(in_html);
  return page.render(all);
}

}  // namespace rotor
