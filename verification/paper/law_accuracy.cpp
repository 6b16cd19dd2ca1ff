#include "verification/paper/law_accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rotor {
namespace {

/// Of the unbalance shares of each group; none for the last.
constexpr std::array share_limits = {"0", "0.03", "0.1", "0.3", ""};

/// A limit of friction, of which an empty field says that there is none.
double limit_in(const CsvRow& rotor, const char* column) {
  return rotor[column].empty() ? std::numeric_limits<double>::infinity()
                               : static_cast<double>(rotor.number(column));
}

}  // namespace

void LawAccuracy::add(const CsvRow& rotor) {
  if (!rotor["refusal"].empty()) return;
  const auto number = [&](const char* column) { return static_cast<double>(rotor.number(column)); };
  const auto note = [&](const char* quantity, bool holds) {
    ratios_[{rotor["equations_varied"], quantity, "", ""}].push_back(holds ? 1 : 0);
  };
  const bool touches = number("touch_downs_to_rolling") > 0, rolls = rotor["outcome"] == "rolling",
             is_to_touch = rotor["law_contact"] == "true",
             has_rolling = !rotor["law_rolling_speed_Hz"].empty();
  note("touches", touches == is_to_touch);
  if (is_to_touch) {
    const double friction = number("friction"), of_whirl = number("law_whirl_friction"),
                 of_rub = std::min(limit_in(rotor, "law_forward_friction"),
                                   limit_in(rotor, "law_stable_forward_friction"));
    if (has_rolling && friction > of_whirl && friction > of_rub)
      note("rolls_above_both_frictions", rolls);
    if (touches && friction < of_whirl) note("rolls_below_the_whirl_friction", rolls);
    if (touches && friction < of_whirl / 3)
      note("rolls_below_a_third_of_the_whirl_friction", rolls);
  }
  if (!rolls || !has_rolling) return;
  const double share = number("law_unbalance_share");
  std::size_t above = 0;
  while (above + 2 < share_limits.size() && share >= std::stod(share_limits[above + 1])) ++above;
  const auto compare = [&](const char* quantity, const char* run, const char* law) {
    ratios_[{rotor["equations_varied"], quantity, share_limits[above], share_limits[above + 1]}]
        .push_back(number(run) / number(law));
  };
  compare("rolling_speed", "rolling_onset_speed_Hz", "law_rolling_speed_Hz");
  compare("peak_force", "peak_force_to_rolling_N", "law_peak_force_N");
}

std::string LawAccuracy::csv() const {
  std::string text = "equations,quantity,share_from,share_to,runs,q05,q25,median,q75,q95,agree\n";
  for (const auto& [group, ratios] : ratios_) {
    std::vector<double> sorted = ratios;
    std::ranges::sort(sorted);
    const auto runs = static_cast<double>(sorted.size());
    text += fmt::format("{},{},{},{},{}", group.equations, group.quantity, group.share_from,
                        group.share_to, runs);
    for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95})
      text += group.share_from.empty()
                  ? ","
                  : fmt::format(",{:.3f}",
                                sorted[static_cast<std::size_t>(std::lround(share * (runs - 1)))]);
    const auto agree =
        std::ranges::count_if(sorted, [](double ratio) { return ratio >= 0.9 && ratio <= 1.1; });
    text += fmt::format(",{:.6f}\n", static_cast<double>(agree) / runs);
  }
  return text;
}

}  // namespace rotor
