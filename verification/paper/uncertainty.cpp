#include "verification/paper/uncertainty.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "figures/data/csv.hpp"
#include "verification/paper/readings.hpp"

namespace rotor {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Yes or no, and counts, have no small errors.
bool is_continuous(const Number& number) {
  return number.kind == Kind::simulated && number.rule != "is" &&
         !(number.unit.empty() && number.rule == "few");
}

bool has_printed_number(const Number& number) {
  return number.rule == "digits" || number.rule == "about";
}

}  // namespace

std::vector<Uncertainty> uncertainties(const std::vector<Number>& numbers) {
  PaperInputs finer;
  finer.spec.numbers["tolerance"] = Scenario{}.tolerance / 100;
  PaperRuns finer_runs(finer);
  std::vector<Uncertainty> all;
  for (const Number& number : numbers) {
    if (!is_continuous(number)) continue;
    const Reading& reading = number.readings.front();
    const Reading::InSet& in = reading.in[0];
    const double s = in.converged.value();
    if (s == 0) continue;  // kept to the bit: nothing is relative to that
    const auto relative = [&](double value) { return value / std::abs(s); };
    const auto half_range = [&](const Stored& over) {
      return relative((over.spread.high - over.spread.low) / 2);
    };
    const bool printed = has_printed_number(number);
    all.push_back({.number = number.id,
                   .says = number.says,
                   .unit = number.unit,
                   .simulated = s,
                   .error = printed ? relative(s - std::stod(number.printed)) : nan,
                   .u_num = relative(std::abs(read_off(reading.name, finer_runs).value() - s)),
                   .u_num_own = in.by_rk4 ? relative(std::abs(*in.by_rk4 - s)) : nan,
                   .u_times = half_range(in.a),
                   .u_input = half_range(in.b),
                   .u_printed = printed ? relative(half_digit(number.printed)) : nan});
  }
  return all;
}

std::string to_csv(const std::vector<Uncertainty>& all) {
  std::string csv =
      "number,unit,simulated,error,u_num,u_num_published_method,u_input_a,u_input_b,u_printed\n";
  for (const Uncertainty& u : all) {
    csv += fmt::format("{},{}", u.number, u.unit);
    for (const double value :
         {u.simulated, u.error, u.u_num, u.u_num_own, u.u_times, u.u_input, u.u_printed})
      csv += ',' + (std::isnan(value) ? std::string() : fmt::format("{:.6g}", value));
    csv += '\n';
  }
  return csv;
}

}  // namespace rotor
