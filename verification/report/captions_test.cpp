/// The page's captions use numbers of their own figures.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "verification/paper/claims.hpp"
#include "verification/report/page.hpp"

namespace rotor {
namespace {

TEST(Captions, AskForTheSharesOfTheirFigures) {
  std::map<std::string, std::string> figures;
  for (const Number& number : judged()) figures[number.id] = ' ' + number.figures + ' ';
  const Json texts = Json::parse(content_of(ROTOR_SOURCES "/verification/report/texts.json"));
  const std::regex share("holds_in_percent\\.\\w+\\.(\\w+)\\.");
  int asked = 0;
  for (const auto& [figure, words] : texts.at("captions").items()) {
    const auto caption = words.get<std::string>();
    for (std::sregex_iterator found(caption.begin(), caption.end(), share), none; found != none;
         ++found) {
      ++asked;
      EXPECT_NE(figures.at((*found)[1]).find(' ' + figure + ' '), std::string::npos) << caption;
    }
  }
  EXPECT_GT(asked, 2);
}

}  // namespace
}  // namespace rotor
