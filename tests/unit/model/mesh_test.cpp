#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "solver/model/triangle_mesh.h"

namespace trajan::mesh_test {
namespace {

using testing::HasSubstr;

/// A box in triangles that are counter-clockwise seen from outside.
std::vector<Triangle> box(Vector lower, Vector upper) {
  const auto corner = [&](int i) {
    return Vector{i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
  };
  const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  std::vector<Triangle> triangles;
  for (const auto& f : faces) {
    triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
    triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
  }
  return triangles;
}

/// A sphere of radius 1 from an octahedron whose faces are cut in four, several times.
std::vector<Triangle> sphere(int cuts) {
  std::vector<Triangle> triangles;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const Triangle face = {Vector{x, 0, 0}, Vector{0, y, 0}, Vector{0, 0, z}};
        triangles.push_back(x * y * z > 0 ? face : Triangle{face[0], face[2], face[1]});
      }
  const auto middle = [](Vector a, Vector b) {
    const Vector m = {a.x + b.x, a.y + b.y, a.z + b.z};
    const double l = std::hypot(m.x, m.y, m.z);
    return Vector{m.x / l, m.y / l, m.z / l};
  };
  for (int i = 0; i < cuts; ++i) {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const Vector ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = finer;
  }
  return triangles;
}

std::string text_of(const std::vector<Triangle>& triangles) {
  std::ostringstream out;
  out << "solid part of something\n";
  for (const Triangle& t : triangles) {
    out << " facet normal 0 0 0\n  outer loop\n";
    for (const Vector& v : t) out << "   vertex " << v.x << " " << v.y << " " << v.z << "\n";
    out << "  endloop\n endfacet\n";
  }
  out << "endsolid part of something\n";
  return out.str();
}

std::string bytes_of(const std::vector<Triangle>& triangles) {
  std::string bytes("solid, although it is binary");
  bytes.resize(84 + 50 * triangles.size());
  const auto count = static_cast<std::uint32_t>(triangles.size());
  std::memcpy(bytes.data() + 80, &count, 4);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector& v = triangles[i][c];
      const float numbers[] = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
      std::memcpy(bytes.data() + 84 + 50 * i + 12 + 12 * c, numbers, 12);
    }
  return bytes;
}

std::string complaint(const std::string& content) {
  try {
    TriangleMesh mesh(read_stl(content));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Stl, TextAndBytesSayTheSame) {
  // Numbers that single precision and six digits hold exactly.
  const std::vector<Triangle> triangles = box({0, -0.5, 0.25}, {1, 2, 3});
  for (const std::string& content : {text_of(triangles), bytes_of(triangles)}) {
    const std::vector<Triangle> read = read_stl(content);
    ASSERT_EQ(read.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(read[i][c].x, triangles[i][c].x);
        EXPECT_EQ(read[i][c].y, triangles[i][c].y);
        EXPECT_EQ(read[i][c].z, triangles[i][c].z);
      }
  }
}

TEST(Stl, SaysWhatIsWrong) {
  EXPECT_THAT(complaint("not STL"), HasSubstr("neither"));
  EXPECT_THAT(complaint("solid nothing\nendsolid"), HasSubstr("no triangle"));
  EXPECT_THAT(complaint("solid\nfacet vertex 0 0 0 vertex 1 0 x"), HasSubstr("\"x\" in triangle 1"));
  EXPECT_THAT(complaint("solid\nfacet vertex 0 0 0 vertex 1 0 1e999"), HasSubstr("is not a number"));
  EXPECT_THAT(complaint("solid\nfacet vertex 0 0"), HasSubstr("is not a number"));
  std::string cut = bytes_of(box({0, 0, 0}, {1, 1, 1}));
  cut.pop_back();
  EXPECT_NE(complaint(cut), "");
  std::vector<Triangle> open = box({0, 0, 0}, {1, 1, 1});
  open.pop_back();
  EXPECT_THAT(complaint(text_of(open)), HasSubstr("not closed: along 3 edges"));
  std::vector<Triangle> turned = box({0, 0, 0}, {1, 1, 1});
  std::swap(turned[5][0], turned[5][1]);
  EXPECT_THAT(complaint(text_of(turned)), HasSubstr("not closed"));
  EXPECT_THAT(complaint(text_of(box({0, 0, 0}, {1, 1, 0}))), HasSubstr("no volume"));
}

TEST(TriangleMesh, OfABoxIsTheBox) {
  const Box inner = {{0, -0.5, 0.25}, {1, 2, 3}};
  const TriangleMesh mesh(box(inner.lower, inner.upper));
  EXPECT_DOUBLE_EQ(mesh.volume(), 1 * 2.5 * 2.75);
  for (int i = 0; i < 1000; ++i) {
    const Vector place = {2 * std::sin(i), 3 * std::sin(3.7 * i), 2 + 2 * std::sin(5.3 * i)};
    EXPECT_NEAR(mesh.signed_distance(place), signed_distance(inner, place), 1e-14) << i;
  }
}

TEST(TriangleMesh, LinesThroughEdgesAndCornersMeetItOnce) {
  // Lines along x through the diagonals and corners of all faces of a sphere that is symmetric to the axes.
  const TriangleMesh mesh(sphere(3));
  for (const double y : {-0.5, 0.0, 0.5})
    for (const double z : {-0.5, 0.0, 0.5}) {
      const Spans parts = mesh.spans(y, z, 0);
      ASSERT_EQ(parts.size(), 1u) << y << " " << z;
      const double half = std::sqrt(1 - y * y - z * z);
      // A triangle of edge length 0.35 lies at most 0.35^2 / 6 below the sphere, and along a line that meets
      // the sphere at 45 degrees that is 0.03.
      EXPECT_NEAR(parts[0].from, -half, 0.03);
      EXPECT_NEAR(parts[0].to, half, 0.03);
    }
  EXPECT_TRUE(mesh.spans(2, 0, 0).empty());
}

TEST(TriangleMesh, TurnedInsideOutIsTheSameBody) {
  std::vector<Triangle> triangles = sphere(2);
  for (Triangle& t : triangles) std::swap(t[0], t[1]);
  EXPECT_LT(TriangleMesh(triangles).signed_distance({0, 0, 0}), -0.9);
  EXPECT_EQ(TriangleMesh(triangles).spans(0.1, 0.2, 0).size(), 1u);
}

TEST(TriangleMesh, LinesMeetItWhereItsPointsAre) {
  std::vector<Triangle> triangles = sphere(2);
  for (const Triangle& t : box({0.5, 0.5, -2}, {2, 2, 2})) triangles.push_back(t);  // overlaps the sphere
  const TriangleMesh mesh(triangles);
  for (int i = 0; i < 2000; ++i) {
    const Vector place = {2 * std::sin(i), 2 * std::sin(3.7 * i), 2 * std::sin(5.3 * i)};
    bool inside = false;
    for (const Span& span : mesh.spans(place.y, place.z, 0))
      inside = inside || (place.x >= span.from && place.x <= span.to);
    EXPECT_EQ(inside, mesh.signed_distance(place) < 0) << i;
  }
}

TEST(TriangleMesh, LooksAtFewTrianglesPerLine) {
  const TriangleMesh mesh(sphere(5));
  EXPECT_LT(mesh.work_of_a_line(), 8192 / 20.0);
}

}  // namespace
}  // namespace trajan::mesh_test
