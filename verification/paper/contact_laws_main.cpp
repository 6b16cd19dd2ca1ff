/// Recomputes reference-data/contact-laws.csv: `contact-laws FOLDER DRAWS`.
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "verification/paper/contact_laws.hpp"
#include "verification/paper/ensembles.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

/// One ring and one friction: as printed, and in the draws of population (b) against the linear
/// ring of the same draw.
struct Row {
  std::string key;  ///< the first columns
  std::string printed;
  std::vector<double> same_outcome, force_ratio, time_ratio, more_touch_downs;
};

double time_to_rolling(const Summary& s) {
  return s.rolling_onset_s && s.first_contact_s ? *s.rolling_onset_s - *s.first_contact_s
                                                : std::nan("");
}

std::string cell(double value, const char* form = "{:.5g}") {
  return std::isnan(value) ? "" : fmt::format(fmt::runtime(form), value);
}

/// What the runs of one set of inputs add to each row, in the order of the rows; those at the
/// inputs as printed make them.
void add_to(std::vector<Row>& rows, PaperRuns& runs, const char* set, bool printed) {
  static std::mutex adding;
  std::size_t n = 0;
  for (const double mu :
       {runs.inputs().mu_high, runs.inputs().mu_intermediate, runs.inputs().mu_low}) {
    const Summary linear = runs.with(mu, {}).summary();
    const auto add = [&](const char* same, double exponent,
                         const std::optional<std::map<std::string, double>>& numbers) {
      if (printed) rows.emplace_back();
      Row& row = rows[n++];
      if (!numbers) return;
      const PaperRun& run = runs.with(mu, *numbers);
      const Summary& s = run.summary();
      const double force = s.peak_normal_force_N.value_or(0);
      if (printed) {
        const Parameters& p = run.scenario().parameters;
        row.key = fmt::format("{},{},{},{}", set, mu, same, exponent);
        row.printed = fmt::format("{},{},{},{},{},{}", cell(p.contact_stiffness),
                                  exponent == 1 ? "" : cell(1e6 * p.reference_indentation),
                                  name_of(s.outcome), s.touch_downs, cell(1e3 * time_to_rolling(s)),
                                  cell(1e-3 * force));
        return;
      }
      const std::scoped_lock lock(adding);
      const bool as_before = s.outcome == linear.outcome;
      row.same_outcome.push_back(as_before ? 1 : 0);
      row.force_ratio.push_back(force / linear.peak_normal_force_N.value_or(0));
      row.time_ratio.push_back(time_to_rolling(s) / time_to_rolling(linear));
      row.more_touch_downs.push_back(static_cast<double>(s.touch_downs - linear.touch_downs));
    };
    add("", 1, std::map<std::string, double>());
    for (const auto& [same, name] : {std::pair(SameIndentation::impact, "impact"),
                                     std::pair(SameIndentation::rolling, "rolling")})
      for (const double exponent : other_exponents)
        add(name, exponent, numbers_of(exponent, same, runs));
  }
}

constexpr const char* head =
    R"(# The accident in rings of other laws, from `make contact-laws`; not from the paper. same_indentation: where the ring is indented
# as far as the linear one, in the first impact or in rolling. k_t to peak_kN: at the inputs as printed, Delta_0 in um. Then {0} draws of
# population (b) of policy.md, each against the linear ring: share with its outcome and standard error of the share; force, time to
# rolling relative to it (5, 50 and 95 % quantiles; of all draws, and of those in which both roll); median of additional touch-downs.
equations,mu,same_indentation,exponent,k_t,Delta_0_um,outcome,touch_downs,to_rolling_ms,peak_kN,same_outcome,error,force_p5,force,force_p95,time_p5,time,time_p95,more_touch_downs
)";

std::string to_csv(const Row& row) {
  const auto range = [](const std::vector<double>& values) {
    const Spread s = spread(values);
    return fmt::format("{},{},{}", cell(s.low, "{:.3f}"), cell(s.median, "{:.3f}"),
                       cell(s.high, "{:.3f}"));
  };
  const auto draws = static_cast<double>(row.same_outcome.size());
  const double share =
      static_cast<double>(std::ranges::count(row.same_outcome, 1.)) / std::max(1., draws);
  return fmt::format("{},{},{:.3f},{:.3f},{},{},{}\n", row.key, row.printed, share,
                     std::sqrt(share * (1 - share) / std::max(1., draws)), range(row.force_ratio),
                     range(row.time_ratio), cell(spread(row.more_touch_downs).median));
}

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: FOLDER DRAWS");
  const std::filesystem::path folder = arguments[0];
  const long count = std::stol(arguments[1]);
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const PopulationDraws draws(Population::b, folder, count);
  std::string csv = fmt::format(fmt::runtime(head), count);
  for (const Set& set : sets) {
    PaperInputs inputs;
    inputs.spec.equations = set.equations;
    PaperRuns runs(inputs);
    std::vector<Row> rows;
    add_to(rows, runs, set.name, true);
    in_parallel(count, threads, [&](long n) {
      PaperInputs drawn = draws(n, set.equations);
      drawn.spec.numbers["tolerance"] = 1e-8;  // as in ensembles.csv
      PaperRuns runs_of_draw(drawn);
      add_to(rows, runs_of_draw, set.name, false);
    });
    for (const Row& row : rows) csv += to_csv(row);
  }
  write_file(folder / "contact-laws.csv", csv);
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("contact-laws", rotor::main, argc, argv);
}
