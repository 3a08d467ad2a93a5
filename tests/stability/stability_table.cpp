// Tries scenes at the extremes and prints, as a Markdown table, what must hold of each, what was found and the
// verdict.
//   stability_table [--whole] [CASE…]      --whole: also what takes minutes
//   stability_table --random NUMBER        tries so many random scenes instead (tests/stability/luck.h)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "tests/stability/extremes.h"
#include "tests/stability/luck.h"

namespace trajan::stability {
namespace {

int print(const Case& kind, Size size) {
  int wrong = 0;
  for (const Extreme& extreme : kind.extremes(size)) {
    const Row row = judge(extreme);
    wrong += row.verdict == Verdict::wrong;
    std::printf("| %s | %s | %s | %.3g | ", std::string(kind.name).c_str(), extreme.name.c_str(),
                extreme.claim.c_str(), extreme.bound);
    if (row.figure) std::printf("%.3g", *row.figure);
    std::printf(" | %s%s%s |\n", std::string(name(row.verdict)).c_str(), row.diagnosis.empty() ? "" : ": ",
                row.diagnosis.c_str());
    std::fflush(stdout);
  }
  return wrong;
}

}  // namespace
}  // namespace trajan::stability

int main(int argc, char** argv) {
  using namespace trajan::stability;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 2 && words[0] == "--random") return !try_luck(std::atoi(words[1].c_str()));
  const bool whole = std::ranges::count(words, "--whole") > 0;
  const bool all = words.size() == static_cast<std::size_t>(whole);
  int wrong = 0;
  try {
    std::puts("| case | extreme | what must hold | at most | found | verdict |\n|---|---|---|--:|--:|---|");
    for (const Case& kind : cases())
      if (all || std::ranges::count(words, kind.name) > 0) wrong += print(kind, whole ? Size::whole : Size::quick);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stability_table: %s\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "%d wrong\n", wrong);
  return wrong > 0;
}
