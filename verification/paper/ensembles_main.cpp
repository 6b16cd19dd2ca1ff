/// Recomputes reference-data/ensembles.csv, every reading over the populations of policy.md:
/// `ensembles FOLDER COUNT`; or only the rows of one claim: `ensembles FOLDER COUNT CLAIM`. With
/// `ensembles FOLDER COUNT seed SEED TABLE` it writes another table, and prints the claims whose
/// verdict no other rule turns, and it does.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "figures/input/words.hpp"
#include "verification/paper/tally.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

/// Rows by what identifies them: all up to the column `draws`.
using Rows = std::map<std::string, std::string>;

void add(Rows& rows, std::istream& lines) {
  for (std::string line; std::getline(lines, line);) {
    std::size_t comma = 0;
    for (int n = 0; n < 4; ++n) comma = line.find(',', comma + (n > 0));
    if (comma != std::string::npos) rows[line.substr(0, comma)] = line;
  }
}

/// How many claims that no other rule turns have another verdict with these ensembles, or are
/// then turned by a rule.
int print_turned(const std::filesystem::path& folder, const std::filesystem::path& ensembles) {
  const auto stored = judged_numbers(folder), anew = judged_numbers(folder, ensembles);
  int unturned = 0, turned = 0;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto now = judged_claims(anew, set);
    for (const JudgedClaim& claim : judged_claims(stored, set)) {
      if (!claim.turned_by.empty()) continue;
      ++unturned;
      const auto& [id, verdict, turned_by] =
          *std::ranges::find(now, claim.claim, &JudgedClaim::claim);
      if (verdict == claim.verdict && turned_by.empty()) continue;
      ++turned;
      fmt::print("{}, {}: {}; {} with the other seed{}\n", id, sets_in_words[set].words,
                 words_of(claim.verdict), words_of(verdict),
                 turned_by.empty() ? "" : ", and turned by another rule");
    }
  }
  fmt::print("{} of {} verdicts that no other rule turns are turned\n", turned, unturned);
  return turned;
}

int main(const Arguments& arguments) {
  const bool has_seed = arguments.size() == 5 && arguments[2] == "seed";
  if (arguments.size() != 2 && arguments.size() != 3 && !has_seed)
    throw std::runtime_error("needs: FOLDER COUNT [CLAIM], or FOLDER COUNT seed SEED TABLE");
  const std::filesystem::path folder = arguments[0],
                              table = has_seed ? std::filesystem::path(arguments[4])
                                               : folder / "ensembles.csv";
  const long count = std::stol(arguments[1]);
  const auto seed = static_cast<unsigned>(has_seed ? std::stoul(arguments[3]) : 1);
  const auto all = read_numbers(folder / "claims.csv");
  std::vector<Number> numbers = all;
  Rows rows;
  if (arguments.size() == 3) {
    numbers = of_claim(all, arguments[2]);
    std::ifstream file(table);
    add(rows, file);
  }
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  constexpr std::array populations = {std::pair("a", Population::a), std::pair("b", Population::b)};
  for (const auto& [name, population] : populations) {
    const PopulationDraws draws(population, folder, count, seed);
    for (const Set& set : sets) {
      const auto at = [&](long n) { return draws(n, set.equations); };
      const auto report = [&, name = name, next = 0L](long done) mutable {
        if (done < next) return;
        fmt::print(stderr, "({}), {} equations: {} of {} draws\n", name, set.name, done, count);
        next = done + std::max(1L, count / 10);
      };
      std::istringstream lines(
          ensembles_rows(numbers, set.name, name,
                         evaluate(readings_to_draw(numbers), count, at, threads, report)));
      add(rows, lines);
    }
  }
  std::string csv =
      "# Each reading over the populations of policy.md, from `make ensembles`; not from "
      "the paper.\n"
      "# rotor " ROTOR_VERSION ", method event at tolerance 1e-8; seed " +
      std::to_string(seed) +
      ": (a) of Sobol's sequence, (b) independent draws.\n"
      "# valued: share of the draws with a value; median, p5, p95: of those; holds: share of the "
      "draws in which the claim holds.\n"
      "equations,population,number,reading,draws,valued,median,p5,p95,holds\n";
  for (const auto& [name, population] : populations)
    for (const Set& set : sets)
      for (const Number& number : all)
        for (const Reading& reading : number.readings)
          if (const auto row =
                  rows.find(fmt::format("{},{},{},{}", set.name, name, number.id, reading.name));
              row != rows.end())
            csv += row->second + '\n';
  write_file(table, csv);
  return has_seed && print_turned(folder, table) > 0 ? 1 : 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("ensembles", rotor::main, argc, argv); }
