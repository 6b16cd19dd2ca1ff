/// The page's captions ask for what belongs to their figures.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "verification/paper/judged.hpp"
#include "verification/report/page.hpp"
#include "verification/support/figure_list.hpp"

namespace rotor {
namespace {

// Shares are those of claims about the figure, and of the loss that its runs have.
TEST(Captions, AskForTheSharesOfTheirFigures) {
  std::map<std::string, std::string> figures;
  for (const Number& number : judged()) figures[number.id] = ' ' + number.figures + ' ';
  const Json texts = Json::parse(content_of(ROTOR_SOURCES "/verification/report/texts.json"));
  const std::regex share("holds_in_percent\\.(\\w+)|accidents\\.\\w+\\.at_([0-9]+_[0-9]+)");
  int asked = 0;
  for (const Figure& figure : paper_figures()) {
    const std::string name = std::to_string(figure.number);
    const std::string caption = texts.at("captions").at(name).get<std::string>();
    for (std::sregex_iterator found(caption.begin(), caption.end(), share), none; found != none;
         ++found) {
      ++asked;
      const std::string claim = (*found)[1], loss = (*found)[2];
      if (!claim.empty()) {
        EXPECT_NE(figures.at(claim).find(' ' + name + ' '), std::string::npos) << caption;
      } else {
        const double loss_s = std::stod(std::regex_replace(loss, std::regex("_"), "."));
        EXPECT_EQ(figure.runs.front().second.parameters.separation_time, loss_s) << caption;
      }
    }
  }
  EXPECT_GT(asked, 2);
}

}  // namespace
}  // namespace rotor
