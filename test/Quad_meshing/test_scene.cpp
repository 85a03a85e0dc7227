// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Scenes, and the files that show them: pages, pictures, VTK. What stands in them is what the scene says, and what
// cannot be shown is refused. OBJ files with groups, and fields in the format .rosy.

#include <CGAL/Quad_meshing/IO/internal/Png_encoder.h>
#include <CGAL/Quad_meshing/IO/read_polygon_soup.h>
#include <CGAL/Quad_meshing/IO/rosy_field.h>
#include <CGAL/Quad_meshing/IO/scene_layers.h>
#include <CGAL/Quad_meshing/IO/write_grouped_obj.h>
#include <CGAL/Quad_meshing/IO/write_html_page.h>
#include <CGAL/Quad_meshing/IO/write_png_picture.h>
#include <CGAL/Quad_meshing/IO/write_vtk.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>

#include "structure_meshes.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace pt = boost::property_tree;

typedef QM::Scene_writing_status Status;

// The bytes of a text in base 64 (RFC 4648), letter by letter.
std::vector<unsigned char> decoded(const std::string& text)
{
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for(char c : text)
  {
    if(c == '=')
      break;
    const std::size_t value = letters.find(c);
    assert(value != std::string::npos);
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    number_of_bits += 6;
    if(number_of_bits >= 8)
    {
      number_of_bits -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> number_of_bits & 0xFF));
    }
  }
  assert(text.size() % 4 == 0);
  return bytes;
}

template <typename T>
std::vector<T> array_in(const pt::ptree& tree, const std::string& key)
{
  const std::vector<unsigned char> bytes = decoded(tree.get<std::string>(key));
  assert(bytes.size() % sizeof(T) == 0);
  std::vector<T> values(bytes.size() / sizeof(T));
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    std::uint32_t bits = 0;
    for(int k = 3; k >= 0; --k)
      bits = bits << 8 | bytes[4 * i + static_cast<std::size_t>(k)];
    std::memcpy(&values[i], &bits, sizeof(T));
  }
  return values;
}

std::string page_of(const QM::Scene& scene)
{
  std::ostringstream os;
  const QM::Scene_writing_result result = QM::write_html_page(os, scene);
  assert(result.is_valid() && result.status == Status::WRITTEN);
  return os.str();
}

pt::ptree scene_in(const std::string& page)
{
  const std::string begin = "<script type=\"application/json\" id=\"scene\">", end = "</script>";
  const std::size_t first = page.find(begin) + begin.size();
  std::istringstream is(page.substr(first, page.find(end, first) - first));
  pt::ptree tree;
  pt::read_json(is, tree);
  return tree;
}

QM::Scene small_scene()
{
  QM::Scene scene;
  scene.title = "a </script> & \"b\"";
  QM::Scene_layer layer;
  layer.name = "two faces";
  // far from the origin, where single precision knows steps of 0.06 only
  for(double x : { 0., 1., 2. })
    for(double y : { 0., 0.25 })
      layer.add_point({ { 1e6 + x, -2e6 + y, 5 } });
  layer.add_element(std::vector<int>{ 0, 2, 3, 1 });
  layer.add_element(std::vector<int>{ 2, 4, 5 });
  layer.grid = { { { 1000000001.5, -7.25 } },
                 { { 1000000002.5, -7.25 } },
                 { { 1000000002.5, -6.25 } },
                 { { 1000000001.5, -6.25 } },
                 { { 0, 0 } },
                 { { 0.5, 0 } },
                 { { 0.5, 0.5 } } };
  QM::Scene_numbers numbers;
  numbers.name = "height";
  numbers.values = { 0.5, std::numeric_limits<double>::infinity() };
  layer.numbers.push_back(numbers);
  layer.colored_by = 0;
  scene.layers.push_back(layer);
  return scene;
}

void test_contents()
{
  if(!QM::has_html_viewer())
    return;
  const QM::Scene scene = small_scene();
  const std::string page = page_of(scene);
  assert(page.find("a </script>") == std::string::npos);
  const pt::ptree tree = scene_in(page);
  assert(tree.get<std::string>("title") == scene.title);
  const pt::ptree& layer = tree.get_child("layers").front().second;
  assert(layer.get<std::string>("kind") == "faces" && layer.get<int>("colored_by") == 0);

  std::array<double, 3> center;
  int k = 0;
  for(const auto& c : tree.get_child("center"))
    center[k++] = c.second.get_value<double>();
  const double radius = tree.get<double>("radius");
  const std::vector<float> points = array_in<float>(layer, "points");
  assert(points.size() == 18);
  for(std::size_t i = 0; i < 6; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      assert(std::abs(center[j] + radius * points[3 * i + j] - scene.layers[0].points[i][j]) < 1e-6);
  assert((array_in<std::uint32_t>(layer, "corners") == std::vector<std::uint32_t>{ 0, 2, 3, 1, 2, 4, 5 }));
  assert((array_in<std::uint32_t>(layer, "first") == std::vector<std::uint32_t>{ 0, 4, 7 }));
  const std::vector<float> values = array_in<float>(layer.get_child("numbers").front().second, "values");
  assert(values.size() == 2 && values[0] == 0.5f && std::isinf(values[1]));

  // the places in the cells, and which cells of a chessboard they are, stay as they were
  const std::vector<float> grid = array_in<float>(layer, "grid");
  assert(grid.size() == 14);
  for(std::size_t i = 0; i < grid.size(); ++i)
  {
    const double shift = scene.layers[0].grid[i / 2][i % 2] - double(grid[i]);
    assert(std::fmod(shift, 2.) == 0 && std::abs(grid[i]) < 4);
  }
}

void test_refusals()
{
  const auto refused = [](const QM::Scene& scene, const std::string& word)
  {
    std::ostringstream os;
    const QM::Scene_writing_result result = QM::write_html_page(os, scene);
    return result.status == Status::INVALID_SCENE && !result.is_valid() && os.str().empty() &&
           result.message.find("two faces") != std::string::npos && result.message.find(word) != std::string::npos;
  };
  QM::Scene scene = small_scene();
  scene.layers[0].corners[3] = 6;
  assert(refused(scene, "point"));
  scene = small_scene();
  scene.layers[0].kind = QM::Scene_layer_kind::FACES;
  scene.layers[0].first_corner = { 0, 5, 7 };
  assert(refused(scene, "element 1"));
  scene = small_scene();
  scene.layers[0].first_corner.back() = 6;
  assert(refused(scene, "first corners"));
  scene = small_scene();
  scene.layers[0].numbers[0].values.pop_back();
  assert(refused(scene, "height"));
  scene = small_scene();
  scene.layers[0].colored_by = 1;
  assert(refused(scene, "color"));
  scene = small_scene();
  scene.layers[0].grid.pop_back();
  assert(refused(scene, "grid"));

  std::ostringstream os;
  os.setstate(std::ios::badbit);
  const Status status = QM::write_html_page(os, small_scene()).status;
  assert(status == (QM::has_html_viewer() ? Status::WRITING_FAILED : Status::NO_VIEWER));
  for(Status s : { Status::WRITTEN, Status::NO_VIEWER, Status::INVALID_SCENE, Status::WRITING_FAILED })
    assert(*QM::status_name(s) != '\0');
}

// An empty scene, and one with a single point, have a size too.
void test_small_scenes()
{
  if(!QM::has_html_viewer())
    return;
  QM::Scene scene;
  assert(scene_in(page_of(scene)).get<double>("radius") > 0);
  QM::Scene_layer layer;
  layer.kind = QM::Scene_layer_kind::POINTS;
  layer.add_element(std::vector<std::size_t>{ layer.add_point({ { 3, 4, 5 } }) });
  scene.layers.push_back(layer);
  assert(scene_in(page_of(scene)).get<double>("radius") > 0);
}

// A torus with too many triangles is shown with fewer, and stays a torus; a smaller one is shown as it is.
void test_display()
{
  QM::Scene scene;
  const test_meshes::Mesh large = test_meshes::make_mesh(test_meshes::torus(300, 200)),
                          small = test_meshes::make_mesh(test_meshes::torus(20, 10));
  const QM::Scene_layer shown = QM::make_display_layer(large, "large", "", scene);
  assert(large.number_of_faces() == 120000 && scene.remarks.size() == 1);
  assert(shown.size() <= QM::most_triangles_of_page && shown.size() > QM::most_triangles_of_page * 99 / 100);
  assert(shown.points.size() * 2 == shown.size()); // Euler number 0 of a closed triangle mesh
  for(const std::array<double, 3>& p : shown.points)
    assert(std::abs(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4) < 0.01);
  assert(QM::make_display_layer(small, "small", "", scene).size() == small.number_of_faces() &&
         scene.remarks.size() == 1);
}

// The numbers of the layers of a quad mesh are those of its structure.
void test_quad_layers()
{
  const structure_meshes::Mesh qm = structure_meshes::make_mesh(structure_meshes::cube(4));
  QM::Scene scene;
  QM::add_quad_mesh_layers(scene, qm);
  assert(scene.layers.size() == 3 && scene.histograms.size() == 3);
  const QM::Scene_layer &quads = scene.layers[0], &irregular = scene.layers[1], &separatrices = scene.layers[2];
  assert(quads.size() == 96 && irregular.size() == 8 && separatrices.size() == 48);
  for(double x : quads.numbers[0].values)
    assert(std::abs(x - 1) < 1e-12);
  for(double x : quads.numbers[1].values)
    assert(std::abs(x) < 1e-9);
  // six patches of sixteen quads
  std::vector<int> of_patch(6, 0);
  for(double x : quads.numbers[5].values)
    ++of_patch[static_cast<std::size_t>(x)];
  assert(of_patch == std::vector<int>(6, 16));
  const std::vector<double>& indices = irregular.numbers[0].values;
  assert(std::accumulate(indices.begin(), indices.end(), 0.) == 4 * 2);
  for(const QM::Scene_histogram& h : scene.histograms)
  {
    const std::size_t sum = std::accumulate(h.counts.begin(), h.counts.end(), std::size_t(0));
    assert(sum == 96 || sum == 4 * 96 || sum == 2 * 96);
  }
}

// The layers of a run are those of its stages.
void test_quadrangulation_layers()
{
  const test_meshes::Mesh tm = test_meshes::make_mesh(test_meshes::cube(3));
  QM::Quadrangulation q(tm, tm.points());
  q.options.target_number_of_quads = 150;
  assert(q.run().is_valid());
  QM::Scene scene;
  QM::add_quadrangulation_layers(scene, tm, q);
  const auto layer = [&](const std::string& name) -> const QM::Scene_layer&
  {
    for(const QM::Scene_layer& l : scene.layers)
      if(l.name == name)
        return l;
    assert(false);
    return scene.layers.front();
  };
  assert(layer("triangles").size() == tm.number_of_faces());
  assert(layer("sharp edges, kept").size() == 36);
  assert(layer("quads").size() == q.quads().mesh.number_of_faces());
  const std::vector<double>& indices = layer("singularities").numbers[0].values;
  assert(std::accumulate(indices.begin(), indices.end(), 0.) == 4 * 2);
  const QM::Scene_layer& map = layer("integer grid");
  assert(map.grid.size() == 3 * q.surface().mesh.number_of_faces());
  // The grid lies on the corners that it belongs to: its cells have the size of the quads.
  double area = 0;
  for(std::size_t i = 0; i < map.size(); ++i)
  {
    const std::array<double, 2>* g = &map.grid[3 * i];
    area += std::abs((g[1][0] - g[0][0]) * (g[2][1] - g[0][1]) - (g[1][1] - g[0][1]) * (g[2][0] - g[0][0])) / 2;
  }
  assert(std::abs(area - double(layer("quads").size())) < 1e-9 * area);
  for(const QM::Scene_layer& l : scene.layers)
    assert(l.colored_by < static_cast<int>(l.numbers.size()));
  if(QM::has_html_viewer())
    page_of(scene);
}

// A byte of a PNG file, and the numbers in it, higher bytes first.
std::uint32_t number_at(const std::string& bytes, std::size_t i)
{
  std::uint32_t n = 0;
  for(std::size_t k = 0; k < 4; ++k)
    n = n << 8 | static_cast<unsigned char>(bytes[i + k]);
  return n;
}

// The bits of a deflated block, lower ones first.
class Bits
{
  const std::string& m_bytes;
  std::size_t m_place;

public:
  Bits(const std::string& bytes, std::size_t first_byte) : m_bytes(bytes), m_place(8 * first_byte) {}

  unsigned get(int number)
  {
    unsigned value = 0;
    for(int k = 0; k < number; ++k, ++m_place)
      value |= (static_cast<unsigned char>(m_bytes[m_place / 8]) >> (m_place % 8) & 1u) << k;
    return value;
  }

  // A symbol of the fixed codes, by their ranges (RFC 1951, 3.2.6).
  unsigned symbol()
  {
    unsigned code = 0;
    for(int length = 1; length <= 9; ++length)
    {
      code = code << 1 | get(1);
      if(length == 7 && code <= 0x17)
        return 256 + code;
      if(length == 8 && code >= 0x30 && code <= 0xBF)
        return code - 0x30;
      if(length == 8 && code >= 0xC0 && code <= 0xC7)
        return 280 + code - 0xC0;
      if(length == 9 && code >= 0x190)
        return 144 + code - 0x190;
    }
    assert(false);
    return 0;
  }
};

// The rows of a picture with their filters, of a file with one block of fixed codes.
std::string inflated(const std::string& data)
{
  static const unsigned lengths[] = { 3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                      31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258 };
  static const int extra_bits[] = { 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                    2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0 };
  assert((static_cast<unsigned char>(data[0]) * 256u + static_cast<unsigned char>(data[1])) % 31 == 0);
  Bits bits(data, 2);
  assert(bits.get(1) == 1 && bits.get(2) == 1);
  std::string out;
  for(unsigned s = bits.symbol(); s != 256; s = bits.symbol())
  {
    if(s < 256)
    {
      out += static_cast<char>(s);
      continue;
    }
    const unsigned length = lengths[s - 257] + bits.get(extra_bits[s - 257]);
    assert(bits.get(5) == 0); // the distance is one byte
    out.append(length, out.back());
  }
  return out;
}

// The red, green and blue of the pixels of a picture.
std::vector<unsigned char> pixels_in(const std::string& png, std::size_t width, std::size_t height)
{
  assert(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  std::string data;
  std::size_t chunks = 0;
  for(std::size_t i = 8; i < png.size(); ++chunks)
  {
    const std::size_t length = number_at(png, i);
    const std::string type = png.substr(i + 4, 4), body = png.substr(i + 8, length);
    if(type == "IHDR")
      assert(number_at(body, 0) == width && number_at(body, 4) == height && body[8] == 8 && body[9] == 2);
    if(type == "IDAT")
      data += body;
    i += 12 + length;
  }
  assert(chunks == 3);
  const std::string rows = inflated(data);
  assert(rows.size() == height * (3 * width + 1));
  std::vector<unsigned char> pixels(3 * width * height, 0);
  for(std::size_t y = 0; y < height; ++y)
  {
    assert(rows[y * (3 * width + 1)] == 2);
    for(std::size_t x = 0; x < 3 * width; ++x)
      pixels[y * 3 * width + x] =
        static_cast<unsigned char>(rows[y * (3 * width + 1) + 1 + x] + (y > 0 ? pixels[(y - 1) * 3 * width + x] : 0));
  }
  return pixels;
}

// A square that the eye looks at straight is where it must be, has its color, and hides what is behind it.
void test_picture()
{
  QM::Scene scene;
  const double e[3] = { 0.55, 0.45, 0.75 }, length = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
  const double right = std::hypot(e[2], e[0]);
  const std::array<double, 3> r = { { e[2] / right, 0, -e[0] / right } };
  const std::array<double, 3> u = { { -e[1] * e[0] / right / length, right / length, -e[1] * e[2] / right / length } };
  for(int i = 0; i < 2; ++i)
  {
    // in front a square of half the radius, behind it one of the double size
    QM::Scene_layer layer;
    layer.name = i == 0 ? "front" : "back";
    layer.has_sides = false;
    layer.color = i == 0 ? "#ff0000" : "#00ff00";
    layer.side = i == 0 ? QM::Scene_side::RIGHT : QM::Scene_side::LEFT;
    std::vector<std::size_t> corners;
    for(int k = 0; k < 4; ++k)
    {
      const double s = (i + 1) * (k == 0 || k == 3 ? -1 : 1), t = (i + 1) * (k < 2 ? -1 : 1), d = i == 0 ? 1 : -1;
      std::array<double, 3> p;
      for(std::size_t j = 0; j < 3; ++j)
        p[j] = s * r[j] + t * u[j] + d * e[j] / length;
      corners.push_back(layer.add_point(p));
    }
    layer.add_element(corners);
    scene.layers.push_back(layer);
  }
  // the eye looks at the middle of all points, from a distance that goes by their box
  QM::Scene_layer frame;
  frame.is_visible = false;
  for(double x : { -3., 3. })
    frame.add_point({ { x, x, x } });
  scene.layers.push_back(frame);

  constexpr std::size_t width = 161, height = 121, column = 80, row = 60;
  QM::Png_picture_options options;
  options.width = int(width);
  options.height = int(height);
  const auto pixel = [&](QM::Scene_side side, std::size_t x, std::size_t y)
  {
    std::ostringstream os;
    options.side = side;
    assert(QM::write_png_picture(os, scene, options).is_valid());
    const std::vector<unsigned char> pixels = pixels_in(os.str(), width, height);
    const std::size_t i = 3 * (y * width + x);
    return std::array<int, 3>{ { pixels[i], pixels[i + 1], pixels[i + 2] } };
  };
  const std::array<int, 3> red = { { 255, 0, 0 } }, green = { { 0, 255, 0 } }, white = { { 255, 255, 255 } };
  const auto near = [](const std::array<int, 3>& p, const std::array<int, 3>& q)
  { return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) < 10; };
  assert(near(pixel(QM::Scene_side::BOTH, column, row), red));
  assert(near(pixel(QM::Scene_side::LEFT, column, row), green));
  assert(near(pixel(QM::Scene_side::BOTH, column + 45, row), green));
  assert(pixel(QM::Scene_side::BOTH, 0, 0) == white);
  // The larger square fills the height; the smaller one has half its size, and is nearer.
  const double distance = 1.1 / std::sin(35 * CGAL_PI / 360) * 3 * std::sqrt(3.);
  const double large = 0.94 * height / 2, small = large / 2 * (distance + 1) / (distance - 1);
  for(double sign : { -1., 1. })
  {
    const auto at = [](std::size_t size, double offset) { return static_cast<std::size_t>(size / 2. + offset); };
    const auto is_red = [&](std::size_t x, std::size_t y) { return near(pixel(QM::Scene_side::BOTH, x, y), red); };
    assert(near(pixel(QM::Scene_side::BOTH, at(width, sign * (large - 2)), row), green));
    assert(near(pixel(QM::Scene_side::BOTH, column, at(height, sign * (large - 2))), green));
    assert(pixel(QM::Scene_side::BOTH, at(width, sign * (large + 2)), row) == white);
    assert(pixel(QM::Scene_side::BOTH, column, at(height, sign * (large + 2))) == white);
    assert(is_red(at(width, sign * (small - 2)), row) && !is_red(at(width, sign * (small + 2)), row));
    assert(is_red(column, at(height, sign * (small - 2))) && !is_red(column, at(height, sign * (small + 2))));
    // alone it fills the height, too
    assert(near(pixel(QM::Scene_side::RIGHT, at(width, sign * (large - 2)), row), red));
  }
  scene.layers[0].corners[0] = 9;
  std::ostringstream os;
  assert(QM::write_png_picture(os, scene).status == Status::INVALID_SCENE && os.str().empty());
}

// All lengths of repetitions and all bytes survive the compression.
void test_compression()
{
  std::string data;
  for(int n = 1; n < 600; n += n < 40 ? 1 : 7)
    data += std::string(static_cast<std::size_t>(n), static_cast<char>(n * 37)) + static_cast<char>(n);
  for(int c = 0; c < 256; ++c)
    data += static_cast<char>(c);
  assert(inflated(QM::internal::Run_deflater()(data)) == data);
  assert(inflated(QM::internal::Run_deflater()("")).empty());
}

void test_vtk()
{
  std::ostringstream os;
  os.precision(17);
  assert(QM::write_vtk(os, small_scene().layers[0]).is_valid());
  std::istringstream is(os.str());
  std::string line;
  std::getline(is, line);
  assert(line == "# vtk DataFile Version 3.0");
  std::getline(is, line);
  assert(line == "two_faces");
  std::string word;
  std::size_t n = 0, m = 0;
  is >> word >> word >> word; // ASCII DATASET UNSTRUCTURED_GRID
  assert(word == "UNSTRUCTURED_GRID");
  is >> word >> n >> word;
  assert(n == 6 && word == "double");
  for(std::size_t i = 0; i < 18; ++i)
  {
    double x;
    is >> x;
    assert(x == small_scene().layers[0].points[i / 3][i % 3]);
  }
  is >> word >> n >> m;
  assert(word == "CELLS" && n == 2 && m == 9);
  for(std::size_t expected : { 4, 0, 2, 3, 1, 3, 2, 4, 5 })
  {
    is >> n;
    assert(n == expected);
  }
  is >> word >> n;
  assert(word == "CELL_TYPES" && n == 2);
  for(std::size_t expected : { 9, 5 }) // a quad and a triangle
  {
    is >> n;
    assert(n == expected);
  }
  is >> word >> n;
  assert(word == "CELL_DATA" && n == 2);
  is >> word >> line;
  assert(word == "SCALARS" && line == "height");
}

// The quads of a cube in six groups, its twelve edges as lines; the file reads back as the same mesh.
void test_grouped_obj()
{
  const structure_meshes::Mesh qm = structure_meshes::make_mesh(structure_meshes::cube(3));
  structure_meshes::Mesh copy = qm;
  const auto is_separatrix = copy.add_property_map<structure_meshes::Mesh::Edge_index, bool>("e:s", false).first;
  const auto patch = copy.add_property_map<structure_meshes::Mesh::Face_index, std::size_t>("f:p", 0).first;
  assert(QM::base_complex(copy, is_separatrix, patch) == 6);
  {
    std::ofstream out("patches.obj");
    out.precision(17);
    assert(QM::write_grouped_obj(out, copy, patch, is_separatrix));
  }
  std::ifstream in("patches.obj");
  std::string line;
  std::map<std::string, std::size_t> lines, of_group;
  std::string group;
  while(std::getline(in, line))
  {
    const std::string key = line.substr(0, line.find(' '));
    ++lines[key];
    if(key == "g")
      group = line.substr(2);
    else if(key != "v")
      ++of_group[group];
  }
  assert(lines["v"] == 56 && lines["f"] == 54 && lines["l"] == 36 && lines["g"] == 7);
  assert(of_group["separatrices"] == 36 && of_group["patch_0"] == 9 && of_group["patch_5"] == 9);
  std::vector<structure_meshes::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  assert(QM::read_polygon_soup("patches.obj", points, polygons));
  assert(polygons.size() == 54 && points.size() == 56);
  for(std::size_t i = 0; i < points.size(); ++i)
    assert(points[i] == qm.point(structure_meshes::Mesh::Vertex_index(structure_meshes::Mesh::size_type(i))));
}

void test_rosy()
{
  const test_meshes::Mesh tm = test_meshes::make_mesh(test_meshes::cube(1));
  const auto direction = [](test_meshes::Mesh::Face_index f)
  { return test_meshes::Vector_3(0.1, double(std::size_t(f)) / 3, -1e-20); };
  {
    std::ofstream out("field.rosy");
    assert(QM::write_rosy_field(out, tm, direction));
  }
  std::vector<std::array<double, 3>> field;
  assert(QM::read_rosy_field("field.rosy", field) && field.size() == 12);
  for(test_meshes::Mesh::Face_index f : tm.faces())
    for(int k = 0; k < 3; ++k)
      assert(field[f][static_cast<std::size_t>(k)] == direction(f)[k]);

  const auto refused = [&](const std::string& text, const std::string& word)
  {
    std::ofstream("bad.rosy", std::ios::binary) << text;
    const std::vector<std::array<double, 3>> before = field;
    const QM::Mesh_reading_result result = QM::read_rosy_field("bad.rosy", field);
    return !result && field == before && result.message.find(word) != std::string::npos;
  };
  assert(refused("", "ends"));
  assert(refused("2\n4\n1 0 0\n", "Line"));
  assert(refused("1\n4\n1 0 0\n0 1 0\n", "more than"));
  assert(refused("1\n2\n1 0 0\n", "2 directions"));
  assert(refused("0\n4\n", "0 faces"));
  assert(refused("1\n4\n1 0 nan\n", "finite"));
  assert(refused("1\n4\n1 0\n", "Line 3"));
  assert(QM::read_rosy_field("no such file.rosy", field).status == QM::Mesh_reading_status::CANNOT_OPEN);
}

// The numbers of a part lead to the elements of the file and back.
void test_numbers_of_part()
{
  const std::uint32_t none = 0xFFFFFFFF;
  // the file has six elements: the mesh merges 0 and 1, drops 4, and splits 5 in two; its element 2 is inserted
  const QM::File_numbers numbers({ 0, 2, none, 3, 5, 5 }, { 0, 0, 1, 3, none, 4 });
  const QM::File_numbers part = numbers.of_part({ 0, 2, 5 });
  assert(part.mesh_size() == 3 && part.file_size() == 6);
  assert(part.file_number(0) == 0 && part.file_number(1) == QM::File_numbers::none && part.file_number(2) == 5);
  assert(part.mesh_number(0) == 0 && part.mesh_number(1) == 0 && part.mesh_number(5) == 2);
  for(std::size_t n : { 2, 3, 4 })
    assert(part.mesh_number(n) == QM::File_numbers::none);
  const QM::File_numbers of_identity = QM::File_numbers(4).of_part({ 1, 3 });
  assert(of_identity.file_number(0) == 1 && of_identity.mesh_number(3) == 1);
  assert(of_identity.mesh_number(0) == QM::File_numbers::none);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "contents", test_contents },
                     { "refusals", test_refusals },
                     { "small_scenes", test_small_scenes },
                     { "display", test_display },
                     { "picture", test_picture },
                     { "compression", test_compression },
                     { "vtk", test_vtk },
                     { "grouped_obj", test_grouped_obj },
                     { "rosy", test_rosy },
                     { "numbers_of_part", test_numbers_of_part },
                     { "quad_layers", test_quad_layers },
                     { "quadrangulation_layers", test_quadrangulation_layers } });
}
