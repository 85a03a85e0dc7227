// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_SCENE_JSON_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_SCENE_JSON_H

#include <CGAL/Quad_meshing/IO/Flat_json.h>
#include <CGAL/Quad_meshing/IO/Scene.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// An array of floats or 32-bit integers as text, lower bytes first.
class Base64_array
{
  std::string m_bytes;

public:
  void push_back(std::uint32_t n)
  {
    for(int k = 0; k < 4; ++k)
      m_bytes += static_cast<char>(n >> (8 * k) & 0xFF);
  }

  void push_back(float x)
  {
    std::uint32_t bits;
    static_assert(sizeof(bits) == sizeof(x), "float has 32 bits");
    std::memcpy(&bits, &x, sizeof(x));
    push_back(bits);
  }

  std::string text() const
  {
    namespace iterators = boost::archive::iterators;
    typedef iterators::base64_from_binary<iterators::transform_width<std::string::const_iterator, 6, 8>> To_base64;
    // whole groups of three bytes, as the last one must be padded
    std::string padded = m_bytes;
    padded.append((3 - m_bytes.size() % 3) % 3, '\0');
    std::string text(To_base64(padded.begin()), To_base64(padded.end()));
    const std::size_t padding = padded.size() - m_bytes.size();
    text.replace(text.size() - padding, padding, padding, '=');
    return text;
  }
};

// The box around all points of a scene.
class Scene_box
{
  std::array<double, 3> m_low, m_high;

public:
  explicit Scene_box(const Scene& scene)
  {
    m_low.fill((std::numeric_limits<double>::infinity)());
    m_high.fill(-(std::numeric_limits<double>::infinity)());
    for(const Scene_layer& layer : scene.layers)
      for(const std::array<double, 3>& p : layer.points)
        for(int k = 0; k < 3; ++k)
        {
          m_low[k] = (std::min)(m_low[k], p[k]);
          m_high[k] = (std::max)(m_high[k], p[k]);
        }
    if(m_low[0] > m_high[0])
      m_low = m_high = { { 0, 0, 0 } };
  }

  double center(int k) const { return m_low[k] / 2 + m_high[k] / 2; }

  // Half the diagonal, and 1 for a single point.
  double radius() const
  {
    const double r = std::hypot(m_high[0] - m_low[0], m_high[1] - m_low[1], m_high[2] - m_low[2]) / 2;
    return r > 0 ? r : 1;
  }
};

// Text inside of a script element: it must not end it.
inline std::string script_string(const std::string& s)
{
  std::string out;
  for(char c : json_string(s))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

class Scene_json_writer
{
  std::ostream& m_os;
  const Scene_box m_box;

public:
  Scene_json_writer(std::ostream& os, const Scene& scene) : m_os(os), m_box(scene) {}

  void write(const Scene& scene)
  {
    // Coordinates are scaled to a radius of 1: single precision then holds them whatever the unit of the model is.
    m_os << "{\"title\":" << script_string(scene.title) << ",\"message\":" << script_string(scene.message)
         << ",\"side_by_side\":" << (scene.is_side_by_side ? "true" : "false") << ",\"center\":["
         << json_number(m_box.center(0)) << "," << json_number(m_box.center(1)) << "," << json_number(m_box.center(2))
         << "],\"radius\":" << json_number(m_box.radius());
    write_table("figures", scene.figures);
    write_table("options", scene.options);
    m_os << ",\"remarks\":[";
    for(std::size_t i = 0; i < scene.remarks.size(); ++i)
      m_os << (i == 0 ? "" : ",") << script_string(scene.remarks[i]);
    m_os << "],\"histograms\":[";
    for(std::size_t i = 0; i < scene.histograms.size(); ++i)
      write_histogram(scene.histograms[i], i == 0 ? "\n" : ",\n");
    m_os << "],\"layers\":[";
    for(std::size_t i = 0; i < scene.layers.size(); ++i)
      write_layer(scene.layers[i], i == 0 ? "\n" : ",\n");
    m_os << "]}";
  }

private:
  void write_table(const char* key, const Scene::Table& table)
  {
    m_os << ",\"" << key << "\":[";
    for(std::size_t i = 0; i < table.size(); ++i)
      m_os << (i == 0 ? "[" : ",[") << script_string(table[i].first) << "," << script_string(table[i].second) << "]";
    m_os << "]";
  }

  void write_histogram(const Scene_histogram& h, const char* separator)
  {
    m_os << separator << "{\"name\":" << script_string(h.name) << ",\"unit\":" << script_string(h.unit)
         << ",\"low\":" << json_number(h.low) << ",\"high\":" << json_number(h.high) << ",\"counts\":[";
    for(std::size_t i = 0; i < h.counts.size(); ++i)
      m_os << (i == 0 ? "" : ",") << h.counts[i];
    m_os << "]}";
  }

  void write_layer(const Scene_layer& layer, const char* separator)
  {
    static const char* const kinds[] = { "faces", "lines", "points" };
    m_os << separator << "{\"name\":" << script_string(layer.name) << ",\"group\":" << script_string(layer.group)
         << ",\"kind\":\"" << kinds[static_cast<int>(layer.kind)] << "\",\"side\":" << static_cast<int>(layer.side)
         << ",\"visible\":" << (layer.is_visible ? "true" : "false")
         << ",\"edges\":" << (layer.has_sides ? "true" : "false") << ",\"color\":" << script_string(layer.color)
         << ",\"colored_by\":" << layer.colored_by;
    Base64_array points, corners, first, grid;
    for(const std::array<double, 3>& p : layer.points)
      for(int k = 0; k < 3; ++k)
        points.push_back(static_cast<float>((p[k] - m_box.center(k)) / m_box.radius()));
    for(std::size_t c : layer.corners)
      corners.push_back(static_cast<std::uint32_t>(c));
    for(std::size_t c : layer.first_corner)
      first.push_back(static_cast<std::uint32_t>(c));
    write_grid(layer, grid);
    m_os << ",\"points\":\"" << points.text() << "\",\"corners\":\"" << corners.text() << "\",\"first\":\""
         << first.text() << "\",\"grid\":\"" << grid.text() << "\",\"numbers\":[";
    for(std::size_t i = 0; i < layer.numbers.size(); ++i)
      write_numbers(layer.numbers[i], i == 0 ? "" : ",");
    m_os << "]}";
  }

  // Only the places within the cells count: those of each element are moved near zero, by an even number, where single
  // precision is fine.
  static void write_grid(const Scene_layer& layer, Base64_array& grid)
  {
    if(layer.grid.empty())
      return;
    for(std::size_t i = 0; i < layer.size(); ++i)
    {
      const std::array<double, 2>& first = layer.grid[layer.first_corner[i]];
      const double shift[2] = { 2 * std::floor(first[0] / 2), 2 * std::floor(first[1] / 2) };
      for(std::size_t c = layer.first_corner[i]; c < layer.first_corner[i + 1]; ++c)
        for(int k = 0; k < 2; ++k)
          grid.push_back(static_cast<float>(layer.grid[c][k] - shift[k]));
    }
  }

  void write_numbers(const Scene_numbers& n, const char* separator)
  {
    static const char* const scales[] = { "sequence", "categories", "signed" };
    Base64_array values;
    for(double x : n.values)
      values.push_back(static_cast<float>(x));
    m_os << separator << "{\"name\":" << script_string(n.name) << ",\"unit\":" << script_string(n.unit)
         << ",\"scale\":\"" << scales[static_cast<int>(n.scale)] << "\",\"low\":" << json_number(n.low)
         << ",\"high\":" << json_number(n.high) << ",\"values\":\"" << values.text() << "\"}";
  }
};

inline void write_scene_json(std::ostream& os, const Scene& scene) { Scene_json_writer(os, scene).write(scene); }

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_SCENE_JSON_H
