/// Recomputes reference-data/ranking.csv: which input decides each number of the text:
/// `ranking FOLDER COUNT`. Designs and estimators are OpenTURNS's.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <openturns/OT.hxx>
#include <thread>

#include "figures/data/files.hpp"
#include "verification/paper/uncertainty.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

std::string cells(const Estimate& e) {
  return fmt::format("{:.3f},{:.3f},{:.3f}", e.value, e.low, e.high);
}
std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

/// Whether an index can be told from 0 with the digits that are written.
bool is_told(const Estimate& index) { return index.high >= 0.005; }

/// The design A, B, and A with each column from B in turn, of so many rows each.
OT::Sample design(const std::vector<InputRange>& ranges, std::size_t count) {
  OT::Collection<OT::Distribution> inputs;
  for (const InputRange& range : ranges) inputs.add(OT::Uniform(range.least, range.greatest));
  OT::RandomGenerator::SetSeed(1);
  return OT::SobolIndicesExperiment(OT::ComposedDistribution(inputs), count, false).generate();
}

/// Martinez's estimators of an input's indices, from those rows of A, B and the input's own part in
/// which there is a value. None if nothing varies there, or not with the input.
std::optional<std::pair<Estimate, Estimate>> indices(const std::vector<double>& values,
                                                     std::size_t count, std::size_t input) {
  OT::Sample parts[3] = {OT::Sample(0, 1), OT::Sample(0, 1), OT::Sample(0, 1)};
  bool matters = false;
  for (std::size_t n = 0; n < count; ++n) {
    const double row[3] = {values[n], values[count + n], values[(2 + input) * count + n]};
    if (std::isnan(row[0] + row[1] + row[2])) continue;
    for (std::size_t part = 0; part < 3; ++part) parts[part].add(OT::Point(1, row[part]));
    matters = matters || row[0] != row[2];
  }
  const auto varies = [](const OT::Sample& part) {  // by more than rounding
    const double least = part.getMin()[0], greatest = part.getMax()[0];
    return greatest - least > 1e-9 * std::max(std::abs(least), std::abs(greatest));
  };
  if (!matters || !std::ranges::all_of(parts, varies)) return std::nullopt;
  const OT::UnsignedInteger rows = parts[0].getSize();
  // The input counts twice: for a single one, OpenTURNS 1.20 leaves the intervals times the
  // variance.
  OT::Sample all(parts[0]);
  for (const std::size_t part : {1U, 2U, 2U}) all.add(parts[part]);
  OT::MartinezSensitivityAlgorithm algorithm(OT::Sample(4 * rows, 2), all, rows);
  algorithm.setUseAsymptoticDistribution(true);
  const OT::Interval first = algorithm.getFirstOrderIndicesInterval();
  const OT::Interval total = algorithm.getTotalOrderIndicesInterval();
  return std::pair{Estimate{algorithm.getFirstOrderIndices()[0], first.getLowerBound()[0],
                            first.getUpperBound()[0]},
                   Estimate{algorithm.getTotalOrderIndices()[0], total.getLowerBound()[0],
                            total.getUpperBound()[0]}};
}

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: FOLDER COUNT");
  const std::filesystem::path folder = arguments[0];
  const std::size_t count = std::stoul(arguments[1]);
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::string> readings;
  for (const Number& number : read_numbers(folder / "claims.csv"))
    for (const Reading& reading : number.readings)
      if (number.kind == Kind::simulated &&
          std::ranges::find(readings, reading.name) == readings.end())
        readings.push_back(reading.name);
  std::ranges::sort(readings);
  const auto ranges = read_input_ranges(folder / "printed-inputs.csv");

  const OT::Sample points = design(ranges, count);
  const auto at = [&](long n) {
    PaperInputs inputs;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      inputs.set(ranges[i].input, points(static_cast<std::size_t>(n), i));
    return inputs;
  };
  const Draws alone = one_at_a_time(readings, ranges, threads);
  const Draws draws = evaluate(readings, static_cast<long>(points.getSize()), at, threads,
                               [&, next = 0L](long done) mutable {
                                 if (done < next) return;
                                 fmt::print(stderr, "{} of {} draws\n", done, points.getSize());
                                 next = done + 1000;
                               });
  std::string csv = fmt::format(
      "# Which input decides each number of the text, over the box (c) of policy.md: from `make "
      "ranking`, not from the paper.\n"
      "# rotor " ROTOR_VERSION
      ", published equations, method event at tolerance 1e-8; OpenTURNS {}, "
      "a design of {} x {} draws, seed 1.\n"
      "# at_least, at_greatest: with this input at the ends of its range in printed-inputs.csv, "
      "all "
      "others as printed.\n"
      "# first, total: Sobol's indices by Martinez's estimators, with intervals of 95 % "
      "confidence; "
      "draws without a value are "
      "left out, and so are inputs whose total index is below 0.005.\n"
      "reading,input,at_least,at_greatest,first,first_low,first_high,total,total_low,total_high\n",
      OT::PlatformInfo::GetVersion(), count, ranges.size() + 2);
  for (const std::string& reading : readings)
    for (std::size_t i = 0; i < ranges.size(); ++i)
      if (const auto found = indices(draws.at(reading), count, i); found && is_told(found->second))
        csv += fmt::format("{},{},{},{},{},{}\n", reading, ranges[i].input,
                           cell(alone.at(reading)[2 * i]), cell(alone.at(reading)[2 * i + 1]),
                           cells(found->first), cells(found->second));
  FileTransaction files;
  files.write(folder / "ranking.csv", csv);
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("ranking", rotor::main, argc, argv); }
