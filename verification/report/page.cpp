#include "verification/report/page.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <sstream>

#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::list;
using kainjow::mustache::mustache;
using kainjow::mustache::object;

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
        {"(^|[ (])-(?=\\d)", "$1\u2212"},
        {"\\bx (?=\\d)", "\u00d7 "},
        {"\\b(\\d+(?:\\.\\d+)?)e-0?(\\d+)\\b", "$1\u00a0\u00d7\u00a010<sup>\u2212$2</sup>"},
        {"(\\d) (?=(k?N|k?Hz|J|mm|m?s|%)(?![A-Za-z]))", "$1\u00a0"},
        {"(\\b[A-Za-z]|\u0394)_([A-Za-z0-9]{1,4})(?![A-Za-z0-9_])", "$1<sub>$2</sub>"}})
    html = replaced(html, plain, symbol);
  return html;
}

/// A number in text, with a typographic minus sign.
std::string in_print(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "\u2212");
  return number;
}

/// In a form such as f1; empty for one that there is not.
std::string in_form(const std::string& form, double number) {
  if (matches(form, "^[fkmp][0-4]$").empty()) return "";
  const double factor = form[0] == 'k' ? 1e-3 : form[0] == 'm' ? 1e3 : form[0] == 'p' ? 100 : 1;
  return in_print(fmt::format("{:.{}f}", factor * number, form[1] - '0'));
}

/// What stands at a place such as published.mu_03.peak_normal_force_N.k1; empty if nothing does.
std::string text_at(const std::string& place, const Json& values) {
  const Json* at = &values;
  std::istringstream names(place);
  for (std::string name; std::getline(names, name, '.');) {
    if (at->is_null()) return "none";
    if (at->is_number()) return names.eof() ? in_form(name, at->get<double>()) : "";
    if (!at->contains(name)) return "";
    at = &at->at(name);
  }
  return at->is_string() ? at->get<std::string>() : "";
}

std::string with_numbers(const std::string& text, const Json& values) {
  return replaced(text, "\\{\\{([^}]*)\\}\\}", [&](const Match& place) {
    const std::string found = text_at(place[1], values);
    if (found.empty())
      throw std::invalid_argument(fmt::format("nothing is known of {} in: {}", place[0], text));
    return found;
  });
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
  if (texts.is_string()) return with_numbers(texts.get<std::string>(), values);
  Json all = texts;
  for (Json& item : all) item = with_numbers(item, values);
  return all;
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
