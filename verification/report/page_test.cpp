/// The reviewer's page: its texts, verdicts, points and pictures.
#include "verification/report/page.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/report/document.hpp"
#include "verification/support/approved.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

const std::filesystem::path room = ROTOR_SOURCES "/verification/report";

Json texts() { return read_json(room / "texts.json"); }

TEST(ReportTexts, StateNoResultThemselves) {
  // A text may contain inputs of the scenarios, places in the paper, names and units; results need
  // placeholders such as {{reading.f_q1.f0}}.
  const std::string may_be_typed(
      "\\{\\{[^}]*\\}\\}|Eqs?\\. \\([0-9]+\\)|mu = 0\\.[0-9]+|(29\\.1|14\\.15|2\\.2|2|6) s\\b|"
      "(first|over) 5 ms|clearance (is|of) 3 mm|radius of 60 mm|mass of 5 kg|is 800 kN|1e-11|2 "
      "pi|\\^2|/2|[A-Za-z_]+[0-9]'?|[A-Za-z/]+\\.[A-Z]\\w+");
  const Json all = texts().flatten();
  for (const Json& text : all) {
    const std::string rest = replaced(text, may_be_typed, "");
    EXPECT_EQ(rest.find_first_of("0123456789"), std::string::npos) << text;
  }
}

TEST(Render, EscapesAndPrintsSymbols) {
  const auto rendered = [](const std::string& text) {
    return render("{{text}}", {}, {{"text", text}});
  };
  EXPECT_EQ(rendered("mu < 0.3 & F_n, Delta_vy, rho"),
            "\u03bc &lt; 0.3 &amp; F<sub>n</sub>, \u0394<sub>vy</sub>, \u03c1");
  EXPECT_EQ(rendered("2 pi x 0.5 +- 0.1 kg m^2, 7 % of 2 Hz"),
            "2 \u03c0 \u00d7 0.5 \u00b1 0.1 kg m\u00b2, 7\u00a0% of 2\u00a0Hz");
  EXPECT_EQ(rendered("(-7.8 %), 1.5e-06 to 2e-5"),
            "(\u22127.8\u00a0%), 1.5\u00a0\u00d7\u00a010<sup>\u22126</sup> to "
            "2\u00a0\u00d7\u00a010<sup>\u22125</sup>");
  EXPECT_EQ(rendered("I_C1, u_num_published, t_operating"),  // but no symbols of identifiers
            "I<sub>C1</sub>, u_num_published, t_operating");
  EXPECT_EQ(rendered("columns = [\n\"x_a_m\"]"), "columns = [\n&quot;x_a_m&quot;]");
  EXPECT_EQ(render("{{#x}}{{is}}{{/x}}{{^y}}no{{/y}}", {}, {{"x", {{{"is", -2.5}}}}, {"y", ""}}),
            "\u22122.5no");
}

// A number that the page can state from a run or as a reading is the same in both.
TEST(ReportValues, OfRunsAreTheReadingsOfTheSameQuantities) {
  const Json all = values_json(judged());
  struct Both {
    const char *reading, *run;
    double unit;
  };
  for (const auto& [set, readings] :
       {std::pair("published", "reading"), {"corrected", "reading_corrected"}})
    for (const auto& [reading, run, unit] : {Both{"peak_kN", "/mu_03/peak_normal_force_N", 1e3},
                                             {"peak_kN_100", "/t_19/peak_normal_force_N", 1e3},
                                             {"to_rolling", "/mu_03/to_rolling_s", 1},
                                             {"onset_Hz", "/mu_03/rolling_onset_speed_Hz", 1}}) {
      const Json& value = all[set][Json::json_pointer(run)];
      EXPECT_NEAR(all[readings].at(reading).get<double>() * unit / value.get<double>(), 1, 1e-9)
          << set << ' ' << reading;
    }
}

TEST(ApprovedAccident, IsThePictureInTheReadme) {
  expect_approved("figures/paper/preview/accident.svg",
                  render(content_of(room / "accident.mustache.svg"), {}, accident_json()));
}

}  // namespace
}  // namespace rotor
