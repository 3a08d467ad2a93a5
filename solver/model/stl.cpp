#include "solver/model/stl.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "solver/model/names.h"

namespace trajan {

namespace {

static_assert(std::endian::native == std::endian::little, "STL numbers are little-endian");

/// A header of 80 bytes, the number of triangles, and for each a normal, three corners and two bytes.
constexpr std::size_t header_size = 84, record_size = 50, corners_offset = 12;

std::uint32_t announced_triangles(std::string_view content) {
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + header_size - sizeof count, sizeof count);
  return count;
}

/// Binary files may begin with "solid" as well: their size tells.
bool is_binary(std::string_view content) {
  return content.size() >= header_size &&
         content.size() == header_size + record_size * std::size_t{announced_triangles(content)};
}

void require_finite(const Triangle& triangle, std::size_t number) {
  for (const Vector& v : triangle) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      throw StlError("triangle " + std::to_string(number) + " has a corner that is not finite");
  }
}

std::vector<Triangle> read_binary(std::string_view content) {
  std::vector<Triangle> triangles(announced_triangles(content));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    float numbers[9];
    std::memcpy(numbers, content.data() + header_size + i * record_size + corners_offset, sizeof numbers);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float* at = numbers + 3 * corner;
      triangles[i][corner] = {at[0], at[1], at[2]};
    }
    require_finite(triangles[i], i + 1);
  }
  return triangles;
}

/// Words of an ASCII file, one after the other.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// Empty at the end.
  std::string_view next() {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = std::min(rest_.find_first_not_of(blanks), rest_.size());
    rest_.remove_prefix(begin);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(word.size());
    return word;
  }
  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

 private:
  std::string_view rest_;
};

double read_number(std::string_view word, std::size_t triangle) {
  double value = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
    throw StlError(quoted(word) + " in triangle " + std::to_string(triangle) + " is not a number");
  }
  return value;
}

std::vector<Triangle> read_text(std::string_view content) {
  Words words(content);
  if (words.next() != "solid") throw StlError("the content is neither a binary nor an ASCII STL file");
  words.skip_line();
  std::vector<Triangle> triangles;
  std::size_t corners = 0;
  Triangle triangle;
  for (std::string_view word = words.next(); !word.empty() && word != "endsolid"; word = words.next()) {
    if (word == "facet") corners = 0;
    if (word != "vertex") continue;
    const std::size_t number = triangles.size() + 1;
    if (corners == 3) throw StlError("triangle " + std::to_string(number - 1) + " has more than three corners");
    Vector& corner = triangle[corners++];
    for (double* component : {&corner.x, &corner.y, &corner.z}) *component = read_number(words.next(), number);
    if (corners == 3) triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace

std::vector<Triangle> read_stl(std::string_view content) {
  std::vector<Triangle> triangles = is_binary(content) ? read_binary(content) : read_text(content);
  if (triangles.empty()) throw StlError("there is no triangle in it");
  return triangles;
}

}  // namespace trajan
